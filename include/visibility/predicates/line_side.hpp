#pragma once

#include "visibility/predicates/orient3d.hpp"

namespace visibility {

/// Side on which the line from p to q passes the line from r to s: the sign of the Plücker product
/// b(k, l) = d_k.m_l + d_l.m_k with k = (q - p, p x q), l = (s - r, r x s); zero iff the lines meet or are parallel.
/// It is a polynomial of degree 3 in the coordinates, identical to det[q-p, r-p, s-p] (proofs/plucker.md), so lines
/// named by input points need no Plücker coordinates.
/// Laws: symmetric -- line_side(k,l) == line_side(l,k);  reversing one line flips the sign.
template <Arithmetic A, class NT>
Sign line_side(Point3<NT> const& p, Point3<NT> const& q, Point3<NT> const& r, Point3<NT> const& s)
{
  return orient3d<A>(p, q, r, s);
}

}  // namespace visibility
