#include "visibility/methods/extended_projection/convex_part.hpp"

#include <algorithm>
#include <limits>

namespace visibility::extended_projection {

namespace {

/// Beyond so many pairs of points the segments between them are left out: the part gets smaller.
constexpr std::size_t most_pairs = 1024;

/// The side of the points at sign * w >= sign * at. Points that may be on either side are left out.
ConvexPart keep_side(ConvexPart const& points, double at, double sign)
{
  ConvexPart in, out;
  for (auto const& p : points)
    if (sign * p.at.z - p.depth_error >= sign * at)
      in.push_back(p);
    else if (sign * p.at.z + p.depth_error < sign * at)
      out.push_back(p);
  if (out.empty() || in.size() * out.size() > most_pairs) return in;
  std::size_t const kept = in.size();
  for (std::size_t i = 0; i < kept; ++i)
    for (auto const& q : out)
      if (in[i].at.z != at)
        if (auto const p = crossing(in[i], q, at)) in.push_back(*p);
  return in;
}

}  // namespace

std::optional<PartPoint> crossing(PartPoint const& p, PartPoint const& q, double at)
{
  double const d = q.at.z - p.at.z, s = (at - p.at.z) / d, off = p.depth_error + q.depth_error;
  if (!in_domain(s) || std::fabs(d) < 4 * off) return {};
  auto const u = view(p.at.x, q.at.x, 0, s), v = view(p.at.y, q.at.y, 0, s);
  // The place on the segment is off by at most (p.depth_error + s off) / (|d| - off).
  double const along =
    std::max(std::fabs(q.at.x - p.at.x), std::fabs(q.at.y - p.at.y)) * (2 * off / (std::fabs(d) - off));
  double const error = std::max(u.error, v.error) + std::max(p.error, q.error) + along;
  return PartPoint{{u.value, v.value, at}, error * (1 + 0x1p-40)};
}

ConvexPart cut(std::span<PartPoint const> points, double low, double high)
{
  ConvexPart part(points.begin(), points.end());
  double const least = nearest(part), greatest = deepest(part);
  if (least < low) part = keep_side(part, low, 1);
  if (greatest > high) part = keep_side(part, high, -1);
  return part;
}

double deepest(std::span<PartPoint const> part)
{
  double w = -std::numeric_limits<double>::infinity();
  for (auto const& p : part) w = std::max(w, p.at.z + p.depth_error);
  return w;
}

double nearest(std::span<PartPoint const> part)
{
  double w = std::numeric_limits<double>::infinity();
  for (auto const& p : part) w = std::min(w, p.at.z - p.depth_error);
  return w;
}

}  // namespace visibility::extended_projection
