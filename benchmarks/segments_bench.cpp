/// Segment against box, prism, polyhedron, triangle and ball, per arithmetic.
///
/// One body of each kind within [-10, 10]^3 and 512 segments per family, seed 2:
///   random   both ends uniform in [-20, 20)^3
///   zero     ends at vertices, at midpoints of two of them, and beyond them on their lines: exact contact is the rule
/// Counters as in predicates_bench.cpp; the layer counts are signs per segment.
#include "harness.hpp"
#include "support/random.hpp"
#include "visibility/geometry/segment_ball.hpp"
#include "visibility/geometry/segment_box.hpp"
#include "visibility/geometry/segment_polyhedron.hpp"
#include "visibility/geometry/segment_prism.hpp"
#include "visibility/geometry/segment_triangle.hpp"

using namespace visibility;
using namespace visibility::bench;

namespace {

constexpr int count = 512;
constexpr std::uint64_t seed = 2;

struct Segment {
  Point3d p, q;
};

std::vector<Segment> random_segments()
{
  test::Random random(seed);
  std::vector<Segment> segments;
  for (int i = 0; i < count; ++i) segments.push_back({random.point(-20, 20), random.point(-20, 20)});
  return segments;
}

std::vector<Segment> touching_segments(std::vector<Point3d> const& vertices)
{
  test::Random random(seed);
  auto const special = [&] {
    auto const any = [&] {
      return vertices[static_cast<std::size_t>(random.below(static_cast<int>(vertices.size())))];
    };
    Point3d const a = any(), b = any();
    double const t = 0.5 * random.between(-3, 3);
    return Point3d{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
  };
  std::vector<Segment> segments;
  while (segments.size() < count) {
    Segment const s{special(), special()};
    if (s.p != s.q) segments.push_back(s);
  }
  return segments;
}

template <class Body>
void add_body(std::string const& name, Body const& body, std::vector<Point3d> const& vertices)
{
  auto const ask = [body]<class A>(Segment const& s) { return segment_meets<A, End::excluded>(body, s.p, s.q); };
  for (auto const& [family, segments] :
       {std::pair("random", random_segments()), std::pair("zero", touching_segments(vertices))}) {
    add<Double>("segment_" + name, family, segments, ask);
    add<Filtered>("segment_" + name, family, segments, ask);
    add<Rational>("segment_" + name, family, segments, ask);
  }
}

}  // namespace

int main(int argc, char** argv)
{
  Box const box{{-10, -8, -6}, {10, 7, 9}};
  auto const corners = box.corners();
  add_body("box", box, {corners.begin(), corners.end()});

  ConvexPrism const prism{{{-8, -6}, {6, -10}, {10, 4}, {2, 10}, {-10, 6}}, 0, 10};
  std::vector<Point3d> vertices;
  for (auto const& v : prism.footprint)
    vertices.insert(vertices.end(), {{v.x, v.y, prism.bottom}, {v.x, v.y, prism.top}});
  add_body("prism", prism, vertices);
  auto const polyhedron = ConvexPolyhedron::hull(vertices);
  add_body("polyhedron", polyhedron, polyhedron.vertices);

  Triangle const triangle{{Point3d{-10, -8, 1}, {9, -7, 4}, {2, 10, -6}}};
  add_body("triangle", triangle, {triangle.vertices.begin(), triangle.vertices.end()});

  std::vector<Point3d> on_sphere;
  for (double const x : {-4.0, 4.0})
    for (double const y : {-6.0, 6.0}) on_sphere.insert(on_sphere.end(), {{x, y, 12}, {x, y, -12}, {x, 12, y}});
  add_body("ball", Ball{{0, 0, 0}, 14}, on_sphere);
  return run(argc, argv);
}
