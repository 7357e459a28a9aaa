#include "visibility/raster/contours.hpp"

#include "pixel_oracle.hpp"
#include "polygons.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"

#include <map>

using namespace visibility;
using namespace visibility::test;

namespace {

struct Segment {
  Point2q p, q;
};

/// Edges in pixels; `odd`: only those that occur an odd number of times.
std::vector<Segment> edges(Grid const& grid, Contours const& contours, bool odd)
{
  std::map<std::array<double, 4>, int> count;
  for (auto const& c : contours)
    for (std::size_t i = 0; i < c.size(); ++i) {
      auto p = c[i], q = c[(i + 1) % c.size()];
      if (std::pair(q.x, q.y) < std::pair(p.x, p.y)) std::swap(p, q);
      if (p != q) ++count[{p.x, p.y, q.x, q.y}];
    }
  std::vector<Segment> result;
  for (auto const& [e, n] : count)
    for (int k = odd ? n % 2 : n; k > 0; --k)
      result.push_back({in_pixels(grid, Point2d{e[0], e[1]}), in_pixels(grid, Point2d{e[2], e[3]})});
  return result;
}

/// Whether the closed segment has a point in the open square (x, x + 1) x (y, y + 1), enlarged: a segment of positive
/// length has a point there iff an interval of its parameters is strictly within both slabs.
bool meets_interior(Segment const& s, int x, int y, Q const& margin)
{
  Q first(0), last(1);
  auto const clip = [&](Q const& from, Q const& to, Q const& low, Q const& high) {
    if (from == to) return low < from && from < high;
    Q a = (low - from) / (to - from), b = (high - from) / (to - from);
    if (a > b) std::swap(a, b);
    first = std::max(first, a);
    last = std::min(last, b);
    return first < last;
  };
  return clip(s.p.x, s.q.x, Q(x) - margin, Q(x + 1) + margin) && clip(s.p.y, s.q.y, Q(y) - margin, Q(y + 1) + margin);
}

/// Even-odd, for a point on no edge.
bool is_inside(std::vector<Segment> const& all, Q const& x, Q const& y)
{
  bool inside = false;
  for (auto const& s : all)
    if ((s.p.y <= y) != (s.q.y <= y) && s.p.x + (s.q.x - s.p.x) * ((y - s.p.y) / (s.q.y - s.p.y)) < x) inside = !inside;
  return inside;
}

struct Count {
  long covered = 0, missed = 0, rejected = 0;
};

void check(Grid const& grid, Contours const& contours, bool exact, Count& count)
{
  auto const all = edges(grid, contours, false), odd = edges(grid, contours, true);
  std::vector<char> covered(static_cast<std::size_t>(grid.width() * grid.height()), 0);
  Span previous{-1, 0, 0};
  for (auto const& s : inner_even_odd(grid, contours)) {
    REQUIRE((s.begin < s.end && (s.row > previous.row || s.begin > previous.end)));
    previous = s;
    for (int x = s.begin; x < s.end; ++x) covered[static_cast<std::size_t>(s.row * grid.width() + x)] = 1;
  }
  Q const half = Q(1) / Q(2), margin = Q(1) / Q(1 << 24);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) {
      auto const met = [&](Q const& m) {
        return std::any_of(odd.begin(), odd.end(), [&](Segment const& s) { return meets_interior(s, x, y, m); });
      };
      // Off the middle: edges that are there twice may pass it.
      bool const expected = !met(Q(0)) && is_inside(all, Q(x) + half + Q(1) / Q(1009), Q(y) + half + Q(1) / Q(1013));
      bool const result = covered[static_cast<std::size_t>(y * grid.width() + x)] != 0;
      CAPTURE(x, y, expected, result);
      if (result) REQUIRE(expected);
      if (expected && !result) {
        ++count.missed;
        REQUIRE(!exact);
        REQUIRE(met(margin));
      }
      ++(result ? count.covered : count.rejected);
    }
}

}  // namespace

TEST_CASE("raster: inner pixels of contours are the rational truth, within its side", "[raster][oracle][degenerate]")
{
  auto const grids = tested_grids();
  Count count, on_uniform;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    PolygonSource source(grids[g], 700 + g);
    for (auto const shape : {Shape::lattice, Shape::quarter, Shape::uniform, Shape::displaced, Shape::degenerate})
      for (int i = trials(4); i > 0; --i) {
        Contours contours;
        for (int k = source.random().between(1, 3); k > 0; --k) contours.push_back(source(shape));
        if (source.random().chance(0.3)) contours.push_back(contours.front());  // cancels
        CAPTURE(name(shape), g, i);
        check(grids[g], contours, g < short_grids && is_exact(shape), shape == Shape::uniform ? on_uniform : count);
      }
  }
  REQUIRE(count.covered > 1000);
  REQUIRE(on_uniform.covered > 300);
  REQUIRE(on_uniform.missed == 0);
}

TEST_CASE("raster: contours with holes, islands, shared edges and touching corners", "[raster][degenerate]")
{
  auto const grid = Grid::covering({0, 0}, {12, 12}, 12, 12);
  auto const box = [](double x0, double y0, double x1, double y1) {
    return std::vector<Point2d>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  };
  CHECK(pixel_count(inner_even_odd(grid, {box(1, 1, 11, 11), box(3, 3, 9, 9), box(5, 5, 7, 7)})) == 100 - 36 + 4);
  CHECK(pixel_count(inner_even_odd(grid, {box(1, 1, 6, 11), box(6, 1, 11, 11)})) == 100);      // halves
  CHECK(pixel_count(inner_even_odd(grid, {box(1, 1, 5.5, 11), box(5.5, 1, 11, 11)})) == 100);  // within a pixel
  CHECK(pixel_count(inner_even_odd(grid, {box(1, 1, 5.5, 11), box(5.5, 1, 11, 10)})) < 100);   // edges that overlap
  CHECK(pixel_count(inner_even_odd(grid, {box(1, 1, 11, 11), box(1, 1, 4, 4)})) == 91);        // a hole at the border
  CHECK(pixel_count(inner_even_odd(grid, {box(1, 1, 11, 11), box(1, 1, 11, 11)})) == 0);
  CHECK(pixel_count(inner_even_odd(grid, {box(0, 0, 4, 4), box(4, 4, 8, 8)})) == 32);  // one corner in common
  CHECK(pixel_count(inner_even_odd(grid, {box(-5, -5, 50, 50), box(2, 2, 3, 50)})) == 144 - 10);
  CHECK(pixel_count(inner_even_odd(grid, {{{-3, 4}, {20, 4}, {-3, 4}}})) == 0);
  CHECK(inner_even_odd(grid, {}).empty());
  CHECK(inner_even_odd(grid, {{}, {{1, 1}}, {{1, 1}, {1, 1}}}).empty());
  CHECK(inner_even_odd(grid, {{{0, 0}, {1e300, 0}, {0, 1e300}}}).empty());
}

TEST_CASE("raster: contours of one convex polygon hold what its outline holds", "[raster][law]")
{
  property("inner_even_odd(contour) == inner(outline)", [] {
    auto const grids = tested_grids();
    auto const seed = *rc::gen::arbitrary<std::uint64_t>();
    auto const& grid = grids[seed % short_grids];
    PolygonSource source(grid, seed);
    auto points = source(Shape::quarter);
    points.resize(3);
    Outline const outline{points};
    RC_ASSERT(inner_even_odd(grid, Contours{points}) == inner(grid, {&outline, 1}));
  });
}

TEST_CASE("raster: contours are safe for every choice of points within their error", "[raster][conservative]")
{
  auto const grid = tested_grids()[3];
  PolygonSource source(grid, 900);
  auto& random = source.random();
  long covered = 0;
  Q const half = Q(1) / Q(2);
  for (int i = trials(60); i > 0; --i) {
    double const size = std::ldexp(1.0, -random.between(0, 40));
    Point2d const error{size * grid.step().x, size * grid.step().y};
    Contours const contours{source(Shape::uniform), source(Shape::displaced)};
    std::vector<Segment> meant;
    for (auto const& c : contours) {
      std::vector<Point2q> points;
      for (auto const& p : c) {
        auto const q = in_pixels(grid, p);
        points.push_back({q.x + Q(size * random.between(-1, 1)), q.y + Q(size * random.between(-1, 1))});
      }
      for (std::size_t k = 0; k < points.size(); ++k) meant.push_back({points[k], points[(k + 1) % points.size()]});
    }
    for (auto const& s : inner_even_odd(grid, contours, error))
      for (int x = s.begin; x < s.end; ++x, ++covered) {
        for (auto const& e : meant) REQUIRE(!meets_interior(e, x, s.row, Q(0)));
        REQUIRE(is_inside(meant, Q(x) + half, Q(s.row) + half));
      }
  }
  REQUIRE(covered > 200);
}

TEST_CASE("raster: contours as edges in any order and direction, open below a line", "[raster][law]")
{
  auto const grids = tested_grids();
  long open = 0;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    Grid const& grid = grids[g];
    PolygonSource source(grid, 900 + g);
    for (auto const shape : {Shape::lattice, Shape::uniform, Shape::displaced})
      for (int i = trials(6); i > 0; --i) {
        Contours contours;
        for (int k = source.random().between(1, 3); k > 0; --k) contours.push_back(source(shape));
        std::vector<ContourEdge> edges;
        for (auto const& c : contours)
          for (std::size_t k = 0; k < c.size(); ++k) {
            edges.emplace_back(c[k], c[(k + 1) % c.size()]);
            if (source.random().chance(0.5)) std::swap(edges.back().first, edges.back().second);
          }
        for (std::size_t k = edges.size(); k > 1; --k)
          std::swap(edges[k - 1], edges[std::size_t(source.random().below(int(k)))]);
        CAPTURE(name(shape), g, i);
        auto expected = inner_even_odd(grid, contours);
        REQUIRE(inner_even_odd(grid, edges, {0, 0}, -HUGE_VAL) == expected);
        // Edges below a line may be missing.
        int const row = source.random().below(grid.height());
        double const low = grid.row_line(row);
        auto const before = edges.size();
        std::erase_if(edges, [&](ContourEdge const& e) { return e.first.y < low && e.second.y < low; });
        open += edges.size() < before;
        std::erase_if(expected, [&](Span const& s) { return s.row < row; });
        REQUIRE(inner_even_odd(grid, edges, {0, 0}, low) == expected);
      }
  }
  REQUIRE(open > trials(20));
}
