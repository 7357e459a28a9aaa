#pragma once

#include "visibility/line_space/quadric_search.hpp"

#include <array>
#include <optional>
#include <span>

/// Real lines l with b(l, h) > 0 for all of some oriented real lines h: lines that pass all of them strictly on the
/// given side. Such an l exists iff the cone of the h has interior and q takes both strict signs on it
/// (proofs/plucker_cone.md, Theorem 2); lines that only touch do not count.
namespace visibility {

/// The cone of the half-spaces; empty when it has no interior (found as early as possible).
template <class NT>
std::optional<PluckerCone<NT>> cone_with_interior(std::span<PluckerLine<NT> const> half_spaces)
{
  PluckerCone<NT> cone;
  for (auto const& h : half_spaces) {
    cone.insert(h);
    if (!cone.has_interior()) return {};
  }
  return cone;
}

/// Whether some real line l has b(l, h) > 0 for all h. Exact for exact NT; for `double` a guess, for comparison.
/// Requires: every h is a real line, q(h) = 0, or zero (then the answer is no).
/// `SearchDepth::edges` is enough for portal sequences and says no too often in general.
/// Source: [Teller92], [Bittner05, §5.1], completed by proofs/plucker_cone.md, Theorem 3.
template <class NT>
bool has_strict_stabbing_line(std::span<PluckerLine<NT> const> half_spaces, SearchDepth depth = SearchDepth::faces)
{
  auto const cone = cone_with_interior(half_spaces);
  if (!cone) return false;
  QuadricSearch<NT> const search(*cone, depth);
  return search.find(Sign::positive) && search.find(Sign::negative);
}

namespace detail {

/// Whether b(l, h) > 0 for all h.
template <class NT>
bool strictly_inside(PluckerLine<NT> const& l, std::span<PluckerLine<NT> const> half_spaces)
{
  for (auto const& h : half_spaces)
    if (!is_positive(number_sign(plucker_product(l, h)))) return false;
  return true;
}

/// The real line in the plane of p and the real line h: p + t h with q(p + t h) = q(p) + 2 t b(p, h) = 0, scaled.
/// Requires: b(p, h) > 0.
template <class NT>
PluckerLine<NT> real_line_along(PluckerLine<NT> const& p, PluckerLine<NT> const& h)
{
  NT const b = plucker_product(p, h);
  return combination<NT>(b + b, p, NT(0) - plucker_form(p), h);
}

/// A positive combination of l and the interior vector on which q still has the sign of q(l).
template <class NT>
PluckerLine<NT> moved_inside(PluckerLine<NT> const& l, PluckerLine<NT> const& interior)
{
  Sign const s = number_sign(plucker_form(l));
  std::array ends{l, interior};
  make_comparable(std::span<PluckerLine<NT>>(ends));
  for (NT weight(1);; weight = weight + weight) {
    PluckerLine<NT> const moved = combination<NT>(weight, ends[0], NT(1), ends[1]);
    if (number_sign(plucker_form(moved)) == s) return primitive(moved);
  }
}

/// A real line with a direction near the real line l, still strict. Requires: some h has a direction.
template <class NT>
PluckerLine<NT> away_from_infinity(PluckerLine<NT> const& l, std::span<PluckerLine<NT> const> half_spaces)
{
  auto const at_infinity = [](PluckerLine<NT> const& k) {
    for (NT const& x : k.direction)
      if (!is_zero(number_sign(x))) return false;
    return true;
  };
  if (!at_infinity(l)) return l;
  for (NT weight(1);; weight = weight + weight)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      PluckerLine<NT> step;
      step[axis] = NT(1);
      PluckerLine<NT> const p = combination<NT>(weight, l, NT(1), step);
      if (!strictly_inside(p, half_spaces)) continue;
      PluckerLine<NT> const moved = real_line_along(p, half_spaces.front());
      if (!at_infinity(moved) && strictly_inside(moved, half_spaces)) return moved;
    }
}

}  // namespace detail

/// A real line l, not at infinity, with b(l, h) > 0 for all h, if there is one; homogeneous, exact. Any such line may
/// be returned. The line is found on a segment of the cone's interior on whose ends q has both signs: halve it towards
/// the root of q and go from there to the quadric along the first half-space, until the result is strict. Requires:
/// exact NT; every h is a finite real line or zero.
template <class NT>
std::optional<PluckerLine<NT>> strict_stabbing_line(std::span<PluckerLine<NT> const> half_spaces,
                                                    SearchDepth depth = SearchDepth::faces)
{
  if (half_spaces.empty()) return PluckerLine<NT>{{NT(1), NT(0), NT(0)}, {NT(0), NT(0), NT(0)}};
  auto const cone = cone_with_interior(half_spaces);
  if (!cone) return {};
  QuadricSearch<NT> const search(*cone, depth);
  auto const positive = search.find(Sign::positive);
  auto const negative = positive ? search.find(Sign::negative) : std::nullopt;
  if (!negative) return {};
  std::span<PluckerLine<NT> const> const h(cone->half_spaces());
  std::array ends{detail::moved_inside(positive->line, cone->interior()),
                  detail::moved_inside(negative->line, cone->interior())};
  make_comparable(std::span<PluckerLine<NT>>(ends));
  for (;;) {
    auto const middle = combination<NT>(NT(1), ends[0], NT(1), ends[1]);
    Sign const s = number_sign(plucker_form(middle));
    auto const line = is_zero(s) ? middle : detail::real_line_along(middle, h.front());
    if (detail::strictly_inside(line, h)) return primitive(detail::away_from_infinity(line, h));
    // The other end is doubled, so that the next sum is again the middle of the segment.
    std::size_t const replaced = is_positive(s) ? 0 : 1;
    auto& other = ends[1 - replaced];
    other = combination<NT>(NT(1), other, NT(1), other);
    ends[replaced] = middle;
  }
}

}  // namespace visibility
