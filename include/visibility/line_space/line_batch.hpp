#pragma once

#include "visibility/line_space/funnel.hpp"

#include <array>
#include <cmath>
#include <concepts>

namespace visibility {

/// The vertices of a funnel side by side, to ask on which side of all of them a plan point lies: the question that
/// every node of an occlusion tree puts. One multiply-add per line in doubles about a local origin, with one error
/// bound for all; where it cannot tell, the exact predicate does. proofs/exact_2_5d.md, "Sides of many lines".
template <Arithmetic A>
class LineBatch {
public:
  static constexpr std::size_t capacity = 12;

  LineBatch(Funnel const& lines, Point2d const& origin) : origin_(origin), size_(lines.vertices().size())
  {
    if (size_ > capacity) return;
    for (std::size_t i = 0; i < size_; ++i) {
      auto const& v = lines.vertices()[i];
      double const x = v.p.x - origin.x, y = v.p.y - origin.y;
      a_[i] = v.p.y - v.q.y;
      b_[i] = v.q.x - v.p.x;
      c_[i] = -(b_[i] * y + a_[i] * x);
      extent_ = std::max(extent_, std::fabs(x) + std::fabs(y));
      size_bound_ = std::max(size_bound_, std::fabs(a_[i]) + std::fabs(b_[i]));
    }
    rows_ = (size_ + 3) / 4 * 4;
    for (std::size_t i = size_; i < rows_; ++i) a_[i] = a_[0], b_[i] = b_[0], c_[i] = c_[0];
  }

  /// The sides of the point as seen along each line, where that is certain for all.
  enum class Answer : std::uint8_t { left, right, both, unknown };
  Answer side(Point2d const& point) const
  {
    std::array<double, capacity> ignored;
    return side(point, ignored);
  }
  /// The same; if the answer is `both`, `sides` have the sign of each line's.
  Answer side(Point2d const& point, std::array<double, capacity>& sides) const
  {
    if (std::same_as<A, Rational> || size_ > capacity) return Answer::unknown;
    double const x = point.x - origin_.x, y = point.y - origin_.y;
    double const size = size_bound_ * (extent_ + std::fabs(x) + std::fabs(y));
    if (!(size < 0x1p1000)) return Answer::unknown;  // or products may overflow
    double const error = A::is_exact ? 0x1p-49 * size + 0x1p-900 : 0;
    double least = HUGE_VAL, greatest = -HUGE_VAL, closest = HUGE_VAL;
    for (std::size_t i = 0; i < rows_; ++i) {
      double const s = a_[i] * x + b_[i] * y + c_[i];
      sides[i] = s;
      least = s < least ? s : least;
      greatest = s > greatest ? s : greatest;
      double const distance = std::fabs(s);
      closest = distance < closest ? distance : closest;
    }
    if (least > error) return Answer::left;
    if (greatest < -error) return Answer::right;
    return closest > error ? Answer::both : Answer::unknown;
  }

private:
  std::array<double, capacity> a_{}, b_{}, c_{};
  Point2d origin_;
  double extent_ = 0, size_bound_ = 0;
  std::size_t size_, rows_ = 0;
};

}  // namespace visibility
