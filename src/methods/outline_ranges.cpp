#include "visibility/methods/exact_25d/outline_ranges.hpp"

#include "scene/line_clip.hpp"

#include <algorithm>

namespace visibility::exact_25d {

using height_field::turn;
using NT = RationalNumber;

std::optional<OpenInterval> along_side(PlanSegment const& segment, CellOutline const& outline, std::size_t side)
{
  auto const& [p, q] = segment;
  auto const [left, right] = exact_gate(outline.exit(side));
  if (turn(p, q, left) != 0 || turn(p, q, right) != 0) return {};
  bool const along_x = p.x != q.x;
  auto const position = [&, &p = p, &q = q](Point2q const& x) -> NT {
    return along_x ? NT((x.x - p.x) / (q.x - p.x)) : NT((x.y - p.y) / (q.y - p.y));
  };
  NT const low = std::max(NT(0), position(left)), high = std::min(NT(1), position(right));
  if (!(low < high)) return {};
  return OpenInterval{low, high};
}

std::optional<OpenInterval> inside(PlanSegment const& segment, CellOutline const& outline)
{
  auto const& [p, q] = segment;
  height_field::LineRange range{NT(0), NT(1)};
  range.clip(outline.corners, p, q);
  if (!range.has_length()) return {};
  NT const middle = (*range.low + *range.high) / 2;
  Point2q const x{p.x + middle * (q.x - p.x), p.y + middle * (q.y - p.y)};
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (turn(horizontal(exact(outline.corner(i))), horizontal(exact(outline.corner(i + 1))), x) <= 0) return {};
  return OpenInterval{*range.low, *range.high};
}

}  // namespace visibility::exact_25d
