#include "visibility/geometry/convex_prism.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"

#include <stdexcept>

namespace visibility {

void ConvexPrism::validate() const
{
  auto const fail = [](char const* what) { throw std::logic_error(std::string("ConvexPrism: ") + what); };
  std::size_t const n = footprint.size();
  if (n < 3) fail("fewer than three footprint points");
  if (!(bottom < top)) fail("bottom >= top");
  // Convex once around: every point lies on the inner side of, or on, every edge line, and some point strictly.
  for (std::size_t i = 0; i < n; ++i) {
    auto const &a = footprint[i], &b = footprint[(i + 1) % n];
    if (a == b) fail("a repeated footprint point");
    bool inner = false;
    for (auto const& p : footprint) {
      Sign const s = orient2d<Filtered>(a, b, p);
      if (is_negative(s)) fail("a footprint point beyond a wall");
      inner |= is_positive(s);
    }
    if (!inner) fail("a footprint without area");
  }
}

}  // namespace visibility
