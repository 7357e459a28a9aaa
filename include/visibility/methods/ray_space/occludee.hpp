#pragma once

#include "visibility/methods/ray_space/refined_map.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace visibility::ray_space {

/// Asks occlusion maps whether all of a box, or of the convex hull of points, is hidden: in every pixel that its
/// footprint meets, whatever lies there. Answers "hidden" only if it is; what is out of the domain is visible.
/// Keeps its scratch memory from question to question, and begins with the pixel that showed the last thing that was
/// not hidden: what is asked next is often a part of that, or beside it.
class OccludeeTest {
public:
  /// A frame with its map, and the parts of its pixels or null. Requires: they outlive this.
  struct Family {
    Frame const* frame;
    OcclusionMap const* map;
    RefinedMap* refined = nullptr;
  };
  explicit OccludeeTest(std::vector<Family> families) : families_(std::move(families)) {}

  enum class Pixels { whole, refined };
  /// In each pixel one extent for the whole box; in parts of pixels, if they are asked, what of it is there.
  bool hidden(Box const& box, Pixels pixels = Pixels::refined);
  /// In each pixel, or each part of it, only what of the hull lies between its outermost lines. `bounds`: contains the
  /// points.
  bool hidden(Box const& bounds, std::span<Point3d const> points);

private:
  void localize(Frame const& frame, std::span<Point3d const> points);
  bool is_last_shown(Family const& family) const;
  bool shows_where_the_last_did(Family const& family);
  bool hidden_in_pixel(Family const& family, int row, int column);
  bool hidden_in_part(RefinedMap& map, std::uint32_t part, std::optional<std::uint32_t> whole = {});
  bool hidden_by_one_of(std::span<Gate const> gates) const;
  void clip(Pixel const& pixel);
  void keep_plan_of_upright();
  void add(double u, double z, double du, double dz);
  void add_extent(double near, double far, double low, double high);

  /// Whether all_hidden(family, row to begin with, row in which something showed) is true of every family.
  template <class AllHidden>
  bool in_every_family(AllHidden&& all_hidden);

  std::vector<Family> families_;
  std::size_t last_family_ = 0;  // where something was not hidden
  int last_row_ = 0;
  RefinedMap const* last_map_ = nullptr;  // null, or where last_part_ was when it had so many notes
  std::uint32_t last_part_ = 0;
  std::size_t last_notes_ = 0;
  Frame const* frame_ = nullptr;  // that the following are in
  std::vector<LocalPoint> points_;
  std::vector<double> margin_, low_side_, high_side_;
  double nearest_ = 0, farthest_ = 0;  // u of the hull
  bool is_upright_ = false;            // points_ are its plan, from lowest_ to highest_
  double lowest_ = 0, highest_ = 0;
  double clipped_near_ = 0, clipped_far_ = 0;  // u of an upright hull's clipped plan
  std::vector<Extent> extents_;                // points of the clipped hull in the slices
};

}  // namespace visibility::ray_space
