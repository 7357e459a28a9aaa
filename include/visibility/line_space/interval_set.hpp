#pragma once

#include "visibility/kernel/number_types.hpp"
#include "visibility/line_space/quadratic_number.hpp"

#include <vector>

namespace visibility {

/// A finite union of disjoint open intervals with quadratic end points, ascending. Exact for exact number types.
template <class NT>
class IntervalSet {
public:
  using Number = QuadraticNumber<NT>;
  struct Interval {
    Number low, high;
  };

  IntervalSet() = default;
  /// The open interval between the two, empty unless low < high.
  IntervalSet(Number const& low, Number const& high)
  {
    if (is_negative(compare(low, high))) intervals_.push_back({low, high});
  }

  std::vector<Interval> const& intervals() const { return intervals_; }
  bool empty() const { return intervals_.empty(); }
  void clear() { intervals_.clear(); }
  /// Requires: all of `above` lies above all of this.
  void append(IntervalSet const& above)
  {
    intervals_.insert(intervals_.end(), above.intervals_.begin(), above.intervals_.end());
  }

  /// Keeps the points where a x^2 + b x + c > 0.
  void keep_positive(NT const& a, NT const& b, NT const& c)
  {
    if (empty()) return;
    Sign const sa = sign_of(a), sb = sign_of(b);
    if (is_zero(sa) && is_zero(sb)) {
      if (!is_positive(sign_of(c))) clear();
      return;
    }
    auto const [first, second] = real_roots(a, b, c);
    if (!first) {
      if (is_negative(sa)) clear();
    } else if (is_zero(sa))
      is_positive(sb) ? keep_between(&*first, nullptr) : keep_between(nullptr, &*first);
    else if (is_negative(sa))
      second ? keep_between(&*first, &*second) : clear();
    else {
      IntervalSet right = *this;
      keep_between(nullptr, &*first);
      right.keep_between(second ? &*second : &*first, nullptr);
      append(right);
    }
  }

private:
  void keep_between(Number const* low, Number const* high)
  {
    std::vector<Interval> kept;
    for (auto const& i : intervals_) {
      Number const& l = low != nullptr && is_negative(compare(i.low, *low)) ? *low : i.low;
      Number const& h = high != nullptr && is_positive(compare(i.high, *high)) ? *high : i.high;
      if (is_negative(compare(l, h))) kept.push_back({l, h});
    }
    intervals_ = std::move(kept);
  }

  std::vector<Interval> intervals_;
};

/// A number strictly inside the interval, found by bisection of [0, 1], which must contain it.
template <class NT>
QuadraticNumber<NT> dyadic_inside(typename IntervalSet<NT>::Interval const& interval)
{
  NT low(0), denominator(2);
  for (;;) {
    NT const numerator = low + NT(1);
    auto const candidate = QuadraticNumber<NT>::fraction(numerator, denominator);
    if (!is_negative(compare(interval.low, candidate)))
      low = numerator;
    else if (is_negative(compare(candidate, interval.high)))
      return candidate;
    low = NT(2) * low;
    denominator = NT(2) * denominator;
  }
}

}  // namespace visibility
