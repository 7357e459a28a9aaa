#include "visibility/scene/exposed_lines.hpp"

#include "edge_cover.hpp"
#include "line_clip.hpp"
#include "top_plane.hpp"

#include <algorithm>

namespace visibility {

namespace {

using namespace height_field;
using NT = RationalNumber;
using Column = HeightField::Column;
using Parts = std::vector<OpenInterval>;

Parts listed(ExposedParts parts)
{
  if (parts.all) return {{0, 1}};
  return std::move(parts.parts);
}

Parts common(Parts const& a, Parts const& b)
{
  Parts out;
  for (auto const& x : a)
    for (auto const& y : b) {
      NT const low = std::max(x.low, y.low), high = std::min(x.high, y.high);
      if (low < high) out.push_back({low, high});
    }
  return out;
}

SeamPart seam_part(Point3q const& left, Point3q const& right, OpenInterval const& i)
{
  return {between(left, right, i.low), between(left, right, i.high)};
}
SeamPart reversed(SeamPart const& p) { return {p.right, p.left}; }

/// What columns leave of the line a -> b on one side of it.
Parts uncovered_parts(HeightField const& field, Point3d const& a, Point3d const& b, Sign side, Corners top)
{
  EdgeCover<Filtered, Point3d> const cover(field, a, b, side, {top});
  return listed(uncovered(field, cover, reach(a, b), [] { return OpenInterval{0, 1}; }));
}

/// What curtains in the vertical plane of a -> b leave of it where they are lower.
Parts above_curtains(HeightField const& field, Point3d const& a, Point3d const& b)
{
  Parts covered;
  bool const along_x = a.x != b.x;
  field.column_hierarchy().any_item_meeting(reach(a, b), [&](std::uint32_t c) {
    auto const corners = field.corners(field.columns()[c]);
    if (corners.size() != 2 || !are_zero(side_of(a, b, corners[0]), side_of(a, b, corners[1]))) return false;
    auto const position = [&](Point3d const& p) -> NT {
      return along_x ? NT((NT(p.x) - NT(a.x)) / (NT(b.x) - NT(a.x))) : NT((NT(p.y) - NT(a.y)) / (NT(b.y) - NT(a.y)));
    };
    auto const rise = [&](Point3d const& p, NT const& t) -> NT { return NT(p.z) - NT(a.z) - t * (NT(b.z) - NT(a.z)); };
    NT const s = position(corners[0]), t = position(corners[1]);
    NT const at_s = rise(corners[0], s), at_t = rise(corners[1], t);
    if (nowhere_positive(sign_of(at_s), sign_of(at_t)) && !(at_s == 0 && at_t == 0)) return false;
    LineRange range{NT(0), NT(1)};
    range.clip(at_s, at_t);
    NT const u = s + *range.low * (t - s), v = s + *range.high * (t - s);
    covered.push_back({std::min(u, v), std::max(u, v)});
    return false;
  });
  return remainder({0, 1}, std::move(covered));
}

/// A corner on that side of the line in plan.
std::optional<Point3d> corner_beside(Corners corners, Point3d const& a, Point3d const& b, Sign side)
{
  auto const c = std::ranges::find_if(corners, [&](Point3d const& p) { return side_of(a, b, p) == side; });
  return c == corners.end() ? std::nullopt : std::optional(*c);
}

/// A corner of a wall that is not on a line of its upper boundary.
Point3d corner_below(Corners wall, Point3d const& a, Point3d const& b)
{
  bool const along_x = a.x != b.x;
  auto const upright = [&](Point3d const& p) { return Point2d{along_x ? p.x : p.y, p.z}; };
  return *std::ranges::find_if(
    wall, [&](Point3d const& p) { return !is_zero(orient2d<Filtered>(upright(a), upright(b), upright(p))); });
}

void append_wall(HeightField const& field, Corners wall, Corners boundary, std::vector<ExposedLine>& out)
{
  for (std::size_t i = 1; i < boundary.size(); ++i) {
    Point3d const &a = boundary[i - 1], &b = boundary[i], inside = corner_below(wall, a, b);
    Point3q const qa = exact(a), qb = exact(b);
    for (auto const& p : uncovered_parts(field, a, b, Sign::negative, {}))
      out.push_back({seam_part(qa, qb, p), inside, {{a, b}}});
    for (auto const& p : uncovered_parts(field, a, b, Sign::positive, {}))
      out.push_back({reversed(seam_part(qa, qb, p)), inside, {{b, a}}});
  }
}

/// The line of a side of a column, or of a crease, over a top that the column rises above behind it.
class TopSeams {
public:
  TopSeams(HeightField const& field, Corners top, std::vector<ExposedLine>& out)
    : field_(field), top_(top), plane_(plane_of(top)), out_(out)
  {
  }

  void append(Column const& column)
  {
    Corners const other = field_.corners(column);
    if (separates(top_, other) || separates(other, top_)) return;
    any_side(other, [&](Point3d const& p, Point3d const& q) {
      append_foot(p, q);
      return false;
    });
    if (!column.is_curtain()) append_crease(other);
  }

private:
  void append_foot(Point3d const& p, Point3d const& q)
  {
    auto const inside = corner_beside(top_, p, q, Sign::negative);
    if (!inside || has_outside(top_, p, q)) return;
    Point3q const a = exact(p), b = exact(q);
    LineRange range{NT(0), NT(1)};
    range.clip(a.z - plane_.over(horizontal(a)), b.z - plane_.over(horizontal(b)));
    range.clip(top_, horizontal(a), horizontal(b));
    append(horizontal(a), horizontal(b), range, *inside, {{p, q}});
  }

  void append_crease(Corners other)
  {
    Plane const rise = plane_of(other) - plane_;
    if (rise.is_level()) return;
    auto const [p, q] = crease_line(rise);
    auto const inside =
      std::ranges::find_if(top_, [&](Point3d const& c) { return rise.over(horizontal(exact(c))) < 0; });
    if (inside == top_.end()) return;
    LineRange range;
    range.clip(top_, p, q);
    range.clip(other, p, q);
    append(p, q, range, *inside, {});
  }

  void append(Point2q const& p, Point2q const& q, LineRange const& range, Point3d const& inside,
              std::optional<std::array<Point3d, 2>> const& gate)
  {
    if (!range.has_length()) return;
    auto const on_top = [&](NT const& t) -> Point3q {
      Point2q const x{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
      return {x.x, x.y, plane_.over(x)};
    };
    Point3q const a = on_top(*range.low), b = on_top(*range.high);
    EdgeCover<Rational, Point3q> const cover(field_, a, b, Sign::negative, {top_});
    for (auto const& i : listed(uncovered(field_, cover, reach(a, b), [] { return OpenInterval{0, 1}; })))
      out_.push_back({seam_part(a, b, i), inside, gate});
  }

  HeightField const& field_;
  Corners top_;
  Plane plane_;
  std::vector<ExposedLine>& out_;
};

}  // namespace

std::vector<ExposedLine> exposed_sides(HeightField const& field, Occludees const& occludees, std::uint32_t index)
{
  std::vector<ExposedLine> out;
  auto const& piece = occludees.pieces()[index];
  Corners const corners = occludees.corners(piece);
  if (piece.is_wall()) {
    append_wall(field, corners, occludees.upper_boundary(piece), out);
    return out;
  }
  any_side(corners, [&](Point3d const& a, Point3d const& b) {
    auto const before = uncovered_parts(field, a, b, Sign::positive, corners);
    auto const inside = corner_beside(corners, a, b, Sign::positive);
    if (before.empty() || !inside) return false;
    Point3q const qa = exact(a), qb = exact(b);
    for (auto const& p : before) out.push_back({reversed(seam_part(qa, qb, p)), *inside, {{b, a}}});
    // What is as high there, on either side, hides what is just behind it from below; from above the other end of the
    // piece is seen as well.
    auto const behind = common(uncovered_parts(field, a, b, Sign::positive, {}),
                               common(uncovered_parts(field, a, b, Sign::negative, {}), above_curtains(field, a, b)));
    for (auto const& p : behind) out.push_back({seam_part(qa, qb, p), *inside, {{a, b}}});
    return false;
  });
  return out;
}

std::vector<ExposedLine> exposed_seams(HeightField const& field, Occludees const& occludees, std::uint32_t index)
{
  std::vector<ExposedLine> out;
  auto const& piece = occludees.pieces()[index];
  if (piece.is_wall()) return out;
  Corners const corners = occludees.corners(piece);
  TopSeams seams(field, corners, out);
  Box box = occludees.bounds(index);
  box.max.z = std::numeric_limits<double>::infinity();
  field.column_hierarchy().any_item_meeting(box, [&](std::uint32_t c) {
    seams.append(field.columns()[c]);
    return false;
  });
  return out;
}

}  // namespace visibility
