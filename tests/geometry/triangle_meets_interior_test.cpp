#include "visibility/geometry/triangle_meets_interior.hpp"

#include "segment_checks.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

using oracle::Vec;

/// Clips the triangle by closed half-spaces in rationals; shares no code with the library.
class ClippedTriangle {
public:
  explicit ClippedTriangle(Triangle const& t)
  {
    for (auto const& v : t.vertices) polygon_.push_back(oracle::vec(v));
  }
  /// Keeps the points with n.(x - a) <= 0.
  void below(Vec const& n, Vec const& a)
  {
    sides_.push_back({n, a});
    std::vector<Vec> kept;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      Vec const &p = polygon_[i], &q = polygon_[(i + 1) % polygon_.size()];
      oracle::NT const fp = value(n, a, p), fq = value(n, a, q);
      if (fp <= 0) kept.push_back(p);
      if ((fp < 0 && fq > 0) || (fp > 0 && fq < 0)) {
        oracle::NT const s = fp / (fp - fq);
        kept.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)});
      }
    }
    polygon_ = std::move(kept);
  }
  /// Whether some point is strictly below all: then the mean of the clipped polygon's vertices is.
  bool has_strict_point() const
  {
    if (polygon_.empty()) return false;
    Vec mean{0, 0, 0};
    for (auto const& p : polygon_) mean = {mean.x + p.x, mean.y + p.y, mean.z + p.z};
    oracle::NT const n(static_cast<int>(polygon_.size()));
    mean = {mean.x / n, mean.y / n, mean.z / n};
    return std::ranges::all_of(sides_, [&](auto const& s) { return value(s.first, s.second, mean) < 0; });
  }

private:
  static oracle::NT value(Vec const& n, Vec const& a, Vec const& p) { return oracle::dot(n, oracle::minus(p, a)); }

  std::vector<Vec> polygon_;
  std::vector<std::pair<Vec, Vec>> sides_;
};

bool oracle_meets_interior(Triangle const& t, ConvexPrism const& k)
{
  ClippedTriangle clip(t);
  clip.below({0, 0, 1}, {0, 0, oracle::NT(k.top)});
  clip.below({0, 0, -1}, {0, 0, oracle::NT(k.bottom)});
  for (std::size_t i = 0, n = k.footprint.size(); i < n; ++i) {
    Vec const a = oracle::vec({k.footprint[i].x, k.footprint[i].y, 0}),
              b = oracle::vec({k.footprint[(i + 1) % n].x, k.footprint[(i + 1) % n].y, 0});
    clip.below({b.y - a.y, a.x - b.x, 0}, a);
  }
  return clip.has_strict_point();
}

bool oracle_meets_interior(Triangle const& t, ConvexPolyhedron const& k)
{
  ClippedTriangle clip(t);
  for (auto const& f : k.facets) {
    auto const v = [&](int i) { return oracle::vec(k.vertices[f.vertices[static_cast<std::size_t>(i)]]); };
    clip.below(oracle::cross(oracle::minus(v(1), v(0)), oracle::minus(v(2), v(0))), v(0));
  }
  return clip.has_strict_point();
}

/// A triangle that touches, lines up with or slightly misses the body: corners in special positions, some degenerate.
Triangle special_triangle(std::vector<Point3d> const& landmarks, Random& random, double scale)
{
  Triangle t;
  for (auto& v : t.vertices) v = special_point(landmarks, random, scale);
  if (random.chance(0.1)) t.vertices[2] = t.vertices[0];
  if (random.chance(0.05)) t.vertices[1] = t.vertices[2];
  if (random.chance(0.1)) {  // collinear
    auto const &a = t.vertices[0], &b = t.vertices[1];
    t.vertices[2] = {2 * b.x - a.x, 2 * b.y - a.y, 2 * b.z - a.z};
  }
  if (random.chance(0.15)) t.vertices[2].z = t.vertices[0].z;
  if (random.chance(0.15)) t.vertices[1] = {t.vertices[0].x, t.vertices[0].y, t.vertices[1].z};
  if (random.chance(0.2)) t.vertices[1].x = std::nextafter(t.vertices[1].x, t.vertices[2].y);
  return t;
}

struct Count {
  int met = 0, disjoint = 0, touching = 0;
};

/// Requires Filtered == Rational == oracle, for every order of the corners.
template <class Body>
void check(Body const& body, Random& random, double scale, int count, Count& reached)
{
  for (int i = 0; i < count; ++i) {
    Triangle t = special_triangle(landmarks(body), random, scale);
    if (!std::ranges::all_of(t.vertices, [](Point3d const& p) { return is_finite(p); })) continue;
    CAPTURE(t.vertices[0].x, t.vertices[0].y, t.vertices[0].z, t.vertices[1].x, t.vertices[1].y, t.vertices[1].z);
    CAPTURE(t.vertices[2].x, t.vertices[2].y, t.vertices[2].z, scale);
    bool const expected = oracle_meets_interior(t, body);
    REQUIRE(meets_interior<Filtered>(t, body) == expected);
    REQUIRE(meets_interior<Rational>(t, body) == expected);
    std::swap(t.vertices[static_cast<std::size_t>(random.below(3))], t.vertices[0]);
    REQUIRE(meets_interior<Filtered>(t, body) == expected);
    expected ? ++reached.met : ++reached.disjoint;
    auto const &a = t.vertices[0], &b = t.vertices[1];
    reached.touching += !expected && a != b && oracle::meets(body, a, b, End::included);
  }
}

void require_reached(Count const& n)
{
  REQUIRE(n.met > 200);
  REQUIRE(n.disjoint > 200);
  REQUIRE(n.touching > 50);
}

constexpr std::array tested_scales{1.0, 0x1p-1074, 0x1p300, 0x1p1000};

}  // namespace

TEST_CASE("triangle meets interior: of a prism, agrees with exact clipping in special positions, at all scales",
          "[geometry][oracle][degenerate]")
{
  static std::vector<std::vector<Point2d>> const shapes{
    {{0, 0}, {8, 0}, {2, 6}},
    {{-6, -4}, {6, -4}, {6, 8}, {-6, 8}},
    {{0, 0}, {4, 0}, {8, 0}, {8, 4}, {4, 8}, {0, 8}},
    {{-8, -2}, {-2, -8}, {4, -8}, {8, -2}, {8, 4}, {2, 8}, {-4, 8}, {-8, 4}},
    {{0, 0}, {2, 0}, {10, 10}, {8, 10}}};
  Random random(71);
  Count reached;
  for (double const scale : tested_scales)
    for (int i = 0; i < trials(30); ++i) {
      ConvexPrism k{shapes[static_cast<std::size_t>(random.below(5))], 2.0 * random.between(-6, 0) * scale,
                    2.0 * random.between(1, 6) * scale};
      for (auto& p : k.footprint) p = {p.x * scale, p.y * scale};
      k.validate();
      check(k, random, scale, 20, reached);
    }
  require_reached(reached);
}

TEST_CASE("triangle meets interior: of a polyhedron, agrees with exact clipping in special positions, at all scales",
          "[geometry][oracle][degenerate]")
{
  Random random(72);
  Count reached;
  for (double const scale : tested_scales)
    for (int i = 0; i < trials(25); ++i) {
      std::vector<Point3d> points;
      for (int j = random.between(4, 8); j > 0; --j) points.push_back(even_point(random, 6));
      if (random.chance(0.5))  // faces with more than three vertices
        for (std::size_t j = 0, n = points.size(); j < n; ++j) points.push_back({points[j].x, points[j].y, 14});
      for (auto& p : points) p = scaled(p, scale);
      ConvexPolyhedron k;
      try {
        k = ConvexPolyhedron::hull(points);
      } catch (std::invalid_argument const&) {
        continue;  // all points in one plane
      }
      check(k, random, scale, 20, reached);
    }
  require_reached(reached);
}

TEST_CASE("triangle meets interior: walls, floors and edges of the body only touch", "[geometry][degenerate]")
{
  ConvexPrism const prism{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 0, 4};
  auto const cube = ConvexPolyhedron::from_box({{0, 0, 0}, {4, 4, 4}});
  auto const both = [&](Triangle const& t) {
    bool const meets = meets_interior<Filtered>(t, prism);
    CHECK(meets_interior<Filtered>(t, cube) == meets);
    return meets;
  };
  CHECK_FALSE(both({{{{0, 0, 0}, {4, 0, 0}, {4, 0, 4}}}}));      // in a wall
  CHECK_FALSE(both({{{{-9, -9, 4}, {9, -9, 4}, {0, 30, 4}}}}));  // the roof and more
  CHECK_FALSE(both({{{{-2, 2, -2}, {2, -2, -2}, {0, 0, 9}}}}));  // touches a vertical edge
  CHECK_FALSE(both({{{{4, 0, 8}, {4, 4, 8}, {8, 2, 0}}}}));      // passes over the edge of the roof
  CHECK_FALSE(both({{{{2, -2, 6}, {-2, 2, 6}, {-2, -2, 1}}}}));  // past a corner of the roof
  CHECK(both({{{{-9, -9, 2}, {9, -9, 2}, {0, 30, 2}}}}));        // larger than the body, no edge inside
  CHECK(both({{{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}}}));            // inside
  CHECK(both({{{{0, 0, 0}, {4, 4, 4}, {0, 0, 0}}}}));            // a diagonal
  CHECK_FALSE(both({{{{0, 0, 4}, {4, 4, 4}, {2, 2, 4}}}}));      // a diagonal of the roof
  CHECK(both({{{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}}}));            // a point
  CHECK_FALSE(both({{{{4, 2, 2}, {4, 2, 2}, {4, 2, 2}}}}));      // a point of a wall
}
