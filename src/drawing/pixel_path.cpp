#include "pixel_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace visibility::detail::drawing {

namespace {

/// Pixels around the frame that are drawn, unseen: no cut edge shows.
constexpr double rim = 40;
constexpr double largest_disc = 5000;
/// Outlines of a crowd below this many pixels are drawn as rectangles.
constexpr double still_small = 4;
/// Lines and discs in a path of a crowd; one object may add more.
constexpr std::size_t most_in_path = 1000;

using Points = std::vector<Point2d>;

/// The polygon on the side of the limit where sign * coordinate <= sign * limit [Sutherland & Hodgman 1974].
Points clipped(Points const& in, double Point2d::*axis, double sign, double limit)
{
  Points out;
  double Point2d::*const other = axis == &Point2d::x ? &Point2d::y : &Point2d::x;
  for (std::size_t i = 0; i < in.size(); ++i) {
    Point2d const &a = in[i], &b = in[i + 1 == in.size() ? 0 : i + 1];
    bool const a_in = sign * (a.*axis) <= sign * limit, b_in = sign * (b.*axis) <= sign * limit;
    if (a_in) out.push_back(a);
    if (a_in == b_in) continue;
    Point2d cut{};
    cut.*axis = limit;
    cut.*other = a.*other + (b.*other - a.*other) * ((limit - a.*axis) / (b.*axis - a.*axis));
    out.push_back(cut);
  }
  return out;
}

/// In the frame or its rim.
bool is_near(Point2d const& p, Rectangle const& f)
{
  return p.x >= f.x - rim && p.x <= f.x + f.width + rim && p.y >= f.y - rim && p.y <= f.y + f.height + rim;
}

Points clipped(Points p, Rectangle const& frame)
{
  if (std::ranges::all_of(p, [&](Point2d const& q) { return is_near(q, frame); })) return p;
  p = clipped(p, &Point2d::x, 1, frame.x + frame.width + rim);
  p = clipped(p, &Point2d::x, -1, frame.x - rim);
  p = clipped(p, &Point2d::y, 1, frame.y + frame.height + rim);
  return clipped(p, &Point2d::y, -1, frame.y - rim);
}

Points without_near_corners(Points const& in, double tolerance)
{
  Points out;
  for (auto const& p : in)
    if (out.empty() || std::hypot(p.x - out.back().x, p.y - out.back().y) >= tolerance) out.push_back(p);
  if (out.size() < 3 && in.size() >= 3) return in;
  return out;
}

Points in_pixels(Points const& in, PixelMap const& map)
{
  Points out;
  out.reserve(in.size());
  for (auto const& p : in) out.push_back(map(p));
  return out;
}

/// Counterclockwise as one sees it, like everything else, so that nothing cancels in one path.
Path::Line rectangle(double x0, double y0, double x1, double y1) { return {{{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}}; }

/// Counterclockwise as one sees it.
Points polygon_of(Path::Disc const& d)
{
  Points out;
  constexpr int corners = 720;
  for (int i = 0; i < corners; ++i) {
    double const angle = 2 * std::numbers::pi * i / corners;
    out.push_back({d.centre.x + d.radius * std::cos(angle), d.centre.y - d.radius * std::sin(angle)});
  }
  return out;
}

/// Bounds of what is drawn, in pixels.
struct Bounds {
  double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;
  void extend(Point2d const& p, double by = 0)
  {
    x0 = std::min(x0, p.x - by), x1 = std::max(x1, p.x + by);
    y0 = std::min(y0, p.y - by), y1 = std::max(y1, p.y + by);
  }
  double size() const { return std::max(x1 - x0, y1 - y0); }
  Point2d middle() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
};

Bounds bounds_of(PlanOutline const& outline, PixelMap const& map)
{
  Bounds b;
  for (auto const& ring : outline.rings)
    for (auto const& p : ring) b.extend(map(p));
  for (auto const& d : outline.discs) b.extend(map(d.centre), d.radius * map.scale());
  return b;
}

}  // namespace

PixelMap::PixelMap(PlanRegion const& region, Rectangle const& frame)
  : region_(region), frame_(frame), scale_(frame.width / (region.max.x - region.min.x))
{
}

Point2d PixelMap::operator()(Point2d const& p) const
{
  return {frame_.x + (p.x - region_.min.x) * scale_, frame_.y + frame_.height - (p.y - region_.min.y) * scale_};
}

Path pixel_path(PlanOutline const& outline, PixelMap const& map, Detail const& detail)
{
  if (Bounds const b = bounds_of(outline, map); b.size() < detail.least) {
    auto const [x, y] = b.middle();
    double const r = detail.least / 2;
    return {{rectangle(x - r, y - r, x + r, y + r)}, {}};
  }
  Path path;
  for (auto const& ring : outline.rings) {
    auto points = without_near_corners(clipped(in_pixels(ring, map), map.frame()), detail.tolerance);
    if (!points.empty()) path.lines.push_back({std::move(points)});
  }
  for (auto const& d : outline.discs) {
    Path::Disc const disc{map(d.centre), d.radius * map.scale()};
    if (disc.radius <= largest_disc)
      path.discs.push_back(disc);
    else if (auto points = clipped(polygon_of(disc), map.frame()); !points.empty())
      path.lines.push_back({std::move(points)});
  }
  return path;
}

Path pixel_path(PlanPicture::Segment const& segment, PixelMap const& map)
{
  auto points = clipped({map(segment.from), map(segment.to)}, map.frame());
  if (points.size() < 2) return {};
  points.resize(2);  // a line clipped as a polygon of two sides comes back on itself
  return {{{std::move(points), false}}, {}};
}

Path pixel_path(std::vector<Point2d> const& polygon, PixelMap const& map)
{
  auto points = clipped(in_pixels(polygon, map), map.frame());
  if (points.empty()) return {};
  return {{{std::move(points)}}, {}};
}

void Crowd::add(PlanOutline const& outline)
{
  Bounds const b = bounds_of(outline, map_);
  if (b.size() < still_small && !is_near(b.middle(), map_.frame())) return;
  if (b.size() < 1) {
    auto const [x, y] = b.middle();
    pixels_.emplace_back(static_cast<std::int32_t>(std::floor(y)), static_cast<std::int32_t>(std::floor(x)));
    return;
  }
  auto const tenths = [](double v) { return std::round(10 * v) / 10; };
  if (b.size() < still_small && outline.discs.empty()) {
    open_path().lines.push_back(rectangle(tenths(b.x0), tenths(b.y0), tenths(b.x1), tenths(b.y1)));
    return;
  }
  Path part = pixel_path(outline, map_, detail_);
  Path& path = open_path();
  for (auto& line : part.lines) {
    for (auto& p : line.points) p = {tenths(p.x), tenths(p.y)};
    path.lines.push_back(std::move(line));
  }
  std::ranges::move(part.discs, std::back_inserter(path.discs));
}

Path& Crowd::open_path()
{
  if (large_.empty() || large_.back().lines.size() + large_.back().discs.size() >= most_in_path) large_.emplace_back();
  return large_.back();
}

std::vector<Path> Crowd::paths() const
{
  auto out = large_;
  Path small;
  auto pixels = pixels_;
  std::ranges::sort(pixels);
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  for (std::size_t i = 0; i < pixels.size();) {
    auto const [row, first] = pixels[i];
    std::int32_t last = first;
    for (++i; i < pixels.size() && pixels[i] == std::pair{row, last + 1}; ++i) ++last;
    small.lines.push_back(rectangle(first, row, last + 1, row + 1));
  }
  if (!small.empty()) out.push_back(std::move(small));
  return out;
}

}  // namespace visibility::detail::drawing
