#include "support/catch.hpp"

#include "visibility/scene/moving_objects.hpp"
#include "visibility/scene/scene_builder.hpp"

using namespace visibility;

TEST_CASE("moving objects file: names, boxes and polygons", "[results]")
{
  auto const moving = moving_objects_from_json(
    R"([{"name":"street 1","min":[0,0,0],"max":[10,4,2],"polygons":1400,"note":1},{"name":"b","min":[0,0,0],"max":[1,1,0]}])",
    "x");
  REQUIRE(moving.size() == 2);
  REQUIRE(moving[0].name == "street 1");
  REQUIRE(moving[0].region == Box{{0, 0, 0}, {10, 4, 2}});
  REQUIRE(moving[0].polygons == 1400);
  REQUIRE(moving[1].polygons == 0);
}

TEST_CASE("moving objects file: faults are one line that names the file and the entry", "[results][degenerate]")
{
  for (std::string const text :
       {"", "{}", "[]", "[1]", R"([{"name":1,"min":[0,0,0],"max":[1,1,1]}])", R"([{"min":[0,0,0],"max":[1,1,1]}])",
        R"([{"name":"a","min":[0,0],"max":[1,1,1]}])", R"([{"name":"a","min":[0,0,0],"max":[1,1,1e999]}])",
        R"([{"name":"a","min":[2,0,0],"max":[1,1,1]}])", R"([{"name":"a","min":[0,0,0],"max":[1,1,1],"polygons":-1}])",
        R"([{"name":"a","min":[0,0,0],"max":[1,1,1],"polygons":1e300}])"}) {
    CAPTURE(text);
    std::string what;
    try {
      (void)moving_objects_from_json(text, "moving.json");
    } catch (BadInput const& e) {
      what = e.what();
    }
    REQUIRE(what.find("moving.json") != std::string::npos);
    REQUIRE(what.find('\n') == std::string::npos);
  }
}
