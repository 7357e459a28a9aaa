#pragma once

#include "visibility/kernel/sign.hpp"

namespace visibility::detail {

/// Collects the sides on which a line passes the edges of one convex facet, taken around the facet.
/// The line meets the closed facet in a single point iff no two sides differ and not all are zero; all are zero iff
/// the line lies in the facet's plane (proofs/segment_convex.md, Lemma 2).
class FacetStab {
public:
  void add(Sign s)
  {
    positive_ |= is_positive(s);
    negative_ |= is_negative(s);
  }
  bool hit() const { return positive_ != negative_; }

private:
  bool positive_ = false, negative_ = false;
};

}  // namespace visibility::detail
