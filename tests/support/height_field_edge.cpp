// Sight lines to one point of a top edge: all directions in the plan, by linear forms of the direction. Shares nothing
// with the search over all lines. Derived in proofs/height_field_oracle.md, "One point of an edge".

#include "support/height_field_rational.hpp"

#include <algorithm>

namespace visibility::oracle {
namespace {

using Q = RationalNumber;
using rational::height, rational::plan, rational::turn;

/// A direction of the plan, from the edge's point back to the eye; or a linear form of directions.
struct Vector2 {
  Q x, y;
};
Vector2 operator+(Vector2 const& a, Vector2 const& b) { return {a.x + b.x, a.y + b.y}; }
Vector2 operator-(Vector2 const& a, Vector2 const& b) { return {a.x - b.x, a.y - b.y}; }
Vector2 operator*(Q const& f, Vector2 const& a) { return {f * a.x, f * a.y}; }
Q dot(Vector2 const& a, Vector2 const& b) { return a.x * b.x + a.y * b.y; }
Q cross(Vector2 const& a, Vector2 const& b) { return a.x * b.y - a.y * b.x; }
Vector2 from_to(Point2q const& p, Point2q const& q) { return {q.x - p.x, q.y - p.y}; }
Point2q ahead(Point2q const& p, Vector2 const& d, Q const& f) { return {p.x + f * d.x, p.y + f * d.y}; }

using Ring = std::vector<Point2q>;

/// Where the ray from the point passes a polygon's interior: from distance `near` to `far`, in lengths of its
/// direction. `closeness`: the inverse of a distance, as a linear form of directions that holds as long as the sides
/// are the same.
struct Stretch {
  Q near, far;
  Vector2 near_closeness, far_closeness;  ///< the first one only if near > 0
};

std::optional<Stretch> stretch(Ring const& ring, Point2q const& point, Vector2 const& d)
{
  Stretch s{Q(0), Q(0), {Q(0), Q(0)}, {Q(0), Q(0)}};
  bool bounded = false;
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    auto const &a = ring[i], &b = ring[(i + 1) % n];
    Q const inside = turn(a, b, point), gain = cross(from_to(a, b), d);  // inside + distance * gain > 0 is the interior
    if (gain == 0 && inside <= 0) return {};
    if (gain == 0) continue;
    Q const distance = -inside / gain;
    Vector2 const closeness = inside == 0 ? Vector2{Q(0), Q(0)} : (Q(1) / inside) * Vector2{b.y - a.y, a.x - b.x};
    if (gain > 0 && distance > s.near) s.near = distance, s.near_closeness = closeness;
    if (gain < 0 && (!bounded || distance < s.far)) s.far = distance, s.far_closeness = closeness, bounded = true;
  }
  if (s.near >= s.far) return {};
  return s;
}

/// The edge's point and all that may stand before it.
struct Situation {
  std::span<Column const> columns;
  std::size_t own;
  Crossing crossing;
  Cell const& cell;
  std::vector<Ring> rings;
  Ring footprint;
  Point2q at;
  Q z;
};

/// How much a column's top rises in a direction.
Vector2 slope(Column const& c)
{
  Point2q const zero{Q(0), Q(0)}, x{Q(1), Q(0)}, y{Q(0), Q(1)};
  Q const base = height(c, zero);
  return {height(c, x) - base, height(c, y) - base};
}

/// The forms that must be positive for the eye at the given distance (zero: right above the point) to see it; none if
/// something covers it for sure. Holds for all directions between the critical ones around d.
std::optional<std::vector<Vector2>> conditions(Situation const& s, Vector2 const& d, Q const& eye,
                                               Vector2 const& eye_closeness)
{
  std::vector<Vector2> forms;
  Vector2 const rise_to_eye = (Q(s.cell.top) - s.z) * eye_closeness;
  for (std::size_t i = 0; i < s.columns.size(); ++i) {
    auto const& c = s.columns[i];
    auto const passed = stretch(s.rings[i], s.at, d);
    if (!passed) continue;
    Q const here = height(c, s.at) - s.z;  // of its plane; its top, where it covers the point
    if (passed->near == 0 && i != s.own) {
      if (here > 0 || (here == 0 && s.crossing == Crossing::entering)) return {};
      Vector2 const lead = slope(s.columns[s.own]) - slope(c);  // of the own top just before the edge
      if (here == 0 && (lead.x != 0 || lead.y != 0)) forms.push_back(lead);
    }
    if (passed->near >= eye) continue;
    auto const pass_above = [&](Vector2 const& closeness) {
      forms.push_back(rise_to_eye - (here * closeness + slope(c)));
    };
    if (passed->near > 0) pass_above(passed->near_closeness);
    pass_above(passed->far < eye ? passed->far_closeness : eye_closeness);
  }
  return forms;
}

/// A direction strictly between the two at which all forms are positive.
std::optional<Vector2> solve(std::vector<Vector2> const& forms, Vector2 const& first, Vector2 const& last)
{
  Q low(0);
  std::optional<Q> high;
  for (auto const& f : forms) {  // a + l b > 0 at first + l last
    Q const a = dot(f, first), b = dot(f, last);
    if (b == 0 && a <= 0) return {};
    if (b > 0) low = std::max<Q>(low, -a / b);
    if (b < 0) high = high ? std::min<Q>(*high, -a / b) : Q(-a / b);
  }
  if (high && low >= *high) return {};
  Q const l = high ? Q((low + *high) / 2) : Q(low + 1);
  return first + l * last;
}

/// All directions to the given side of u at which the order along the ray changes, in order from end to end.
std::vector<Vector2> critical_directions(Situation const& s, Vector2 const& u)
{
  Vector2 const start = s.crossing == Crossing::entering ? Q(-1) * u : u;  // the others lie to the left of it
  std::vector<Vector2> out{{-start.y, start.x}};
  auto const add = [&](Point2q const& p) {
    Vector2 const d = from_to(s.at, p);
    if (cross(start, d) > 0) out.push_back(d);
  };
  for (auto const& p : s.footprint) add(p);
  for (auto const& ring : s.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      add(ring[i]);
      Vector2 const side = from_to(ring[i], ring[(i + 1) % ring.size()]);
      for (std::size_t j = 0; j < s.footprint.size(); ++j) {
        auto const &a = s.footprint[j], &b = s.footprint[(j + 1) % s.footprint.size()];
        Q const at_p = turn(a, b, ring[i]), gain = cross(from_to(a, b), side);
        if (gain != 0) add(ahead(ring[i], side, -at_p / gain));  // perhaps beyond the sides: no harm
      }
    }
  std::ranges::sort(out, [](Vector2 const& a, Vector2 const& b) { return cross(a, b) > 0; });
  out.insert(out.begin(), start);
  out.push_back(Q(-1) * start);
  return out;
}

/// A sight line near the limit: in direction d, from an eye near the given distance.
std::optional<Witness> sight_line(Situation const& s, Vector2 const& d, bool far)
{
  std::vector<Column> judged(s.columns.begin(), s.columns.end());
  for (auto& c : judged) c.object = 0, c.inner.clear();
  judged[s.own].object = 1;
  auto const view = *stretch(s.footprint, s.at, d);
  Q shrink = Q(1) / 4;
  for (int tries = 0; tries < 12; ++tries, shrink = shrink * shrink) {
    Q const inwards = shrink * (view.far - view.near), eye = far ? Q(view.far - inwards) : Q(view.near + inwards);
    Point2q const from = ahead(s.at, d, eye);
    bool const wall = s.crossing == Crossing::entering;
    Point2q const to = wall ? s.at : ahead(s.at, d, shrink * eye);
    Q const z = wall ? Q(s.z - shrink) : height(s.columns[s.own], to);
    Witness w{1, {from.x, from.y, Q(s.cell.top) - shrink * (Q(s.cell.top) - Q(s.cell.bottom))}, {to.x, to.y, z}};
    if (!confirms(judged, s.cell, w)) continue;
    w.object = s.columns[s.own].object;
    return w;
  }
  throw std::logic_error("height field oracle: a visible point of an edge has no sight line");
}

}  // namespace

std::optional<Witness> sight_line_to_edge(std::span<Column const> columns, std::size_t column, std::size_t side,
                                          Crossing crossing, Q const& t, Cell const& cell)
{
  std::size_t objects = 0;
  for (auto const& c : columns) objects = std::max(objects, std::size_t(c.object) + 1);
  validate(columns, objects, cell);
  rational::require(column < columns.size() && side < columns[column].corners.size(), "no such edge");
  rational::require(t > 0 && t < 1, "a position on an edge lies between its ends");

  Situation s{columns, column, crossing, cell, {}, rational::polygon(cell.footprint), {}, {}};
  for (auto const& c : columns) s.rings.push_back(rational::polygon(c.corners));
  auto const& own = s.rings[column];
  Vector2 const u = from_to(own[side], own[(side + 1) % own.size()]);
  s.at = ahead(own[side], u, t);
  s.z = height(columns[column], s.at);

  auto const critical = critical_directions(s, u);
  for (std::size_t i = 0; i + 1 < critical.size(); ++i) {
    auto const &first = critical[i], &last = critical[i + 1];
    if (cross(first, last) == 0) continue;
    Vector2 const middle = first + last;
    auto const view = stretch(s.footprint, s.at, middle);
    if (!view) continue;
    for (bool const far : {false, true}) {
      auto const forms =
        conditions(s, middle, far ? view->far : view->near, far ? view->far_closeness : view->near_closeness);
      if (!forms) continue;
      if (auto const d = solve(*forms, first, last)) return sight_line(s, *d, far);
    }
  }
  return {};
}

Verdict sees_edge_at(std::span<Column const> columns, std::size_t column, std::size_t side, Crossing crossing,
                     Q const& t, Cell const& cell)
{
  return sight_line_to_edge(columns, column, side, crossing, t, cell) ? Verdict::visible : Verdict::hidden;
}

}  // namespace visibility::oracle
