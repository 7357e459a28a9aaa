#include "shell_slice.hpp"

#include "visibility/methods/extended_projection/convex_part.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace visibility::extended_projection {

namespace {

/// So often a plane is moved to where no vertex is near it.
constexpr int most_moves = 4;

struct End {
  Point2d at{};
  bool on_ground = false;
};

class Slicer {
public:
  Slicer(EnclosingShell const& shell, Frame const& frame) : shell_(shell)
  {
    for (auto const& p : shell.vertices) points_.push_back({frame(p), frame.error(p), frame.depth_error(p)});
  }

  /// A plane at or a little before this one that no vertex may be on either side of; none if it is hard to find. In
  /// frames that are not turned it is this one.
  std::optional<double> certain_plane(double at) const
  {
    for (int i = 0; i < most_moves; ++i) {
      double to = at;
      for (auto const& p : points_)
        if (p.depth_error > 0 && std::fabs(p.at.z - at) <= 2 * p.depth_error)
          to = std::min(to, p.at.z - 4 * p.depth_error);
      if (to == at) return at;
      at = to;
    }
    return {};
  }

  bool add_facet(std::span<std::uint32_t const> around, double at, Ground const* ground, ShellSlice& out) const
  {
    std::array<End, 2> ends;
    std::size_t count = 0;
    for (std::size_t k = 0; k < around.size(); ++k) {
      auto a = around[k], b = around[k + 1 == around.size() ? 0 : k + 1];
      if (is_before(a, at) == is_before(b, at)) continue;
      if (is_before(b, at)) std::swap(a, b);
      auto const end = crossing_of(a, b, at, ground, out.error);
      if (!end || count == 2) return false;
      ends[count++] = *end;
    }
    if (count == 0) return true;
    // What lies on the ground bounds nothing: the solid goes on below.
    if (ends[0].on_ground && ends[1].on_ground) return true;
    out.edges.emplace_back(ends[0].at, ends[1].at);
    for (auto const& e : ends)
      if (e.on_ground) out.edges.emplace_back(e.at, Point2d{e.at.x, ground->deep});
    return true;
  }

private:
  bool is_before(std::uint32_t v, double at) const { return points_[v].at.z < at; }

  /// The same for each facet with this side: from the end before the plane.
  std::optional<End> crossing_of(std::uint32_t a, std::uint32_t b, double at, Ground const* ground, double& error) const
  {
    auto const on_ground = [&](std::uint32_t v) { return ground != nullptr && shell_.vertices[v].z == ground->level; };
    if (points_[b].at.z == at) {
      error = std::max(error, points_[b].error);
      return End{{points_[b].at.x, points_[b].at.y}, on_ground(b)};
    }
    auto const p = crossing(points_[a], points_[b], at);
    if (!p || !std::isfinite(p->at.x) || !std::isfinite(p->at.y) || !std::isfinite(p->error)) return {};
    error = std::max(error, p->error);
    return End{{p->at.x, p->at.y}, on_ground(a) && on_ground(b)};
  }

  EnclosingShell const& shell_;
  std::vector<PartPoint> points_;
};

}  // namespace

std::optional<ShellSlice> slice(EnclosingShell const& shell, Frame const& frame, double at, Ground const* ground)
{
  Slicer const slicer(shell, frame);
  auto const plane = slicer.certain_plane(at);
  if (!plane) return {};
  ShellSlice out{*plane, {}, 0, -HUGE_VAL};
  // A section that is tilted reaches above the floor and below.
  if (!frame.turn.keeps_heights() && std::isfinite(shell.floor)) return {};
  // A level section is above the floor or below it.
  if (frame.w == axis_z && !((frame.up ? *plane : -*plane) > shell.floor)) return {};
  bool const stands_on_ground = frame.has_vertical_v() && ground != nullptr && shell.floor <= ground->level;
  for (std::size_t f = 0; f < shell.facets(); ++f)
    if (!slicer.add_facet(shell.facet(f), *plane, stands_on_ground ? ground : nullptr, out)) return {};
  if (out.edges.empty()) return {};
  if (frame.has_vertical_v() && !stands_on_ground) out.low = shell.floor;
  return out;
}

}  // namespace visibility::extended_projection
