#include "reading.hpp"
#include "support/real_scenes.hpp"

#include <fstream>

using namespace visibility;
using namespace visibility::test;

namespace {

struct Case {
  SceneFormat format;
  std::string bytes;
  std::string part;  ///< of the message: where and what
};

auto const obj = SceneFormat::obj, ply = SceneFormat::ply, json = SceneFormat::json;

std::string const city =
  R"({"type":"CityJSON","version":"1.1","CityObjects":{"b":{"type":"Building","geometry":[{"type":"MultiSurface","lod":1,"boundaries":)";
std::string const ply_header =
  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
  "property list uchar int vertex_indices\nend_header\n";
std::string polygon(std::string const& rings)
{
  return R"({"type":"Feature","properties":{"h":1},"geometry":{"type":"Polygon","coordinates":)" + rings + "}}";
}
std::string native(std::string const& object)
{
  return R"({"format":"visibility-scene/1","objects":[{"name":"a",)" + object + "}]}";
}

std::vector<Case> const cases = {
  {obj, "", "no objects"},
  {obj, "v 0 0\n", "line 1: a vertex needs three numbers"},
  {obj, "v 0 0 nan\n", "line 1: a coordinate is not finite"},
  {obj, "v 0 0 0\nv 0 0 1e999\n", "line 2: a coordinate is not finite"},
  {obj, "v 0 0 0\no a\nf 1 1 2\n", "line 3, object 'a': a face names vertex 2, but 1 are defined"},
  {obj, "v 0 0 0\nf 0 1 1\n", "vertex 0"},
  {obj, "v 0 0 0\nf 1 1\n", "line 2: a face needs three"},
  {obj, "v 0 0 0\nf 1 1 x\n", "'x' is not a vertex of a face"},
  {obj, "v 0 0 0\nf 1 1 99999999999999999999\n", "is not a vertex of a face"},
  {obj, "hello world\n", "line 1: unknown statement 'hello'"},
  {obj, "v 0 0 0\no only\n", "no objects"},
  {ply, "", "line 1"},
  {ply, "plx\n", "line 1: does not begin"},
  {ply, "ply\nelement vertex 3\n", "the header does not end"},
  {ply, "ply\nformat odd 1.0\nend_header\n", "line 2: unknown format 'odd'"},
  {ply, "ply\nelement vertex 3\nend_header\n", "names no format"},
  {ply, "ply\nformat ascii 1.0\nelement vertex -3\nend_header\n", "line 3: '-3' is not a number"},
  {ply, "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n", "line 4: unknown property type"},
  {ply, "ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_indices\nend_header\n",
   "must be of an integer type"},
  {ply, "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n", "no property 'y'"},
  {ply, ply_header + "0 0 0 1 1 1 2 2", "vertex 2: the file ends"},
  {ply, ply_header + "0 0 0\n1 x 1\n2 2 2\n3 0 1 2\n", "line 11, vertex 1: 'x' is not a value"},
  {ply, ply_header + "0 0 0\n1 inf 1\n2 2 2\n3 0 1 2\n", "vertex 1: a coordinate is not finite"},
  {ply, ply_header + "0 0 0\n1 1 1\n2 2 2\n3 0 1 3\n", "a face names vertex 3, but there are 3"},
  {ply, ply_header + "0 0 0\n1 1 1\n2 2 2\n3 0 1 -1\n", "face 0: a face names vertex -1"},
  {ply, ply_header + "0 0 0\n1 1 1\n2 2 2\n1000000000 0 1 2\n", "face 0: list 'vertex_indices' claims"},
  {ply,
   "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n",
   "no faces"},
  {json, "", "is empty"},
  {json, "[1,2]", "neither CityJSON, GeoJSON nor visibility-scene"},
  {json, "{\"type\":\n\"Feature\",,}", "line 2: not valid JSON"},
  {json, R"({"type":"Feature","properties":{"h":NaN}})", "line 1: not valid JSON"},
  {json, polygon("[[[0,0],[1,0],[1e999,1]]]"), "line 1: not valid JSON: number overflow"},
  {json, std::string(100000, '['), "nested deeper"},
  {json, R"({"a":)" + std::string(100000, '['), "nested deeper"},
  {json, R"({"type":"FeatureCollection"})", "without a list 'features'"},
  {json, R"({"type":"FeatureCollection","features":[{}]})", "feature 1: is no Feature"},
  {json, R"({"type":"FeatureCollection","features":[]})", "no objects"},
  {json, polygon("7"), "feature 1: its geometry has no coordinates"},
  {json, polygon("[7]"), "feature 1: a ring must be"},
  {json, polygon("[[7]]"), "feature 1: a position must be"},
  {json, polygon("[[[1,\"2\"]]]"), "feature 1: a position must be"},
  {json, polygon("[[[0,0],[300,0],[300,1]]]") + "\n{}",
   "line 2, feature 1: a Feature or FeatureCollection was expected"},
  {json, R"({"type":"CityJSON","version":"0.9"})", "version '0.9' cannot be read"},
  {json, R"({"type":"CityJSON","version":"1.0"})", "has no 'CityObjects'"},
  {json, R"({"type":"CityJSON","version":"1.0","CityObjects":{}})", "has no list 'vertices'"},
  {json, R"({"type":"CityJSONFeature"})", "before the CityJSON line"},
  {json, city + "[[[0,1,5]]]}]}},\"vertices\":[[0,0,0]]}", "object 'b': a ring names vertex 1, but there are 1"},
  {json, city + "[[[0,1.5]]]}]}},\"vertices\":[[0,0,0],[0,0,0]]}", "object 'b': a ring names vertex 1.5"},
  {json, city + "[[0]]}]}},\"vertices\":[[0,0,0]]}", "object 'b': a ring must be"},
  {json, city + "[7]}]}},\"vertices\":[[0,0,0]]}", "object 'b': a surface must be"},
  {json, city + "7}]}},\"vertices\":[[0,0,0]]}", "object 'b': boundaries must be"},
  {json, city + "[]}]}},\"vertices\":[[0,0]]}", "vertex 0: a vertex must be three numbers"},
  {json, city + "[]}]}},\"vertices\":[[0,0,0]],\"transform\":{\"scale\":[1,1],\"translate\":[0,0,0]}}",
   "transform: 'scale' must be"},
  {json, city + "[]}]}},\"vertices\":[[0,0,0]],\"transform\":{\"scale\":[1e-5000,1,1],\"translate\":[0,0,0]}}",
   "transform: 'scale' must be"},
  {json, city + "[]}]}},\"vertices\":[[1e308,0,0]],\"transform\":{\"scale\":[1e300,1,1],\"translate\":[0,0,0]}}",
   "vertex 0: a coordinate is not finite"},
  {json, R"({"format":"visibility-scene/2"})", "unknown format 'visibility-scene/2'"},
  {json, R"({"format":"visibility-scene/1","objects":[]})", "no objects"},
  {json, native(R"("cones":[])"), "object 1 'a': unknown kind 'cones'"},
  {json, native(R"("boxes":[1,2,3])"), "'boxes' must be a flat list"},
  {json, native(R"("boxes":[1,0,0,0,1,1])"), "min > max"},
  {json, native(R"("balls":[0,0,0,-1])"), "negative radius"},
  {json, native(R"("triangles":[0,0,0])"), "names vertex 0, but there are 0"},
  {json, native(R"("prisms":[{"bottom":1,"top":1,"rings":[[0,0,1,0,1,1]]}])"), "no height"},
  {json, native(R"("prisms":[{"bottom":0,"top":1}])"), "fewer than three points"},
  {json, native(R"("polyhedra":[{"vertices":[0,0,0,1,0,0,0,1,0],"facets":[0,1,2]}])"), "not convex and closed"},
};

}  // namespace

TEST_CASE("bad input: one line that says what and where", "[readers][bad-input]")
{
  for (auto const& c : cases) {
    auto const message = refusal(c.bytes, c.format);
    CAPTURE(c.bytes.substr(0, 300), message, c.part);
    CHECK(message.starts_with("input"));
    CHECK(message.find(c.part) != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("bad input: names with line ends or broken UTF-8 stay on one line", "[readers][bad-input]")
{
  auto const message = refusal("v 0 0 0\no a\x01\xff\nf 1 1 9\n", obj);
  CHECK(message.find("object 'a?\?'") != std::string::npos);
  CHECK(refusal(R"({"type":"Fea\nture"})", json).find('\n') == std::string::npos);
}

TEST_CASE("bad input: files that are missing, folders, of unknown kind, cut short", "[readers][bad-input]")
{
  auto const folder = std::filesystem::temp_directory_path() / "visibility-bad-input";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "what.xyz") << "1 2 3\n";
  std::ofstream(folder / "cut.obj.gz") << std::string("\x1f\x8b\x08\0\0\0\0\0\0\x03\x2b\x53\x30", 13);
  for (auto const* name : {"none.obj", ".", "what.xyz", "cut.obj.gz"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(read_scene(folder / name), BadInput);
  }
  std::filesystem::remove_all(folder);
}
