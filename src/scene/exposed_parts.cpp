#include "visibility/scene/exposed_parts.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace visibility {

namespace {

/// Closed interval of the parameter of an edge; an end that is not set is that of the edge.
struct ClosedInterval {
  std::optional<RationalNumber> low, high;
  bool is_whole_edge() const { return !low && !high; }
};

bool are_zero(Sign s, Sign t) { return is_zero(s) && is_zero(t); }
/// Of a linear function with these signs at the ends: whether it is nowhere positive between them.
bool nowhere_positive(Sign s, Sign t) { return !is_positive(s) && !is_positive(t); }
bool changes(Sign s, Sign t) { return is_negative(s * t); }

/// What covers one edge, crossed in one way.
template <Arithmetic A>
class Cover {
public:
  using Column = HeightField::Column;

  Cover(HeightField const& field, std::uint32_t edge, Crossing crossing) : field_(field)
  {
    auto const& e = field.edges()[edge];
    bool const leaving = crossing == Crossing::leaving;
    a_ = e.a;
    b_ = e.b;
    side_ = leaving ? Sign::positive : Sign::negative;
    column_ = e.column;
    sees_top_ = leaving && !field.columns()[column_].is_curtain();
  }

  /// Where all columns lie that can cover: a lower top covers nothing.
  Box reach() const
  {
    Box box;
    box.extend(a_);
    box.extend(b_);
    box.max.z = std::numeric_limits<double>::infinity();
    return box;
  }

  /// Where the column covers; nothing if nowhere or only in single points.
  std::optional<ClosedInterval> by(std::uint32_t column) const
  {
    Column const& f = field_.columns()[column];
    if (column == column_ || f.is_curtain()) return {};
    auto const corners = field_.corners(f);
    if (!has_area_beside(corners)) return {};
    Sign const at_a = rise(f, a_), at_b = rise(f, b_);
    if (are_zero(at_a, at_b)) {
      if (sees_top_ && !rises_away(f)) return {};
    } else if (nowhere_positive(at_a, at_b)) {
      return {};
    }
    ClosedInterval covered;
    clip(covered, corners);
    if (changes(at_a, at_b)) clip(covered, at_a, exact_rise(f, a_), exact_rise(f, b_));
    if (covered.low && covered.high && *covered.low >= *covered.high) return {};
    return covered;
  }

private:
  /// Whether the polygon reaches to the side of the edge from a stretch of its line that meets the edge. Separates the
  /// two by the edge's line and by the sides of the polygon, which is enough for convex sets in the plane.
  bool has_area_beside(std::span<Point3d const> corners) const
  {
    auto const a = horizontal(a_), b = horizontal(b_);
    bool beyond = false, before = false;
    int on = 0;
    for (auto const& c : corners) {
      Sign const s = orient2d<A>(a, b, horizontal(c));
      beyond |= s == side_;
      before |= s == -side_;
      on += is_zero(s);
    }
    if (!beyond || !(before || on >= 2)) return false;
    for (std::size_t i = corners.size() - 1, j = 0; j < corners.size(); i = j++) {
      auto const p = horizontal(corners[i]), q = horizontal(corners[j]);
      Sign const at_a = orient2d<A>(p, q, a), at_b = orient2d<A>(p, q, b);
      if (nowhere_positive(at_a, at_b) && !are_zero(at_a, at_b)) return false;
    }
    return true;
  }

  /// Sign of how much higher the column's top plane is over p than p. A column that is not flat is a triangle.
  Sign rise(Column const& f, Point3d const& p) const
  {
    auto const c = field_.corners(f);
    if (f.is_flat) return c[0].z > p.z ? Sign::positive : c[0].z < p.z ? Sign::negative : Sign::zero;
    return -orient3d<A>(c[0], c[1], c[2], p);
  }

  /// The same as a number, up to a positive factor that is the same for all p.
  RationalNumber exact_rise(Column const& f, Point3d const& p) const
  {
    using NT = RationalNumber;
    auto const c = field_.corners(f);
    if (f.is_flat) return NT(c[0].z) - NT(p.z);
    auto const [x0, y0, z0] = exact(c[0]);
    auto const [x1, y1, z1] = exact(c[1]);
    auto const [x2, y2, z2] = exact(c[2]);
    auto const [x, y, z] = exact(p);
    return -detail::Orient3dFormula{}(x0, y0, z0, x1, y1, z1, x2, y2, z2, x, y, z);
  }

  /// Of a column whose top plane contains the edge: whether it is above that of the edge's column on the latter's side.
  bool rises_away(Column const& f) const
  {
    return std::ranges::any_of(field_.corners(field_.columns()[column_]),
                               [&](Point3d const& p) { return is_positive(rise(f, p)); });
  }

  /// Keeps what lies in the polygon.
  void clip(ClosedInterval& interval, std::span<Point3d const> corners) const
  {
    using NT = RationalNumber;
    for (std::size_t i = corners.size() - 1, j = 0; j < corners.size(); i = j++) {
      auto const p = horizontal(corners[i]), q = horizontal(corners[j]);
      Sign const at_a = orient2d<A>(p, q, horizontal(a_));
      if (!changes(at_a, orient2d<A>(p, q, horizontal(b_)))) continue;
      auto const value = [&](Point3d const& r) -> NT {
        return detail::Orient2dFormula{}(NT(p.x), NT(p.y), NT(q.x), NT(q.y), NT(r.x), NT(r.y));
      };
      clip(interval, at_a, value(a_), value(b_));
    }
  }

  /// Keeps where a linear function is not negative, given its values at the ends, which differ in sign.
  static void clip(ClosedInterval& interval, Sign at_a, RationalNumber const& a, RationalNumber const& b)
  {
    RationalNumber t = a / (a - b);
    if (is_negative(at_a)) {
      if (!interval.low || *interval.low < t) interval.low = std::move(t);
    } else {
      if (!interval.high || t < *interval.high) interval.high = std::move(t);
    }
  }

  HeightField const& field_;
  Point3d a_, b_;
  Sign side_;             ///< of the edge's line: where the area lies that covers
  std::uint32_t column_;  ///< of the edge
  bool sees_top_;         ///< the top of that column; else its wall
};

/// What is left of (0, 1).
std::vector<OpenInterval> complement(std::vector<ClosedInterval> const& covered)
{
  std::vector<OpenInterval> closed, open;
  for (auto const& c : covered) closed.push_back({c.low.value_or(0), c.high.value_or(1)});
  std::ranges::sort(closed, {}, &OpenInterval::low);
  RationalNumber end = 0;
  for (auto const& c : closed) {
    if (end < c.low) open.push_back({end, c.low});
    if (end < c.high) end = c.high;
  }
  if (end < 1) open.push_back({end, 1});
  return open;
}

}  // namespace

template <Arithmetic A>
ExposedParts exposed_parts(HeightField const& field, std::uint32_t edge, Crossing crossing)
{
  Cover<A> const cover(field, edge, crossing);
  std::vector<ClosedInterval> covered;
  bool const everywhere = field.column_hierarchy().any_item_meeting(cover.reach(), [&](std::uint32_t column) {
    auto interval = cover.by(column);
    if (!interval) return false;
    if (interval->is_whole_edge()) return true;
    covered.push_back(std::move(*interval));
    return false;
  });
  if (everywhere) return {false, {}};
  if (covered.empty()) return {};
  return {false, complement(covered)};
}

template ExposedParts exposed_parts<Filtered>(HeightField const&, std::uint32_t, Crossing);
template ExposedParts exposed_parts<Rational>(HeightField const&, std::uint32_t, Crossing);

}  // namespace visibility
