#include "polygon_sides.hpp"

#include "visibility/predicates/orient3d.hpp"
#include "visibility/scene/seams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace visibility {

namespace {

using namespace height_field;
using Column = HeightField::Column;

Box box_of(Corners points)
{
  Box box;
  for (auto const& p : points) box.extend(p);
  return box;
}

class SeamFinder {
public:
  explicit SeamFinder(HeightField const& field) : field_(field), first_edge_(field.columns().size() + 1, 0)
  {
    for (auto const& e : field.edges()) ++first_edge_[e.column + 1];
    for (std::size_t c = 1; c < first_edge_.size(); ++c) first_edge_[c] += first_edge_[c - 1];
  }

  std::vector<Seam> operator()()
  {
    auto const& hierarchy = field_.column_hierarchy();
    for (std::size_t i = 0; i < hierarchy.items().size(); ++i) {  // in this order neighbours ask after each other
      std::uint32_t const s = hierarchy.items()[i];
      Column const& column = field_.columns()[s];
      if (column.is_curtain()) continue;
      hierarchy.any_item_meeting(reach(s, hierarchy.item_bounds()[i]), [&](std::uint32_t f) {
        if (field_.columns()[f].object != column.object) find(s, f);
        return false;
      });
    }
    std::ranges::sort(seams_);
    return std::move(seams_);
  }

private:
  /// Meets the boxes of the columns that are higher than the lowest corner of S and overlap with its box, which means
  /// more than touch unless S has sides without an edge.
  Box reach(std::uint32_t s, Box box) const
  {
    constexpr double inf = std::numeric_limits<double>::infinity();
    box.min.z = inf;
    for (auto const& p : corners(s)) box.min.z = std::min(box.min.z, p.z);
    box.min.z = std::nextafter(box.min.z, inf);
    box.max.z = inf;
    if (has_open_sides(s)) return box;
    box.min.x = std::nextafter(box.min.x, inf);
    box.min.y = std::nextafter(box.min.y, inf);
    box.max.x = std::nextafter(box.max.x, -inf);
    box.max.y = std::nextafter(box.max.y, -inf);
    return box;
  }

  void find(std::uint32_t s, std::uint32_t f)
  {
    for (auto e = first_edge_[f]; e < first_edge_[f + 1]; ++e) {
      if (stands_on(s, e, Sign::negative)) seams_.push_back({s, f, e, false});
      if (field_.columns()[f].is_curtain() && stands_on(s, e, Sign::positive)) seams_.push_back({s, f, e, true});
    }
    if (crosses(s, f)) seams_.push_back({s, f, Seam::no_edge, false});
  }

  /// Whether the edge may have a foot on S, seen from the side `near` of a -> b.
  bool stands_on(std::uint32_t s, std::uint32_t edge, Sign near) const
  {
    auto const& [a, b, f] = field_.edges()[edge];
    Corners const polygon = corners(s);
    double const top = std::max(a.z, b.z);
    if (std::ranges::all_of(polygon, [&](Point3d const& p) { return p.z >= top; })) return false;
    if (!is_negative(rise(s, a)) && !is_negative(rise(s, b))) return false;
    bool const behind = has_corner_beside(polygon, a, b, -near);
    if (!behind && !has_open_sides(s)) return false;
    if (!has_corner_beside(polygon, a, b, near) || has_outside(polygon, a, b)) return false;
    return behind || any_side(polygon, [&, &a = a, &b = b](Point3d const& p, Point3d const& q) {
             return are_zero(side_of(a, b, p), side_of(a, b, q)) && is_open(s, p, q);
           });
  }

  /// Whether the top planes may cross on S, F rising above.
  bool crosses(std::uint32_t s, std::uint32_t f) const
  {
    Column const &low = field_.columns()[s], &high = field_.columns()[f];
    if (high.is_curtain() || (low.is_flat && high.is_flat)) return false;
    Corners const polygon = corners(s), other = corners(f);
    bool in_front = false, behind = false;
    for (auto const& p : polygon) {
      Sign const sign = rise(f, p);
      in_front |= is_negative(sign);
      behind |= is_positive(sign);
    }
    if (!in_front || std::ranges::none_of(other, [&](Point3d const& p) { return is_negative(rise(s, p)); }))
      return false;
    if (behind) return !separates(polygon, other) && !separates(other, polygon);
    return has_open_sides(s) && any_side(polygon, [&](Point3d const& p, Point3d const& q) {
             return are_zero(rise(f, p), rise(f, q)) && is_open(s, p, q) && !has_outside(other, p, q);
           });
  }

  Corners corners(std::uint32_t c) const { return field_.corners(field_.columns()[c]); }

  /// Sign of how much higher the column's top plane is over p than p. A column that is not flat is a triangle.
  Sign rise(std::uint32_t column, Point3d const& p) const
  {
    Corners const c = corners(column);
    if (field_.columns()[column].is_flat) return sign_of(c[0].z - p.z);
    return -orient3d<Filtered>(c[0], c[1], c[2], p);
  }

  /// Whether the column has sides that are left out of the edges.
  bool has_open_sides(std::uint32_t c) const { return first_edge_[c + 1] - first_edge_[c] < field_.columns()[c].count; }

  bool is_open(std::uint32_t c, Point3d const& p, Point3d const& q) const
  {
    auto const edges = field_.edges().subspan(first_edge_[c], first_edge_[c + 1] - first_edge_[c]);
    return std::ranges::none_of(edges, [&](HeightField::TopEdge const& e) { return e.a == p && e.b == q; });
  }

  HeightField const& field_;
  std::vector<std::uint32_t> first_edge_;  ///< of each column; its edges lie together
  std::vector<Seam> seams_;
};

}  // namespace

std::vector<Seam> find_seams(HeightField const& field) { return SeamFinder(field)(); }

Box bounds(HeightField const& field, Seam const& seam)
{
  Box box = box_of(field.corners(field.columns()[seam.column]));
  Box other;
  if (seam.is_crease()) {
    other = box_of(field.corners(field.columns()[seam.other]));
  } else {
    other.extend(field.edges()[seam.edge].a);
    other.extend(field.edges()[seam.edge].b);
  }
  box.min = {std::max(box.min.x, other.min.x), std::max(box.min.y, other.min.y), box.min.z};
  box.max = {std::min(box.max.x, other.max.x), std::min(box.max.y, other.max.y), std::min(box.max.z, other.max.z)};
  return box;
}

}  // namespace visibility
