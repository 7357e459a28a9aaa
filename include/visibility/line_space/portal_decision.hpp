#pragma once

#include "visibility/line_space/interval_set.hpp"
#include "visibility/line_space/portal_sequence.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <array>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace visibility {

/// A polynomial of degree one in each of two parameters: the position s on the source edge and t on the target edge,
/// both from the left end (0) to the right end (1). Every condition on a sight line that joins the two is one:
/// the side of a plan point, and the side of a third line.
template <class NT>
struct BilinearForm {
  NT c, s, t, st;

  static BilinearForm from_corners(NT const& left_left, NT const& right_left, NT const& left_right,
                                   NT const& right_right)
  {
    return {left_left, right_left - left_left, left_right - left_left,
            right_right - right_left - left_right + left_left};
  }
  BilinearForm swapped() const { return {c, t, s, st}; }
};

/// The sight lines of a portal sequence, exactly, by conics in 2D line space. With s and t as coordinates of line space
/// a conic is a hyperbola: at a fixed s every condition bounds t from one side by a fraction of linear functions of s,
/// so some t is left iff each lower bound is below each upper bound, a quadratic inequality in s for each pair.
/// Degree in input coordinates: 3 for a form, 6 for a quadratic, 12 for its discriminant.
/// Source: design of this library; proofs/exact_2_5d.md. Independent of the Pluecker cone (stabbing_line.hpp).
template <class NT>
class PortalDecision {
public:
  /// Constructed points and ends of the target have a common denominator, by which their conditions are multiplied.
  explicit PortalDecision(PortalSequence const& sequence)
  {
    source_ = {number(sequence.source.left), number(sequence.source.right)};
    if (auto const& target = sequence.constructed_target)
      target_ = {homogeneous(target->left), homogeneous(target->right)};
    else
      target_ = {Homogeneous{number(sequence.target.left), NT(1)}, Homogeneous{number(sequence.target.right), NT(1)}};
    for (auto const& f : sequence.occluders) add(occluder_form(f));
    for (auto const& x : sequence.points) add(point_form({{NT(x.point.x), NT(x.point.y), NT(0)}, NT(1)}, x.side));
    for (auto const& x : sequence.constructed_points)
      add(point_form(homogeneous({x.point.x, x.point.y, RationalNumber(0)}), x.side));
  }

  /// A sight line by its parameters on source and target.
  struct SightLine {
    RationalNumber source, target;
  };

  /// Empty if there is none.
  std::optional<SightLine> find() const
  {
    auto const open = positions(forms_);
    if (open.empty()) return std::nullopt;
    auto const inside = dyadic_inside<NT>(open.intervals().front());
    RationalNumber const s = rational(inside.p) / rational(inside.r), t = middle_target(s);
    RationalNumber const left = (RationalNumber(1) - t) * rational(target_[0].w), right = t * rational(target_[1].w);
    return SightLine{s, right / (left + right)};
  }
  bool exists() const { return !positions(forms_).empty(); }

  /// The parts of the source edge that see the target, and those of the target edge that are seen: the antipenumbra's
  /// traces. End points are exact quadratic numbers. Requires of `target_parts`: the target is not constructed.
  IntervalSet<NT> source_parts() const { return positions(forms_); }
  IntervalSet<NT> target_parts() const
  {
    std::vector<BilinearForm<NT>> swapped;
    for (auto const& f : forms_) swapped.push_back(f.swapped());
    return positions(swapped);
  }

private:
  using Form = BilinearForm<NT>;
  using Point = Point3<NT>;
  using Linear = std::array<NT, 2>;  // constant and slope

  static Point number(Point3d const& p) { return {NT(p.x), NT(p.y), NT(p.z)}; }
  /// The point p / w. Invariant: w > 0.
  struct Homogeneous {
    Point p;
    NT w;
  };
  static Homogeneous homogeneous(Point3q const& q)
  {
    if constexpr (std::is_same_v<NT, RationalNumber>) {
      return {q, NT(1)};
    } else if constexpr (std::is_same_v<NT, double>) {
      return {{CGAL::to_double(q.x), CGAL::to_double(q.y), CGAL::to_double(q.z)}, 1.0};
    } else {
      using Integer = CGAL::Gmpz;
      auto const common = [](Integer const& a, Integer const& b) {
        return Integer(a * CGAL::integral_division(b, CGAL::gcd(a, b)));
      };
      Integer const w = common(common(q.x.denominator(), q.y.denominator()), q.z.denominator());
      auto const scaled = [&](RationalNumber const& x) -> NT {
        Integer const n = x.numerator() * CGAL::integral_division(w, x.denominator());
        // CGAL 5.5 makes an Mpzf of an integer without its sign, and none of zero.
        if (is_zero(sign_of(n))) return NT(0);
        return is_negative(sign_of(n)) ? NT(0) - NT(Integer(-n)) : NT(n);
      };
      return {{scaled(q.x), scaled(q.y), scaled(q.z)}, NT(w)};
    }
  }

  static RationalNumber rational(RationalNumber const& x) { return x; }
  static RationalNumber rational(double x) { return RationalNumber(x); }
#ifdef CGAL_HAS_MPZF
  static RationalNumber rational(ExactNumber const& x) { return x.operator CGAL::Gmpq(); }
#endif

  /// How far a line passes above an edge.
  Form occluder_form(PortalSequence::Edge const& f) const
  {
    Point const left = number(f.left), right = number(f.right);
    return form([&](Point const& a, Point const& b) {
      return NT(
        detail::Orient3dFormula{}(a.x, a.y, a.z, b.x, b.y, b.z, right.x, right.y, right.z, left.x, left.y, left.z));
    });
  }

  /// How far a plan point lies on its side of a line.
  Form point_form(Homogeneous const& x, PortalSequence::Side side) const
  {
    return form([&](Point const& a, Point const& b) {
      NT const turn =
        times(x, [&](Point const& y) -> NT { return detail::Orient2dFormula{}(a.x, a.y, b.x, b.y, y.x, y.y); });
      return side == PortalSequence::Side::left ? turn : NT(NT(0) - turn);
    });
  }

  /// w f(p / w) for a function that is affine in the point.
  template <class Affine>
  static NT times(Homogeneous const& q, Affine const& f)
  {
    if (q.w == NT(1)) return f(q.p);
    return f(q.p) + (q.w - NT(1)) * f(Point{NT(0), NT(0), NT(0)});
  }

  template <class Condition>
  Form form(Condition const& at) const
  {
    auto const corner = [&](Point const& source, Homogeneous const& target) -> NT {
      return times(target, [&](Point const& t) -> NT { return at(source, t); });
    };
    return Form::from_corners(corner(source_[0], target_[0]), corner(source_[1], target_[0]),
                              corner(source_[0], target_[1]), corner(source_[1], target_[1]));
  }

  /// Leaves out what holds on the whole open square.
  void add(Form const& f)
  {
    NT const right_left = f.c + f.s, left_right = f.c + f.t, right_right = right_left + f.t + f.st;
    std::array const signs{sign_of(f.c), sign_of(right_left), sign_of(left_right), sign_of(right_right)};
    bool const never_negative = std::ranges::none_of(signs, [](Sign s) { return is_negative(s); });
    bool const somewhere_positive = std::ranges::any_of(signs, [](Sign s) { return is_positive(s); });
    if (!(never_negative && somewhere_positive)) forms_.push_back(f);
  }

  /// The s in (0, 1) for which some t in (0, 1) makes all forms positive.
  static IntervalSet<NT> positions(std::vector<Form> const& forms);
  /// With all slopes in t of constant sign on the interval.
  static IntervalSet<NT> positions(std::vector<Form> const& forms, QuadraticNumber<NT> const& low,
                                   QuadraticNumber<NT> const& high);
  RationalNumber middle_target(RationalNumber const& s) const;

  std::array<Point, 2> source_;        // left and right end
  std::array<Homogeneous, 2> target_;  // positions in between are weighted by w
  std::vector<Form> forms_;
};

template <class NT>
IntervalSet<NT> PortalDecision<NT>::positions(std::vector<Form> const& forms)
{
  // The slope of a form in t is linear in s: cut (0, 1) where one changes its sign.
  std::vector<QuadraticNumber<NT>> cuts{QuadraticNumber<NT>::integer(0), QuadraticNumber<NT>::integer(1)};
  for (auto const& f : forms) {
    if (is_zero(sign_of(f.st))) continue;
    auto const cut = QuadraticNumber<NT>::fraction(NT(0) - f.t, f.st);
    if (is_positive(compare(cut, cuts[0])) && is_negative(compare(cut, cuts[1]))) cuts.push_back(cut);
  }
  std::ranges::sort(cuts, [](auto const& a, auto const& b) { return is_negative(compare(a, b)); });
  IntervalSet<NT> out;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    if (is_negative(compare(cuts[i], cuts[i + 1]))) out.append(positions(forms, cuts[i], cuts[i + 1]));
  return out;
}

template <class NT>
IntervalSet<NT> PortalDecision<NT>::positions(std::vector<Form> const& forms, QuadraticNumber<NT> const& low,
                                              QuadraticNumber<NT> const& high)
{
  struct Bound {
    Linear value, slope;  // value(s) + slope(s) t > 0
  };
  IntervalSet<NT> open(low, high);
  std::vector<Bound> lower{{{NT(0), NT(0)}, {NT(1), NT(0)}}};                              // t > 0
  std::vector<Bound> upper{{{NT(1), NT(0)}, {NT(-1), NT(0)}}};                             // 1 - t > 0
  NT const middle_p = low.p * high.r + high.p * low.r, middle_r = NT(2) * low.r * high.r;  // both are fractions
  for (auto const& f : forms) {
    Bound const b{{f.c, f.s}, {f.t, f.st}};
    switch (sign_of(NT(f.t * middle_r + f.st * middle_p))) {
    case Sign::positive: lower.push_back(b); break;
    case Sign::negative: upper.push_back(b); break;
    case Sign::zero: open.keep_positive(NT(0), f.s, f.c); break;
    }
  }
  // l < u for the bounds l = -value/slope of a lower and u of an upper one: value_u slope_l - value_l slope_u > 0.
  for (auto const& l : lower)
    for (auto const& u : upper) {
      if (open.empty()) return open;
      auto const product = [](Linear const& a, Linear const& b) {
        return std::array<NT, 3>{a[1] * b[1], a[0] * b[1] + a[1] * b[0], a[0] * b[0]};
      };
      auto const x = product(u.value, l.slope), y = product(l.value, u.slope);
      open.keep_positive(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
    }
  return open;
}

/// The middle of the positions on the target that a feasible position on the source sees.
template <class NT>
RationalNumber PortalDecision<NT>::middle_target(RationalNumber const& s) const
{
  RationalNumber low(0), high(1);
  for (auto const& f : forms_) {
    RationalNumber const value = rational(f.c) + rational(f.s) * s, slope = rational(f.t) + rational(f.st) * s;
    if (is_zero(sign_of(slope))) continue;
    RationalNumber const bound = -value / slope;
    if (is_positive(sign_of(slope)))
      low = std::max(low, bound);
    else
      high = std::min(high, bound);
  }
  return (low + high) / RationalNumber(2);
}

}  // namespace visibility
