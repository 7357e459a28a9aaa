#pragma once

#include "polygon_sides.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"
#include "visibility/scene/exposed_parts.hpp"

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <type_traits>

namespace visibility::height_field {

/// Closed interval of the parameter of an edge; an end that is not set is that of the edge.
struct ClosedInterval {
  std::optional<RationalNumber> low, high;
  bool has_length() const { return !low || !high || *low < *high; }
};

enum class Extent : std::uint8_t { nowhere, partly, everywhere };

/// Of a linear function with these signs at the ends: whether it is nowhere positive between them.
inline bool nowhere_positive(Sign s, Sign t) { return !is_positive(s) && !is_positive(t); }
inline bool changes(Sign s, Sign t) { return is_negative(s * t); }

/// What may be covered: a wall, or the top with these corners. A column that it is part of does not cover it.
struct Covered {
  static constexpr std::uint32_t no_column = 0xffffffff;
  Corners top{};  ///< empty: a wall
  std::uint32_t column = no_column;
};

/// What covers a straight line a -> b of a wall or a top in plan, on one side of it: scene/exposed_parts.hpp says when.
/// `P` is Point3d, or Point3q with `Rational`.
template <Arithmetic A, class P>
class EdgeCover {
public:
  using Column = HeightField::Column;
  /// Of values at the ends of the edge.
  using NT = std::conditional_t<std::same_as<A, Rational>, RationalNumber, ExactNumber>;

  EdgeCover(HeightField const& field, P a, P b, Sign side, Covered covered)
    : field_(field), a_(std::move(a)), b_(std::move(b)), side_(side), covered_(covered)
  {
  }

  /// How much of the edge the column covers, by signs alone. `partly` may turn out to be a point or nothing.
  Extent extent(std::uint32_t column) const
  {
    Column const& f = field_.columns()[column];
    if (column == covered_.column || f.is_curtain()) return Extent::nowhere;
    Extent const beside = area_beside(field_.corners(f));
    if (beside == Extent::nowhere) return Extent::nowhere;
    Sign const at_a = rise(f, a_), at_b = rise(f, b_);
    if (changes(at_a, at_b)) return Extent::partly;
    bool const covers = are_zero(at_a, at_b) ? covered_.top.empty() || rises_away(f) : !nowhere_positive(at_a, at_b);
    return covers ? beside : Extent::nowhere;
  }

  /// Where the column covers. Requires: extent(column) == Extent::partly.
  ClosedInterval interval(std::uint32_t column) const
  {
    Column const& f = field_.columns()[column];
    ClosedInterval covered;
    clip(covered, field_.corners(f));
    Sign const at_a = rise(f, a_);
    if (changes(at_a, rise(f, b_))) clip(covered, at_a, exact_rise(f, a_), exact_rise(f, b_));
    return covered;
  }

private:
  static decltype(auto) in(Point3d const& p)
  {
    if constexpr (std::same_as<P, Point3q>)
      return exact(p);
    else
      return (p);
  }

  /// How much of the edge has area of the polygon on the side from which it could be covered. Two convex sets in the
  /// plane are apart iff the line of a side of one of them separates them.
  Extent area_beside(std::span<Point3d const> corners) const
  {
    auto const a = horizontal(a_), b = horizontal(b_);
    bool beyond = false, before = false;
    int on = 0;
    for (auto const& c : corners) {
      Sign const s = orient2d<A>(a, b, horizontal(in(c)));
      beyond |= s == side_;
      before |= s == -side_;
      on += is_zero(s);
    }
    if (!beyond || !(before || on >= 2)) return Extent::nowhere;
    Extent extent = Extent::everywhere;
    for (std::size_t i = corners.size() - 1, j = 0; j < corners.size(); i = j++) {
      auto const p = horizontal(in(corners[i])), q = horizontal(in(corners[j]));
      Sign const at_a = orient2d<A>(p, q, a), at_b = orient2d<A>(p, q, b);
      if (nowhere_positive(at_a, at_b) && !are_zero(at_a, at_b)) return Extent::nowhere;
      if (changes(at_a, at_b)) extent = Extent::partly;
    }
    return extent;
  }

  /// Sign of how much higher the column's top plane is over p than p. A column that is not flat is a triangle.
  Sign rise(Column const& f, P const& p) const
  {
    auto const c = field_.corners(f);
    if (f.is_flat) return c[0].z > p.z ? Sign::positive : c[0].z < p.z ? Sign::negative : Sign::zero;
    return -orient3d<A>(in(c[0]), in(c[1]), in(c[2]), p);
  }

  /// The same as a number, up to a positive factor that is the same for all p.
  NT exact_rise(Column const& f, P const& r) const
  {
    auto const c = field_.corners(f);
    if (f.is_flat) return NT(c[0].z) - NT(r.z);
    auto const &p = c[0], &q = c[1], &s = c[2];
    return -detail::Orient3dFormula{}(NT(p.x), NT(p.y), NT(p.z), NT(q.x), NT(q.y), NT(q.z), NT(s.x), NT(s.y), NT(s.z),
                                      NT(r.x), NT(r.y), NT(r.z));
  }

  /// Of a column whose top plane contains the line: whether it is above the covered top on the side asked for.
  bool rises_away(Column const& f) const
  {
    return std::ranges::any_of(covered_.top, [&](Point3d const& c) {
      P const p = in(c);
      return orient2d<A>(horizontal(a_), horizontal(b_), horizontal(p)) == side_ && is_positive(rise(f, p));
    });
  }

  /// Keeps what lies in the polygon.
  void clip(ClosedInterval& interval, std::span<Point3d const> corners) const
  {
    for (std::size_t i = corners.size() - 1, j = 0; j < corners.size(); i = j++) {
      auto const p = horizontal(in(corners[i])), q = horizontal(in(corners[j]));
      Sign const at_a = orient2d<A>(p, q, horizontal(a_));
      if (!changes(at_a, orient2d<A>(p, q, horizontal(b_)))) continue;
      auto const value = [&](P const& r) -> NT {
        return detail::Orient2dFormula{}(NT(p.x), NT(p.y), NT(q.x), NT(q.y), NT(r.x), NT(r.y));
      };
      clip(interval, at_a, value(a_), value(b_));
    }
  }

  /// Keeps where a linear function is not negative, given its values at the ends, which differ in sign.
  static void clip(ClosedInterval& interval, Sign at_a, NT const& a, NT const& b)
  {
    RationalNumber t = RationalNumber(a) / RationalNumber(a - b);
    if (is_negative(at_a)) {
      if (!interval.low || *interval.low < t) interval.low = std::move(t);
    } else {
      if (!interval.high || t < *interval.high) interval.high = std::move(t);
    }
  }

  HeightField const& field_;
  P a_, b_;
  Sign side_;  ///< of the line: where the area lies that covers
  Covered covered_;
};

/// All columns that are as high as one of the points and whose boxes meet that of the two in plan meet this box.
inline Box reach(Point3q const& p, Point3q const& q)
{
  Box box;
  for (auto const& r : {p, q}) {
    auto const x = CGAL::to_interval(r.x), y = CGAL::to_interval(r.y), z = CGAL::to_interval(r.z);
    box.extend(Point3d{x.first, y.first, z.first});
    box.extend(Point3d{x.second, y.second, z.second});
  }
  box.max.z = std::numeric_limits<double>::infinity();
  return box;
}
inline Box reach(Point3d const& p, Point3d const& q)
{
  Box box;
  box.extend(p);
  box.extend(q);
  box.max.z = std::numeric_limits<double>::infinity();
  return box;
}

/// What closed intervals leave of an open one.
inline std::vector<OpenInterval> remainder(OpenInterval const& range, std::vector<OpenInterval> covered)
{
  std::ranges::sort(covered, {}, &OpenInterval::low);
  std::vector<OpenInterval> open;
  RationalNumber end = range.low;
  for (auto const& c : covered) {
    if (c.low >= range.high) break;
    if (end < c.low) open.push_back({end, c.low});
    if (end < c.high) end = c.high;
  }
  if (end < range.high) open.push_back({end, range.high});
  return open;
}

/// What columns leave of a line that they may cover, found among those that meet `reach`. `range` is asked for only
/// where part of the line is covered.
template <class Cover, class Range>
ExposedParts uncovered(HeightField const& field, Cover const& cover, Box const& reach, Range&& range)
{
  std::vector<std::uint32_t> partly;
  bool const everywhere = field.column_hierarchy().any_item_meeting(reach, [&](std::uint32_t column) {
    Extent const extent = cover.extent(column);
    if (extent == Extent::partly) partly.push_back(column);
    return extent == Extent::everywhere;
  });
  if (everywhere) return {false, {}};
  if (partly.empty()) return {};
  std::vector<OpenInterval> covered;
  for (auto const column : partly)
    if (auto const c = cover.interval(column); c.has_length())
      covered.push_back({c.low.value_or(0), c.high.value_or(1)});
  if (covered.empty()) return {};
  return {false, remainder(range(), std::move(covered))};
}

}  // namespace visibility::height_field
