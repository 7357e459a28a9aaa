#include "support/height_field_lines.hpp"

#include <cmath>

namespace visibility::oracle::detail {
namespace {

/// The same ray with coordinates near one, so that sums of rays lie well inside. A choice: nothing depends on it.
Vector scaled(Vector v)
{
  for (int tries = 0; tries < 8; ++tries) {
    double const size =
      std::fabs(CGAL::to_double(v.x)) + std::fabs(CGAL::to_double(v.y)) + std::fabs(CGAL::to_double(v.z));
    if (!std::isfinite(size)) {
      v = NT(0x1p-900) * v;
    } else if (size == 0) {
      v = NT(0x1p900) * v;
    } else {
      return NT(std::ldexp(1.0, -std::ilogb(size))) * v;
    }
  }
  return v;
}

}  // namespace

std::vector<Cone> all_lines()
{
  std::vector<Cone> cones;
  for (int octant = 0; octant < 8; ++octant) {
    auto const unit = [&](int axis) {
      NT const one((octant >> axis & 1) != 0 ? -1 : 1), zero(0);
      return Vector{axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero};
    };
    cones.push_back({{unit(0), unit(1), unit(2)}, {unit(2), unit(0), unit(1)}});
  }
  return cones;
}

Vector inner_line(std::span<Vector const> rays)
{
  Vector sum{NT(0), NT(0), NT(0)};
  for (auto const& r : rays) sum = sum + r;
  return sum;
}

Signs signs(Vector const& linear, std::span<Vector const> rays)
{
  Signs s;
  for (auto const& r : rays) {
    int const at = sign(dot(linear, r));
    s.negative = s.negative || at < 0;
    s.positive = s.positive || at > 0;
  }
  return s;
}

std::pair<Cone, Cone> split(Cone const& cone, Vector const& point)
{
  std::size_t const n = cone.rays.size();
  std::vector<NT> at;
  for (auto const& r : cone.rays) at.push_back(dot(point, r));
  // The ray of facet i on the plane of the point, computed from these two so that its coordinates stay short.
  auto const new_ray = [&](std::size_t i) {
    std::size_t const next = (i + 1) % n;
    Vector const between = (CGAL::abs(at[next]) * cone.rays[i]) + (CGAL::abs(at[i]) * cone.rays[next]);
    Vector const ray = cross(cone.facets[i], point);
    return scaled(dot(ray, between) < 0 ? -ray : ray);
  };
  auto const part = [&](int side) {
    Cone out;
    auto const push = [&](Vector const& ray, Vector const& facet) {
      out.rays.push_back(ray);
      out.facets.push_back(facet);
    };
    for (std::size_t i = 0; i < n; ++i) {
      int const here = side * sign(at[i]), next = side * sign(at[(i + 1) % n]);
      if (here >= 0) push(cone.rays[i], here == 0 && next < 0 ? point : cone.facets[i]);
      if (here > 0 && next < 0) push(new_ray(i), point);
      if (here < 0 && next > 0) push(new_ray(i), cone.facets[i]);
    }
    return out;
  };
  return {part(-1), part(1)};
}

Vector Posts::order(Plan const& plan, Stop a, Stop b)
{
  auto const &k = plan.segments[std::size_t(a.segment)].line, &l = plan.segments[std::size_t(b.segment)].line;
  Vector const both = cross(k, l);
  return a.rising == b.rising ? both : -both;
}

Posts::Functions Posts::functions(Post const& post) const
{
  auto const& top = plan_.tops[std::size_t(post.top)];
  Vector const& line = plan_.segments[std::size_t(post.stop.segment)].line;
  Vector const crossing = post.stop.rising ? line : -line;
  return {top.scale * crossing, cross(crossing, top.form)};
}

Form const& Posts::above(Post const& p, Post const& q, Post const& s)
{
  std::uint64_t key = 0;
  for (Post const* post : {&p, &q, &s}) {
    key = key * plan_.segments.size() + std::uint64_t(post->stop.segment);
    key = key * (plan_.tops.size() * 2) + std::uint64_t(post->top) * 2 + (post->stop.rising ? 1 : 0);
  }
  auto const [entry, fresh] = forms_.try_emplace(key);
  Form& f = entry->second;
  if (!fresh) return f;
  f = {NT(0), NT(0), NT(0), NT(0), NT(0), NT(0)};
  auto const add_product = [&](Vector const& u, Vector const& v) {  // twice the product of the linear forms u and v
    f.xx = f.xx + NT(2) * u.x * v.x;
    f.yy = f.yy + NT(2) * u.y * v.y;
    f.zz = f.zz + NT(2) * u.z * v.z;
    f.xy = f.xy + u.x * v.y + u.y * v.x;
    f.xz = f.xz + u.x * v.z + u.z * v.x;
    f.yz = f.yz + u.y * v.z + u.z * v.y;
  };
  Functions const a = functions(p), b = functions(q), c = functions(s);
  add_product(cross(b.crossing, c.crossing), a.height);
  add_product(cross(a.crossing, b.crossing), c.height);
  add_product(-cross(a.crossing, c.crossing), b.height);
  return f;
}

}  // namespace visibility::oracle::detail
