#include "scenes.hpp"
#include "support/catch.hpp"
#include "visibility/evidence/ray_scene.hpp"
#include "visibility/evidence/witness.hpp"
#include "visibility/methods/sampling/method.hpp"

using namespace visibility;
using test::boxes;
using Ids = std::vector<std::uint32_t>;

namespace {

ViewCell const unit_cell(Box{{0, 0, 0}, {1, 1, 1}});

PotentiallyVisibleSet sample(test::TestScene const& s, ViewCell const& cell, std::uint64_t rays = 200'000,
                             std::uint64_t seed = 1, int threads = 1)
{
  auto result = Sampling({rays, 0, seed, threads})(*s.prepared, cell);
  for (auto const& w : result.witnesses) REQUIRE(confirm(*s.prepared, cell, w));
  return result;
}

}  // namespace

TEST_CASE("sampling: an object behind one wall is hidden, one beside it is found", "[evidence]")
{
  auto const s = boxes({Box{{5, -50, -50}, {6, 50, 50}}, Box{{9, 0, 0}, {10, 1, 1}}, Box{{0, 9, 0}, {1, 10, 1}}});
  CHECK(sample(s, unit_cell).visible == Ids{0, 2});
}

TEST_CASE("sampling: an object in a closed room is hidden", "[evidence]")
{
  auto const s = boxes({Box{{8, 0, 0}, {9, 1, 1}},  // inside the room
                        Box{{5, -5, -5}, {6, 6, 6}}, Box{{11, -5, -5}, {12, 6, 6}}, Box{{5, -5, -5}, {12, -4, 6}},
                        Box{{5, 5, -5}, {12, 6, 6}}, Box{{5, -5, -5}, {12, 6, -4}}, Box{{5, -5, 5}, {12, 6, 6}}});
  auto const seen = sample(s, unit_cell).visible;
  CHECK(std::ranges::find(seen, 0U) == seen.end());
  CHECK(std::ranges::find(seen, 1U) != seen.end());
}

TEST_CASE("sampling: what meets the cell is listed without a witness; what is nested in a solid is not", "[evidence]")
{
  auto const s = boxes({Box{{1, 1, 1}, {2, 2, 2}}, Box{{5, 0, 0}, {8, 3, 3}}, Box{{6, 1, 1}, {7, 2, 2}}});
  auto const r = sample(s, unit_cell);
  CHECK(r.visible == Ids{0, 1});
  CHECK(r.statistics.at("touching") == 1);
  CHECK(r.witnesses.size() == 1);
}

TEST_CASE("sampling: coinciding boxes are all found", "[evidence][degenerate]")
{
  Box const b{{5, 0, 0}, {6, 1, 1}};
  CHECK(sample(boxes({b, b, b}), unit_cell).visible == Ids{0, 1, 2});
}

TEST_CASE("sampling: abutting walls hide what lies behind their joint", "[evidence][degenerate]")
{
  auto const s = boxes({Box{{9, 0, 0}, {10, 1, 1}}, Box{{5, -50, -50}, {6, 0.5, 50}}, Box{{5, 0.5, -50}, {6, 50, 50}}});
  CHECK(sample(s, unit_cell).visible == Ids{1, 2});
}

TEST_CASE("sampling: a gap of a millimetre is found", "[evidence][hard]")
{
  for (double const depth : {0.1, 1.0, 10.0}) {
    auto const s = boxes({Box{{30, -5, -5}, {31, 6, 6}}, Box{{5, -90, -90}, {5 + depth, 0.3, 90}},
                          Box{{5, 0.301, -90}, {5 + depth, 90, 90}}});
    CAPTURE(depth);
    CHECK(sample(s, unit_cell, 500'000).visible == Ids{0, 1, 2});
  }
}

TEST_CASE("sampling: every kind of object is found", "[evidence]")
{
  SceneBuilder b("kinds");
  b.begin_object("box"), b.add(Box{{5, 0, 0}, {6, 1, 1}});
  b.begin_object("ball"), b.add(Ball{{-5, 0, 0}, 1});
  b.begin_object("prism"), b.add(Prism{{{{0, 5}, {1, 5.5}, {0, 7}}}, 0, 2});
  b.begin_object("bow tie"),
    b.add(Prism{{{{0, -5}, {2, -7}, {2, -5}, {0, -7}}}, 0, 2});  // occludes nothing, yet is there
  b.begin_object("polyhedron"),
    b.add(ConvexPolyhedron::hull(std::vector<Point3d>{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {0, 0, 6}}));
  b.begin_object("triangle");
  b.add_triangle(b.add_vertex({0, 0, -5}), b.add_vertex({1, 0, -5.5}), b.add_vertex({0, 1, -6}));
  b.begin_object("behind the bow tie"), b.add(Box{{0, -12, 0}, {1, -11, 1}});
  test::TestScene const s(b.finish());
  CHECK(sample(s, unit_cell).visible == Ids{0, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("sampling: a cell that is no box samples its own interior only", "[evidence]")
{
  ViewCell const cell = ViewCell::hull(std::vector<Point3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  auto const s = boxes({Box{{5, 0, 0}, {6, 1, 1}}, Box{{9, 0, 0}, {10, 1, 1}}});
  auto const r = sample(s, cell);
  CHECK(r.visible == Ids{0});  // from the corner (1, 1, 1) of the cell's box one would see past
}

TEST_CASE("sampling: the same seed gives the same result on any number of threads", "[evidence][law]")
{
  auto const s = boxes(test::box_city(12, 7));
  auto const cell = test::street_cell(12);
  auto const a = sample(s, cell, 100'000, 3, 1), b = sample(s, cell, 100'000, 3, 1), c = sample(s, cell, 100'000, 3, 2);
  CHECK(a.visible == b.visible);
  CHECK(a.visible == c.visible);
  CHECK(a.statistics == b.statistics);
  CHECK(a.statistics == c.statistics);
  REQUIRE(a.witnesses.size() == c.witnesses.size());
  for (std::size_t i = 0; i < a.witnesses.size(); ++i) {
    CHECK(a.witnesses[i].from == c.witnesses[i].from);
    CHECK(a.witnesses[i].to == c.witnesses[i].to);
  }
}

TEST_CASE("sampling: far from the origin the same city gives nearly the same set", "[evidence][hard]")
{
  auto const reference = sample(boxes(test::box_city(10, 4)), test::street_cell(10), 300'000).visible;
  for (double const offset : {0x1p20, 0x1p23, 0x1p26}) {
    auto const far = sample(boxes(test::box_city(10, 4, offset)), test::street_cell(10, offset), 300'000).visible;
    CAPTURE(offset);
    CHECK(std::abs(static_cast<int>(far.size()) - static_cast<int>(reference.size())) <= 2);
  }
}

TEST_CASE("sampling: a time limit ends the search", "[evidence]")
{
  auto const s = boxes(test::box_city(10, 4));
  auto const r = Sampling({std::uint64_t{1} << 40, 0.2, 1, 1})(*s.prepared, test::street_cell(10));
  CHECK(r.visible.size() > 10);
}
