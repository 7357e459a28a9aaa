#include "visibility/scene/convex_cover.hpp"

#include "meshes.hpp"
#include "scene/convex_growth.hpp"
#include "support/catch.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

using NT = RationalNumber;
using Exact = std::vector<Point2q>;

NT doubled_area(Exact const& ring)
{
  NT sum(0);
  for (std::size_t i = 0, n = ring.size(); i < n; ++i)
    sum += ring[i].x * ring[(i + 1) % n].y - ring[(i + 1) % n].x * ring[i].y;
  return sum;
}

Exact exact_ring(Ring const& ring)
{
  Exact out;
  for (auto const& p : ring) out.push_back({NT(p.x), NT(p.y)});
  return out;
}

/// Sutherland and Hodgman in rationals: the part of one convex polygon in another.
Exact common(Exact subject, Exact const& clip)
{
  for (std::size_t i = 0, n = clip.size(); i < n; ++i) {
    auto const &a = clip[i], &b = clip[(i + 1) % n];
    auto const side = [&](Point2q const& p) -> NT { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
    Exact kept;
    for (std::size_t j = 0; j < subject.size(); ++j) {
      auto const &p = subject[j], &q = subject[(j + 1) % subject.size()];
      NT const fp = side(p), fq = side(q);
      if (fp >= 0) kept.push_back(p);
      if ((fp > 0 && fq < 0) || (fp < 0 && fq > 0)) {
        NT const t = fp / (fp - fq);
        kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
      }
    }
    subject = std::move(kept);
  }
  return subject;
}

/// Whether the piece lies in the prism's polygon: the disjoint pieces of the partition cut it without loss.
void require_inside(ConvexPrism const& piece, std::vector<ConvexPrism> const& partition)
{
  piece.validate();
  NT covered(0);
  for (auto const& p : partition) covered += doubled_area(common(exact_ring(piece.footprint), exact_ring(p.footprint)));
  REQUIRE(covered == doubled_area(exact_ring(piece.footprint)));
}

double area(Ring const& ring) { return CGAL::to_double(doubled_area(exact_ring(ring))) / 2; }

}  // namespace

TEST_CASE("convex cover: an L is its two bars", "[scene]")
{
  auto const cover = convex_cover({{plan_of(0)}, 1, 5});
  REQUIRE(cover.size() == 2);
  for (auto const& k : cover) {
    Box const b = bounding_box(k);
    CHECK(k.footprint.size() == 4);
    CHECK((b == Box{{0, 0, 1}, {20, 8, 5}} || b == Box{{0, 0, 1}, {8, 20, 5}}));
  }
  CHECK(bounding_box(cover[0]) != bounding_box(cover[1]));
}

TEST_CASE("convex cover: every piece lies inside the footprint, exactly", "[scene][law][conservative]")
{
  double gained = 0;
  for (int seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    Ring ring = seed % 3 == 0 ? star(random, random.between(5, 30), 20, 100) : plan_of(seed % plan_kinds);
    ring = turned(ring, random.uniform(0, 6), random.uniform(-1e5, 1e5), random.uniform(-1e5, 1e5));
    Prism prism{{ring}, 0, 1};
    if (seed % 6 == 0) {
      Point2d const c{random.uniform(-2, 2), random.uniform(-2, 2)};
      Ring const hole = star(random, random.between(3, 9), 1, 5);
      Ring moved;
      Point2d middle{0, 0};
      for (auto const& p : ring) middle = {middle.x + p.x / double(ring.size()), middle.y + p.y / double(ring.size())};
      for (auto const& p : hole) moved.push_back({middle.x + c.x + p.x, middle.y + c.y + p.y});
      prism.rings.push_back(moved);
    }
    auto const partition = convex_partition(prism);
    if (partition.size() < 2) continue;
    auto const cover = convex_cover(prism);
    REQUIRE_FALSE(cover.empty());
    for (auto const& k : cover) require_inside(k, partition);
    double largest = 0;
    for (auto const& k : partition) largest = std::max(largest, area(k.footprint));
    CHECK(area(cover[0].footprint) > 0.999 * largest);
    gained += area(cover[0].footprint) / largest - 1;
  }
  CHECK(gained > 3);
}

TEST_CASE("convex cover: nothing to add to a convex footprint, nothing from an invalid one", "[scene][degenerate]")
{
  CHECK(convex_cover({{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, 0, 1}).empty());
  CHECK(convex_cover({{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}, 0, 1}).empty());
  CHECK(convex_cover({{plan_of(0)}, 1, 1}).empty());
  CHECK(convex_cover({{plan_of(4)}, 0, 1}, 1).size() == 1);
}

TEST_CASE("convex cover: a court is avoided", "[scene]")
{
  Prism const prism{{{{0, 0}, {30, 0}, {30, 30}, {0, 30}}, {{10, 10}, {20, 10}, {20, 20}, {10, 20}}}, 0, 9};
  auto const partition = convex_partition(prism);
  auto const cover = convex_cover(prism);
  REQUIRE(cover.size() >= 4);
  for (auto const& k : cover) require_inside(k, partition);
  CHECK(area(cover[0].footprint) >= 300);
}

TEST_CASE("convex cover: a polygon that meets no edge is inside or outside by parity", "[scene][degenerate]")
{
  // A square with a square hole, and an L; candidates in every cell of the plane they make.
  Ring const outer{{0, 0}, {12, 0}, {12, 12}, {0, 12}}, hole{{4, 4}, {4, 8}, {8, 8}, {8, 4}};
  std::vector<Ring> const frame{outer, hole}, corner{plan_of(0)};
  auto const square = [](double x, double y, double side) {
    return Ring{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  };
  using detail::lies_inside;
  REQUIRE(lies_inside(frame, square(1, 1, 2)));
  REQUIRE(lies_inside(frame, square(0, 0, 4)));  // fills a corner between the walls
  REQUIRE_FALSE(lies_inside(frame, square(5, 5, 2)));
  REQUIRE_FALSE(lies_inside(frame, square(4, 4, 4)));  // fills the hole
  REQUIRE_FALSE(lies_inside(frame, square(13, 1, 2)));
  REQUIRE_FALSE(lies_inside(frame, square(12, 0, 12)));  // leans on a wall from outside
  REQUIRE_FALSE(lies_inside(frame, square(2, 2, 4)));
  REQUIRE(lies_inside(corner, square(0, 0, 8)));
  REQUIRE_FALSE(lies_inside(corner, square(8, 8, 12)));  // fills the notch
  REQUIRE_FALSE(lies_inside(corner, square(-5, -5, 3)));
}
