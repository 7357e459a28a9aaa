#include "scenes.hpp"
#include "support/catch.hpp"
#include "visibility/evidence/check.hpp"
#include "visibility/evidence/sight_line.hpp"
#include "visibility/evidence/witness.hpp"
#include "visibility/methods/sampling/method.hpp"

#include <set>

using namespace visibility;

namespace {

ViewCell const cell(Box{{0, 0, 0}, {1, 1, 1}});

/// Unit boxes on the grid in front of the cell, with some doubled and some abutting.
std::vector<Box> grid_boxes(test::Random& random)
{
  std::vector<Box> out;
  int const n = random.between(4, 12);
  for (int i = 0; i < n; ++i) {
    Point3d const p{double(random.between(2, 5)), double(random.between(-1, 1)), double(random.between(-1, 1))};
    out.push_back({p, {p.x + 1, p.y + random.between(1, 2), p.z + random.between(1, 2)}});
  }
  return out;
}

/// Every line from a grid of origins to a grid of points on all faces, each decided by rationals: what it lists is
/// visible, and in such small scenes it lists all.
std::set<std::uint32_t> brute_force(PreparedScene const& scene)
{
  std::set<std::uint32_t> visible;
  std::vector<Point3d> origins;
  for (double x : {0.03, 0.99})
    for (double y : {0.02, 0.35, 0.66, 0.97})
      for (double z : {0.02, 0.37, 0.64, 0.97}) origins.push_back({x, y, z});
  auto const& boxes = scene.scene().boxes;
  for (std::uint32_t id = 0; id < boxes.size(); ++id)
    for (std::uint32_t part = 0; part < 6 && !visible.contains(id); ++part)
      for (double s = 1; s < 24 && !visible.contains(id); ++s)
        for (double t = 1; t < 24 && !visible.contains(id); ++t) {
          Box const& b = boxes[id];
          auto const at = [](double lo, double hi, double u) { return lo + (hi - lo) * u / 24; };
          Point3d p{at(b.min.x, b.max.x, s), at(b.min.y, b.max.y, part / 2 == 0 ? s : t), at(b.min.z, b.max.z, t)};
          (part / 2 == 0   ? p.x
           : part / 2 == 1 ? p.y
                           : p.z) = std::array{b.min.x, b.max.x, b.min.y, b.max.y, b.min.z, b.max.z}[part];
          for (auto const& o : origins)
            if (!blocker<Filtered>(scene, o, p)) {
              visible.insert(id);
              break;
            }
        }
  return visible;
}

}  // namespace

TEST_CASE("sampling finds what exhaustive exact lines find, and nothing that has no proof", "[evidence][oracle]")
{
  int hidden = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    auto const s = test::boxes(grid_boxes(random));
    auto const truth = brute_force(*s.prepared);
    auto const r = Sampling({100'000, 0, seed, 0})(*s.prepared, cell);
    hidden += static_cast<int>(s.scene->objects.size() - truth.size());
    for (auto const id : truth) {
      CAPTURE(id);
      CHECK(std::ranges::binary_search(r.visible, id));
    }
    REQUIRE(r.witnesses.size() == r.visible.size());
    for (std::size_t i = 0; i < r.visible.size(); ++i) {
      CHECK(r.witnesses[i].object == r.visible[i]);
      CHECK(confirm(*s.prepared, cell, r.witnesses[i]));
    }
  }
  CHECK(hidden > 20);
}

TEST_CASE("sight line: filtered, filtered rational and rational arithmetic agree", "[evidence][law]")
{
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    SceneBuilder b("mixed");
    b.begin_object("boxes");
    for (auto const& box : grid_boxes(random)) b.add(box);
    b.add(Ball{{4, 0, 0}, 1});
    b.begin_object("prism");
    b.add(Prism{{{{3, 0}, {4, 2}, {3.5, 3}, {2, 1}}}, 0, 1});
    b.begin_object("leaf");
    b.add_triangle(b.add_vertex(random.grid_point(2, 6)), b.add_vertex(random.grid_point(-1, 4)),
                   b.add_vertex(random.grid_point(-1, 4)));
    test::TestScene const s(b.finish());
    for (int i = 0; i < 20; ++i) {
      Point3d const p = i % 2 == 0 ? random.point(0, 1) : random.grid_point(0, 1), q = random.grid_point(-2, 8);
      if (p == q) continue;
      Point3q const pq = exact(p), qq = exact(q);
      bool const reference = blocker<Rational>(*s.prepared, pq, qq).has_value();
      blocked += reference;
      CHECK(blocker<Filtered>(*s.prepared, p, q).has_value() == reference);
      CHECK(blocker<FilteredRational>(*s.prepared, enclosed(pq), enclosed(qq)).has_value() == reference);
    }
  }
  CHECK(blocked > 200);
}
