#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

namespace visibility {

/// Number type of the `Rational` arithmetic and of constructed coordinates: reduced to lowest terms, no expression
/// templates (formulas may hold intermediate results in `auto`).
using RationalNumber = CGAL::Gmpq;

/// Number type of the exact layer of `Filtered`: integers with a common binary exponent, about ten times faster than
/// rationals for signs of polynomials in doubles. CGAL offers it on 64-bit little-endian machines with GMP.
#ifdef CGAL_HAS_MPZF
using ExactNumber = CGAL::Mpzf;
#else
using ExactNumber = CGAL::Gmpq;
#endif

/// Number type of the interval layer; arithmetic on it needs rounding towards plus infinity
/// (CGAL::Protect_FPU_rounding).
using IntervalNumber = CGAL::Interval_nt_advanced;

}  // namespace visibility
