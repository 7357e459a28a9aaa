#include "support/catch.hpp"
#include "support/height_field_oracle.hpp"
TEST_CASE("x","[height_field]") {
  using namespace visibility;
  std::vector<oracle::Column> c{{{{4,-5,5},{5,-5,5},{5,5,5},{4,5,5}},0,{}},{{{7,-2,4},{8,-2,4},{8,2,4},{7,2,4}},1,{}},{{{10,-2,14},{11,-2,14},{11,2,14},{10,2,14}},2,{}}};
  auto a = oracle::visible_objects(c,3,{{{0,0},{1,0},{1,1},{0,1}},0,2});
  CHECK(int(a.verdict[0])==1); CHECK(int(a.verdict[1])==0); CHECK(int(a.verdict[2])==1);
}
