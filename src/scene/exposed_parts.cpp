#include "visibility/scene/exposed_parts.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <type_traits>

namespace visibility {

namespace {

/// Closed interval of the parameter of an edge; an end that is not set is that of the edge.
struct ClosedInterval {
  std::optional<RationalNumber> low, high;
};

enum class Extent : std::uint8_t { nowhere, partly, everywhere };

bool are_zero(Sign s, Sign t) { return is_zero(s) && is_zero(t); }
/// Of a linear function with these signs at the ends: whether it is nowhere positive between them.
bool nowhere_positive(Sign s, Sign t) { return !is_positive(s) && !is_positive(t); }
bool changes(Sign s, Sign t) { return is_negative(s * t); }

/// What covers one edge, crossed in one way.
template <Arithmetic A>
class Cover {
public:
  using Column = HeightField::Column;
  /// Of values at the ends of the edge.
  using NT = std::conditional_t<std::same_as<A, Rational>, RationalNumber, ExactNumber>;

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

  /// How much of the edge the column covers, by signs alone. `partly` may turn out to be a point or nothing.
  Extent extent(std::uint32_t column) const
  {
    Column const& f = field_.columns()[column];
    if (column == column_ || f.is_curtain()) return Extent::nowhere;
    Extent const beside = area_beside(field_.corners(f));
    if (beside == Extent::nowhere) return Extent::nowhere;
    Sign const at_a = rise(f, a_), at_b = rise(f, b_);
    if (changes(at_a, at_b)) return Extent::partly;
    bool const covers = are_zero(at_a, at_b) ? !sees_top_ || rises_away(f) : !nowhere_positive(at_a, at_b);
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
  /// How much of the edge has area of the polygon on the side from which it could be covered. Two convex sets in the
  /// plane are apart iff the line of a side of one of them separates them.
  Extent area_beside(std::span<Point3d const> corners) const
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
    if (!beyond || !(before || on >= 2)) return Extent::nowhere;
    Extent extent = Extent::everywhere;
    for (std::size_t i = corners.size() - 1, j = 0; j < corners.size(); i = j++) {
      auto const p = horizontal(corners[i]), q = horizontal(corners[j]);
      Sign const at_a = orient2d<A>(p, q, a), at_b = orient2d<A>(p, q, b);
      if (nowhere_positive(at_a, at_b) && !are_zero(at_a, at_b)) return Extent::nowhere;
      if (changes(at_a, at_b)) extent = Extent::partly;
    }
    return extent;
  }

  /// Sign of how much higher the column's top plane is over p than p. A column that is not flat is a triangle.
  Sign rise(Column const& f, Point3d const& p) const
  {
    auto const c = field_.corners(f);
    if (f.is_flat) return c[0].z > p.z ? Sign::positive : c[0].z < p.z ? Sign::negative : Sign::zero;
    return -orient3d<A>(c[0], c[1], c[2], p);
  }

  /// The same as a number, up to a positive factor that is the same for all p.
  NT exact_rise(Column const& f, Point3d const& r) const
  {
    auto const c = field_.corners(f);
    if (f.is_flat) return NT(c[0].z) - NT(r.z);
    auto const &p = c[0], &q = c[1], &s = c[2];
    return -detail::Orient3dFormula{}(NT(p.x), NT(p.y), NT(p.z), NT(q.x), NT(q.y), NT(q.z), NT(s.x), NT(s.y), NT(s.z),
                                      NT(r.x), NT(r.y), NT(r.z));
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
  Point3d a_, b_;
  Sign side_;             ///< of the edge's line: where the area lies that covers
  std::uint32_t column_;  ///< of the edge
  bool sees_top_;         ///< the top of that column; else its wall
};

/// What closed intervals leave of (0, 1).
std::vector<OpenInterval> complement(std::vector<OpenInterval> covered)
{
  std::ranges::sort(covered, {}, &OpenInterval::low);
  std::vector<OpenInterval> open;
  RationalNumber end = 0;
  for (auto const& c : covered) {
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
  std::vector<std::uint32_t> partly;
  bool const everywhere = field.column_hierarchy().any_item_meeting(cover.reach(), [&](std::uint32_t column) {
    Extent const extent = cover.extent(column);
    if (extent == Extent::partly) partly.push_back(column);
    return extent == Extent::everywhere;
  });
  if (everywhere) return {false, {}};
  if (partly.empty()) return {};
  std::vector<OpenInterval> covered;
  for (auto const column : partly) {
    auto const [low, high] = cover.interval(column);
    if (low && high && *low >= *high) continue;
    covered.push_back({low.value_or(0), high.value_or(1)});
  }
  if (covered.empty()) return {};
  return {false, complement(std::move(covered))};
}

template ExposedParts exposed_parts<Filtered>(HeightField const&, std::uint32_t, Crossing);
template ExposedParts exposed_parts<Rational>(HeightField const&, std::uint32_t, Crossing);

}  // namespace visibility
