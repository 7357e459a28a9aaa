#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/kernel/layers.hpp"
#include "visibility/kernel/number_types.hpp"
#include "visibility/kernel/point.hpp"

#include <compare>
#include <string_view>

namespace visibility {

/// A rational number, or a double, between two doubles: what `FilteredRational` computes with first. Cheap to copy;
/// keeps a reference to a rational number, which must outlive it. Comparisons are exact.
class EnclosedRational {
public:
  EnclosedRational(double x) : low_(x), high_(x) {}
  EnclosedRational(RationalNumber const& x) : number_(&x)
  {
    auto const [low, high] = CGAL::to_interval(x);
    low_ = low, high_ = high;
  }
  EnclosedRational(RationalNumber&&) = delete;

  double low() const { return low_; }
  double high() const { return high_; }
  RationalNumber exact() const { return number_ != nullptr ? *number_ : RationalNumber(low_); }
  friend std::strong_ordering operator<=>(EnclosedRational const& a, EnclosedRational const& b)
  {
    if (a.high_ < b.low_) return std::strong_ordering::less;
    if (a.low_ > b.high_) return std::strong_ordering::greater;
    if (a.low_ == b.low_ && a.high_ == b.high_ && (a.low_ == a.high_ || a.number_ == b.number_))
      return std::strong_ordering::equal;
    RationalNumber const x = a.exact(), y = b.exact();
    return x < y ? std::strong_ordering::less : y < x ? std::strong_ordering::greater : std::strong_ordering::equal;
  }
  friend bool operator==(EnclosedRational const& a, EnclosedRational const& b)
  {
    return (a <=> b) == std::strong_ordering::equal;
  }

private:
  double low_, high_;
  RationalNumber const* number_ = nullptr;
};

/// A point that outlives its coordinates.
inline Point3<EnclosedRational> enclosed(Point3q const& p) { return {p.x, p.y, p.z}; }
inline Point3<EnclosedRational> enclosed(Point3d const& p) { return {p.x, p.y, p.z}; }

/// Signs for coordinates that are rationals or doubles: intervals first, then rational numbers. Exact.
struct FilteredRational {
  static constexpr std::string_view name = "filtered rational";
  static constexpr bool is_exact = true;

  template <class Formula, class... X>
  static Sign sign(Formula const& f, X const&... x)
  {
    return enclosed_sign(f, EnclosedRational(x)...);
  }

private:
  template <class Formula, class... X>
  static Sign enclosed_sign(Formula const& f, X const&... x)
  {
    if (auto const s = interval_sign(f, x...)) return *s;
    return Rational::sign(f, x.exact()...);
  }
  template <class Formula, class... X>
  static MaybeSign interval_sign(Formula const& f, X const&... x)
  {
    // Outside this domain a bound might overflow.
    if (!((-layers::interval_domain <= x.low() && x.high() <= layers::interval_domain) && ...)) return {};
    CGAL::Protect_FPU_rounding<true> const upward;
    IntervalNumber const value = f(IntervalNumber(x.low(), x.high())...);
    if (value.inf() > 0) return Sign::positive;
    if (value.sup() < 0) return Sign::negative;
    if (value.inf() == 0 && value.sup() == 0) return Sign::zero;
    return {};
  }
};
static_assert(Arithmetic<FilteredRational>);

}  // namespace visibility
