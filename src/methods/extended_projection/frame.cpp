#include "visibility/methods/extended_projection/frame.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

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

double dot(Point3d const& a, Point3d const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3d difference(Point3d const& a, Point3d const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3d cross(Point3d const& a, Point3d const& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Not finite if there is no direction.
Point3d of_length_1(Point3d const& p)
{
  double const length = std::hypot(p.x, p.y, p.z);
  return {p.x / length, p.y / length, p.z / length};
}

/// Whether the points are the corners of a box in the coordinates of the turn.
bool makes_box(Turn const& turn, std::span<Point3d const> vertices)
{
  Box bounds;
  std::vector<Point3d> points;
  for (auto const& q : vertices) bounds.extend(points.emplace_back(turn(q)));
  return is_like(bounds, points);
}

/// That in which the 8 vertices are those of an upright box.
std::optional<Turn> upright_turn(std::span<Point3d const> vertices)
{
  for (auto const& p : vertices.subspan(1)) {
    Point3d const side = of_length_1({p.x - vertices[0].x, p.y - vertices[0].y, 0});
    if (!is_finite(side)) continue;
    Turn const turn = Turn::of_plan(side.x, side.y);
    if (makes_box(turn, vertices)) return turn;
  }
  return {};
}

/// That in which they are those of any box: two of the ways from one vertex to the others are its sides. The axes made
/// of two long sides are the more exact ones; all of it is a choice.
std::optional<Turn> tilted_turn(std::span<Point3d const> vertices)
{
  std::vector<Point3d> ways;
  for (auto const& p : vertices.subspan(1)) ways.push_back(difference(p, vertices[0]));
  std::ranges::stable_sort(ways, std::ranges::greater{}, [](Point3d const& p) { return dot(p, p); });
  for (auto const& p : ways)
    for (auto const& q : ways) {
      Point3d const a = of_length_1(p);
      double const along = dot(q, a);
      Point3d const b = of_length_1({q.x - along * a.x, q.y - along * a.y, q.z - along * a.z});
      if (!is_finite(a) || !is_finite(b) || std::fabs(along) > 0x1p-10 * std::hypot(q.x, q.y, q.z)) continue;
      std::array<Point3d, 3> rows{a, b, cross(a, b)};
      std::ranges::sort(rows, {}, [](Point3d const& r) { return std::fabs(r.z); });
      if (rows[2].z < 0) rows[2] = {-rows[2].x, -rows[2].y, -rows[2].z};
      Turn const turn(rows[0], rows[1], rows[2]);
      if (makes_box(turn, vertices)) return turn;
    }
  return {};
}

/// Along the sides of a box in any position; none if the cell is no such box, or one along the axes.
std::optional<Turn> turn_of(ViewCell const& cell)
{
  auto const vertices = cell.vertices();
  if (cell.is_box() || vertices.size() != 8) return {};
  auto const upright = upright_turn(vertices);
  return upright ? upright : tilted_turn(vertices);
}

}  // namespace

Box Frame::operator()(Box const& box) const
{
  Box in = box;
  if (is_turned()) {
    Point3d const farthest{std::max(std::fabs(box.min.x), std::fabs(box.max.x)),
                           std::max(std::fabs(box.min.y), std::fabs(box.max.y)),
                           std::max(std::fabs(box.min.z), std::fabs(box.max.z))};
    double const off = turn.error(farthest);
    auto const image = [&](Point3d const& row, double& low, double& high) {
      auto const [x0, x1] = std::minmax({row.x * box.min.x, row.x * box.max.x});
      auto const [y0, y1] = std::minmax({row.y * box.min.y, row.y * box.max.y});
      auto const [z0, z1] = std::minmax({row.z * box.min.z, row.z * box.max.z});
      low = x0 + y0 + z0 - off, high = x1 + y1 + z1 + off;
    };
    image(turn.rows()[0], in.min.x, in.max.x);
    image(turn.rows()[1], in.min.y, in.max.y);
    if (!turn.keeps_heights()) image(turn.rows()[2], in.min.z, in.max.z);
  }
  Point3d low = exchanged(in.min), high = exchanged(in.max);
  if (!up) std::swap(low.z, high.z);
  return {low, high};
}

Box Frame::around(Point3d const& p) const
{
  Point3d const at = turn(p);
  double const off = turn.error(p), height_off = turn.keeps_heights() ? 0 : off;
  Point3d low = exchanged({at.x - off, at.y - off, at.z - height_off}),
          high = exchanged({at.x + off, at.y + off, at.z + height_off});
  if (!up) std::swap(low.z, high.z);
  return {low, high};
}

std::array<Frame, 6> frames_of(ViewCell const& cell)
{
  auto out = frames;
  if (auto const turn = turn_of(cell))
    for (auto& f : out) f.turn = *turn;
  return out;
}

std::array<Frame, 6> frames_for(ViewCell const& cell, Directions directions)
{
  if (directions == Directions::axes) return frames;
  auto const along = frames_of(cell);
  // Along tilted cells planes see less of what stands upright (docs/measurements.md, "Planes along tilted cells").
  return directions == Directions::cell || along[0].turn.keeps_heights() ? along : frames;
}

}  // namespace visibility::extended_projection
