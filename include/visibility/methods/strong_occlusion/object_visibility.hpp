#pragma once

#include "visibility/methods/strong_occlusion/occluder_search.hpp"
#include "visibility/scene/faces.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace visibility::strong_occlusion {

/// Calls find(target) for the triangles of a convex polygon, fanned from its first vertex, until it finds nothing;
/// returns whether that happened.
template <class Find>
bool any_triangle_unoccluded(std::span<Point3d const> polygon, Find&& find)
{
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    std::array<Point3d, 3> const triangle{polygon[0], polygon[i - 1], polygon[i]};
    if (!find(target_of(triangle))) return true;
  }
  return false;
}

/// Whether objects of a remainder are possibly visible: none of the targets of some granularity has a strong occluder.
template <Arithmetic A>
class ObjectVisibility {
public:
  using Item = Remainder::Item;

  /// Keeps references to the first three.
  ObjectVisibility(OccluderSearch<A>& search, Remainder const& remainder, ViewCell const& cell, Options const& options)
    : search_(search), remainder_(remainder), cell_(cell), granularity_(options.granularity),
      face_first_(options.visible_first && options.granularity == Granularity::face)
  {
  }

  /// Whether a sight line to a vertex of the object is free. Then the object is possibly visible at any granularity:
  /// the vertex belongs to a face that looks towards the cell, or the line would run through the body before it ends.
  /// Aims at what is likely to be seen if anything is: a high and near vertex of the nearest body, then of the highest.
  bool is_seen(Item object)
  {
    auto const [first, last] = remainder_.occluders_of(object);
    if (remainder_.body(first) == nullptr) return false;  // settled, and all its own bodies are redundant
    Item const nearest = nearest_body(first, last);
    Item highest = nearest;
    for (Item b = first; b < std::min(last, first + most_bodies_compared) && remainder_.body(b) != nullptr; ++b)
      if (remainder_.bounds(b).max.z > remainder_.bounds(highest).max.z) highest = b;
    auto const sees = [&](Item body) {
      Point3d const target = high_and_near(body);
      return !contains(cell_.bounds(), target) && search_.is_free(target);
    };
    return sees(nearest) || (highest != nearest && sees(highest));
  }

  /// Marks bodies found hidden as such.
  bool operator()(Item object)
  {
    Box const& box = remainder_.scene().object_bounds()[remainder_.object(object)];
    auto const [first, last] = remainder_.occluders_of(object);
    bool const disjoint = certainly_disjoint(cell_, box);
    if (disjoint) {
      using Effort = typename OccluderSearch<A>::Effort;
      BoxTarget const whole(box);
      bool hidden = face_first_ && search_.find(whole.target(), Effort::recent);
      if (!hidden && face_first_ && a_face_is_unoccluded(nearest_body(first, last))) return true;
      hidden = hidden || search_.find(whole.target(), Effort::exhaustive);
      if (hidden) {
        for (Item b = first; b < last; ++b) search_.hide(b);
        return false;
      }
    }
    if (granularity_ == Granularity::object) return true;
    for (Item b = first; b < last && remainder_.body(b) != nullptr; ++b) {
      bool const same_box = disjoint && is_box(b) && remainder_.bounds(b) == box;
      if (body(b, same_box)) return true;
    }
    return false;
  }

  /// The same for one body of the object. `box_was_tested`: no strong occluder was found for its bounding box, and that
  /// is its hull.
  bool body(Item item, bool box_was_tested)
  {
    if (!certainly_disjoint(cell_, remainder_.bounds(item))) return true;
    if (!box_was_tested && whole_body_is_hidden(item)) {
      search_.hide(item);
      return false;
    }
    if (granularity_ < Granularity::face) return true;
    return any_face_towards(cell_, bodies(), of(item), [&](std::span<Point3d const> face) {
      auto const find = [&](Target const& t) { return search_.find_for_face(t); };
      if (find(target_of(face))) return false;
      if (granularity_ == Granularity::face || face.size() == 3 || !has_polygons(of(item))) return true;
      return any_triangle_unoccluded(face, find);
    });
  }

private:
  using Kind = ConvexBodies::Kind;

  ConvexBodies const& bodies() const { return remainder_.scene().bodies(); }
  ConvexBodies::Body const& of(Item item) const { return *remainder_.body(item); }
  bool is_box(Item item) const { return of(item).kind == Kind::box || of(item).kind == Kind::ball; }

  /// Requires: body(first).
  Item nearest_body(Item first, Item last) const
  {
    if (last - first == 1) return first;
    Item nearest = first;
    double distance = HUGE_VAL;
    for (Item b = first; b < std::min(last, first + most_bodies_compared) && remainder_.body(b) != nullptr; ++b) {
      double const d = approximate_squared_distance(cell_.bounds(), remainder_.bounds(b));
      if (d < distance) distance = d, nearest = b;
    }
    return nearest;
  }

  /// Whether a face of the body that looks towards the cell has no strong occluder. Then neither the body has, nor any
  /// group around it. Looks at one face: of a box that across the widest gap to the cell. Requires: the body is
  /// disjoint from the cell.
  bool a_face_is_unoccluded(Item item)
  {
    if (of(item).kind == Kind::box && of(item).occludes) {
      Box face = remainder_.bounds(item);
      Box const &b = remainder_.bounds(item), &c = cell_.bounds();
      double widest = 0;
      for (auto const k : {&Point3d::x, &Point3d::y, &Point3d::z}) {
        double const below = b.min.*k - c.max.*k, above = c.min.*k - b.max.*k;
        if (std::max(below, above) <= widest) continue;
        widest = std::max(below, above);
        face = b;
        // Not (below > above ? face.max : face.min).*k = ...: GCC 12 assigns to a copy.
        if (below > above)
          face.max.*k = b.min.*k;
        else
          face.min.*k = b.max.*k;
      }
      return widest > 0 && !search_.find_for_face(BoxTarget(face).target());
    }
    bool unoccluded = false;
    any_face_towards(cell_, bodies(), of(item), [&](std::span<Point3d const> face) {
      unoccluded = !search_.find_for_face(target_of(face));
      return true;
    });
    return unoccluded;
  }

  /// Of the highest vertices of the body, or of its bounding box, that nearest to the cell.
  Point3d high_and_near(Item item)
  {
    Box const &b = remainder_.bounds(item), &c = cell_.bounds();
    if (is_box(item))
      return {b.min.x + b.max.x > c.min.x + c.max.x ? b.min.x : b.max.x,
              b.min.y + b.max.y > c.min.y + c.max.y ? b.min.y : b.max.y, b.max.z};
    vertices_.clear();
    bodies().append_vertices(of(item), vertices_);
    return *std::ranges::min_element(vertices_, {}, [&](Point3d const& v) {
      return std::pair(-v.z, approximate_squared_distance(c, Box{v, v}));
    });
  }

  bool whole_body_is_hidden(Item item)
  {
    if (is_box(item)) return search_.find(BoxTarget(remainder_.bounds(item)).target()).has_value();
    vertices_.clear();
    bodies().append_vertices(of(item), vertices_);
    return search_.find(target_of(vertices_)).has_value();
  }

  static constexpr Item most_bodies_compared = 16;

  OccluderSearch<A>& search_;
  Remainder const& remainder_;
  ViewCell const& cell_;
  Granularity granularity_;
  bool face_first_;
  std::vector<Point3d> vertices_;
};

}  // namespace visibility::strong_occlusion
