#include "support/height_field_slice.hpp"

#include "support/height_field_profile.hpp"

#include <algorithm>

namespace visibility::oracle::detail {

using Q = RationalNumber;

std::vector<Post> occluders_up_to(Slice const& slice, int source, int end, bool behind)
{
  std::vector<Post> posts;
  for (auto const& c : slice.columns())
    if (c.last > source && (c.first < end || (behind && c.first == end))) {
      posts.push_back({slice.stop(std::max(c.first, source)), c.polygon});
      posts.push_back({slice.stop(std::min(c.last, end)), c.polygon});
    }
  return posts;
}

std::vector<Post> occluders_of_top(Slice const& slice, int source, int begin, Slice::Span const& own)
{
  std::vector<Post> posts{{slice.stop(std::max(own.first, source)), own.polygon}};
  for (auto const& c : slice.columns())
    if (c.polygon != own.polygon && c.last > source && c.first <= begin) {
      posts.push_back({slice.stop(std::max(c.first, source)), c.polygon});
      if (c.last <= begin) posts.push_back({slice.stop(c.last), c.polygon});
    }
  return posts;
}

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
  if (plan.is_fence(polygon)) {  // both, whichever way it is crossed
    Stop const s = p.enter.segment < 0 ? p.leave : p.enter;
    p = {s, s};
  }
  if (p.enter.segment < 0 || p.leave.segment < 0) return {};
  return p;
}

View view_along(Plan const& plan, Vector const& line, int target, Polygons alive, Q const& shrink)
{
  View view;
  Slice const slice(plan, line, alive);
  if (target == plan.target()) return view_of_target(plan, slice, shrink);
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
        view.candidates.push_back({{stop, plan.cell()},
                                   {own->passage.enter, target},
                                   Candidate::Kind::wall,
                                   occluders_up_to(slice, from, r, false)});
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
        view.candidates.push_back({{stop, plan.cell()},
                                   {slice.stop(r + 1), target},
                                   Candidate::Kind::far_end,
                                   occluders_of_top(slice, from, r, *own)});
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
  bool const wall = candidate.kind == Candidate::Kind::wall;
  Point2q const to =
    wall ? limit : towards(limit, at(candidate.kind == Candidate::Kind::far_end ? own.enter : own.leave), shrink);
  Q const drop = wall ? shrink : Q(0);
  return {0, plan.in_scene(from, height(plan, plan.cell(), from) - shrink),
          plan.in_scene(to, height(plan, candidate.target.top, to) - drop)};
}

}  // namespace visibility::oracle::detail
