#pragma once

#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/segment_oracle.hpp"
#include "support/trials.hpp"
#include "visibility/kernel/arithmetic.hpp"

#include <cmath>
#include <vector>

namespace visibility::test {

/// Bodies are made of even integers times a power of two, so that vertices, midpoints of edges and faces, and points
/// collinear with them are all doubles: from the smallest subnormal to the overflow threshold.
inline constexpr std::array scales{1.0, 0x1p-1074, 0x1p-600, 0x1p300, 0x1p1000};

inline Point3d scaled(Point3d const& p, double s) { return {p.x * s, p.y * s, p.z * s}; }

/// What the queries of one test reached.
struct Reached {
  int queries = 0, met = 0, missed = 0;
  int touched_by_end = 0;  ///< the closed segment meets the body, the half-open one does not
};

/// An end of a segment that stands in a special position to the vertices: on one, between two or three of them, on the
/// line of two beyond them, on the plane of three; or anywhere near.
inline Point3d special_point(std::vector<Point3d> const& v, Random& random, double scale)
{
  auto const any = [&] { return v[static_cast<std::size_t>(random.below(static_cast<int>(v.size())))]; };
  Point3d const a = any(), b = any(), c = any();
  auto const combine = [&](double i, double j, double k) {
    return Point3d{i * a.x + j * b.x + k * c.x, i * a.y + j * b.y + k * c.y, i * a.z + j * b.z + k * c.z};
  };
  switch (random.below(8)) {
  case 0: return a;
  case 1: return combine(0.5, 0.5, 0);
  case 2: return combine(2, -1, 0);
  case 3: return combine(-1, 1, 1);
  case 4: return combine(1.5, -0.5, 0);
  case 5: return combine(0.5, 1, -0.5);
  default: {
    Point3d const p = random.grid_point(-24, 24);
    return scaled(p, scale);
  }
  }
}

/// Requires Filtered == Rational == oracle for closed and half-open segments with ends in special positions.
template <class Body>
void check_segments(Body const& body, std::vector<Point3d> const& landmarks, Random& random, double scale, int count,
                    Reached& reached)
{
  for (int i = 0; i < count; ++i) {
    Point3d p = special_point(landmarks, random, scale), q = special_point(landmarks, random, scale);
    if (random.chance(0.2)) p.x = std::nextafter(p.x, q.x);
    if (random.chance(0.2)) q.y = std::nextafter(q.y, p.y);
    if (p == q || !is_finite(p) || !is_finite(q)) continue;
    CAPTURE(p.x, p.y, p.z, q.x, q.y, q.z, scale);
    bool const closed = oracle::meets(body, p, q, End::included), half_open = oracle::meets(body, p, q, End::excluded);
    REQUIRE(segment_meets<Filtered>(body, p, q) == closed);
    REQUIRE(segment_meets<Filtered, End::excluded>(body, p, q) == half_open);
    REQUIRE(segment_meets<Filtered>(body, q, p) == closed);
    Point3q const P = exact(p), Q = exact(q);
    REQUIRE(segment_meets<Rational>(body, P, Q) == closed);
    REQUIRE(segment_meets<Rational, End::excluded>(body, P, Q) == half_open);
    ++reached.queries;
    closed ? ++reached.met : ++reached.missed;
    reached.touched_by_end += closed && !half_open;
  }
}

inline void require_reached(Reached const& r)
{
  REQUIRE(r.met > r.queries / 20);
  REQUIRE(r.missed > r.queries / 20);
  REQUIRE(r.touched_by_end > r.queries / 200);
}

inline Point3d even_point(Random& random, int reach)
{
  return {2.0 * random.between(-reach, reach), 2.0 * random.between(-reach, reach),
          2.0 * random.between(-reach, reach)};
}

inline std::vector<Point3d> landmarks(Box const& b)
{
  auto const c = b.corners();
  return {c.begin(), c.end()};
}
inline std::vector<Point3d> landmarks(ConvexPolyhedron const& p) { return p.vertices; }
inline std::vector<Point3d> landmarks(ConvexPrism const& p)
{
  std::vector<Point3d> v;
  for (auto const& f : p.footprint)
    for (double z : {p.bottom, p.top}) v.push_back({f.x, f.y, z});
  return v;
}
inline std::vector<Point3d> landmarks(Triangle const& t) { return {t.vertices.begin(), t.vertices.end()}; }

}  // namespace visibility::test
