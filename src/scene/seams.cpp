#include "visibility/scene/seams.hpp"

#include "edge_cover.hpp"
#include "line_clip.hpp"
#include "top_plane.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace visibility {

namespace {

using namespace height_field;
using NT = RationalNumber;
using Column = HeightField::Column;

/// The line of a seam in plan, directed from left to right as seen from the side of S, which is its right side.
class SeamLine {
public:
  SeamLine(HeightField const& field, Seam const& seam)
    : field_(field), seam_(seam), s_(field.columns()[seam.column]), f_(field.columns()[seam.other]),
      top_(top_plane(field, s_))
  {
    if (seam.is_crease()) {
      std::tie(p_, q_) = crease_line(top_plane(field, f_) - top_);  // not level: the planes cross
    } else {
      p_ = horizontal(exact(left()));
      q_ = horizontal(exact(right()));
    }
  }

  /// Where S lies just before the line and F, higher, just behind.
  LineRange range() const
  {
    LineRange range;
    if (seam_.is_crease()) {
      if (!has_area_beside(f_, Sign::positive)) return {{}, {}, true};
      clip(range, f_);
    } else {
      range = {NT(0), NT(1)};
      NT const at_0 = NT(left().z) - top_.over(p_), at_1 = NT(right().z) - top_.over(q_);
      if (at_0 == 0 && at_1 == 0) return {{}, {}, true};
      range.clip(at_0, at_1);
    }
    if (!has_area_beside(s_, Sign::negative)) return {{}, {}, true};
    clip(range, s_);
    return range;
  }

  /// Where the column covers S's top just before the line.
  LineRange covered_by(Column const& g) const
  {
    if (&g == &s_ || g.is_curtain() || !has_area_beside(g, Sign::negative) || is_beyond_edge(g)) return {{}, {}, true};
    Plane const rise = top_plane(field_, g) - top_;
    NT const at_0 = rise.over(p_), at_1 = rise.over(q_);
    LineRange range;
    if (at_0 == 0 && at_1 == 0)  // rising towards the right?
      range.is_empty = rise.a * (q_.y - p_.y) <= rise.b * (q_.x - p_.x);
    else
      range.clip(at_0, at_1);
    if (range.has_length()) clip(range, g);
    return range;
  }

  Point3q on_top(NT const& t) const
  {
    Point2q const p{p_.x + t * (q_.x - p_.x), p_.y + t * (q_.y - p_.y)};
    return {p.x, p.y, top_.over(p)};
  }

private:
  bool has_area_beside(Column const& column, Sign beside) const
  {
    Corners const corners = field_.corners(column);
    if (!seam_.is_crease()) return has_corner_beside(corners, left(), right(), beside);
    return std::ranges::any_of(corners, [&](Point3d const& c) {
      return sign_of(turn(p_, q_, {NT(c.x), NT(c.y)})) == beside;
    });
  }

  /// Whether signs show that a foot has no part over the column: saves numbers.
  bool is_beyond_edge(Column const& column) const
  {
    return !seam_.is_crease() && has_outside(field_.corners(column), left(), right());
  }

  /// Of a foot.
  HeightField::TopEdge const& edge() const { return field_.edges()[seam_.edge]; }
  Point3d const& left() const { return seam_.from_left ? edge().b : edge().a; }
  Point3d const& right() const { return seam_.from_left ? edge().a : edge().b; }

  void clip(LineRange& range, Column const& column) const { range.clip(field_.corners(column), p_, q_); }

  HeightField const& field_;
  Seam const& seam_;
  Column const &s_, &f_;
  Plane top_;  ///< of S
  Point2q p_, q_;
};

}  // namespace

std::vector<SeamPart> exposed_parts(HeightField const& field, Seam const& seam)
{
  SeamLine const line(field, seam);
  LineRange const range = line.range();
  if (!range.has_length()) return {};
  NT const low = *range.low, high = *range.high;
  using Interval = std::pair<NT, NT>;
  std::vector<Interval> covered;
  Box const box = reach(line.on_top(low), line.on_top(high));
  bool const everywhere = field.column_hierarchy().any_item_meeting(box, [&](std::uint32_t g) {
    LineRange const r = line.covered_by(field.columns()[g]);
    if (!r.has_length()) return false;
    covered.emplace_back(*r.low, *r.high);
    return *r.low <= low && high <= *r.high;
  });
  if (everywhere) return {};
  std::ranges::sort(covered, {}, &Interval::first);
  std::vector<SeamPart> parts;
  NT end = low;
  auto const expose = [&](NT const& until) {
    if (end < until) parts.push_back({line.on_top(end), line.on_top(until)});
  };
  for (auto const& [first, last] : covered) {
    expose(std::min(first, high));
    if (end < last) end = last;
  }
  expose(high);
  return parts;
}

}  // namespace visibility
