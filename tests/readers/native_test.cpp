#include "reading.hpp"

#include "visibility/scene/write_scene.hpp"

#include <sstream>

using namespace visibility;
using namespace visibility::test;

TEST_CASE("native: every kind of primitive", "[readers][native]")
{
  Scene const s = read_json(R"({"format":"visibility-scene/1","notes":["n"],"objects":[
    {"name":"a","boxes":[0,0,0,1,1,1],"balls":[3,3,3,0.5]},
    {"name":"b","prisms":[{"bottom":0,"top":2,"rings":[[0,0,4,0,4,4,0,4],[1,1,2,1,2,2]]}],
     "polyhedra":[{"vertices":[0,0,0,1,0,0,0,1,0,0,0,1],"facets":[0,2,1,0,1,3,1,2,3,0,3,2]}],"triangles":[0,1,2]}],
    "vertices":[0,0,0,1,0,0,0,1,-0.0]})");
  CHECK(s.notes == Names{"n"});
  CHECK(names(s) == Names{"a", "b"});
  CHECK(s.balls[0] == Ball{{3, 3, 3}, 0.5});
  CHECK(s.prisms[0].rings[1][2] == Point2d{2, 2});
  CHECK(s.polyhedra[0].facets.size() == 4);
  CHECK(std::signbit(s.vertices[2].z));
}
