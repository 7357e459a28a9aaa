#include "inner_prisms.hpp"

#include "convex_growth.hpp"
#include "inner_certificate.hpp"
#include "mesh_slices.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace visibility::detail {

namespace {

using plan::Polygon;

struct Extent {
  double bottom, top;
};

/// Heights of the part of the triangle whose plan is more than `slack` inside the convex polygon; empty (top < bottom)
/// if there is none. Rounded, but exact for a horizontal triangle.
Extent heights_over(Polygon const& convex, Triangle const& t, double slack)
{
  thread_local std::vector<Point3d> part, rest;
  part.assign(t.vertices.begin(), t.vertices.end());
  for (std::size_t i = 0, n = convex.size(); i < n && !part.empty(); ++i) {
    Point2d const &a = convex[i], &b = convex[(i + 1) % n];
    double const length = plan::distance(a, b);
    auto const inside = [&](Point3d const& p) { return plan::turn(a, b, horizontal(p)) - slack * length; };
    rest.clear();
    for (std::size_t j = 0; j < part.size(); ++j) {
      Point3d const &p = part[j], &q = part[(j + 1) % part.size()];
      double const fp = inside(p), fq = inside(q);
      if (fp > 0) rest.push_back(p);
      if ((fp > 0) == (fq > 0)) continue;
      double const s = fp / (fp - fq);
      rest.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)});
    }
    part.swap(rest);
  }
  Extent e{t.vertices[0].z, t.vertices[0].z};
  if (part.empty()) return {e.bottom, -std::numeric_limits<double>::infinity()};
  auto const [low, high] = std::ranges::minmax(part, {}, [](Point3d const& p) { return p.z; });
  return {low.z, high.z};
}

/// How far the convex polygon at height z can move down and up before it meets a facet; nothing if one crosses it.
std::optional<Extent> free_extent(MeshShell const& shell, Polygon const& convex, double z, double slack)
{
  Box plan_bounds;
  for (auto const& p : convex) plan_bounds.extend(Point3d{p.x, p.y, z});
  Extent e{std::max(shell.floor, shell.bounds.min.z), shell.bounds.max.z};
  for (std::size_t f = 0; f < shell.facets.size(); ++f) {
    Triangle const t = shell.triangle(f);
    Box const b = visibility::bounding_box(t);
    if (b.max.x <= plan_bounds.min.x || plan_bounds.max.x <= b.min.x || b.max.y <= plan_bounds.min.y ||
        plan_bounds.max.y <= b.min.y || b.max.z <= e.bottom || e.top <= b.min.z)
      continue;
    Extent const h = heights_over(convex, t, slack);
    if (h.top < h.bottom) continue;
    if (h.bottom >= z)
      e.top = std::min(e.top, h.bottom);
    else if (h.top <= z)
      e.bottom = std::max(e.bottom, h.top);
    else
      return {};
  }
  return e;
}

/// Parts by which a polygon is shrunk until it fits; the last ones are for walls that are only nearly straight.
constexpr std::array shrinks{0.0, 1e-9, 1e-6, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2};

/// A nearly convex section whose hull fits after so little shrinking has no better polygon.
constexpr double good_shrink = 1e-3;

/// The part at which to start: where a little less width gives clearly more height, as between leaning walls.
std::size_t first_shrink(MeshShell const& shell, Polygon const& polygon, double z, double slack)
{
  auto const height = [&](double by) {
    auto const e = free_extent(shell, plan::convex_hull(plan::shrunk(polygon, by)), z, slack);
    return e ? (e->top - e->bottom) * (1 - 2 * by) : 0;
  };
  double best = height(shrinks.front());
  if (height(shrinks.back()) <= best) return 0;
  std::size_t first = 0;
  for (std::size_t i = 1; i < shrinks.size(); ++i)
    if (double const h = height(shrinks[i]); h > 1.02 * best) best = h, first = i;
  return first;
}

struct Fitted {
  ConvexPrism body;
  double shrunk_by;
};

/// A certified prism over the polygon, shrunk a little more each time that the certificate fails.
std::optional<Fitted> fit(MeshShell const& shell, Polygon const& polygon, double z, double slack)
{
  if (polygon.size() < 3) return {};
  for (auto i = first_shrink(shell, polygon, z, slack); i < shrinks.size(); ++i) {
    ConvexPrism body{plan::convex_hull(plan::shrunk(polygon, shrinks[i])), 0, 0};
    if (body.footprint.size() < 3) return {};
    auto const extent = free_extent(shell, body.footprint, z, slack);
    if (!extent) continue;
    double const margin = shrinks[i] * (extent->top - extent->bottom);
    // An end that stays on a level facet, above all the foot on the ground, is worth a try.
    for (auto const& [below, above] : {std::pair{0.0, 0.0}, {0.0, margin}, {margin, margin}}) {
      body.bottom = extent->bottom + below;
      body.top = extent->top - above;
      if (body.bottom < body.top && is_certified(shell, body)) return Fitted{std::move(body), shrinks[i]};
      if (margin == 0) break;
    }
  }
  return {};
}

/// Convex polygons inside one polygon with holes, grown from its convex pieces, large ones first.
std::vector<Polygon> convex_polygons(std::vector<Polygon> const& rings, std::size_t most, double slack)
{
  auto pieces = convex_partition({rings, 0, 1});
  std::ranges::sort(pieces, std::greater<>{}, [](ConvexPrism const& p) { return plan::area(p.footprint); });
  if (pieces.size() > most) pieces.resize(most);
  std::vector<Polygon> out;
  for (auto const& piece : pieces) {
    Polygon grown = plan::convex_hull(grow(rings, piece.footprint));
    if (std::ranges::none_of(out, [&](Polygon const& q) { return plan::contains(q, grown, slack); }))
      out.push_back(std::move(grown));
  }
  return out;
}

/// Whether the ring is convex but for a hundredth of its area: then its hull, a little shrunk, is worth a try.
bool is_nearly_convex(Polygon const& ring, Polygon const& hull)
{
  return std::abs(plan::area(hull)) <= 1.01 * std::abs(plan::area(ring));
}

}  // namespace

std::vector<ConvexPrism> inner_prisms(MeshShell const& shell, InnerBodyOptions const& options)
{
  double const size = shell.bounds.max.x - shell.bounds.min.x + shell.bounds.max.y - shell.bounds.min.y;
  double const slack = 1e-9 * size;
  std::vector<ConvexPrism> out;
  for (double const z : slice_heights(shell, options.slices)) {
    auto const is_new = [&](Polygon const& polygon) {
      return std::ranges::none_of(out, [&](ConvexPrism const& k) {
        return k.bottom <= z && z <= k.top && plan::contains(k.footprint, polygon, 1e-4 * size);
      });
    };
    auto const add = [&](Polygon const& polygon) {
      auto fitted = fit(shell, plan::with_few_corners(polygon, options.max_corners), z, slack);
      if (fitted) out.push_back(std::move(fitted->body));
      return fitted && fitted->shrunk_by <= good_shrink;
    };
    for (auto const& rings : nested(slice(shell, z, slack))) {
      Polygon const hull = plan::convex_hull(rings[0]);
      if (rings.size() == 1 && is_nearly_convex(rings[0], hull) && (!is_new(hull) || add(hull))) continue;
      for (auto const& polygon : convex_polygons(rings, options.pieces_per_slice, slack))
        if (is_new(polygon)) add(polygon);
    }
  }
  return out;
}

}  // namespace visibility::detail
