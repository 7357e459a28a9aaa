#pragma once

#include "visibility/drawing/plan_outline.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace visibility {

/// What a picture says of an object. In pictures of two sets `visible` are the objects of both.
enum class PlanRole : std::uint8_t { occluder, hidden, visible, touching, only_first, only_second };
inline constexpr std::size_t plan_roles = 6;

/// The part of the plane that a picture shows, in metres.
struct PlanRegion {
  Point2d min, max;
};

/// A scene from above with a view cell and what can be seen from it; lengths in metres, for a person to look at.
struct PlanPicture {
  struct DrawnObject {
    std::string name;
    PlanRole role;
    PlanOutline outline;
  };
  struct Segment {
    Point2d from, to;
  };
  /// Part of a top edge that sight lines reach.
  struct EdgePart {
    Segment at;
    bool sees_top;  ///< the top before the edge; otherwise the wall below it
  };
  struct Funnel {
    std::vector<Segment> lines;  ///< bounding lines, from their first point beyond the region
    std::vector<Point2d> area;   ///< what its lines sweep past the cell; empty where that is no simple shape
  };

  std::string title, subtitle;
  PlanRegion region{};
  std::vector<DrawnObject> objects;                  ///< those that reach into the region
  std::array<std::size_t, plan_roles> objects_of{};  ///< of the whole scene, by role
  std::vector<Point2d> cell;                         ///< its outline, counterclockwise
  std::vector<Segment> sight_lines;                  ///< from the cell to an object
  std::vector<EdgePart> edge_parts;
  std::vector<Funnel> funnels;
  std::vector<std::vector<Point2d>> shadows;  ///< convex
};

/// Roles of all objects for a set: touching the closed cell, visible, hidden. `visible` ascending.
std::vector<PlanRole> plan_roles_of(PreparedScene const& scene, ViewCell const& cell,
                                    std::span<std::uint32_t const> visible);
/// The same for two sets, each ascending.
std::vector<PlanRole> plan_roles_of(PreparedScene const& scene, ViewCell const& cell,
                                    std::span<std::uint32_t const> first, std::span<std::uint32_t const> second);

/// The cell and everything that a set holds, with a margin.
PlanRegion default_region(Scene const& scene, std::span<PlanRole const> roles, ViewCell const& cell);

/// A picture of the cell alone. The region is widened where it is more than 2.5 times as long as wide.
/// Throws BadInput if it is not finite, has no area, or is too large or too small for floating point.
PlanPicture plan_picture(ViewCell const& cell, PlanRegion const& region);

/// Adds the objects that reach into the picture's region, and counts all. Requires: one role per object.
void add_objects(PlanPicture& picture, Scene const& scene, std::span<PlanRole const> roles);

}  // namespace visibility
