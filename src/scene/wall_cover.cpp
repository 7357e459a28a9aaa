#include "wall_cover.hpp"

#include "line_clip.hpp"
#include "polygon_sides.hpp"
#include "top_plane.hpp"

#include <algorithm>
#include <tuple>

namespace visibility::height_field {

namespace {

using NT = RationalNumber;

auto plan_key(Point3d const& a, Point3d const& b) { return std::tuple(a.x, a.y, b.x, b.y); }

/// A height over the line a + t (b - a).
struct Height {
  NT at_0, slope;
  NT over(NT const& t) const { return at_0 + slope * t; }
};

Height between(NT const& t, NT const& z, NT const& u, NT const& w)
{
  NT const slope = (w - z) / (u - t);
  return {z - slope * t, slope};
}

/// What fills the plane over the line for low < t < high; without a lower side all the way down.
struct Piece {
  NT low, high;
  Height upper;
  std::optional<Height> lower;
};

/// The heights between the line a -> b and the ground, and what fills them.
class Profile {
public:
  Profile(Point3d const& a, Point3d const& b, double ground)
    : a_(a), along_x_(a.x != b.x), length_(along_x_ ? NT(b.x) - NT(a.x) : NT(b.y) - NT(a.y)), p_(horizontal(exact(a))),
      q_(horizontal(exact(b))), ground_{NT(ground), 0}, top_(between(0, NT(a.z), 1, NT(b.z)))
  {
  }

  /// Requires: the corners lie on the line in plan.
  void add_wall(std::array<Point3d, 3> const& corners)
  {
    std::array<std::pair<NT, NT>, 3> c;  // parameter, height
    for (std::size_t i = 0; i < 3; ++i) c[i] = {parameter(corners[i]), NT(corners[i].z)};
    std::ranges::sort(c);
    if (c[0].first == c[2].first) return;
    Height const whole = between(c[0].first, c[0].second, c[2].first, c[2].second);
    for (auto const& [first, last] : {std::pair(0, 1), std::pair(1, 2)}) {
      auto const &p = c[static_cast<std::size_t>(first)], &q = c[static_cast<std::size_t>(last)];
      if (p.first == q.first) continue;
      Height const part = between(p.first, p.second, q.first, q.second);
      bool const above = c[1].second > whole.over(c[1].first);
      add({p.first, q.first, above ? part : whole, above ? whole : part});
    }
  }

  void add_column(Corners corners)
  {
    LineRange range{NT(0), NT(1)};
    range.clip(corners, p_, q_);
    if (!range.has_length()) return;
    Plane const top = plane_of(corners);
    add({*range.low, *range.high, between(0, top.over(p_), 1, top.over(q_)), {}});
  }

  /// Between two neighbours of `cuts` no two sides of pieces cross, so that what is filled over one t is over all.
  bool is_filled() const
  {
    auto const cuts = this->cuts();
    for (std::size_t i = 1; i < cuts.size(); ++i)
      if (!is_filled_over((cuts[i - 1] + cuts[i]) / 2)) return false;
    return true;
  }

private:
  NT parameter(Point3d const& p) const { return (along_x_ ? NT(p.x) - NT(a_.x) : NT(p.y) - NT(a_.y)) / length_; }

  void add(Piece piece)
  {
    if (piece.low < 0) piece.low = 0;
    if (piece.high > 1) piece.high = 1;
    if (piece.low < piece.high) pieces_.push_back(std::move(piece));
  }

  std::vector<NT> cuts() const
  {
    std::vector<Height> sides{ground_, top_};
    std::vector<NT> cuts{0, 1};
    for (auto const& p : pieces_) {
      sides.push_back(p.upper);
      if (p.lower) sides.push_back(*p.lower);
      cuts.insert(cuts.end(), {p.low, p.high});
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (sides[i].slope == sides[j].slope) continue;
        NT const t = (sides[j].at_0 - sides[i].at_0) / (sides[i].slope - sides[j].slope);
        if (0 < t && t < 1) cuts.push_back(t);
      }
    std::ranges::sort(cuts);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }

  bool is_filled_over(NT const& t) const
  {
    NT const ground = ground_.over(t);
    for (NT z = top_.over(t); z > ground;) {
      NT next = z;
      for (auto const& p : pieces_) {
        if (t < p.low || p.high < t || p.upper.over(t) < z) continue;
        if (!p.lower) return true;
        next = std::min(next, p.lower->over(t));
      }
      if (next == z) return false;
      z = next;
    }
    return true;
  }

  Point3d a_;
  bool along_x_;
  NT length_;
  Point2q p_, q_;
  Height ground_, top_;
  std::vector<Piece> pieces_;
};

Box bounds_in_plan(std::span<Point3d const> points)
{
  Box box;
  for (auto const& p : points) box.extend(Point3d{p.x, p.y, 0});
  return box;
}

}  // namespace

WallCover::WallCover(ObjectColumns::Result const& object, double ground) : object_(object), ground_(ground)
{
  for (auto const& w : object.walls) add_wall(w);
  for (std::size_t c = 0; c < object.columns.size(); ++c) {
    auto const& corners = object.columns[c];
    if (corners.size() == 2) continue;
    any_side(corners, [&](Point3d const& p, Point3d const& q) {
      bool const forward = less_in_plan(p, q);
      auto const beside = c < object.solids ? Beside::both : forward ? Beside::left : Beside::right;
      strips_.push_back({forward ? p : q, forward ? q : p, HeightField::bottomless, HeightField::bottomless, beside});
      return false;
    });
  }
  std::ranges::sort(strips_, {}, [](Strip const& s) { return plan_key(s.a, s.b); });
}

/// A strip if the corners lie on two vertical lines.
void WallCover::add_wall(std::array<Point3d, 3> const& corners)
{
  auto const [least, greatest] = std::ranges::minmax_element(corners, less_in_plan);
  Strip s{*least, *greatest, least->z, greatest->z, Beside::both};
  for (auto const& p : corners) {
    bool const at_a = same_in_plan(p, s.a);
    if (!at_a && !same_in_plan(p, s.b)) return;
    auto& upper = at_a ? s.a.z : s.b.z;
    auto& lower = at_a ? s.lower_a : s.lower_b;
    upper = std::max(upper, p.z);
    lower = std::min(lower, p.z);
  }
  if (!same_in_plan(s.a, s.b)) strips_.push_back(s);
}

bool WallCover::has_open_wall()
{
  return std::ranges::any_of(object_.edges, [&](ObjectColumns::Edge const& e) {
    if (e.column < object_.solids || (e.a.z <= ground_ && e.b.z <= ground_)) return false;
    return is_open(e, false) || (object_.columns[e.column].size() == 2 && is_open(e, true));
  });
}

bool WallCover::is_open(ObjectColumns::Edge const& edge, bool on_left)
{
  bool const forward = less_in_plan(edge.a, edge.b);
  bool const left = forward == on_left;
  auto const &a = forward ? edge.a : edge.b, &b = forward ? edge.b : edge.a;
  return !is_filled_by_strips(a, b, left) && !is_filled(a, b, left);
}

/// Enough, not needed: strips one below the other from the edge to the ground.
bool WallCover::is_filled_by_strips(Point3d const& a, Point3d const& b, bool on_left) const
{
  auto const strips =
    std::ranges::equal_range(strips_, plan_key(a, b), {}, [](Strip const& s) { return plan_key(s.a, s.b); });
  double at_a = a.z, at_b = b.z;
  while (at_a > ground_ || at_b > ground_) {
    auto const next = std::ranges::find_if(strips, [&](Strip const& s) {
      return (s.beside == Beside::both || (s.beside == Beside::left) == on_left) && s.a.z >= at_a && s.b.z >= at_b &&
             s.lower_a <= at_a && s.lower_b <= at_b && (s.lower_a < at_a || s.lower_b < at_b);
    });
    if (next == strips.end()) return false;
    at_a = next->lower_a;
    at_b = next->lower_b;
  }
  return true;
}

bool WallCover::is_filled(Point3d const& a, Point3d const& b, bool on_left)
{
  Profile profile(a, b, ground_);
  Sign const side = on_left ? Sign::positive : Sign::negative;
  hierarchy().any_item_meeting(bounds_in_plan(std::array{a, b}), [&](std::uint32_t i) {
    if (i < object_.columns.size()) {
      Corners const corners = object_.columns[i];
      bool const counts = i < object_.solids || has_corner_beside(corners, a, b, side);
      if (corners.size() > 2 && counts && !has_outside(corners, a, b)) profile.add_column(corners);
    } else {
      auto const& w = object_.walls[i - object_.columns.size()];
      if (std::ranges::all_of(w, [&](Point3d const& p) { return is_zero(side_of(a, b, p)); })) profile.add_wall(w);
    }
    return false;
  });
  return profile.is_filled();
}

BoundingHierarchy const& WallCover::hierarchy()
{
  if (!hierarchy_) {
    std::vector<Box> bounds;
    for (auto const& c : object_.columns) bounds.push_back(bounds_in_plan(c));
    for (auto const& w : object_.walls) bounds.push_back(bounds_in_plan(w));
    hierarchy_.emplace(bounds);
  }
  return *hierarchy_;
}

}  // namespace visibility::height_field
