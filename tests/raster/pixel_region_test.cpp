#include "visibility/raster/pixel_region.hpp"

#include "pixel_oracle.hpp"
#include "polygons.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"

#include <cstdio>

using namespace visibility;
using namespace visibility::test;

namespace {

/// Beyond this many pixels no answer may differ from the truth; polygons reach 2^20 pixels, hence 27 bits of fraction.
Q const margin = Q(1) / Q(1 << 24);

struct Count {
  long polygons = 0, inside = 0, touching = 0, missed = 0, added = 0;
};

/// Requires result = truth, or on its safe side and within the margin of it.
void check_inside(Row const& result, Row const& truth, int y, std::vector<Point2q> const& points, bool exact,
                  Count& count)
{
  for (int x = result.begin; x < result.end; ++x) REQUIRE((truth.begin <= x && x < truth.end));
  for (int x = truth.begin; x < truth.end; ++x) {
    ++count.inside;
    if (result.begin <= x && x < result.end) continue;
    ++count.missed;
    REQUIRE(!exact);
    REQUIRE(!enlarged_inside(points, x, y, margin));
  }
}

void check_touching(Row const& result, Row const& truth, int y, std::vector<Point2q> const& points, bool exact,
                    Count& count)
{
  for (int x = truth.begin; x < truth.end; ++x) REQUIRE((result.begin <= x && x < result.end));
  for (int x = result.begin; x < result.end; ++x) {
    ++count.touching;
    if (truth.begin <= x && x < truth.end) continue;
    ++count.added;
    REQUIRE(!exact);
    REQUIRE(enlarged_touching(points, x, y, margin));
  }
}

void check(Grid const& grid, std::vector<Point2d> const& points, bool exact, Count& count)
{
  auto const q = in_pixels(grid, points);
  Truth const truth(grid, q);
  Outline const outline{points};
  auto const in = by_row(inner(grid, {&outline, 1}), grid.height());
  auto const out = by_row(outer(grid, outline), grid.height());
  for (int y = 0; y < grid.height(); ++y) {
    auto const i = static_cast<std::size_t>(y);
    check_inside(in[i], truth.inside[i], y, q, exact, count);
    check_touching(out[i], truth.touching[i], y, q, exact, count);
  }
  ++count.polygons;
}

/// The truth by another way: clips the hull of the points to the pixel's corners one by one, in rationals.
bool corner_inside(std::vector<Point2q> const& points, Q const& x, Q const& y)
{
  auto const line = on_line(points, y);
  return line && line->low <= x && x <= line->high;
}

}  // namespace

TEST_CASE("raster: inner and outer pixels of convex polygons are the rational truth, within its side",
          "[raster][oracle][degenerate][conservative]")
{
  auto const grids = tested_grids();
  for (auto const shape : all_shapes) {
    Count all, on_short;
    for (std::size_t g = 0; g < grids.size(); ++g) {
      PolygonSource source(grids[g], 100 + g);
      bool const exact = g < short_grids && is_exact(shape);
      CAPTURE(name(shape), g);
      for (int i = trials(600); i > 0; --i) check(grids[g], source(shape), exact, g < short_grids ? on_short : all);
    }
    if (std::getenv("VISIBILITY_TRIALS_SCALE") != nullptr)
      std::printf("%-14s %ld polygons; missed %ld of %ld inside, added %ld to %ld touching; short grids: %ld, %ld\n",
                  name(shape).data(), all.polygons + on_short.polygons, all.missed + on_short.missed,
                  all.inside + on_short.inside, all.added + on_short.added, all.touching + on_short.touching,
                  on_short.missed, on_short.added);
    REQUIRE(all.touching + on_short.touching > 100);
    if (shape != Shape::sliver && shape != Shape::tiny && shape != Shape::degenerate)
      REQUIRE(all.inside + on_short.inside > 100);
    // Loose answers would be a fault too: at random polygons nothing is lost at all.
    if (shape == Shape::uniform) REQUIRE(all.missed + all.added + on_short.missed + on_short.added == 0);
  }
}

TEST_CASE("raster: the oracle's rows are what its corners say", "[raster][oracle]")
{
  auto const grid = tested_grids()[1];
  PolygonSource source(grid, 7);
  for (auto const shape : {Shape::lattice, Shape::uniform, Shape::sliver})
    for (int i = 0; i < 20; ++i) {
      auto const q = in_pixels(grid, source(shape));
      Truth const truth(grid, q);
      for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
          bool const inside = corner_inside(q, Q(x), Q(y)) && corner_inside(q, Q(x + 1), Q(y)) &&
                              corner_inside(q, Q(x), Q(y + 1)) && corner_inside(q, Q(x + 1), Q(y + 1));
          auto const& row = truth.inside[static_cast<std::size_t>(y)];
          REQUIRE(inside == (row.begin <= x && x < row.end));
        }
    }
}

TEST_CASE("raster: inner pixels of several views are those of each of them", "[raster][law]")
{
  property("inner(views) == intersection of inner(view)", [] {
    auto const grids = tested_grids();
    auto const seed = *rc::gen::arbitrary<std::uint64_t>();
    auto const& grid = grids[seed % grids.size()];
    PolygonSource source(grid, seed);
    std::vector<std::vector<Point2d>> views;
    Point2d const low{grid.origin().x, grid.origin().y},
      high{grid.column_line(grid.width()), grid.row_line(grid.height())};
    for (int i = source.random().between(1, 8); i > 0; --i) {
      views.push_back(source(all_shapes[static_cast<std::size_t>(source.random().below(10))]));
      if (source.random().chance(0.8)) views.back().insert(views.back().end(), {low, {high.x, low.y}});
      if (source.random().chance(0.8)) views.back().insert(views.back().end(), {high, {low.x, high.y}});
    }
    std::vector<Outline> outlines;
    for (auto const& v : views) outlines.push_back({v});
    auto const together = by_row(inner(grid, outlines), grid.height());
    std::vector<Row> common(together.size(), Row{0, grid.width()});
    for (auto const& o : outlines) {
      auto const rows = by_row(inner(grid, {&o, 1}), grid.height());
      for (std::size_t y = 0; y < rows.size(); ++y)
        common[y] = {std::max(common[y].begin, rows[y].begin), std::min(common[y].end, rows[y].end)};
    }
    for (std::size_t y = 0; y < common.size(); ++y) {
      if (common[y].begin >= common[y].end) common[y] = {};
      RC_ASSERT(together[y].begin == common[y].begin);
      RC_ASSERT(together[y].end == common[y].end);
    }
  });
}

TEST_CASE("raster: order, orientation and repetition of points change nothing", "[raster][law]")
{
  property("same hull, same pixels", [] {
    auto const grids = tested_grids();
    auto const seed = *rc::gen::arbitrary<std::uint64_t>();
    auto const& grid = grids[seed % grids.size()];
    PolygonSource source(grid, seed);
    auto const points = source(all_shapes[static_cast<std::size_t>(source.random().below(10))]);
    auto shuffled = points;
    shuffled.push_back(points[static_cast<std::size_t>(source.random().below(static_cast<int>(points.size())))]);
    for (auto& p : shuffled)
      std::swap(p, shuffled[static_cast<std::size_t>(source.random().below(static_cast<int>(shuffled.size())))]);
    Outline const a{points}, b{shuffled};
    RC_ASSERT(inner(grid, {&a, 1}) == inner(grid, {&b, 1}));
    RC_ASSERT(outer(grid, a) == outer(grid, b));
  });
}

TEST_CASE("raster: pixels are safe for every choice of points within their error", "[raster][conservative]")
{
  auto const grids = tested_grids();
  long inside = 0, touching = 0;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    auto const& grid = grids[g];
    PolygonSource source(grid, 300 + g);
    auto& random = source.random();
    for (int i = trials(60); i > 0; --i) {
      auto const shape = all_shapes[static_cast<std::size_t>(random.below(10))];
      auto const points = source(shape);
      double const size = random.chance(0.2) ? 0 : std::ldexp(1.0, -random.between(0, 45));
      Point2d const error{size * grid.step().x, random.chance(0.2) ? 0 : size * grid.step().y};
      Outline const outline{points, error};
      auto const in = by_row(inner(grid, {&outline, 1}), grid.height());
      auto const out = by_row(outer(grid, outline), grid.height());
      // The points meant: at the corners of their boxes, where they do most harm, or between.
      std::vector<Point2q> meant;
      for (auto const& p : points) {
        auto const shift = [&](double e) {
          return Q(e) * Q(random.chance(0.7) ? random.between(-1, 1) : random.uniform(-1, 1));
        };
        meant.push_back({(Q(p.x) + shift(error.x) - Q(grid.origin().x)) / Q(grid.step().x),
                         (Q(p.y) + shift(error.y) - Q(grid.origin().y)) / Q(grid.step().y)});
      }
      Truth const truth(grid, meant);
      CAPTURE(name(shape), g, size);
      for (std::size_t y = 0; y < in.size(); ++y) {
        for (int x = in[y].begin; x < in[y].end; ++x, ++inside)
          REQUIRE((truth.inside[y].begin <= x && x < truth.inside[y].end));
        for (int x = truth.touching[y].begin; x < truth.touching[y].end; ++x, ++touching)
          REQUIRE((out[y].begin <= x && x < out[y].end));
      }
    }
  }
  REQUIRE(inside > 1000);
  REQUIRE(touching > 1000);
}

TEST_CASE("raster: shrinking edges by a pixel each way is safe and loses pixels", "[raster][conservative]")
{
  // [Durand00, section 3.2]: edges moved by (+-1, +-1) pixels inwards, pixels taken by their centres.
  auto const grid = Grid::covering({0, 0}, {64, 64}, 64, 64);
  Random random(5);
  long ours = 0, theirs = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<Point2d> p;
    for (int k = 0; k < 3; ++k) p.push_back({random.uniform(0, 64), random.uniform(0, 64)});
    if ((p[1].x - p[0].x) * (p[2].y - p[0].y) < (p[1].y - p[0].y) * (p[2].x - p[0].x)) std::swap(p[1], p[2]);
    PixelRegion shrunk(grid);
    for (std::size_t k = 0; k < 3; ++k) {
      auto const &a = p[k], &b = p[(k + 1) % 3];
      double const nx = a.y - b.y, ny = b.x - a.x;
      // The centre, half a pixel from the corner, at least |nx| + |ny| inside.
      // As a half-plane of lower corners: that of pixels touched, less what `touching` grants.
      double const grant = std::max(nx, 0.0) + std::max(ny, 0.0);
      double const c = -(nx * a.x + ny * a.y) + 0.5 * (nx + ny) - std::fabs(nx) - std::fabs(ny);
      shrunk.keep(HalfPlane{nx, ny, c - grant}, Cover::touching);
    }
    Spans spans;
    shrunk.spans(spans);
    Outline const outline{p};
    auto const in = by_row(inner(grid, {&outline, 1}), 64);
    for (auto const& s : spans)
      for (int x = s.begin; x < s.end; ++x) {
        auto const& row = in[static_cast<std::size_t>(s.row)];
        REQUIRE((row.begin <= x && x < row.end));
      }
    theirs += pixel_count(spans);
    for (auto const& r : in) ours += r.end - r.begin;
  }
  REQUIRE(theirs > 0);
  REQUIRE(theirs < ours);
}

TEST_CASE("raster: points out of the domain give the safe answer", "[raster][degenerate]")
{
  auto const grid = Grid::covering({0, 0}, {8, 8}, 8, 8);
  double const nan = std::nan(""), huge = 1e300;
  for (auto const& points : std::vector<std::vector<Point2d>>{
         {{-huge, -huge}, {huge, -huge}, {0, huge}}, {{nan, 0}, {8, 0}, {0, 8}}, {{HUGE_VAL, 0}, {-8, 0}, {0, 8}}}) {
    Outline const o{points};
    CHECK(inner(grid, {&o, 1}).empty());
    CHECK(pixel_count(outer(grid, o)) == 64);
  }
  std::vector<Point2d> const beside{{huge, 0}, {1e200, 5}, {9, 7}};
  CHECK(outer(grid, Outline{beside}).empty());
  CHECK(outer(grid, Outline{{}}).empty());
  Outline const none{{}};
  CHECK(inner(grid, {&none, 1}).empty());
  CHECK(pixel_count(inner(grid, {})) == 64);
  std::vector<Point2d> const triangle{{0, 0}, {8, 0}, {0, 8}};
  Outline const vague{triangle, {huge, 0}};
  CHECK(inner(grid, {&vague, 1}).empty());
  CHECK(pixel_count(outer(grid, vague)) == 64);
}

TEST_CASE("raster: a rounded point near an exact edge counts where it is", "[raster][degenerate]")
{
  // On the fixed grid the third point lies on the edge of the first two; it is beyond, and beyond the corner (1, 1).
  auto const grid = Grid::covering({0, 0}, {8, 8}, 8, 8);
  double const unit = 0x1p-36;
  std::vector<Point2d> const points{{0.25 - unit, 0.75}, {4 - unit, 2}, {1 - 0.55 * unit, 1 - 0.45 * unit}, {0, 6}};
  CHECK(Truth(grid, in_pixels(grid, points)).touching[0].end == 2);
  CHECK(outer(grid, Outline{points}).front() == Span{0, 0, 2});
  std::vector<Point2d> const exact{points[0], points[1], points[3]};
  CHECK(outer(grid, Outline{exact}).front() == Span{0, 0, 1});
}

TEST_CASE("raster: an exact edge along pixels is exact beside points that are not", "[raster]")
{
  auto const grid = Grid::covering({0, 0}, {8, 8}, 8, 8);
  std::vector<Point2d> const triangle{{1, 2}, {7, 2}, {4.1, 6.3}, {3.3, 2.1}};
  Outline const o{triangle};
  CHECK(inner(grid, {&o, 1}).front().row == 2);
  CHECK(inner(grid, {&o, 1}).front() == Span{2, 2, 6});
  CHECK(outer(grid, o).front() == Span{1, 0, 8});
}

TEST_CASE("raster: a corner touched from outside is touched; a polygon along pixels holds all of them", "[raster]")
{
  auto const grid = Grid::covering({0, 0}, {8, 8}, 8, 8);
  std::vector<Point2d> const corner{{3, 5}}, diagonal{{1, 1}, {4, 4}}, box{{2, 3}, {5, 3}, {5, 7}, {2, 7}};
  CHECK(outer(grid, Outline{corner}) == Spans{{4, 2, 4}, {5, 2, 4}});
  CHECK(outer(grid, Outline{diagonal}) == Spans{{0, 0, 2}, {1, 0, 3}, {2, 1, 4}, {3, 2, 5}, {4, 3, 5}});
  Outline const o{box};
  CHECK(inner(grid, {&o, 1}) == Spans{{3, 2, 5}, {4, 2, 5}, {5, 2, 5}, {6, 2, 5}});
  CHECK(outer(grid, o).front() == Span{2, 1, 6});
  CHECK(outer(grid, o).back() == Span{7, 1, 6});
}
