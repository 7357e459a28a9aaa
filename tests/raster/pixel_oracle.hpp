#pragma once

#include "visibility/kernel/number_types.hpp"
#include "visibility/raster/pixel_region.hpp"

#include <algorithm>
#include <optional>
#include <vector>

/// The truth about pixels and convex hulls, in rationals: hulls are cut by row lines, from all pairs of points. Shares
/// no idea with the library (no half-planes, no hull, no fixed point).
namespace visibility::test {

using Q = RationalNumber;

inline Point2q in_pixels(Grid const& grid, Point2d const& p)
{
  return {(Q(p.x) - Q(grid.origin().x)) / Q(grid.step().x), (Q(p.y) - Q(grid.origin().y)) / Q(grid.step().y)};
}

inline std::vector<Point2q> in_pixels(Grid const& grid, std::span<Point2d const> points)
{
  std::vector<Point2q> result;
  for (auto const& p : points) result.push_back(in_pixels(grid, p));
  return result;
}

struct Interval {
  Q low, high;
};
using MaybeInterval = std::optional<Interval>;

inline void extend(MaybeInterval& i, Q const& x)
{
  if (!i)
    i = Interval{x, x};
  else if (x < i->low)
    i->low = x;
  else if (x > i->high)
    i->high = x;
}

/// The hull of the points on the line of ordinate y.
inline MaybeInterval on_line(std::vector<Point2q> const& points, Q const& y)
{
  MaybeInterval result;
  for (auto const& p : points)
    if (p.y == y) extend(result, p.x);
  for (auto const& p : points)
    if (p.y < y)
      for (auto const& q : points)
        if (q.y > y) extend(result, p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)));
  return result;
}

/// Abscissas of the hull between two lines, given what it is on them.
inline MaybeInterval in_strip(std::vector<Point2q> const& points, Q const& y0, Q const& y1, MaybeInterval const& on_y0,
                              MaybeInterval const& on_y1)
{
  MaybeInterval result = on_y0;
  if (on_y1) {
    extend(result, on_y1->low);
    extend(result, on_y1->high);
  }
  for (auto const& p : points)
    if (p.y > y0 && p.y < y1) extend(result, p.x);
  return result;
}

inline int floor_of(Q const& x)
{
  mpz_t z;
  mpz_init(z);
  mpz_fdiv_q(z, mpq_numref(x.mpq()), mpq_denref(x.mpq()));
  int const result = mpz_cmp_si(z, 1 << 20) > 0      ? 1 << 20
                     : mpz_cmp_si(z, -(1 << 20)) < 0 ? -(1 << 20)
                                                     : static_cast<int>(mpz_get_si(z));
  mpz_clear(z);
  return result;
}
inline int ceil_of(Q const& x) { return -floor_of(-x); }

/// Pixels [begin, end) of a row; empty if begin >= end.
struct Row {
  int begin = 0, end = 0;
};

/// Row by row, the pixels of the grid wholly inside the hull, and those that meet it.
struct Truth {
  std::vector<Row> inside, touching;

  Truth(Grid const& grid, std::vector<Point2q> const& points)
  {
    auto const clip = [&](int begin, int end) { return Row{std::max(begin, 0), std::min(end, grid.width())}; };
    MaybeInterval lower = on_line(points, Q(0));
    for (int y = 0; y < grid.height(); ++y) {
      MaybeInterval const upper = on_line(points, Q(y + 1));
      Row in, touch;
      if (lower && upper)
        in = clip(ceil_of(std::max(lower->low, upper->low)), floor_of(std::min(lower->high, upper->high)));
      if (auto const strip = in_strip(points, Q(y), Q(y + 1), lower, upper))
        touch = clip(ceil_of(strip->low) - 1, floor_of(strip->high) + 1);
      inside.push_back(in);
      touching.push_back(touch);
      lower = upper;
    }
  }
};

/// Whether the pixel, enlarged by `margin` on all sides, lies in the hull, or meets it.
inline bool enlarged_inside(std::vector<Point2q> const& points, int x, int y, Q const& margin)
{
  auto const a = on_line(points, Q(y) - margin), b = on_line(points, Q(y + 1) + margin);
  return a && b && std::max(a->low, b->low) <= Q(x) - margin && std::min(a->high, b->high) >= Q(x + 1) + margin;
}
inline bool enlarged_touching(std::vector<Point2q> const& points, int x, int y, Q const& margin)
{
  Q const y0 = Q(y) - margin, y1 = Q(y + 1) + margin;
  auto const strip = in_strip(points, y0, y1, on_line(points, y0), on_line(points, y1));
  return strip && strip->low <= Q(x + 1) + margin && strip->high >= Q(x) - margin;
}

/// What spans say, row by row. Requires: at most one span per row.
inline std::vector<Row> by_row(Spans const& spans, int height)
{
  std::vector<Row> rows(static_cast<std::size_t>(height));
  for (auto const& s : spans) rows[static_cast<std::size_t>(s.row)] = {s.begin, s.end};
  return rows;
}

}  // namespace visibility::test
