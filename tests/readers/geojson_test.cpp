#include "reading.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

std::string feature(std::string const& properties, std::string const& ring = "[0,0],[100,0],[100,10],[0,0]",
                    std::string const& more = {})
{
  return R"({"type":"Feature",)" + more + R"("properties":{)" + properties +
         R"(},"geometry":{"type":"Polygon","coordinates":[[)" + ring + "]]}}";
}
double top(Scene const& s) { return s.prisms.at(0).top; }

}  // namespace

TEST_CASE("geojson: usual height properties are tried in order, text and units included", "[readers][geojson]")
{
  for (std::string const p : {R"("height":12.5)", R"("h":12.5)", R"("HAUTEUR":12.5)", R"("measuredHeight":12.5)",
                              R"("building:height":"12.5 m")", R"("render_height":"12.5")", R"("HEIGHT":12.5,"h":null)",
                              R"("building:levels":9,"height":12.5)"})
    CHECK(top(read_json(feature(p))) == 12.5);
  Scene const levels = read_json(feature(R"("building:levels":"4")"));
  CHECK(top(levels) == 12);
  CHECK(has_note(levels, "1 heights are storeys of 3 m"));
  ReadOptions options;
  options.height_property = "eaves";
  CHECK(top(read_json(feature(R"("eaves":7,"height":9)"), options)) == 7);
}

TEST_CASE("geojson: heights start at the ground, except where both are measured from zero", "[readers][geojson]")
{
  Scene const hill = read_json(feature(R"("HAUTEUR":9.2,"Z_MIN_SOL":200.6)"));
  CHECK(hill.prisms[0].bottom == 200.6);
  CHECK(top(hill) == 200.6 + 9.2);
  Scene const bridge = read_json(feature(R"("height":9,"min_height":5)"));
  CHECK(bridge.prisms[0].bottom == 5);
  CHECK(top(bridge) == 9);
  ReadOptions options;
  options.ground_property = "sol";
  CHECK(top(read_json(feature(R"("height":9,"sol":-5,"ground":7)"), options)) == 4);
}

TEST_CASE("geojson: a missing ground is taken from z, as the other footprints explain it", "[readers][geojson]")
{
  std::string const roofs = feature(R"("h":10,"ground":100)", "[0,0,110],[100,0,110],[0,9,110],[0,0,110]");
  Scene const s = read_json(roofs + "\n" + feature(R"("h":4)", "[0,0,106],[100,0,106],[0,9,107],[0,0,106]"));
  CHECK(s.prisms[1].bottom == 102);
  CHECK(s.prisms[1].top == 106);
  CHECK(has_note(s, "1 footprints without ground"));
}

TEST_CASE("geojson: features without height or geometry are left out and counted", "[readers][geojson]")
{
  Scene const s =
    read_json(feature(R"("h":1)") + feature(R"("h":null)") + feature(R"("h":0)") +
              R"({"type":"Feature","properties":null,"geometry":null})"
              R"({"type":"Feature","properties":{"h":3},"geometry":{"type":"Point","coordinates":[1,2]}})");
  CHECK(s.objects.size() == 1);
  CHECK(has_note(s, "2 features without a height"));
  CHECK(has_note(s, "1 features without geometry"));
  CHECK(has_note(s, "1 features that are no polygons"));
  CHECK(refusal(feature(R"("roof":"gable","area":7)"), SceneFormat::json).find("properties seen: area, roof") !=
        std::string::npos);
}

TEST_CASE("geojson: rings lose repeated points, holes and parts are kept", "[readers][geojson]")
{
  Scene const s = read_json(
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"h":5},"geometry":{"type":"MultiPolygon",
    "coordinates":[[[[0,0],[100,0],[100,0],[100,100],[0,100],[0,0]],[[10,10],[20,10],[20,20],[10,10]],[[1,1],[2,2],[1,1]]],
    [[[200,0],[300,0],[300,9],[200,0]]],[[[1,1],[1,1],[1,1]]]]}}]})");
  REQUIRE(s.prisms.size() == 2);
  CHECK(s.objects.size() == 1);
  CHECK(s.prisms[0].rings ==
        std::vector<std::vector<Point2d>>{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{10, 10}, {20, 10}, {20, 20}}});
  CHECK(has_note(s, "2 rings with fewer than three points"));
}

TEST_CASE("geojson: names are ids, then usual properties, then positions", "[readers][geojson]")
{
  std::string const lines = "\x1e" + feature(R"("h":1,"ID":"no")", "[0,0],[100,0],[0,9]", R"("id":1034833,)") +
                            "\n\x1e" + feature(R"("h":1,"ID":"B7")") + "\n" +
                            feature(R"("h":1,"name":"Hall","bldg":"x")") + "\r\n\n" + feature(R"("h":1)") +
                            feature(R"("h":1,"ID":"B7")");
  CHECK(names(read_json(feature(R"("h":1)", "[0,0],[100,0],[0,9]", R"("id":100000,)"))) == Names{"100000"});
  CHECK(names(read_json(lines)) == Names{"1034833", "B7", "Hall", "feature 4", "B7#2"});
}

TEST_CASE("geojson: longitude and latitude are told from metres and projected", "[readers][geojson]")
{
  std::string const house = "[4.8001,45.7],[4.8002,45.7],[4.8002,45.7001],[4.8001,45.7]";
  std::string const room = "[-3,-4],[3,-4],[3,4],[-3,-4]";
  Scene const s = read_json(feature(R"("h":9)", house));
  CHECK(has_note(s, "projected to metres"));
  auto const& ring = s.prisms[0].rings[0];
  CHECK(ring[1].x - ring[0].x == Approx(7.78).epsilon(1e-2));  // 1e-4 degrees at 45.7 north
  CHECK(ring[2].y - ring[1].y == Approx(11.11).epsilon(1e-2));
  CHECK(ring[0].y == ring[1].y);
  CHECK(ring[1].x == ring[2].x);
  CHECK_FALSE(has_note(read_json(feature(R"("h":9)", room)), "projected"));
  auto const crs = [](std::string const& name) {
    return R"("crs":{"type":"name","properties":{"name":")" + name + "\"}},";
  };
  CHECK_FALSE(has_note(read_json(feature(R"("h":9)", house, crs("urn:ogc:def:crs:EPSG::3946"))), "projected"));
  CHECK(has_note(read_json(feature(R"("h":9)", house, crs("urn:ogc:def:crs:OGC:1.3:CRS84"))), "projected"));
  ReadOptions options;
  options.coordinates = CoordinateUnit::metres;
  CHECK_FALSE(has_note(read_json(feature(R"("h":9)", house), options), "projected"));
  options.coordinates = CoordinateUnit::degrees;
  CHECK(has_note(read_json(feature(R"("h":9)", room), options), "projected"));
  CHECK(refusal(feature(R"("h":9)", "[0,0],[446,1056],[7,8]"), SceneFormat::json, options).find("no longitude") !=
        std::string::npos);
}
