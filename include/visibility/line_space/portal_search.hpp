#pragma once

#include "visibility/kernel/enclosed_rational.hpp"
#include "visibility/line_space/portal_sequence.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace visibility {

/// A portal sequence decided in intervals, by branch and bound over the positions on source and target; certain
/// whenever it answers. Every condition is bilinear in the two positions (BilinearForm), so that over a rectangle of
/// positions it lies between the least and the greatest of its values at the corners. A rectangle at whose corners
/// some condition is nowhere positive has no sight line; one where all are positive at the middle has one there.
/// The filter of PortalDecision, which decides what is left: lines that exist on less than a curve's width, or nearly.
/// proofs/exact_2_5d.md, "Branch and bound".
class PortalSearch {
public:
  enum class Answer : std::uint8_t { none, line, unknown };

  explicit PortalSearch(PortalSequence const& sequence)
  {
    std::array<End, 2> const source{end(sequence.source.left), end(sequence.source.right)};
    auto const& t = sequence.constructed_target;
    std::array<End, 2> const target{t ? end(t->left) : end(sequence.target.left),
                                    t ? end(t->right) : end(sequence.target.right)};
    for (auto const& f : sequence.occluders) {
      End const left = end(f.left), right = end(f.right);
      add(
        source, target, [](End const&, End const&) { return false; },
        [&](End const& a, End const& b, auto const& sign_of) {
          return sign_of(detail::Orient3dFormula{}, a[0], a[1], a[2], b[0], b[1], b[2], right[0], right[1], right[2],
                         left[0], left[1], left[2]);
        });
    }
    auto const add_point = [&](EnclosedRational const& x, EnclosedRational const& y, PortalSequence::Side side) {
      bool const left = side == PortalSequence::Side::left;
      add(
        source, target,
        [&](End const& a, End const& b) { return (a[0] == x && a[1] == y) || (b[0] == x && b[1] == y); },
        [&](End const& a, End const& b, auto const& sign_of) {
          return left ? sign_of(detail::Orient2dFormula{}, a[0], a[1], b[0], b[1], x, y)
                      : sign_of(detail::Orient2dFormula{}, b[0], b[1], a[0], a[1], x, y);
        });
    };
    for (auto const& x : sequence.points) add_point(x.point.x, x.point.y, x.side);
    for (auto const& x : sequence.constructed_points) add_point(x.point.x, x.point.y, x.side);
  }

  /// Looks at no more than `most` rectangles. After `line`, `source()` and `target()` are the positions of one.
  Answer run(int most)
  {
    if (!is_bounded_) return Answer::unknown;
    left_ = most;
    CGAL::Protect_FPU_rounding<true> const upward;
    return search({0, 1, 0, 1}, 0, forms_.size());
  }
  double source() const { return source_; }
  double target() const { return target_; }

private:
  static constexpr double smallest = 0x1p-24;  // far above one unit in the last place: positions are exact
  using End = std::array<EnclosedRational, 3>;

  /// Bounds of a condition at the four corners of a rectangle: source low, high at target low, then at target high.
  /// The lower one is kept negative, so that both are rounded upwards.
  struct Form {
    std::array<double, 4> high, minus_low;
  };
  /// Of positions on source and target; multiples of small powers of two.
  struct Rectangle {
    double source_low, source_high, target_low, target_high;
  };

  static End end(Point3d const& p) { return {p.x, p.y, p.z}; }
  static End end(Point3q const& p) { return {p.x, p.y, p.z}; }

  /// `vanishes`: at two ends the condition is zero, as it shows without arithmetic.
  template <class Vanishes, class Condition>
  void add(std::array<End, 2> const& source, std::array<End, 2> const& target, Vanishes const& vanishes,
           Condition const& condition)
  {
    Form form{};
    {
      CGAL::Protect_FPU_rounding<true> const upward;
      for (std::size_t i = 0; i < 4; ++i) {
        if (vanishes(source[i & 1], target[i / 2])) continue;
        auto const [low, high] = condition(source[i & 1], target[i / 2], bounds);
        form.high[i] = high, form.minus_low[i] = -low;
        is_bounded_ &= std::isfinite(low) && std::isfinite(high);
      }
    }
    if (is_positive_inside(form)) return;
    // What touches is the rule, and a bound that is not zero there would never end.
    for (std::size_t i = 0; i < 4; ++i)
      if (form.high[i] > 0 && form.minus_low[i] > 0) {
        Sign const s = condition(source[i & 1], target[i / 2], exact_sign);
        if (!is_positive(s)) form.high[i] = 0;
        if (!is_negative(s)) form.minus_low[i] = 0;
      }
    if (!is_positive_inside(form)) forms_.push_back(form);
  }

  static constexpr auto bounds = [](auto const& formula, auto const&... x) {
    if (!((-layers::interval_domain <= x.low() && x.high() <= layers::interval_domain) && ...))
      return std::pair{-HUGE_VAL, HUGE_VAL};
    IntervalNumber const v = formula(IntervalNumber(x.low(), x.high())...);
    return std::pair{v.inf(), v.sup()};
  };
  static constexpr auto exact_sign = [](auto const& formula, auto const&... x) {
    return ((x.low() == x.high()) && ...) ? Filtered::sign(formula, x.low()...) : FilteredRational::sign(formula, x...);
  };

  static bool is_positive_inside(Form const& f)
  {
    return std::ranges::none_of(f.minus_low, [](double x) { return x > 0; }) &&
           std::ranges::any_of(f.minus_low, [](double x) { return x < 0; });
  }

  Answer search(Rectangle const& r, std::size_t first, std::size_t last);

  boost::container::small_vector<Form, 64> forms_;  // those of the sequence, then those open in nested rectangles
  bool is_bounded_ = true;
  int left_ = 0;
  double source_ = 0, target_ = 0;
};

/// Requires: rounding upwards. The conditions `first` to `last` are open; all others are positive in the rectangle.
inline auto PortalSearch::search(Rectangle const& r, std::size_t first, std::size_t last) -> Answer
{
  double const source = r.source_low / 2 + r.source_high / 2, target = r.target_low / 2 + r.target_high / 2;
  bool is_line = true;
  double by_source = 0, by_target = 0;  // how much conditions change along either
  for (std::size_t i = first; i < last; ++i) {
    auto const& [h, l] = forms_[i];
    if (std::max(std::max(h[0], h[1]), std::max(h[2], h[3])) <= 0) return Answer::none;
    is_line &= (l[0] + l[1]) + (l[2] + l[3]) < 0;
    double const size =
      std::max(std::max(std::fabs(h[0]), std::fabs(h[1])), std::max(std::fabs(h[2]), std::fabs(h[3])));
    by_source += (std::fabs(h[1] - h[0]) + std::fabs(h[3] - h[2])) / size;
    by_target += (std::fabs(h[2] - h[0]) + std::fabs(h[3] - h[1])) / size;
  }
  if (is_line) {
    source_ = source, target_ = target;
    return Answer::line;
  }
  if (--left_ < 0 || r.source_high - r.source_low < smallest || r.target_high - r.target_low < smallest)
    return Answer::unknown;
  // Halve it across the direction in which conditions change most.
  bool const across = by_source >= by_target;
  Answer answer = Answer::none;
  for (bool const upper : {false, true}) {
    std::size_t const begin = forms_.size();
    for (std::size_t i = first; i < last; ++i) {
      Form f = forms_[i];
      auto const halve = [&](std::array<double, 4>& v) {
        double const a = v[0] / 2 + v[across ? 1 : 2] / 2, b = v[across ? 2 : 1] / 2 + v[3] / 2;
        v[upper ? 0 : across ? 1 : 2] = a;
        v[upper ? (across ? 2 : 1) : 3] = b;
      };
      halve(f.high);
      halve(f.minus_low);
      if (!is_positive_inside(f)) forms_.push_back(f);
    }
    Rectangle half = r;
    (across ? (upper ? half.source_low : half.source_high) : (upper ? half.target_low : half.target_high)) =
      across ? source : target;
    Answer const found = search(half, begin, forms_.size());
    forms_.resize(begin);
    if (found == Answer::line) return found;
    if (found == Answer::unknown) answer = found;
  }
  return answer;
}

}  // namespace visibility
