#include "visibility/viewspace/divide.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace visibility {

namespace {

/// Edges are cut at multiples of this share of their length.
constexpr int shares = 16;

/// The grid is finer than the coordinates by so many bits, and than the cell by so many.
constexpr int coordinate_bits = 31, cell_bits = 20;

struct Direction {
  double x, y, z;
};
double dot(Direction const& d, Point3d const& p) { return d.x * p.x + d.y * p.y + d.z * p.z; }

Direction unit(Point3d const& a, Point3d const& b)
{
  double const x = b.x - a.x, y = b.y - a.y, z = b.z - a.z, length = std::hypot(x, y, z);
  return {x / length, y / length, z / length};
}

/// The edges between facets in different planes: those of the polytope, not of its triangulation.
std::vector<ConvexPolyhedron::Edge> true_edges(ConvexPolyhedron const& shape)
{
  std::vector<std::vector<std::size_t>> facets(shape.edges.size());
  for (std::size_t f = 0; f < shape.facets.size(); ++f)
    for (auto const e : shape.facets[f].edges) facets[static_cast<std::size_t>(e < 0 ? ~e : e)].push_back(f);
  auto const& v = shape.vertices;
  std::vector<ConvexPolyhedron::Edge> out;
  for (std::size_t e = 0; e < shape.edges.size(); ++e) {
    auto const &a = shape.facets[facets[e].front()].vertices, &b = shape.facets[facets[e].back()].vertices;
    bool const is_flat = std::ranges::all_of(
      b, [&](auto const i) { return is_zero(orient3d<Filtered>(v[a[0]], v[a[1]], v[a[2]], v[i])); });
    if (!is_flat) out.push_back(shape.edges[e]);
  }
  return out;
}

struct Extent {
  Direction direction{};
  double low = 0, high = 0;
  double length() const { return high - low; }
};

Extent greatest(ConvexPolyhedron const& shape, std::vector<ConvexPolyhedron::Edge> const& edges)
{
  Extent best;
  for (auto const& e : edges) {
    Extent x{unit(shape.vertices[e.from], shape.vertices[e.to]), HUGE_VAL, -HUGE_VAL};
    for (auto const& v : shape.vertices) {
      x.low = std::min(x.low, dot(x.direction, v));
      x.high = std::max(x.high, dot(x.direction, v));
    }
    if (x.length() > best.length()) best = x;
  }
  return best;
}

/// a + t (b - a), if that is a double.
std::optional<double> exactly_between(double a, double b, RationalNumber const& t)
{
  RationalNumber const x = RationalNumber(a) + t * (RationalNumber(b) - RationalNumber(a));
  double const rounded = CGAL::to_double(x);
  if (!std::isfinite(rounded) || RationalNumber(rounded) != x) return {};
  return rounded;
}

std::optional<Point3d> exactly_between(Point3d const& a, Point3d const& b, int share)
{
  RationalNumber const t(share, shares);
  auto const x = exactly_between(a.x, b.x, t), y = exactly_between(a.y, b.y, t), z = exactly_between(a.z, b.z, t);
  if (!x || !y || !z) return {};
  return Point3d{*x, *y, *z};
}

double Point3d::*longest_axis(Box const& b)
{
  double const x = b.max.x - b.min.x, y = b.max.y - b.min.y, z = b.max.z - b.min.z;
  return x >= y && x >= z ? &Point3d::x : y >= z ? &Point3d::y : &Point3d::z;
}

std::optional<std::pair<ViewCell, ViewCell>> halves_of_box(Box const& box)
{
  auto const axis = longest_axis(box);
  double const middle = 0.5 * (box.min.*axis) + 0.5 * (box.max.*axis);
  if (!(box.min.*axis < middle && middle < box.max.*axis)) return {};
  Box first = box, second = box;
  first.max.*axis = middle;
  second.min.*axis = middle;
  return {{ViewCell(first), ViewCell(second)}};
}

double longest_side(Box const& b)
{
  auto const axis = longest_axis(b);
  return b.max.*axis - b.min.*axis;
}

/// The grid that a cell is put on.
double grid_of(ViewCell const& cell)
{
  double largest = 0;
  for (auto const& v : cell.vertices()) largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return std::ldexp(
    1.0, std::min(std::ilogb(largest) - coordinate_bits, std::ilogb(longest_side(cell.bounds())) - cell_bits));
}

bool is_multiple(double x, double grid) { return std::rint(x / grid) * grid == x; }
double nearest(double x, double grid) { return std::rint(x / grid) * grid; }

/// The vertices, scaled by 1 + share about their mean and moved to the nearest grid points; heights of a prism to the
/// next ones outward.
std::vector<Point3d> moved(ViewCell const& cell, double grid, double share, bool is_prism)
{
  auto const n = static_cast<double>(cell.vertices().size());
  Point3d middle{0, 0, 0};
  for (auto const& v : cell.vertices()) middle = {middle.x + v.x / n, middle.y + v.y / n, middle.z + v.z / n};
  std::vector<Point3d> out;
  for (auto const& v : cell.vertices()) {
    double const z = is_prism ? (v.z < middle.z ? std::floor(v.z / grid) : std::ceil(v.z / grid)) * grid
                              : nearest(v.z + share * (v.z - middle.z), grid);
    out.push_back({nearest(v.x + share * (v.x - middle.x), grid), nearest(v.y + share * (v.y - middle.y), grid), z});
  }
  return out;
}

/// Whether the vertices stand in pairs one above the other, between two heights.
bool is_upright_prism(ViewCell const& cell)
{
  Box const& box = cell.bounds();
  std::set<std::pair<double, double>> low, high;
  for (auto const& v : cell.vertices()) {
    if (v.z != box.min.z && v.z != box.max.z) return false;
    (v.z == box.min.z ? low : high).insert({v.x, v.y});
  }
  return low == high;
}

}  // namespace

double longest_extent(ViewCell const& cell)
{
  if (!cell.is_box()) return greatest(cell.shape(), true_edges(cell.shape())).length();
  return longest_side(cell.bounds());
}

std::optional<std::pair<ViewCell, ViewCell>> halves(ViewCell const& cell)
{
  if (cell.is_box()) return halves_of_box(cell.bounds());
  auto const& shape = cell.shape();
  auto const edges = true_edges(shape);
  Extent const extent = greatest(shape, edges);
  double const middle = 0.5 * extent.low + 0.5 * extent.high;
  std::vector<double> position;
  std::vector<Point3d> first, second;
  for (auto const& v : shape.vertices) {
    position.push_back(dot(extent.direction, v));
    (position.back() <= middle ? first : second).push_back(v);
  }
  if (first.empty() || second.empty()) return {};
  for (auto const& e : edges) {
    double const a = position[e.from], b = position[e.to];
    if ((a <= middle) == (b <= middle)) continue;
    int const share = std::clamp(static_cast<int>(std::lround(shares * (middle - a) / (b - a))), 1, shares - 1);
    auto const p = exactly_between(shape.vertices[e.from], shape.vertices[e.to], share);
    if (!p) return {};
    first.push_back(*p);
    second.push_back(*p);
  }
  return {{ViewCell::hull(first), ViewCell::hull(second)}};
}

ViewCell divisible(ViewCell const& cell)
{
  if (cell.is_box()) return cell;
  double const grid = grid_of(cell);
  auto const on_grid = [&](Point3d const& v) {
    return is_multiple(v.x, grid) && is_multiple(v.y, grid) && is_multiple(v.z, grid);
  };
  if (std::ranges::all_of(cell.vertices(), on_grid)) return cell;
  bool const is_prism = is_upright_prism(cell);
  constexpr double largest_share = 0x1p-10;
  for (double share = grid / longest_side(cell.bounds()); share <= largest_share; share *= 2) {
    auto const points = moved(cell, grid, share, is_prism);
    try {
      auto const larger = ViewCell::hull(points);
      if (std::ranges::all_of(cell.vertices(), [&](Point3d const& v) { return contains(larger, v); })) return larger;
    } catch (std::invalid_argument const&) {
      continue;  // flat on the grid
    }
  }
  return cell;
}

}  // namespace visibility
