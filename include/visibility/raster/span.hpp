#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace visibility {

/// Pixels [x0, x1) x [y0, y1); empty unless x0 < x1 and y0 < y1.
struct PixelRectangle {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  friend bool operator==(PixelRectangle const&, PixelRectangle const&) = default;
  bool is_empty() const { return !(x0 < x1 && y0 < y1); }
};

inline PixelRectangle common(PixelRectangle const& a, PixelRectangle const& b)
{
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// Pixels [begin, end) of one row; never empty.
struct Span {
  int row, begin, end;
  friend bool operator==(Span const&, Span const&) = default;
};

/// A set of pixels, as disjoint spans ordered by row, then by column.
using Spans = std::vector<Span>;

inline std::int64_t pixel_count(Spans const& spans)
{
  std::int64_t n = 0;
  for (auto const& s : spans) n += s.end - s.begin;
  return n;
}

}  // namespace visibility
