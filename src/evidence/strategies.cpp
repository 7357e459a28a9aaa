#include "strategies.hpp"

#include <algorithm>

namespace visibility::detail {

namespace {

Point3d minus(Point3d const& a, Point3d const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double length(Point3d const& v) { return std::hypot(v.x, v.y, v.z); }

Point3d mix(Point3d const& a, Point3d const& b, double t)
{
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

Point3d shaken(Random& random, Point3d const& p, double step)
{
  Point3d const d = random.direction();
  return {p.x + step * d.x, p.y + step * d.y, p.z + step * d.z};
}

double dot(Point3d const& a, Point3d const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The point of the edge that is nearest to the line through a and b.
Point3d nearest_to_line(Edge const& e, Point3d const& a, Point3d const& b)
{
  Point3d const u = minus(e.b, e.a), v = minus(b, a), w = minus(e.a, a);
  double const uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), d = uu * vv - uv * uv;
  double const t = d > 0 ? (uv * dot(v, w) - vv * dot(u, w)) / d : 0.5;
  return mix(e.a, e.b, std::clamp(t, 0.0, 1.0));
}

/// Recent entries first: they are the frontier.
template <class T>
T const& recent(Random& random, std::vector<T> const& list)
{
  double const u = random.unit(), age = random.chance(0.5) ? u : u * u * u * u;
  auto const back =
    std::min<std::size_t>(static_cast<std::size_t>(age * static_cast<double>(list.size())), list.size() - 1);
  return list[list.size() - 1 - back];
}

}  // namespace

double Planner::apparent_size(std::uint32_t object) const
{
  Box const& b = scene_.object_bounds()[object];
  Point3d const c = cell_.centre();
  double const dx = std::max({0.0, b.min.x - c.x, c.x - b.max.x}), dy = std::max({0.0, b.min.y - c.y, c.y - b.max.y});
  return objects_.size(object) / (1e-9 + std::hypot(dx, dy));
}

std::uint32_t Planner::some_found(Random& random) const { return recent(random, knowledge_.found); }

std::uint32_t Planner::some_unfound(Random& random) const
{
  auto const& list = knowledge_.unfound;
  std::uint32_t best = list[random.below(list.size())];
  // A tournament favours what looks large.
  for (int rivals = static_cast<int>(random.below(4U)); rivals > 0; --rivals)
    if (auto const other = list[random.below(list.size())]; apparent_size(other) > apparent_size(best)) best = other;
  return best;
}

std::optional<std::uint32_t> Planner::neighbour(Random& random, std::uint32_t object, bool wanted) const
{
  // Whatever meets a small box somewhere around the object: cheap, and no side is preferred.
  Box const& own = scene_.object_bounds()[object];
  double const grow = objects_.size(object) * random.log_uniform(0.02, 4), half = 0.25 * grow;
  Point3d const c{random.uniform(own.min.x - grow, own.max.x + grow),
                  random.uniform(own.min.y - grow, own.max.y + grow),
                  random.uniform(own.min.z - grow, own.max.z + grow)};
  Box const box{{c.x - half, c.y - half, c.z - half}, {c.x + half, c.y + half, c.z + half}};
  std::uint32_t seen = 0, chosen = 0;
  int visits = 0;
  scene_.object_hierarchy().any_meeting(box, [&](std::uint32_t other) {
    if (other != object && (!wanted || knowledge_.wanted[other] != 0) && meet(scene_.object_bounds()[other], box) &&
        random.below(++seen) == 0)
      chosen = other;
    return ++visits >= 64;
  });
  return seen > 0 ? std::optional(chosen) : std::nullopt;
}

Plan Planner::at(Random& random, std::uint32_t object) const
{
  Point3d const from = cell_.any(random);
  Aim const aim = objects_.on_face(random, object, from);
  return {from, minus(aim.point, from), aim};
}

Plan Planner::horizontal(Random& random) const
{
  double const azimuth = random.uniform(0, 6.283185307179586), slope = random.log_uniform(1e-3, 2);
  return {cell_.any(random), {std::cos(azimuth), std::sin(azimuth), random.chance(0.5) ? slope : -slope}, {}};
}

Plan Planner::past_edge(Random& random, bool upper) const
{
  std::uint32_t const object = some_found(random);
  Point3d const from = upper ? cell_.near_boundary(random) : cell_.any(random);
  double const offset = objects_.size(object) * random.log_uniform(1e-6, 0.3);
  return {from, minus(objects_.near_edge(random, object, from, offset, upper), from), {}};
}

Plan Planner::mutated(Random& random) const
{
  auto const& s = recent(random, knowledge_.sightings);
  Point3d const from = random.chance(0.7) ? cell_.near(random, s.from, random.log_uniform(1e-5, 1)) : s.from;
  // Either the end moves on the scale of the object, or the direction on the scale of the distance.
  double const reach = random.chance(0.7) ? objects_.size(s.object) : length(minus(s.to, s.from));
  return {from, minus(shaken(random, s.to, reach * random.log_uniform(1e-5, 1)), from), {}};
}

Plan Planner::critical(Random& random) const
{
  for (int tries = 0; tries < 4; ++tries) {
    std::uint32_t const a = some_found(random);
    std::uint32_t const b = random.chance(0.2) ? a : neighbour(random, a, false).value_or(a);
    // A point of one edge, and the point of another that a line from the cell through the first comes nearest to.
    bool const across = random.chance(0.5);
    Point3d const anywhere = cell_.any(random);
    Point3d p = on_edge(random, objects_.edge(random, a, anywhere, false));
    Point3d q = nearest_to_line(objects_.edge(random, across ? b : a, anywhere, false), anywhere, p);
    if (a != b && random.chance(0.6)) {
      // Into the gap between the two, however narrow.
      p = mix(p, objects_.nearest(random, b, p), random.unit());
      q = mix(q, objects_.nearest(random, across ? a : b, q), random.unit());
    } else {
      p = shaken(random, p, objects_.size(a) * random.log_uniform(1e-6, 1e-2));
      q = shaken(random, q, objects_.size(b) * random.log_uniform(1e-6, 1e-2));
    }
    auto const from = cell_.on_line(random, p, q);
    if (!from) continue;
    Point3d const d = minus(p, *from);
    if (length(d) > 0) return {*from, d, {}};
  }
  return past_edge(random, false);
}

Plan Planner::reversed(Random& random) const
{
  auto const& b = knowledge_.blocked[random.below(knowledge_.blocked.size())];
  for (int tries = 0; tries < 4; ++tries) {
    Aim const aim = objects_.on_face(random, b.wanted, b.from);
    double const offset = objects_.size(b.blocker) * random.log_uniform(1e-6, 0.1);
    Point3d const edge = objects_.near_edge(random, b.blocker, b.from, offset, random.chance(0.5));
    if (auto const from = cell_.on_line(random, edge, aim.point)) return {*from, minus(aim.point, *from), aim};
  }
  return at(random, b.wanted);
}

Plan Planner::plan(Random& random, Strategy strategy) const
{
  bool const anything_found = !knowledge_.found.empty(), anything_left = !knowledge_.unfound.empty();
  switch (strategy) {
  case Strategy::uniform: break;
  case Strategy::horizontal: return horizontal(random);
  case Strategy::unfound:
    if (anything_left) return at(random, some_unfound(random));
    break;
  case Strategy::neighbour:
    if (!anything_found) break;
    if (auto const n = neighbour(random, some_found(random), true)) return at(random, *n);
    return past_edge(random, false);
  case Strategy::silhouette:
    if (anything_found) return past_edge(random, false);
    break;
  case Strategy::skyline:
    if (anything_found) return past_edge(random, true);
    break;
  case Strategy::mutation:
    if (!knowledge_.sightings.empty()) return mutated(random);
    break;
  case Strategy::critical:
    if (anything_found) return critical(random);
    break;
  case Strategy::reverse:
    if (!knowledge_.blocked.empty()) return reversed(random);
    break;
  }
  return {cell_.any(random), random.direction(), {}};
}

}  // namespace visibility::detail
