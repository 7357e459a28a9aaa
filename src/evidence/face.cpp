#include "visibility/evidence/face.hpp"

#include "visibility/geometry/segment_coplanar.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace visibility {

namespace {

using Corners = std::array<Point3d, 3>;

ConvexPrism const& piece_of(PreparedScene const& scene, Face const& face)
{
  return scene.bodies().prism(scene.bodies().bodies()[face.primitive]);
}

double clamped(double v, double lo, double hi) { return v < lo ? lo : v > hi ? hi : v; }

/// A double strictly between lo and hi near v; empty if there is none.
std::optional<double> strictly_between(double v, double lo, double hi)
{
  if (lo < v && v < hi) return v;
  double const inset = std::fmin(0x1p-20 * (hi - lo), HUGE_VAL);
  double const w = v <= lo ? lo + inset : hi - inset;
  if (lo < w && w < hi) return w;
  double const next = v <= lo ? std::nextafter(lo, hi) : std::nextafter(hi, lo);
  if (lo < next && next < hi) return next;
  return {};
}

std::optional<FacePoint> inside_box_face(Box const& b, std::uint32_t part, Point3d const& wanted)
{
  std::uint32_t const axis = part / 2;
  bool const high = part % 2 == 1;
  auto const component = [&](std::uint32_t k, double lo, double hi, double v) -> std::optional<double> {
    if (k == axis) return high ? hi : lo;
    return strictly_between(v, lo, hi);
  };
  auto const x = component(0, b.min.x, b.max.x, wanted.x), y = component(1, b.min.y, b.max.y, wanted.y),
             z = component(2, b.min.z, b.max.z, wanted.z);
  if (!x || !y || !z) return {};
  return FacePoint{{*x, *y, *z}, {}};
}

/// Dyadic weights in lowest 30 bits keep the rational small: a corner's 53 bits and these.
constexpr int weight_bits = 30;
constexpr double weight_one = 1 << weight_bits;

std::optional<FacePoint> inside_wall(Prism const& prism, std::uint32_t part, Point3d const& wanted)
{
  auto const [a, b] = wall_ends(prism, part);
  auto const z = strictly_between(wanted.z, prism.bottom, prism.top);
  if (a == b || !z) return {};
  if (a.x == b.x || a.y == b.y) {
    auto const x = a.x == b.x ? std::optional(a.x) : strictly_between(wanted.x, std::min(a.x, b.x), std::max(a.x, b.x));
    auto const y = a.y == b.y ? std::optional(a.y) : strictly_between(wanted.y, std::min(a.y, b.y), std::max(a.y, b.y));
    if (!x || !y) return {};
    return FacePoint{{*x, *y, *z}, {}};
  }
  double const dx = b.x - a.x, dy = b.y - a.y;
  double const t = ((wanted.x - a.x) * dx + (wanted.y - a.y) * dy) / (dx * dx + dy * dy);
  if (!std::isfinite(t)) return {};
  RationalNumber const w =
    RationalNumber(std::rint(clamped(t, 0x1p-20, 1 - 0x1p-20) * weight_one)) / RationalNumber(weight_one);
  Point3q const p{RationalNumber(a.x) + w * (RationalNumber(b.x) - RationalNumber(a.x)),
                  RationalNumber(a.y) + w * (RationalNumber(b.y) - RationalNumber(a.y)), RationalNumber(*z)};
  return FacePoint{{CGAL::to_double(p.x), CGAL::to_double(p.y), *z}, p};
}

std::array<Point2d, 3> fan_triangle(ConvexPrism const& piece, std::uint32_t part)
{
  return {piece.footprint[0], piece.footprint[part + 1], piece.footprint[part + 2]};
}

std::optional<FacePoint> inside_cap(ConvexPrism const& piece, std::uint32_t part, double z, Point3d const& wanted)
{
  auto const t = fan_triangle(piece, part);
  Point2d const c{(t[0].x + t[1].x + t[2].x) / 3, (t[0].y + t[1].y + t[2].y) / 3};
  std::size_t const n = piece.footprint.size();
  for (double const pull : {0.0, 0x1p-20, 0x1p-16, 0x1p-8, 1.0}) {
    Point2d const p{wanted.x + pull * (c.x - wanted.x), wanted.y + pull * (c.y - wanted.y)};
    bool inside = is_finite(p);
    for (std::size_t i = 0; inside && i < n; ++i)
      inside = is_positive(orient2d<Filtered>(piece.footprint[i], piece.footprint[(i + 1) % n], p));
    if (inside) return FacePoint{{p.x, p.y, z}, {}};
  }
  return {};
}

/// Barycentric weights of the point's foot in the triangle's plane, clamped to be positive. Rounded: any positive
/// weights are valid.
std::array<double, 3> weights(Corners const& t, Point3d const& p)
{
  Point3d const u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z},
    v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z}, w{p.x - t[0].x, p.y - t[0].y, p.z - t[0].z};
  auto const dot = [](Point3d const& a, Point3d const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  double const uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  double const d = uu * vv - uv * uv;
  double b = (vv * wu - uv * wv) / d, c = (uu * wv - uv * wu) / d;
  if (!std::isfinite(b) || !std::isfinite(c)) b = c = 1.0 / 3;
  std::array<double, 3> out{clamped(1 - b - c, 0x1p-18, 1), clamped(b, 0x1p-18, 1), clamped(c, 0x1p-18, 1)};
  double const sum = out[0] + out[1] + out[2];
  for (auto& x : out) x /= sum;
  return out;
}

/// The point itself where the triangle lies in a coordinate plane and doubles can name it.
std::optional<FacePoint> inside_level_triangle(Corners const& t, std::array<double, 3> const& w)
{
  Point3d p{w[0] * t[0].x + w[1] * t[1].x + w[2] * t[2].x, w[0] * t[0].y + w[1] * t[1].y + w[2] * t[2].y,
            w[0] * t[0].z + w[1] * t[1].z + w[2] * t[2].z};
  int axis = -1;
  if (t[0].x == t[1].x && t[1].x == t[2].x) axis = 0, p.x = t[0].x;
  if (t[0].y == t[1].y && t[1].y == t[2].y) axis = 1, p.y = t[0].y;
  if (t[0].z == t[1].z && t[1].z == t[2].z) axis = 2, p.z = t[0].z;
  if (axis < 0 || !is_finite(p)) return {};
  Sign const turn = orient2d<Filtered>(detail::drop(axis, t[0]), detail::drop(axis, t[1]), detail::drop(axis, t[2]));
  if (is_zero(turn)) return {};
  for (std::size_t i = 0; i < 3; ++i)
    if (orient2d<Filtered>(detail::drop(axis, t[i]), detail::drop(axis, t[(i + 1) % 3]), detail::drop(axis, p)) != turn)
      return {};
  return FacePoint{p, {}};
}

std::optional<FacePoint> inside_triangle(Corners const& t, Point3d const& wanted)
{
  auto const w = weights(t, wanted);
  if (auto const p = inside_level_triangle(t, w)) return p;
  if (detail::projection_axis<Filtered>(t[0], t[1], t[2]) < 0) return {};  // no relative interior
  double const b = std::fmax(1, std::rint(w[1] * weight_one)), c = std::fmax(1, std::rint(w[2] * weight_one));
  if (b + c >= weight_one) return {};
  RationalNumber const one(weight_one), wb = RationalNumber(b) / one, wc = RationalNumber(c) / one,
                                        wa = RationalNumber(weight_one - b - c) / one;
  auto const mix = [&](double x, double y, double z) {
    return wa * RationalNumber(x) + wb * RationalNumber(y) + wc * RationalNumber(z);
  };
  Point3q const p{mix(t[0].x, t[1].x, t[2].x), mix(t[0].y, t[1].y, t[2].y), mix(t[0].z, t[1].z, t[2].z)};
  return FacePoint{{CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)}, p};
}

/// A rational point of the sphere: stereographic projection from the pole on the far side, with dyadic parameters.
std::optional<FacePoint> on_sphere(Ball const& ball, Point3d const& wanted)
{
  if (!(ball.radius > 0)) return {};
  double const dx = wanted.x - ball.centre.x, dy = wanted.y - ball.centre.y, dz = wanted.z - ball.centre.z;
  double const length = std::hypot(dx, dy, dz);
  if (!(length > 0) || !std::isfinite(length)) return {};
  bool const up = dz > 0;
  double const h = 1 + std::fabs(dz) / length;
  auto const dyadic = [](double x) { return RationalNumber(std::rint(x * weight_one)) / RationalNumber(weight_one); };
  RationalNumber const u = dyadic(dx / length / h), v = dyadic(dy / length / h), r(ball.radius), one(1), two(2);
  RationalNumber const s = u * u + v * v, scale = r / (one + s), z = scale * (one - s);
  Point3q const p{RationalNumber(ball.centre.x) + scale * two * u, RationalNumber(ball.centre.y) + scale * two * v,
                  up ? RationalNumber(ball.centre.z) + z : RationalNumber(ball.centre.z) - z};
  return FacePoint{{CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)}, p};
}

Corners facet_corners(ConvexPolyhedron const& p, std::uint32_t facet)
{
  auto const& v = p.facets[facet].vertices;
  return {p.vertices[v[0]], p.vertices[v[1]], p.vertices[v[2]]};
}

Point3d centroid(Corners const& t)
{
  auto const mean = [](double a, double b, double c) { return a / 3 + b / 3 + c / 3; };
  return {mean(t[0].x, t[1].x, t[2].x), mean(t[0].y, t[1].y, t[2].y), mean(t[0].z, t[1].z, t[2].z)};
}

}  // namespace

std::pair<Point2d, Point2d> wall_ends(Prism const& prism, std::uint32_t edge)
{
  for (auto const& ring : prism.rings) {
    if (edge < ring.size()) return {ring[edge], ring[(edge + 1) % ring.size()]};
    edge -= static_cast<std::uint32_t>(ring.size());
  }
  throw std::out_of_range("a prism has no such wall");
}

std::optional<FacePoint> point_inside(PreparedScene const& scene, Face const& face, Point3d const& wanted)
{
  Scene const& s = scene.scene();
  if (!is_finite(wanted)) return {};
  switch (face.kind) {
  case Face::Kind::box: return inside_box_face(s.boxes[face.primitive], face.part, wanted);
  case Face::Kind::wall: return inside_wall(s.prisms[face.primitive], face.part, wanted);
  case Face::Kind::roof: return inside_cap(piece_of(scene, face), face.part, piece_of(scene, face).top, wanted);
  case Face::Kind::floor: return inside_cap(piece_of(scene, face), face.part, piece_of(scene, face).bottom, wanted);
  case Face::Kind::facet: return inside_triangle(facet_corners(s.polyhedra[face.primitive], face.part), wanted);
  case Face::Kind::triangle: return inside_triangle(s.triangle(face.primitive).vertices, wanted);
  case Face::Kind::sphere: return on_sphere(s.balls[face.primitive], wanted);
  }
  return {};
}

Point3d middle(PreparedScene const& scene, Face const& face, Point3d const& from)
{
  Scene const& s = scene.scene();
  auto const half = [](double a, double b) { return 0.5 * a + 0.5 * b; };
  switch (face.kind) {
  case Face::Kind::box: {
    Box const& b = s.boxes[face.primitive];
    Point3d c{half(b.min.x, b.max.x), half(b.min.y, b.max.y), half(b.min.z, b.max.z)};
    bool const high = face.part % 2 == 1;
    if (face.part / 2 == 0) c.x = high ? b.max.x : b.min.x;
    if (face.part / 2 == 1) c.y = high ? b.max.y : b.min.y;
    if (face.part / 2 == 2) c.z = high ? b.max.z : b.min.z;
    return c;
  }
  case Face::Kind::wall: {
    auto const& prism = s.prisms[face.primitive];
    auto const [a, b] = wall_ends(prism, face.part);
    return {half(a.x, b.x), half(a.y, b.y), half(prism.bottom, prism.top)};
  }
  case Face::Kind::roof:
  case Face::Kind::floor: {
    auto const& piece = piece_of(scene, face);
    auto const t = fan_triangle(piece, face.part);
    double const z = face.kind == Face::Kind::roof ? piece.top : piece.bottom;
    return centroid({Point3d{t[0].x, t[0].y, z}, Point3d{t[1].x, t[1].y, z}, Point3d{t[2].x, t[2].y, z}});
  }
  case Face::Kind::facet: return centroid(facet_corners(s.polyhedra[face.primitive], face.part));
  case Face::Kind::triangle: return centroid(s.triangle(face.primitive).vertices);
  case Face::Kind::sphere: break;
  }
  Ball const& ball = s.balls[face.primitive];
  double const dx = from.x - ball.centre.x, dy = from.y - ball.centre.y, dz = from.z - ball.centre.z;
  constexpr double no_length = 1e-300;  // in place of 0: finite even from the centre
  double const scale = ball.radius / std::fmax(std::hypot(dx, dy, dz), no_length);
  return {ball.centre.x + scale * dx, ball.centre.y + scale * dy, ball.centre.z + scale * dz};
}

}  // namespace visibility
