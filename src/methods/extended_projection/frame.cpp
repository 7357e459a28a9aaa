#include "visibility/methods/extended_projection/frame.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace visibility::extended_projection {

namespace {

/// Cells that differ from a box by less than this share of its size are taken for one.
constexpr double like_a_box = 0x1p-20;

/// Whether each point is near a corner of the box, and each corner near a point.
bool is_like(Box const& box, std::vector<Point3d> const& points)
{
  auto const near = [&](double x, double y, double size) { return std::fabs(x - y) <= like_a_box * size; };
  return std::ranges::all_of(box.corners(), [&](Point3d const& c) {
    return std::ranges::any_of(points, [&](Point3d const& p) {
      return near(p.x, c.x, box.max.x - box.min.x) && near(p.y, c.y, box.max.y - box.min.y) &&
             near(p.z, c.z, box.max.z - box.min.z);
    });
  });
}

/// The direction of a side of an upright box, as (a, b) of length 1; none if the cell is no such box.
std::optional<Point2d> direction(ViewCell const& cell)
{
  auto const vertices = cell.vertices();
  if (cell.is_box() || vertices.size() != 8) return {};
  for (auto const& p : vertices.subspan(1)) {
    double const x = p.x - vertices[0].x, y = p.y - vertices[0].y, length = std::hypot(x, y);
    Frame turn = frames[4];
    turn.a = x / length, turn.b = y / length;
    if (!(std::isfinite(turn.a) && std::isfinite(turn.b))) continue;
    Box bounds;
    std::vector<Point3d> points;
    for (auto const& q : vertices) bounds.extend(points.emplace_back(turn(q)));
    if (is_like(bounds, points)) return Point2d{turn.a, turn.b};
  }
  return {};
}

}  // namespace

Box Frame::operator()(Box const& box) const
{
  Box in = box;
  if (is_turned()) {
    auto const [ax0, ax1] = std::minmax({a * box.min.x, a * box.max.x});
    auto const [ay0, ay1] = std::minmax({a * box.min.y, a * box.max.y});
    auto const [bx0, bx1] = std::minmax({b * box.min.x, b * box.max.x});
    auto const [by0, by1] = std::minmax({b * box.min.y, b * box.max.y});
    double const off = error(
      {std::max(std::fabs(box.min.x), std::fabs(box.max.x)), std::max(std::fabs(box.min.y), std::fabs(box.max.y)), 0});
    in = {{ax0 + by0 - off, ay0 - bx1 - off, box.min.z}, {ax1 + by1 + off, ay1 - bx0 + off, box.max.z}};
  }
  Point3d low = exchanged(in.min), high = exchanged(in.max);
  if (!up) std::swap(low.z, high.z);
  return {low, high};
}

std::array<Frame, 6> frames_of(ViewCell const& cell)
{
  auto out = frames;
  if (auto const d = direction(cell))
    for (auto& f : out) f.a = d->x, f.b = d->y;
  return out;
}

}  // namespace visibility::extended_projection
