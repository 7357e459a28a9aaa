#pragma once

#include "height_fields.hpp"

#include "visibility/scene/seams.hpp"

#include <array>
#include <map>
#include <set>
#include <tuple>

/// Seams of a field by names and coordinates, and a point-wise look at their parts.
namespace visibility::test {

using Coordinates = std::array<double, 3>;
inline Coordinates plain(Point3d const& p) { return {p.x, p.y, p.z}; }

/// x, y, z of the left and of the right end.
using PartEnds = std::array<RationalNumber, 6>;
inline PartEnds ends(SeamPart const& p) { return {p.left.x, p.left.y, p.left.z, p.right.x, p.right.y, p.right.z}; }

/// Object and corners of S and of F, ends of the edge (none: a crease), side.
using SeamName =
  std::tuple<std::string, std::set<Coordinates>, std::string, std::set<Coordinates>, std::vector<Coordinates>, bool>;
using SeamTable = std::map<SeamName, std::set<PartEnds>>;

inline std::string const& object_name(HeightField const& field, std::uint32_t column)
{
  return field.scene().objects[field.columns()[column].object].name;
}

/// The seams that have parts. Columns that coincide must agree.
inline SeamTable seam_table(HeightField const& field)
{
  auto const corners = [&](std::uint32_t c) {
    std::set<Coordinates> out;
    for (auto const& p : field.corners(field.columns()[c])) out.insert(plain(p));
    return out;
  };
  SeamTable out;
  for (auto const& s : field.seams()) {
    std::set<PartEnds> parts;
    for (auto const& p : exposed_parts(field, s)) parts.insert(ends(p));
    if (parts.empty()) continue;
    std::vector<Coordinates> edge;
    if (!s.is_crease()) edge = {plain(field.edges()[s.edge].a), plain(field.edges()[s.edge].b)};
    SeamName name{object_name(field, s.column),
                  corners(s.column),
                  object_name(field, s.other),
                  corners(s.other),
                  edge,
                  s.from_left};
    auto const [at, is_new] = out.try_emplace(std::move(name), parts);
    REQUIRE(at->second == parts);
  }
  return out;
}

inline RationalNumber turn(Point2q const& p, Point2q const& q, Point2q const& r)
{
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}
inline Point2q between(Point2q const& p, Point2q const& q, RationalNumber const& t)
{
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}
/// A tiny step from a point to the left of the direction p -> q; back, to the right.
inline Point2q beside(Point2q const& m, Point2q const& p, Point2q const& q, bool left)
{
  RationalNumber const step(left ? 0x1p-200 : -0x1p-200);
  return {m.x - step * (q.y - p.y), m.y + step * (q.x - p.x)};
}
/// Whether the point lies inside the part, in plan.
inline bool is_on(SeamPart const& part, Point2q const& m)
{
  auto const p = horizontal(part.left), q = horizontal(part.right);
  RationalNumber const dx = q.x - p.x, dy = q.y - p.y, along = (m.x - p.x) * dx + (m.y - p.y) * dy;
  return turn(p, q, m) == 0 && 0 < along && along < dx * dx + dy * dy;
}

/// Whether the column's top is the upper envelope over the point.
inline bool is_on_top(HeightField const& field, HeightField::Column const& s, Point2q const& p)
{
  if (!contains(field, s, p)) return false;
  auto const z = top_over(field, s, p);
  return std::ranges::none_of(field.columns(), [&](HeightField::Column const& g) {
    return !g.is_curtain() && contains(field, g, p) && top_over(field, g, p) > z;
  });
}

/// Whether the side of the column on which the point lies, if any, is one that has no edge.
inline bool is_on_open_side(HeightField const& field, std::uint32_t column, Point2q const& m)
{
  auto const c = field.corners(field.columns()[column]);
  for (std::size_t i = 0; i < c.size(); ++i) {
    auto const &a = c[i], &b = c[(i + 1) % c.size()];
    auto const p = horizontal(exact(a)), q = horizontal(exact(b));
    if (turn(p, q, m) != 0) continue;
    if ((m.x - p.x) * (q.x - m.x) + (m.y - p.y) * (q.y - m.y) < 0) continue;  // on its line only
    if (std::ranges::none_of(field.edges(), [&](auto const& e) { return e.column == column && e.a == a && e.b == b; }))
      return true;
  }
  return false;
}

}  // namespace visibility::test
