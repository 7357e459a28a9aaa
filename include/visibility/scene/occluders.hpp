#pragma once

#include "visibility/scene/convex_bodies.hpp"
#include "visibility/scene/inner_bodies.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// Every closed convex set that may block sight lines on its own: the convex bodies of a scene and, if wanted, convex
/// bodies inside its non-convex objects, which block nothing more than their object does, but on their own. In object
/// order. Named by position; keeps a reference to the bodies, which must outlive it.
class Occluders {
public:
  /// The bodies of the scene alone.
  explicit Occluders(ConvexBodies const& bodies) : bodies_(&bodies) {}
  /// And those inside its objects.
  Occluders(ConvexBodies const& bodies, InnerBodyOptions const& options);

  std::size_t size() const { return all_.empty() ? bodies_->bodies().size() : all_.size(); }
  std::size_t inner_count() const { return inner_.size(); }
  std::span<Box const> bounds() const { return all_.empty() ? bodies_->bounds() : std::span<Box const>(bounds_); }
  /// Position of each object's first occluder, and their number at the end.
  std::span<std::uint32_t const> first_of_object() const
  {
    return all_.empty() ? bodies_->first_of_object() : std::span<std::uint32_t const>(first_of_object_);
  }

  std::uint32_t object(std::uint32_t i) const
  {
    return is_body(i) ? bodies_->bodies()[body(i)].object : inner_owner_[inner_index(i)];
  }
  /// Whether the occluder is a convex body of the scene, and so something to be seen.
  bool is_body(std::uint32_t i) const { return all_.empty() || all_[i] < bodies_->bodies().size(); }
  /// Its position in ConvexBodies::bodies(). Requires: is_body(i).
  std::uint32_t body(std::uint32_t i) const { return all_.empty() ? i : all_[i]; }

  /// Whether the occluder blocks sight lines from this cell: a body that is solid does from any, an inner body only
  /// from where it is enclosed by its object (InnerBody). `owner`: the bounds of its object.
  bool blocks_from(ViewCell const& cell, std::uint32_t i, Box const& owner) const
  {
    if (is_body(i)) return bodies_->bodies()[body(i)].occludes;
    return may_occlude(inner(i), cell.bounds(), owner);
  }

  /// Whether it blocks all sight lines to what lies outside `owner`, from any cell: a solid body does, an inner body if
  /// nothing that is looked for lies lower than the floor above which its object encloses it. proofs/inner_bodies.md,
  /// "Seen from within". `lowest`: no point of what is looked for is lower.
  bool blocks_beyond_owner(std::uint32_t i, double lowest) const
  {
    if (is_body(i)) return bodies_->bodies()[body(i)].occludes;
    return lowest >= inner(i).floor;
  }

  /// Calls f(shape) with the occluder's Box, Ball, Triangle, ConvexPrism or ConvexPolyhedron; returns what f does.
  template <class F>
  auto visit(std::uint32_t i, F&& f) const
  {
    if (is_body(i)) return visit_shape(*bodies_, bodies_->bodies()[body(i)], f);
    return std::visit(f, inner(i).shape);
  }

private:
  std::size_t inner_index(std::uint32_t i) const { return all_[i] - bodies_->bodies().size(); }
  InnerBody const& inner(std::uint32_t i) const { return inner_[inner_index(i)]; }

  ConvexBodies const* bodies_;
  std::vector<InnerBody> inner_;
  std::vector<std::uint32_t> inner_owner_;  // objects
  std::vector<std::uint32_t> all_;  // bodies, then (offset by their number) inner bodies; empty: just the bodies
  std::vector<Box> bounds_;
  std::vector<std::uint32_t> first_of_object_;
};

}  // namespace visibility
