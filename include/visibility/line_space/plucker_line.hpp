#pragma once

#include "visibility/kernel/number_types.hpp"
#include "visibility/kernel/point.hpp"
#include "visibility/kernel/sign.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace visibility {

/// An oriented line in homogeneous Plücker coordinates, or any other vector of Plücker space (R^6 with the product
/// below): the line through p towards q has direction q - p and moment p x q. Scaling by a positive number keeps the
/// line, by a negative one reverses it. A vector is a real line (possibly at infinity: direction zero) iff it is not
/// zero and `plucker_form` is zero.
template <class NT>
struct PluckerLine {
  using Number = NT;
  std::array<NT, 3> direction{NT(0), NT(0), NT(0)}, moment{NT(0), NT(0), NT(0)};

  NT& operator[](std::size_t i) { return i < 3 ? direction[i] : moment[i - 3]; }
  NT const& operator[](std::size_t i) const { return i < 3 ? direction[i] : moment[i - 3]; }
  friend bool operator==(PluckerLine const&, PluckerLine const&) = default;
};

/// The line through p towards q; exact for exact NT. Zero iff p == q. Components of degree 1 and 2.
template <class NT>
PluckerLine<NT> line_through(Point3<NT> const& p, Point3<NT> const& q)
{
  return {{q.x - p.x, q.y - p.y, q.z - p.z}, {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x}};
}

/// The upward vertical line through a plan point.
template <class NT>
PluckerLine<NT> vertical_line(Point2<NT> const& p)
{
  return {{NT(0), NT(0), NT(1)}, {p.y, NT(0) - p.x, NT(0)}};
}

/// The line with the opposite direction.
template <class NT>
PluckerLine<NT> reversed(PluckerLine<NT> const& l)
{
  PluckerLine<NT> r;
  for (std::size_t i = 0; i < 6; ++i) r[i] = NT(0) - l[i];
  return r;
}

/// The permuted inner product b(k, l) = d_k.m_l + d_l.m_k. For lines through points it is det[q-p, r-p, s-p]
/// (proofs/plucker.md): its sign is `line_side`, zero iff the lines meet or are parallel; bilinear and symmetric.
template <class NT>
NT plucker_product(PluckerLine<NT> const& k, PluckerLine<NT> const& l)
{
  return k.direction[0] * l.moment[0] + k.direction[1] * l.moment[1] + k.direction[2] * l.moment[2] +
         (k.moment[0] * l.direction[0] + k.moment[1] * l.direction[1] + k.moment[2] * l.direction[2]);
}

/// The quadratic form q(l) = b(l, l) = 2 d.m, of signature (3, 3): zero exactly on real lines.
template <class NT>
NT plucker_form(PluckerLine<NT> const& l)
{
  NT const half = l.direction[0] * l.moment[0] + l.direction[1] * l.moment[1] + l.direction[2] * l.moment[2];
  return half + half;
}

/// a k + b l.
template <class NT>
PluckerLine<NT> combination(NT const& a, PluckerLine<NT> const& k, NT const& b, PluckerLine<NT> const& l)
{
  PluckerLine<NT> r;
  for (std::size_t i = 0; i < 6; ++i) r[i] = a * k[i] + b * l[i];
  return r;
}

/// Sign of a value of any number type that the cones use.
template <class NT>
Sign number_sign(NT const& x)
{
  return static_cast<Sign>(static_cast<int>(CGAL::sign(x)));
}

/// |x|, exact.
template <class NT>
NT magnitude(NT const& x)
{
  return is_negative(number_sign(x)) ? NT(0) - x : x;
}

template <class NT>
bool is_zero(PluckerLine<NT> const& l)
{
  for (std::size_t i = 0; i < 6; ++i)
    if (!is_zero(number_sign(l[i]))) return false;
  return true;
}

/// The line in rationals.
template <class NT>
PluckerLine<RationalNumber> rational(PluckerLine<NT> const& l)
{
  PluckerLine<RationalNumber> r;
  for (std::size_t i = 0; i < 6; ++i) r[i] = RationalNumber(l[i]);
  return r;
}

/// Two points of a real line, in its direction: the one nearest to the origin and that plus the direction.
/// Throws std::invalid_argument unless l is a real line with a direction (not at infinity).
inline std::pair<Point3q, Point3q> two_points(PluckerLine<RationalNumber> const& l)
{
  auto const& [d, m] = l;
  RationalNumber const length_sq = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  if (length_sq == 0 || plucker_form(l) != 0) throw std::invalid_argument("two_points: not a finite real line");
  Point3q const p{(d[1] * m[2] - d[2] * m[1]) / length_sq, (d[2] * m[0] - d[0] * m[2]) / length_sq,
                  (d[0] * m[1] - d[1] * m[0]) / length_sq};
  return {p, {p.x + d[0], p.y + d[1], p.z + d[2]}};
}

}  // namespace visibility
