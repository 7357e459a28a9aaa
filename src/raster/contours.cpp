#include "visibility/raster/contours.hpp"

#include "visibility/raster/fixed_points.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace visibility {

namespace {

using detail::FixedPoint;
using detail::FixedPoints;

/// What one edge does to one row: its pixels [begin, end) are met by the edge in their interior; if `crosses`, it
/// passes the row's middle line there (or, with no such pixels, along the column line `end`).
struct Contact {
  int row, begin, end;
  bool crosses;
};

/// Leaves out edges that occur an even number of times: they bound nothing.
void cancel_pairs(std::vector<ContourEdge>& edges)
{
  auto const key = [](Point2d const& p) { return std::pair(p.x, p.y); };
  for (auto& e : edges)
    if (key(e.second) < key(e.first)) std::swap(e.first, e.second);
  auto const ends = [&](ContourEdge const& e) { return std::pair(key(e.first), key(e.second)); };
  std::ranges::sort(edges, {}, ends);
  std::size_t kept = 0;
  for (auto const& e : edges) {
    if (kept > 0 && edges[kept - 1] == e)
      --kept;
    else
      edges[kept++] = e;
  }
  edges.resize(kept);
}

class ContactFinder {
public:
  ContactFinder(Grid const& grid, FixedPoints const& fixed) : grid_(grid), fixed_(fixed) {}

  void add(FixedPoint const& p, FixedPoint const& q, std::vector<Contact>& contacts)
  {
    int const f = fixed_.fraction, width = grid_.width();
    auto const first = [&](std::int64_t low, std::int64_t error, int size) {
      return static_cast<int>(std::clamp<std::int64_t>(detail::floor_units(low - error, f), 0, size));
    };
    auto const end = [&](std::int64_t high, std::int64_t error, int size) {
      return static_cast<int>(std::clamp<std::int64_t>(detail::ceil_units(high + error, f), 0, size));
    };
    auto const [u0, u1] = std::minmax(p.u, q.u);
    auto const [v0, v1] = std::minmax(p.v, q.v);
    auto const error_u = fixed_.error_u + std::max(p.off_u, q.off_u),
               error_v = fixed_.error_v + std::max(p.off_v, q.off_v);
    PixelRectangle const rows{0, first(v0, error_v, grid_.height()), width, end(v1, error_v, grid_.height())};
    if (rows.y0 >= rows.y1) return;
    auto const count = static_cast<std::size_t>(rows.y1 - rows.y0);
    left_.assign(count, first(u0, error_u, width));
    right_.assign(count, end(u1, error_u, width));
    if (p.u != q.u && p.v != q.v) {  // else the bounds decide
      detail::clip_rows(left_of(p, q, fixed_, detail::EdgeCover::interior_touching), rows, left_.data(), right_.data());
      detail::clip_rows(left_of(q, p, fixed_, detail::EdgeCover::interior_touching), rows, left_.data(), right_.data());
    }
    for (std::size_t k = 0; k < count; ++k) {
      int const row = rows.y0 + static_cast<int>(k);
      std::int64_t const middle = (2 * std::int64_t{row} + 1) << (f - 1);
      contacts.push_back({row, left_[k], std::max(left_[k], right_[k]), (p.v < middle) != (q.v < middle)});
    }
  }

private:
  Grid const& grid_;
  FixedPoints const& fixed_;
  std::vector<int> left_, right_;
};

/// Writes the free pixels of one row with odd parity. `touched` and `flips` have width + 1 zeros, before and after.
void add_row(int row, std::span<Contact const> contacts, std::vector<int>& touched, std::vector<unsigned char>& flips,
             Spans& spans)
{
  for (auto const& c : contacts) {
    ++touched[static_cast<std::size_t>(c.begin)];
    --touched[static_cast<std::size_t>(c.end)];
    flips[static_cast<std::size_t>(c.end)] ^= static_cast<unsigned char>(c.crosses);
  }
  int depth = 0, begin = -1;
  unsigned char parity = 0;
  auto const width = static_cast<int>(touched.size()) - 1;
  for (int x = 0; x <= width; ++x) {
    auto const i = static_cast<std::size_t>(x);
    depth += touched[i];
    parity ^= flips[i];
    touched[i] = flips[i] = 0;
    bool const covered = x < width && depth == 0 && parity != 0;
    if (covered && begin < 0) begin = x;
    if (!covered && begin >= 0) {
      spans.push_back({row, begin, x});
      begin = -1;
    }
  }
}

}  // namespace

Spans inner_even_odd(Grid const& grid, Contours const& contours, Point2d const& error)
{
  std::vector<ContourEdge> edges;
  for (auto const& contour : contours)
    for (std::size_t i = 0, n = contour.size(); i < n; ++i) edges.emplace_back(contour[i], contour[(i + 1) % n]);
  return inner_even_odd(grid, edges, error, -std::numeric_limits<double>::infinity());
}

Spans inner_even_odd(Grid const& grid, std::span<ContourEdge const> all, Point2d const& error, double low)
{
  std::vector<ContourEdge> edges;
  std::ranges::copy_if(all, std::back_inserter(edges), [](ContourEdge const& e) { return e.first != e.second; });
  // Only edges that are the same for certain cancel: what is meant by rounded ones may differ.
  if (error == Point2d{0, 0}) cancel_pairs(edges);
  std::vector<Point2d> points;
  for (auto const& [p, q] : edges) points.insert(points.end(), {p, q});
  FixedPoints fixed;
  Spans spans;
  if (edges.empty() || !fixed.assign(points, grid.origin(), grid.step(), error)) return spans;
  std::vector<Contact> contacts;
  ContactFinder finder(grid, fixed);
  for (std::size_t i = 0; i < fixed.points.size(); i += 2) finder.add(fixed.points[i], fixed.points[i + 1], contacts);

  // Sort by row, by counting.
  std::vector<std::size_t> start(static_cast<std::size_t>(grid.height()) + 1, 0);
  for (auto const& c : contacts) ++start[static_cast<std::size_t>(c.row) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Contact> sorted(contacts.size());
  auto next = start;
  for (auto const& c : contacts) sorted[next[static_cast<std::size_t>(c.row)]++] = c;

  std::vector<int> touched(static_cast<std::size_t>(grid.width()) + 1, 0);
  std::vector<unsigned char> flips(touched.size(), 0);
  for (int row = 0; row < grid.height(); ++row) {
    auto const r = static_cast<std::size_t>(row);
    if (start[r] < start[r + 1] && grid.row_line(row) >= low)
      add_row(row, std::span(sorted).subspan(start[r], start[r + 1] - start[r]), touched, flips, spans);
  }
  return spans;
}

}  // namespace visibility
