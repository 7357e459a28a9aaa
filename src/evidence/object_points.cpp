#include "object_points.hpp"

#include <algorithm>

namespace visibility::detail {

namespace {

// Where rays are aimed is a choice; what they prove is decided exactly.

/// How near to a border, as a share, aims come: edges that are just seen, and nothing that single precision loses.
constexpr double nearest_border = 1e-4;

/// In place of a length of 0 below a fraction: aims stay finite.
constexpr double no_length = 1e-300;

/// In (0, 1); half of the time near an end, at any scale.
double border_biased(Random& random)
{
  double const t = random.chance(0.5) ? random.unit() : random.log_uniform(nearest_border, 0.5);
  return random.chance(0.5) ? t : 1 - t;
}

/// The same with a preference for the upper end.
double top_biased(Random& random)
{
  return random.chance(0.5) ? 1 - random.log_uniform(nearest_border, 0.5) : border_biased(random);
}

double between(double lo, double hi, double t) { return lo + t * (hi - lo); }

Aim aim_at_box(Random& random, Box const& b, std::uint32_t index, Point3d const& from)
{
  std::uint32_t facing[6], n = 0;
  if (from.x < b.min.x) facing[n++] = 0;
  if (from.x > b.max.x) facing[n++] = 1;
  if (from.y < b.min.y) facing[n++] = 2;
  if (from.y > b.max.y) facing[n++] = 3;
  if (from.z < b.min.z) facing[n++] = 4;
  if (from.z > b.max.z) facing[n++] = 5;
  std::uint32_t const part = n > 0 ? facing[random.below(n)] : random.below(6U);
  Point3d p{between(b.min.x, b.max.x, border_biased(random)), between(b.min.y, b.max.y, border_biased(random)),
            between(b.min.z, b.max.z, top_biased(random))};
  double const on[6] = {b.min.x, b.max.x, b.min.y, b.max.y, b.min.z, b.max.z};
  (part / 2 == 0 ? p.x : part / 2 == 1 ? p.y : p.z) = on[part];
  return {0, {Face::Kind::box, index, part}, p};
}

Point3d in_triangle(Random& random, Point3d const& a, Point3d const& b, Point3d const& c)
{
  double const s = border_biased(random), t = 1 - std::sqrt(border_biased(random));
  auto const at = [&](double x, double y, double z) { return between(between(x, y, s), z, t); };
  return {at(a.x, b.x, c.x), at(a.y, b.y, c.y), at(a.z, b.z, c.z)};
}

/// Whether the plane abc, counterclockwise seen from outside, has `from` on its outer side; rounded.
bool faces(Point3d const& a, Point3d const& b, Point3d const& c, Point3d const& from)
{
  double const ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  return (uy * vz - uz * vy) * (from.x - a.x) + (uz * vx - ux * vz) * (from.y - a.y) +
           (ux * vy - uy * vx) * (from.z - a.z) >
         0;
}

Aim aim_at_wall(Random& random, Prism const& prism, std::uint32_t index)
{
  std::size_t n = 0;
  for (auto const& ring : prism.rings) n += ring.size();
  std::uint32_t const part = random.below(n);
  auto const [a, b] = wall_ends(prism, part);
  double const t = border_biased(random);
  return {0,
          {Face::Kind::wall, index, part},
          {between(a.x, b.x, t), between(a.y, b.y, t), between(prism.bottom, prism.top, top_biased(random))}};
}

Aim aim_at_facet(Random& random, ConvexPolyhedron const& p, std::uint32_t index, Point3d const& from)
{
  std::uint32_t part = 0;
  for (int tries = 0; tries < 4; ++tries) {
    part = random.below(p.facets.size());
    auto const& v = p.facets[part].vertices;
    if (faces(p.vertices[v[0]], p.vertices[v[1]], p.vertices[v[2]], from)) break;
  }
  auto const& v = p.facets[part].vertices;
  return {
    0, {Face::Kind::facet, index, part}, in_triangle(random, p.vertices[v[0]], p.vertices[v[1]], p.vertices[v[2]])};
}

/// The point of the sphere on the side of `from`, at a random angle; often near the outline.
Aim aim_at_ball(Random& random, Ball const& ball, std::uint32_t index, Point3d const& from)
{
  Point3d const d = random.direction();
  double const gx = from.x - ball.centre.x, gy = from.y - ball.centre.y, gz = from.z - ball.centre.z;
  double const g = std::fmax(std::hypot(gx, gy, gz), no_length);
  double const tilt =
    random.chance(0.5) ? random.unit() * 2 : std::fmin(ball.radius / g, 1.0) + random.log_uniform(nearest_border, 1);
  double const vx = d.x + tilt * gx / g, vy = d.y + tilt * gy / g, vz = d.z + tilt * gz / g;
  double const scale = ball.radius / std::fmax(std::hypot(vx, vy, vz), no_length);
  return {0,
          {Face::Kind::sphere, index, 0},
          {ball.centre.x + scale * vx, ball.centre.y + scale * vy, ball.centre.z + scale * vz}};
}

Edge box_edge(Random& random, Box const& b, bool upper)
{
  int const axis = random.chance(upper ? 0.2 : 0.5) ? 2 : static_cast<int>(random.below(2U));
  int corner = static_cast<int>(random.below(8U));
  if (upper && axis != 2) corner |= 4;
  return {b.corner(corner & ~(1 << axis)), b.corner(corner | (1 << axis))};
}

Edge prism_edge(Random& random, ConvexPrism const& p, bool upper)
{
  std::size_t const n = p.footprint.size(), i = random.below(n);
  auto const &a = p.footprint[i], &b = p.footprint[(i + 1) % n];
  if (random.chance(upper ? 0.2 : 0.5)) return {{a.x, a.y, p.bottom}, {a.x, a.y, p.top}};
  double const z = upper || random.chance(0.7) ? p.top : p.bottom;
  return {{a.x, a.y, z}, {b.x, b.y, z}};
}

/// On the circle in which the cone from `from` touches the ball.
Point3d on_outline(Random& random, Ball const& ball, Point3d const& from)
{
  Point3d const d = random.direction();
  double const gx = from.x - ball.centre.x, gy = from.y - ball.centre.y, gz = from.z - ball.centre.z;
  double const gg = std::fmax(gx * gx + gy * gy + gz * gz, no_length), along = (d.x * gx + d.y * gy + d.z * gz) / gg;
  double const px = d.x - along * gx, py = d.y - along * gy, pz = d.z - along * gz;
  double const r = ball.radius, lift = r * r / gg,
               across = r * std::sqrt(std::fmax(0, 1 - lift)) / std::fmax(std::hypot(px, py, pz), no_length);
  return {ball.centre.x + lift * gx + across * px, ball.centre.y + lift * gy + across * py,
          ball.centre.z + lift * gz + across * pz};
}

}  // namespace

Point3d on_edge(Random& random, Edge const& e)
{
  double const t = border_biased(random);
  return {between(e.a.x, e.b.x, t), between(e.a.y, e.b.y, t), between(e.a.z, e.b.z, t)};
}

double ObjectPoints::size(std::uint32_t object) const
{
  Box const& b = scene_.object_bounds()[object];
  return std::hypot(b.max.x - b.min.x, b.max.y - b.min.y, b.max.z - b.min.z);
}

Aim ObjectPoints::on_face(Random& random, std::uint32_t object, Point3d const& from) const
{
  Scene const& s = scene_.scene();
  Object const& o = s.objects[object];
  std::uint32_t k =
    random.below(o.boxes.size() + o.balls.size() + o.prisms.size() + o.polyhedra.size() + o.triangles.size());
  auto const in = [&k](IndexRange r) {
    if (k < r.size()) return true;
    k -= r.size();
    return false;
  };
  Aim aim{};
  if (in(o.boxes)) {
    aim = aim_at_box(random, s.boxes[o.boxes.first + k], o.boxes.first + k, from);
  } else if (in(o.balls)) {
    aim = aim_at_ball(random, s.balls[o.balls.first + k], o.balls.first + k, from);
  } else if (in(o.prisms)) {
    std::uint32_t const index = o.prisms.first + k;
    aim = aim_at_wall(random, s.prisms[index], index);
    // A roof or floor now and then: of any piece of the object.
    auto const own = scene_.bodies().bodies_of(object);
    std::uint32_t const j = random.below(own.size());
    if (random.chance(0.3) && own[j].kind == ConvexBodies::Kind::prism) {
      auto const& piece = scene_.bodies().prism(own[j]);
      bool const roof = from.z >= piece.bottom;
      auto const body = static_cast<std::uint32_t>(own.data() - scene_.bodies().bodies().data()) + j;
      std::uint32_t const t = random.below(piece.footprint.size() - 2);
      double const z = roof ? piece.top : piece.bottom;
      auto const corner = [&](std::size_t i) { return Point3d{piece.footprint[i].x, piece.footprint[i].y, z}; };
      aim = {0,
             {roof ? Face::Kind::roof : Face::Kind::floor, body, t},
             in_triangle(random, corner(0), corner(t + 1), corner(t + 2))};
    }
  } else if (in(o.polyhedra)) {
    aim = aim_at_facet(random, s.polyhedra[o.polyhedra.first + k], o.polyhedra.first + k, from);
  } else {
    std::uint32_t const index = o.triangles.first + k;
    auto const v = s.triangle(index).vertices;
    aim = {0, {Face::Kind::triangle, index, 0}, in_triangle(random, v[0], v[1], v[2])};
  }
  aim.object = object;
  return aim;
}

Edge ObjectPoints::edge(Random& random, std::uint32_t object, Point3d const& from, bool upper) const
{
  using Kind = ConvexBodies::Kind;
  auto const& bodies = scene_.bodies();
  auto const own = bodies.bodies_of(object);
  auto const& body = own[random.below(own.size())];
  switch (body.kind) {
  case Kind::box: return box_edge(random, bodies.box(body), upper);
  case Kind::prism: return prism_edge(random, bodies.prism(body), upper);
  case Kind::polyhedron: {
    auto const& p = bodies.polyhedron(body);
    auto const& e = p.edges[random.below(p.edges.size())];
    return {p.vertices[e.from], p.vertices[e.to]};
  }
  case Kind::triangle: {
    auto const v = bodies.triangle(body).vertices;
    std::uint32_t const i = random.below(3U);
    return {v[i], v[(i + 1) % 3]};
  }
  case Kind::ball: break;
  }
  Point3d const p = on_outline(random, bodies.ball(body), from);
  return {p, p};
}

Point3d ObjectPoints::near_edge(Random& random, std::uint32_t object, Point3d const& from, double offset,
                                bool upper) const
{
  Point3d const p = on_edge(random, edge(random, object, from, upper)), d = random.direction();
  return {p.x + offset * d.x, p.y + offset * d.y, p.z + offset * (upper ? std::fabs(d.z) : d.z)};
}

Point3d ObjectPoints::nearest(Random& random, std::uint32_t object, Point3d const& p) const
{
  auto const& bodies = scene_.bodies();
  auto const own = bodies.bodies_of(object);
  auto const& body = own[random.below(own.size())];
  if (body.kind == ConvexBodies::Kind::box) {
    Box const& b = bodies.box(body);
    return {std::clamp(p.x, b.min.x, b.max.x), std::clamp(p.y, b.min.y, b.max.y), std::clamp(p.z, b.min.z, b.max.z)};
  }
  Point3d best = p;
  double best_distance = HUGE_VAL;
  for (int tries = 0; tries < 4; ++tries) {
    Edge const e = edge(random, object, p, false);
    double const dx = e.b.x - e.a.x, dy = e.b.y - e.a.y, dz = e.b.z - e.a.z;
    double const along = dx * (p.x - e.a.x) + dy * (p.y - e.a.y) + dz * (p.z - e.a.z);
    double const t = std::clamp(along / std::fmax(dx * dx + dy * dy + dz * dz, no_length), 0.0, 1.0);
    Point3d const q{between(e.a.x, e.b.x, t), between(e.a.y, e.b.y, t), between(e.a.z, e.b.z, t)};
    double const d = std::hypot(q.x - p.x, q.y - p.y, q.z - p.z);
    if (d < best_distance) best = q, best_distance = d;
  }
  return best;
}

}  // namespace visibility::detail
