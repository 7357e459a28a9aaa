#include "height_field_columns.hpp"

#include "polygon_sides.hpp"
#include "upper_boundary.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace visibility::height_field {

auto ObjectColumns::of(Object const& object) -> Result const&
{
  result_ = {};
  for (auto i = object.boxes.first; i < object.boxes.last; ++i) {
    Box const& b = scene_.boxes[i];
    Point3d const p00{b.min.x, b.min.y, b.max.z}, p10{b.max.x, b.min.y, b.max.z};
    Point3d const p01{b.min.x, b.max.y, b.max.z}, p11{b.max.x, b.max.y, b.max.z};
    if (b.min.x < b.max.x && b.min.y < b.max.y)
      result_.columns.push_back({p00, p10, p11, p01});
    else if (!same_in_plan(p00, p11))
      add_curtain(p00, p11);
  }
  for (auto i = object.prisms.first; i < object.prisms.last; ++i) add(scene_.prisms[i]);
  result_.solids = result_.columns.size();
  for (auto i = object.polyhedra.first; i < object.polyhedra.last; ++i) add(scene_.polyhedra[i]);
  for (auto i = object.triangles.first; i < object.triangles.last; ++i) {
    auto const [a, b, c] = scene_.triangle(i).vertices;
    add_triangle(a, b, c);
  }
  find_edges();
  return result_;
}

void ObjectColumns::add(Prism const& prism)
{
  auto const pieces = convex_partition(prism);
  for (auto const& piece : pieces) {
    auto& column = result_.columns.emplace_back();
    for (auto const& p : piece.footprint) column.push_back({p.x, p.y, piece.top});
  }
  if (!pieces.empty()) return;
  ++result_.invalid_footprints;
  for (auto const& ring : prism.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      auto const &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if (!(p == q)) add_curtain({p.x, p.y, prism.top}, {q.x, q.y, prism.top});
    }
}

void ObjectColumns::add(ConvexPolyhedron const& polyhedron)
{
  for (auto const& f : polyhedron.facets) {
    auto const &a = polyhedron.vertices[f.vertices[0]], &b = polyhedron.vertices[f.vertices[1]],
               &c = polyhedron.vertices[f.vertices[2]];
    Sign const turn = orient2d<Filtered>(horizontal(a), horizontal(b), horizontal(c));
    if (is_positive(turn)) result_.columns.push_back({a, b, c});
    if (is_zero(turn)) result_.walls.push_back({a, b, c});
  }
}

void ObjectColumns::add_triangle(Point3d const& a, Point3d const& b, Point3d const& c)
{
  switch (orient2d<Filtered>(horizontal(a), horizontal(b), horizontal(c))) {
  case Sign::positive: result_.columns.push_back({a, b, c}); return;
  case Sign::negative: result_.columns.push_back({a, c, b}); return;
  case Sign::zero: break;
  }
  result_.walls.push_back({a, b, c});
  auto const boundary = upper_boundary({a, b, c});
  for (std::size_t i = 1; i < boundary.size(); ++i) add_curtain(boundary[i - 1], boundary[i]);
}

void ObjectColumns::add_curtain(Point3d const& a, Point3d const& b) { result_.columns.push_back({a, b}); }

/// Whether another side over the same piece of the plan makes this one superfluous: a curtain by a side that is at
/// least as high (of equal curtains the first counts), a column by a higher one on the same side, which buries its top
/// there and has its wall.
bool ObjectColumns::is_covered(std::vector<Side> const& group, Side const& side) const
{
  bool const curtain = is_curtain(side);
  return std::ranges::any_of(group, [&](Side const& s) {
    if (&s == &side || s.a.z < side.a.z || s.b.z < side.b.z) return false;
    bool const equal = s.a.z == side.a.z && s.b.z == side.b.z;
    if (!curtain) return !equal && !is_curtain(s) && s.forward == side.forward;
    return !equal || !is_curtain(s) || s.column < side.column;
  });
}

/// Whether the side of a column is one of exactly two in the group, the other opposite and as high, with a top that is
/// flat there or a valley. Curtains do not count.
bool ObjectColumns::is_redundant(std::vector<Side> const& group, Side const& side) const
{
  Side const* other = nullptr;
  for (auto const& s : group) {
    if (&s == &side || is_curtain(s)) continue;
    if (other != nullptr || s.forward == side.forward || !(s.a == side.a) || !(s.b == side.b)) return false;
    other = &s;
  }
  if (other == nullptr) return false;
  // No corner of the other column below this one's plane. A column of more than three corners is flat, and the first
  // three of them may lie on one line.
  auto const& mine = result_.columns[side.column];
  return std::ranges::all_of(result_.columns[other->column], [&](Point3d const& p) {
    return mine.size() > 3 ? p.z >= mine[0].z : !is_negative(orient3d<Filtered>(mine[0], mine[1], mine[2], p));
  });
}

void ObjectColumns::find_edges()
{
  std::vector<Side> sides;
  for (std::uint32_t c = 0; c < result_.columns.size(); ++c) {
    auto const& corners = result_.columns[c];
    std::size_t const n = corners.size() == 2 ? 1 : corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      auto const &a = corners[i], &b = corners[(i + 1) % corners.size()];
      bool const forward = less_in_plan(a, b);
      sides.push_back({forward ? a : b, forward ? b : a, forward, c});
    }
  }
  auto const key = [](Side const& s) { return std::tie(s.a.x, s.a.y, s.b.x, s.b.y); };
  std::ranges::stable_sort(sides, {}, [&](Side const& s) { return key(s); });
  std::vector<Side> group, uncovered;
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    while (j < sides.size() && key(sides[j]) == key(sides[i])) ++j;
    group.assign(sides.begin() + static_cast<std::ptrdiff_t>(i), sides.begin() + static_cast<std::ptrdiff_t>(j));
    uncovered.clear();
    std::ranges::copy_if(group, std::back_inserter(uncovered), [&](Side const& s) { return !is_covered(group, s); });
    for (auto const& s : uncovered)
      if (is_curtain(s) || !is_redundant(uncovered, s))
        result_.edges.push_back({s.forward ? s.a : s.b, s.forward ? s.b : s.a, s.column});
  }
  std::ranges::stable_sort(result_.edges, {}, &Edge::column);
  drop_idle_curtains();
}

/// Removes the curtains that have lost their edge: nothing remains of them.
void ObjectColumns::drop_idle_curtains()
{
  std::uint32_t kept = 0;
  std::size_t solids = 0;
  auto edge = result_.edges.begin();
  for (std::uint32_t c = 0; c < result_.columns.size(); ++c) {
    auto const last = std::find_if(edge, result_.edges.end(), [&](Edge const& e) { return e.column != c; });
    if (result_.columns[c].size() == 2 && edge == last) continue;
    for (; edge != last; ++edge) edge->column = kept;
    solids += c < result_.solids;
    if (kept != c) result_.columns[kept] = std::move(result_.columns[c]);
    ++kept;
  }
  result_.columns.resize(kept);
  result_.solids = solids;
}

}  // namespace visibility::height_field
