#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/kernel/point.hpp"

#include <compare>

namespace visibility {

/// A coordinate of a sight line's end: a double, or a rational enclosed by doubles. Cheap to copy; keeps a reference
/// to the rational. Comparisons are exact.
class Coordinate {
public:
  Coordinate(double x) : below_(x), above_(x) {}  // NOLINT: implicit, as from double to any number type
  explicit Coordinate(RationalNumber const& x) : exact_(&x) { std::tie(below_, above_) = CGAL::to_interval(x); }

  double below() const { return below_; }
  double above() const { return above_; }
  RationalNumber rational() const { return exact_ != nullptr ? *exact_ : RationalNumber(below_); }

  friend std::strong_ordering operator<=>(Coordinate const& a, Coordinate const& b)
  {
    if (a.above_ < b.below_) return std::strong_ordering::less;
    if (a.below_ > b.above_) return std::strong_ordering::greater;
    if (a.exact_ == b.exact_ && a.below_ == b.below_ && a.above_ == b.above_) return std::strong_ordering::equal;
    auto const s = CGAL::compare(a.rational(), b.rational());
    return s == CGAL::SMALLER  ? std::strong_ordering::less
           : s == CGAL::LARGER ? std::strong_ordering::greater
                               : std::strong_ordering::equal;
  }
  friend bool operator==(Coordinate const& a, Coordinate const& b) { return (a <=> b) == std::strong_ordering::equal; }

private:
  double below_ = 0, above_ = 0;
  RationalNumber const* exact_ = nullptr;
};

/// The coordinates of a point that outlives them.
inline Point3<Coordinate> coordinates(Point3q const& p) { return {Coordinate(p.x), Coordinate(p.y), Coordinate(p.z)}; }
inline Point3<Coordinate> coordinates(Point3d const& p) { return {Coordinate(p.x), Coordinate(p.y), Coordinate(p.z)}; }

/// Exact arithmetic for constructed coordinates: intervals, then rationals.
struct FilteredRational {
  static constexpr std::string_view name = "filtered-rational";
  static constexpr bool is_exact = true;
  template <class Formula, std::convertible_to<Coordinate>... X>
  static Sign sign(Formula const& f, X const&... x)
  {
    return decide(f, Coordinate(x)...);
  }

private:
  template <class Formula, class... C>
  static Sign decide(Formula const& f, C const&... x)
  {
    // Inside this domain no bound of a formula of degree layers::max_degree overflows.
    auto const tame = [](Coordinate const& c) {
      return c.below() >= -layers::interval_domain && c.above() <= layers::interval_domain;
    };
    if ((tame(x) && ...)) {
      CGAL::Protect_FPU_rounding<true> const upward;
      IntervalNumber const value = f(IntervalNumber(x.below(), x.above())...);
      if (value.inf() > 0) return Sign::positive;
      if (value.sup() < 0) return Sign::negative;
    }
    return Rational::sign(f, x.rational()...);
  }
};
static_assert(Arithmetic<FilteredRational>);

}  // namespace visibility
