// What one line shows of a polygon that occludes nothing: proofs/height_field_oracle.md, "Occludees".

#include "support/height_field_profile.hpp"

#include <algorithm>

namespace visibility::oracle::detail {
namespace {

using Q = RationalNumber;
using Kind = Candidate::Kind;

struct Source {
  int rank;
  Stop stop;
};

/// A fence is seen at its upper edge, like a wall.
void look_at_fence(Plan const& plan, Slice const& slice, std::span<Source const> sources, Q const& shrink, View& view)
{
  auto const &cell = *slice.cell(), &own = *slice.target();
  int const r = own.first;
  if (r > cell.last) {
    for (auto const& s : sources)
      view.candidates.push_back({{s.stop, plan.cell()},
                                 {own.passage.enter, plan.target()},
                                 Kind::wall,
                                 occluders_up_to(slice, s.rank, r, false)});
  } else if (r > cell.first && slice.stands_out(plan.target(), r)) {
    Point2q const from = towards(slice.place(r), slice.place(r - 1), shrink), to = slice.place(r);
    view.from_above = Witness{0, plan.in_scene(from, height(plan, plan.cell(), from) - shrink),
                              plan.in_scene(to, slice.height_at(plan.target(), to) - shrink)};
  }
}

/// Whether the polygon lies strictly above all columns right where it begins.
bool begins_free(Slice const& slice, int polygon, int rank)
{
  Q const h = slice.height_at(polygon, slice.place(rank));
  return std::ranges::none_of(slice.columns(), [&](Slice::Span const& s) {
    return s.first <= rank && s.last >= rank && slice.height_at(s.polygon, slice.place(rank)) >= h;
  });
}

/// The near end, for segments that come from below the polygon's plane: the steepest there.
void look_at_near_end(Plan const& plan, Slice const& slice, std::span<Source const> sources, Q const& shrink,
                      View& view)
{
  auto const &cell = *slice.cell(), &own = *slice.target();
  int const r = own.first;
  if (r > cell.last) {
    for (auto const& s : sources)
      view.candidates.push_back({{s.stop, plan.cell()},
                                 {own.passage.enter, plan.target()},
                                 Kind::near_end,
                                 occluders_up_to(slice, s.rank, r, true)});
  } else if (r == cell.last && begins_free(slice, plan.target(), r)) {
    // Almost upright; the target's end much closer to the common side, for the sake of high columns that begin there.
    Point2q const from = towards(slice.place(r), slice.place(r - 1), shrink);
    Point2q const to = towards(slice.place(r), slice.place(r + 1), shrink * shrink);
    view.from_above = Witness{0, plan.in_scene(from, height(plan, plan.cell(), from) - shrink),
                              plan.in_scene(to, slice.height_at(plan.target(), to))};
  }
}

/// The pieces that no column covers: from above or below in the cell's footprint, else at the far end, for segments
/// that come from above the polygon's plane.
void look_at_pieces(Plan const& plan, Slice const& slice, std::span<Source const> sources, Q const& shrink, View& view)
{
  auto const &cell = *slice.cell(), &own = *slice.target();
  for (int r = own.first; r < own.last; ++r) {
    if (!slice.is_top(plan.target(), r)) continue;
    if (cell.first <= r && r < cell.last) {
      Point2q const m = middle(slice.place(r), slice.place(r + 1));
      view.from_above = Witness{0, plan.in_scene(m, height(plan, plan.cell(), m) - shrink),
                                plan.in_scene(m, slice.height_at(plan.target(), m))};
    }
    bool const ends = r + 1 == own.last || !slice.is_top(plan.target(), r + 1);
    if (!ends || r + 1 <= cell.last) continue;
    for (auto const& s : sources)
      view.candidates.push_back({{s.stop, plan.cell()},
                                 {slice.stop(r + 1), plan.target()},
                                 Kind::far_end,
                                 occluders_of_top(slice, s.rank, r, own)});
  }
}

}  // namespace

View view_of_target(Plan const& plan, Slice const& slice, Q const& shrink)
{
  View view;
  auto const *const cell = slice.cell(), *const own = slice.target();
  if (cell == nullptr || own == nullptr || own->last <= cell->first) return view;
  Source const sources[] = {{cell->last, cell->passage.leave}, {cell->first, cell->passage.enter}};
  if (plan.is_fence(plan.target())) {
    look_at_fence(plan, slice, sources, shrink, view);
  } else {
    look_at_near_end(plan, slice, sources, shrink, view);
    look_at_pieces(plan, slice, sources, shrink, view);
  }
  return view;
}

}  // namespace visibility::oracle::detail
