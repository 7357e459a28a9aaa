#pragma once

#include "canvas.hpp"

#include "visibility/drawing/plan_picture.hpp"

#include <span>
#include <vector>

namespace visibility::detail::drawing {

/// From metres, y up, to pixels, y down; one scale for both axes.
class PixelMap {
public:
  PixelMap(PlanRegion const& region, Rectangle const& frame);
  Point2d operator()(Point2d const& p) const;
  double scale() const { return scale_; }  ///< pixels per metre
  Rectangle const& frame() const { return frame_; }

private:
  PlanRegion region_;
  Rectangle frame_;
  double scale_;
};

/// How finely something is drawn.
struct Detail {
  double tolerance;  ///< corners nearer than this to the one before are left out
  double least;      ///< what is smaller in both directions becomes a square of this size
};

/// The outline in pixels, cut off well outside the frame so that all numbers stay small.
Path pixel_path(PlanOutline const& outline, PixelMap const& map, Detail const& detail);
/// The same of a line that is not closed; empty if it does not come near the frame.
Path pixel_path(PlanPicture::Segment const& segment, PixelMap const& map);
/// Of a polygon.
Path pixel_path(std::vector<Point2d> const& polygon, PixelMap const& map);

/// Many outlines as a few paths, in tenths of a pixel; not as one, since what fills a path looks for all crossings in
/// it. Those smaller than a pixel are replaced by the pixels they lie in, each once, other small ones by their bounds.
class Crowd {
public:
  Crowd(PixelMap const& map, Detail const& detail) : map_(map), detail_(detail) {}
  void add(PlanOutline const& outline);
  std::vector<Path> paths() const;

private:
  Path& open_path();  ///< with room

  PixelMap const& map_;
  Detail detail_;
  std::vector<Path> large_;
  std::vector<std::pair<std::int32_t, std::int32_t>> pixels_;  // row, column
};

}  // namespace visibility::detail::drawing
