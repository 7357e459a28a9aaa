#include "support/catch.hpp"

#include "visibility/scene/scene_builder.hpp"
#include "visibility/scene/scene_report.hpp"

#include <limits>

using namespace visibility;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
Box const unit{{0, 0, 0}, {1, 1, 1}};

}  // namespace

TEST_CASE("scene builder: names are unique, printable UTF-8, and given ones are kept", "[scene]")
{
  SceneBuilder builder("test");
  for (auto const* name : {"a", "a", "a#2", "a", "Z\xC3\xBCrich", "bad\xFF\n"}) {
    builder.begin_object(name);
    builder.add(unit);
  }
  Scene const scene = builder.finish();
  scene.validate();
  REQUIRE(scene.objects[0].name == "a");
  REQUIRE(scene.objects[1].name == "a#3");  // "a#2" is the name of another
  REQUIRE(scene.objects[2].name == "a#2");
  REQUIRE(scene.objects[3].name == "a#4");
  REQUIRE(scene.objects[4].name == "Z\xC3\xBCrich");
  REQUIRE(scene.objects[5].name == "bad??");
}

TEST_CASE("scene builder: objects without geometry are dropped and said so", "[scene]")
{
  SceneBuilder builder("test");
  builder.begin_object("empty");
  builder.begin_object("full");
  builder.add(unit);
  Scene const scene = builder.finish();
  REQUIRE(scene.objects.size() == 1);
  REQUIRE(scene.notes.size() == 1);
  REQUIRE_THROWS_AS(SceneBuilder("nothing").finish(), BadInput);
}

TEST_CASE("scene builder: what is not a finite shape is refused with the object's name", "[scene][degenerate]")
{
  auto const refused = [](auto&& add) {
    SceneBuilder builder("file.x");
    builder.begin_object("thing");
    try {
      add(builder);
    } catch (BadInput const& e) {
      std::string const what = e.what();
      return what.find("file.x") != std::string::npos && what.find("thing") != std::string::npos &&
             what.find('\n') == std::string::npos;
    }
    return false;
  };
  REQUIRE(refused([](auto& b) { b.add(Box{{0, 0, 0}, {1, not_a_number, 1}}); }));
  REQUIRE(refused([](auto& b) { b.add(Box{{0, 0, 0}, {1, infinite, 1}}); }));
  REQUIRE(refused([](auto& b) { b.add(Box{{0, 2, 0}, {1, 1, 1}}); }));
  REQUIRE(refused([](auto& b) { b.add(Ball{{0, 0, 0}, -1}); }));
  REQUIRE(refused([](auto& b) { b.add(Ball{{0, not_a_number, 0}, 1}); }));
  REQUIRE(refused([](auto& b) { b.add(Prism{{{{0, 0}, {1, 0}, {0, 1}}}, 1, 1}); }));
  REQUIRE(refused([](auto& b) { b.add(Prism{{{{0, 0}, {1, 0}}}, 0, 1}); }));
  REQUIRE(refused([](auto& b) { b.add(Prism{{{{0, 0}, {1, infinite}, {0, 1}}}, 0, 1}); }));
  REQUIRE(refused([](auto& b) { b.add_vertex({0, -infinite, 0}); }));
  REQUIRE(refused([](auto& b) { b.add_triangle(0, 1, 2); }));
  REQUIRE_FALSE(refused([](auto& b) { b.add(Box{{0, 0, 0}, {1, 1, 0}}); }));  // flat is fine
}

TEST_CASE("scene report: degenerate triangles and repeated faces are counted exactly", "[scene]")
{
  SceneBuilder builder("test");
  builder.begin_object("mesh");
  for (auto const& p :
       {Point3d{0, 0, 0}, Point3d{0.1, 0.1, 0.1}, Point3d{0.2, 0.2, 0.2}, Point3d{1, 0, 0}, Point3d{1, 0, 0}})
    builder.add_vertex(p);
  builder.add_triangle(0, 1, 2);  // on one line, exactly: 0.2 = 2 * 0.1
  builder.add_triangle(0, 1, 3);
  builder.add_triangle(4, 0, 1);  // the same, with another vertex of equal coordinates
  builder.add_triangle(3, 4, 0);  // two equal vertices
  builder.begin_object("flat");
  builder.add(Box{{0, 0, 0}, {1, 1, 0}});
  auto const r = report(builder.finish());
  REQUIRE(r.zero_area_triangles == 2);
  REQUIRE(r.duplicate_faces == 1);
  REQUIRE(r.flat_boxes == 1);
}
