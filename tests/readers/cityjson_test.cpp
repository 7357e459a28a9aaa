#include "reading.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

/// A building of one geometry over vertices in millimetres.
std::string city(std::string const& geometry, std::string const& more = {})
{
  return R"({"type":"CityJSON","version":"2.0","transform":{"scale":[0.001,0.001,0.001],"translate":[90409.32,435440.44,0.1]},)"
         R"("CityObjects":{"b":{"type":"Building","geometry":[)" +
         geometry + "]}" + more +
         R"(},"vertices":[)"
         "[579471,198217,0],[589471,198217,0],[589471,208217,0],[579471,208217,0],[581471,200217,0],[583471,200217,0],["
         "583471,202217,0]]}";
}

}  // namespace

TEST_CASE("cityjson: the transform is applied to decimals and rounded once", "[readers][cityjson]")
{
  Scene const s = read_json(city(R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2,3]]]})"));
  CHECK(names(s) == Names{"b"});
  CHECK(s.vertices[0] == Point3d{90988.791, 435638.657, 0.1});
  // Doubles would have given another number for this one:
  CHECK(s.vertices[0].x != 579471 * 0.001 + 90409.32);
}

TEST_CASE("cityjson: vertices without transform are taken as they are", "[readers][cityjson]")
{
  Scene const s = read_json(R"({"type":"CityJSON","version":"1.0","CityObjects":{"b":{"type":"BuildingPart","geometry":[
    {"type":"CompositeSurface","lod":1,"boundaries":[[[2,1,0]]]}]}},"vertices":[[0.1,0,0],[1e-3,85012.343,7],[1,1,1]]})");
  CHECK(s.triangle(0).vertices[1] == Point3d{1e-3, 85012.343, 7});
}

TEST_CASE("cityjson: surfaces, solids and their nesting", "[readers][cityjson]")
{
  std::string const b = "[[0,1,2,3]]";
  for (std::string const& g :
       {R"("MultiSurface","boundaries":[)" + b + "]", R"("Solid","boundaries":[[)" + b + "]]",
        R"("CompositeSolid","boundaries":[[[)" + b + "]]]", R"("MultiSolid","boundaries":[[[)" + b + "]]]"})
    CHECK(read_json(city(R"({"lod":"1","type":)" + g + "}")).triangles.size() == 2);
}

TEST_CASE("cityjson: a hole stays open", "[readers][cityjson]")
{
  Scene const s = read_json(city(R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2,3],[4,5,6]]]})"));
  CHECK(s.triangles.size() == 7);  // n + 2 holes - 2
}

TEST_CASE("cityjson: the highest level of detail of each object; footprints only are skipped", "[readers][cityjson]")
{
  std::string const tri = R"("type":"MultiSurface","boundaries":[[[0,1,2]]]})",
                    quad = R"("type":"MultiSurface","boundaries":[[[0,1,2,3]]]})";
  CHECK(
    read_json(city(R"({"lod":"1.2",)" + tri + R"(,{"lod":"2.2",)" + quad + R"(,{"lod":"0",)" + tri)).triangles.size() ==
    2);
  Scene const s =
    read_json(city(R"({"lod":"2",)" + quad,
                   R"(,"f":{"type":"Building","geometry":[{"lod":0,)" + quad +
                     R"(]},"e":{"type":"Building"},"r":{"type":"Road","geometry":[]},"w":{"type":"WaterBody"})"));
  CHECK(names(s) == Names{"b"});
  CHECK(has_note(s, "1 building objects with a footprint"));
  CHECK(has_note(s, "1 building objects without own geometry"));
  CHECK(has_note(s, "1 objects of type Road skipped"));
}

TEST_CASE("cityjson: degenerate and crossing rings are left out and counted", "[readers][cityjson]")
{
  Scene const s =
    read_json(city(R"({"type":"MultiSurface","lod":2,"boundaries":[[[0,1,2]],[[0,0,1]],[[0,2,1,3]],[]]})"));
  CHECK(s.triangles.size() == 1);
  CHECK(has_note(s, "2 polygons without area"));
  CHECK(has_note(s, "1 polygons whose rings cross"));
}

TEST_CASE("cityjson: templates are placed by their matrix", "[readers][cityjson]")
{
  Scene const s = read_json(R"({"type":"CityJSON","version":"1.1","geometry-templates":{"templates":[
    {"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2]]]}],"vertices-templates":[[0,0,0],[1.5,0,0],[0,1,1]]},
    "CityObjects":{"i":{"type":"BuildingInstallation","geometry":[{"type":"GeometryInstance","template":0,"boundaries":[0],
    "transformationMatrix":[2,0,0,1,0,2,0,0,0,0,2,0,0,0,0,1]}]}},"vertices":[[100,200,3]]})");
  CHECK(s.triangle(0).vertices[1] == Point3d{104, 200, 3});
}

TEST_CASE("cityjson: a sequence takes the transform of its first line", "[readers][cityjson]")
{
  Scene const s = read_json(
    R"({"type":"CityJSON","version":"2.0","transform":{"scale":[0.1,0.1,0.1],"translate":[1,2,3]},"CityObjects":{},"vertices":[]})"
    "\n"
    R"({"type":"CityJSONFeature","id":"a","CityObjects":{"a":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]}]}},"vertices":[[1,0,0],[2,0,0],[2,3,0]]})"
    "\n"
    R"({"type":"CityJSONFeature","id":"b","CityObjects":{"b":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]}]}},"vertices":[[7,0,0],[2,0,0],[2,3,0]]})"
    "\n");
  CHECK(names(s) == Names{"a", "b"});
  CHECK(s.triangle(0).vertices[0] == Point3d{1.1, 2, 3});
  CHECK(s.triangle(1).vertices[0] == Point3d{1.7, 2, 3});
}
