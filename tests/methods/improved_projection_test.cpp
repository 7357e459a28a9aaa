#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/geometry/segment_polyhedron.hpp"
#include "visibility/methods/extended_projection/projection_map.hpp"

using namespace visibility;
using namespace visibility::test;
using namespace visibility::extended_projection;

namespace {

/// A long cell, a plane at w = 20 and a box before it, to the side: frames[4] is (x, y, z) itself.
Box const long_cell{{-1, -1, -100}, {1, 1, 0}}, object{{10, 10, 10}, {50, 50, 10.5}};
constexpr double plane = 20;

double view_of(double c, double cw, double p, double w) { return c + (p - c) * (plane - cw) / (w - cw); }

/// The paper's 2D improved Projection: intersections of the supporting lines of the profiles with the plane.
std::pair<double, double> supporting(double low, double high)
{
  double a = -HUGE_VAL, b = HUGE_VAL;
  for (double const cw : {-100.0, 0.0}) {
    double a_of_eye = HUGE_VAL, b_of_eye = -HUGE_VAL;
    for (double const w : {object.min.z, object.max.z}) {
      a_of_eye = std::min(a_of_eye, view_of(-1, cw, low, w));
      b_of_eye = std::max(b_of_eye, view_of(1, cw, high, w));
    }
    a = std::max(a, a_of_eye);
    b = std::min(b, b_of_eye);
  }
  return {a, b};
}

/// A thin convex plate around w = `at` which contains all that lies, at w = at, in a cone from the cell to the
/// rectangle [low, high]^2 of the plane.
ConvexPolyhedron plate(double low, double high, double at)
{
  std::vector<Point3d> points;
  for (double const cw : {-100.0, -50.0, 0.0})
    for (int i = 0; i < 16; ++i) {
      double const t = (plane - at) / (plane - cw);
      auto const blend = [&](bool far, bool high_c) {
        return (1 - t) * (far ? high : low) + t * (high_c ? 1.0 : -1.0);
      };
      double const x = blend((i & 1) != 0, (i & 2) != 0), y = blend((i & 4) != 0, (i & 8) != 0);
      // A little larger, so that rounding does not matter.
      double const middle = (low + high) / 4;
      points.push_back({x + (x > middle ? 0.001 : -0.001), y + (y > middle ? 0.001 : -0.001), at - 0.001});
      points.push_back({points.back().x, points.back().y, at});
    }
  return ConvexPolyhedron::hull(points);
}

bool sees(Point3d const& from, Point3d const& to, ConvexPolyhedron const& occluder)
{
  return !segment_meets<Rational>(occluder, from, to);
}

}  // namespace

TEST_CASE("the paper's improved Projection hides a corner that is seen; ours does not", "[methods][conservative]")
{
  auto const [low, high] = supporting(object.min.x, object.max.x);
  REQUIRE(low < high);
  auto const occluder = plate(low, high, 9.99);

  // All of the paper's improved Projection is in the Projection of the plate: its corners are, from every vertex.
  ViewCell const cell(long_cell);
  for (double const x : {low, high})
    for (double const y : {low, high})
      for (auto const& c : cell.vertices()) REQUIRE(!sees(c, {x, y, plane}, occluder));
  // And the plate is nearer than the object; but the cell sees a corner of it.
  Point3d const corner{object.min.x, object.max.y, object.min.z};
  bool seen = false;
  for (auto const& c : cell.vertices()) seen = seen || sees(c, corner, occluder);
  REQUIRE(seen);

  CellViews const views(frames[4], cell);
  ProjectionMap map(views, plane, Grid::covering({-50, -50}, {150, 150}, 1024, 1024));
  ConvexPart part;
  for (auto const& v : occluder.vertices) part.push_back({v});
  REQUIRE(map.add(part) > 0);
  REQUIRE(!map.hides_improved(object));
}

TEST_CASE("the improved Projection hides what the plain one does not, and only what is hidden", "[methods][law]")
{
  int improved = 0, plain = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    ViewCell const cell(Box{{-1, -1, -random.uniform(0.1, 9)}, {1, 1, 0}});
    CellViews const views(frames[4], cell);
    double const at = random.uniform(2, 10), plane_at = random.uniform(at, 20);
    ProjectionMap map(views, plane_at, Grid::covering({-60, -60}, {60, 60}, 512, 512));
    std::vector<Point3d> points;
    for (int i = random.between(4, 9); i > 0; --i)
      points.push_back({random.uniform(-5, 5), random.uniform(-5, 5), at - 0.01 * random.unit()});
    auto const occluder = ConvexPolyhedron::hull(points);
    ConvexPart part;
    for (auto const& v : occluder.vertices) part.push_back({v});
    map.add(part);
    Point3d const low{random.uniform(-3, 3), random.uniform(-3, 3), at + (plane_at - at) * random.uniform(0.01, 0.9)};
    Box const box{
      low, {low.x + random.uniform(0, 2), low.y + random.uniform(0, 2), low.z + (plane_at - low.z) * random.unit()}};
    plain += map.hides(box);
    if (!map.hides(box) && !map.hides_improved(box)) continue;
    improved += map.hides_improved(box);
    for (auto const& c : cell.vertices())
      for (auto const& s : box.corners()) REQUIRE(!sees(c, s, occluder));
  }
  CAPTURE(plain, improved);
  REQUIRE(plain > trials(4));
  REQUIRE(improved > plain);
}
