#include "support/height_field_slice.hpp"

#include <algorithm>
#include <map>

namespace visibility::oracle::detail {
namespace {

using Q = RationalNumber;

Q rational(NT const& x) { return static_cast<Q>(x); }

Point2q crossing(Plan const& plan, Vector const& line, int segment)
{
  Vector const x = cross(line, plan.segments[std::size_t(segment)].line);
  Q const w = rational(x.z);
  return {rational(x.x) / w, rational(x.y) / w};
}

Q height(Plan const& plan, int top, Point2q const& p)
{
  auto const& t = plan.tops[std::size_t(top)];
  return (rational(t.form.x) * p.x + rational(t.form.y) * p.y + rational(t.form.z)) / rational(t.scale);
}

Point2q middle(Point2q const& p, Point2q const& q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }

/// The point at p + f (q - p).
Point2q towards(Point2q const& p, Point2q const& q, Q const& f)
{
  return {p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)};
}

/// The breaks of a slice in order: equal positions share a rank.
class Slice {
public:
  struct Span {
    int polygon, first, last;  ///< ranks
    Passage passage;
  };

  Slice(Plan const& plan, Vector const& line, Polygons alive) : plan_(plan), line_(line)
  {
    std::vector<Span> found;
    for (int i = 0; i <= plan.columns; ++i) {
      if ((alive & polygon_bit(i)) == 0) continue;
      if (auto const p = passage(plan, line, i)) {
        found.push_back({i, 0, 0, *p});
        add(p->enter);
        add(p->leave);
      }
    }
    for (int s = plan.first_ridge; s < static_cast<int>(plan.segments.size()); ++s) {
      auto const& ridge = plan.segments[std::size_t(s)];
      if ((ridge.owners & alive) != ridge.owners) continue;
      int const a = sign(dot(line, ridge.a)), b = sign(dot(line, ridge.b));
      if (a * b < 0) add({s, a < 0});
    }
    for (auto const& [position, breaks] : breaks_) {
      for (auto const& s : breaks) rank_[s.segment] = static_cast<int>(stops_.size());
      stops_.push_back(breaks[0]);
      places_.push_back(crossing(plan_, line_, breaks[0].segment));
    }
    for (auto& s : found) {
      s.first = rank_.at(s.passage.enter.segment), s.last = rank_.at(s.passage.leave.segment);
      (s.polygon == plan.cell() ? cell_ : spans_).push_back(s);
    }
  }

  std::vector<Span> const& columns() const { return spans_; }
  Span const* cell() const { return cell_.empty() ? nullptr : &cell_[0]; }
  Span const* column(int i) const
  {
    auto const s = std::ranges::find(spans_, i, &Span::polygon);
    return s == spans_.end() ? nullptr : &*s;
  }
  Stop stop(int rank) const { return stops_[std::size_t(rank)]; }
  Point2q const& place(int rank) const { return places_[std::size_t(rank)]; }
  Q height_at(int top, Point2q const& p) const { return height(plan_, top, p); }

  /// Whether no column is higher than this one between the rank and the next. Requires: the column spans them.
  bool is_top(int column, int rank) const
  {
    Point2q const m = middle(place(rank), place(rank + 1));
    Q const h = height_at(column, m);
    return std::ranges::none_of(
      spans_, [&](Span const& s) { return s.first <= rank && s.last > rank && height_at(s.polygon, m) > h; });
  }
  /// Whether the wall at the rank stands out above all columns just before it.
  bool stands_out(int column, int rank) const
  {
    Q const h = height_at(column, place(rank));
    return std::ranges::none_of(spans_, [&](Span const& s) {
      return s.first < rank && s.last >= rank && height_at(s.polygon, place(rank)) >= h;
    });
  }

private:
  void add(Stop s)
  {
    Point2q const p = crossing(plan_, line_, s.segment);
    breaks_[rational(line_.y) * p.x - rational(line_.x) * p.y].push_back(s);
  }

  Plan const& plan_;
  Vector line_;
  std::map<Q, std::vector<Stop>> breaks_;
  std::map<int, int> rank_;
  std::vector<Stop> stops_;
  std::vector<Point2q> places_;
  std::vector<Span> spans_, cell_;
};

/// What a segment from the source must pass over to reach the top of the wall at rank `end`.
std::vector<Post> occluders_of_wall(Slice const& slice, int source, int end)
{
  std::vector<Post> posts;
  for (auto const& c : slice.columns())
    if (c.last > source && c.first < end) {
      posts.push_back({slice.stop(std::max(c.first, source)), c.polygon});
      posts.push_back({slice.stop(std::min(c.last, end)), c.polygon});
    }
  return posts;
}

/// The same to reach the far end of the piece of a top that no other column covers, which begins at rank `begin`: there
/// all columns are at most as high as the target.
std::vector<Post> occluders_of_top(Slice const& slice, int source, int begin)
{
  std::vector<Post> posts;
  for (auto const& c : slice.columns())
    if (c.last > source && c.first <= begin) {
      posts.push_back({slice.stop(std::max(c.first, source)), c.polygon});
      if (c.last <= begin) posts.push_back({slice.stop(c.last), c.polygon});
    }
  return posts;
}

}  // namespace

std::optional<Passage> passage(Plan const& plan, Vector const& line, int polygon)
{
  Passage p{{-1, false}, {-1, true}};
  int const first = plan.first_side[std::size_t(polygon)];
  for (int s = first; s < first + plan.side_count(polygon); ++s) {
    auto const& side = plan.segments[std::size_t(s)];
    int const a = sign(dot(line, side.a)), b = sign(dot(line, side.b));
    if (a > 0 && b < 0) p.enter.segment = s;
    if (a < 0 && b > 0) p.leave.segment = s;
  }
  if (p.enter.segment < 0 || p.leave.segment < 0) return {};
  return p;
}

View view_along(Plan const& plan, Vector const& line, int target, Polygons alive, Q const& shrink)
{
  View view;
  Slice const slice(plan, line, alive);
  auto const *const cell = slice.cell(), *const own = slice.column(target);
  if (cell == nullptr || own == nullptr || own->last <= cell->first) return view;
  Q const top = height(plan, plan.cell(), slice.place(cell->first)), eye = top - shrink;
  bool const face = plan.segments[std::size_t(own->passage.enter.segment)].face;

  // The ends of the cell's top from which to look. Requires: what is looked at lies beyond the cell.
  std::pair<int, Stop> const sources[] = {{cell->last, cell->passage.leave}, {cell->first, cell->passage.enter}};

  // The wall by which the line enters the column.
  if (int const r = own->first; face && r > cell->first) {
    if (r > cell->last) {
      for (auto const& [from, stop] : sources)
        view.candidates.push_back(
          {{stop, plan.cell()}, {own->passage.enter, target}, true, occluders_of_wall(slice, from, r)});
    } else if (slice.stands_out(target, r)) {
      Point2q const from = towards(slice.place(r), slice.place(r - 1), shrink), to = slice.place(r);
      view.from_above = Witness{0, plan.in_scene(from, eye), plan.in_scene(to, slice.height_at(target, to) - shrink)};
    }
  }
  // Each piece of its top that no other column covers: from above, or by the far end of the piece.
  for (int r = own->first; r < own->last; ++r) {
    if (!slice.is_top(target, r)) continue;
    if (cell->first <= r && r < cell->last) {
      Point2q const m = middle(slice.place(r), slice.place(r + 1));
      view.from_above = Witness{0, plan.in_scene(m, eye), plan.in_scene(m, slice.height_at(target, m))};
    }
    bool const ends = r + 1 == own->last || !slice.is_top(target, r + 1);
    if (ends && r + 1 > cell->last)
      for (auto const& [from, stop] : sources)
        view.candidates.push_back(
          {{stop, plan.cell()}, {slice.stop(r + 1), target}, false, occluders_of_top(slice, from, r)});
  }
  return view;
}

Witness sight_line(Plan const& plan, Vector const& line, Candidate const& candidate, Q const& shrink)
{
  auto const at = [&](Stop s) { return crossing(plan, line, s.segment); };
  auto const cell = *passage(plan, line, plan.cell()), own = *passage(plan, line, candidate.target.top);
  bool const near = candidate.source.stop.segment == cell.leave.segment;
  Point2q const from = towards(at(candidate.source.stop), at(near ? cell.enter : cell.leave), shrink);
  Point2q const limit = at(candidate.target.stop);
  Point2q const to = candidate.wall ? limit : towards(limit, at(own.enter), shrink);
  Q const drop = candidate.wall ? shrink : Q(0);
  return {0, plan.in_scene(from, height(plan, plan.cell(), from) - shrink),
          plan.in_scene(to, height(plan, candidate.target.top, to) - drop)};
}

}  // namespace visibility::oracle::detail
