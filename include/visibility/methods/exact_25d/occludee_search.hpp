#pragma once

/// How a search looks for occludees that are apart from the occluders.
#include "visibility/methods/exact_25d/pierced_piece.hpp"
#include "visibility/methods/exact_25d/search.hpp"
#include "visibility/scene/meets_cell.hpp"

namespace visibility::exact_25d {

/// First what can be seen at a glance, near to far, then what must be decided. Requires: traverse() was called.
template <Arithmetic A>
void Search<A>::look_for_occludees()
{
  auto const& occludees = *occludees_;
  for (std::uint32_t o = 0; o < is_found_.size(); ++o) is_found_[o] = meets_cell(occludees.scene(), view_, o);
  std::vector<std::uint32_t> open;
  occludees.hierarchy().front_to_back(
    view_.bounds(), [&](std::uint32_t, Box const& b) { return !is_culled(b); },
    [&](std::uint32_t piece) {
      if (is_found_[occludees.pieces()[piece].object] || is_culled(occludees.bounds(piece))) return;
      if (look_at(piece, exposed_sides(field_, occludees, piece), false)) open.push_back(piece);
    });
  if (options_.occlusion != Occlusion::exact) return;
  for (auto const piece : open)
    if (!is_found_[occludees.pieces()[piece].object]) look_at(piece, exposed_sides(field_, occludees, piece), true);
  for (auto const piece : open)
    if (!is_found_[occludees.pieces()[piece].object]) look_at(piece, exposed_seams(field_, occludees, piece), true);
}

/// Whether the tree hides what is in the box; not asked where that is over or under the cell.
template <Arithmetic A>
bool Search<A>::is_culled(Box const& box)
{
  if (!options_.hierarchical_culling || is_over_cell(box)) return false;
  ++counts_.nodes_tested;
  Index open = Tree::none;
  bool const hidden = is_hidden(box, open);
  counts_.nodes_hidden += hidden;
  return hidden;
}

template <Arithmetic A>
bool Search<A>::is_over_cell(Box const& box) const
{
  Box column = view_.bounds();
  column.min.z = -HUGE_VAL;
  column.max.z = HUGE_VAL;
  return meet(box, column);
}

/// Whether the part lies on a side of the cell as sight lines cross it that leave by this side: then sight lines run
/// steeply to the piece beside it, and nothing is in between.
template <Arithmetic A>
bool Search<A>::is_flush(SeamPart const& part) const
{
  for (std::size_t i = 0; i < cell_.size(); ++i)
    if (along_side({horizontal(part.left), horizontal(part.right)}, cell_, i)) return true;
  return false;
}

/// Looks along the lines for the piece. Returns whether it is open if the piece is visible.
template <Arithmetic A>
bool Search<A>::look_at(std::uint32_t piece, std::vector<ExposedLine> const& lines, bool decided)
{
  auto const& occludees = *occludees_;
  auto const object = occludees.pieces()[piece].object;
  Box const& box = occludees.bounds(piece);
  if (!decided && is_over_cell(box) &&
      (is_exposed_inside(field_, occludees, piece, lines, cell_.corners) ||
       std::ranges::any_of(lines, [&](ExposedLine const& l) { return is_flush(l.part); }))) {
    is_found_[object] = true;
    return false;
  }
  // Seams are looked at when sides are decided.
  bool is_open = !occludees.pieces()[piece].is_wall();
  for (auto const& line : lines) {
    SeamWedge const wedge(line.part);
    boost::container::small_vector<Edge, 4> gates;
    if (line.gate)
      gates.push_back({(*line.gate)[0], (*line.gate)[1]});
    else {
      auto const corners = occludees.corners(occludees.pieces()[piece]);
      for (std::size_t i = corners.size() - 1, j = 0; j < corners.size(); i = j++)
        gates.push_back({corners[j], corners[i]});
    }
    int retries = 0;
    for (auto const& edge : gates)
      tree_.visit_leaves(gate(edge), box, [&](Index leaf, Funnel const& funnel) {
        if (is_found_[object] || !is_ahead(leaf, edge)) return false;
        ++counts_.portal_tests;
        if (is_hidden(leaf, funnel, wedge)) {
          ++counts_.wedge_hidden;
          return false;
        }
        Find find = Find::visible;
        if (options_.occlusion == Occlusion::single_wedges) {
          is_found_[object] = true;
        } else {
          find = options_.sampled_lines ? sample(leaf, funnel, piece, line, wedge, edge) : Find::nothing;
          if (find == Find::visible) ++counts_.sampled_visible;
          if (find == Find::nothing && decided) {
            ++counts_.decisions;
            find = decide(leaf, funnel, piece, line, wedge, edge);
            if (find == Find::visible) ++counts_.decided_visible;
          }
        }
        is_open |= find == Find::nothing;
        return find == Find::blocked && (A::is_exact || ++retries < most_retries);
      });
    if (is_found_[object]) return false;
  }
  return is_open;
}

/// Tries sight lines in floating point that pass close to the line and pierce the piece beside it.
template <Arithmetic A>
auto Search<A>::sample(Index leaf, Funnel const& funnel, std::uint32_t piece, ExposedLine const& line,
                       SeamWedge const& wedge, Edge const& gate) -> Find
{
  auto const corners = occludees_->corners(occludees_->pieces()[piece]);
  bool const is_wall = occludees_->pieces()[piece].is_wall();
  Edge const target{visibility::detail::rounded(line.part.left), visibility::detail::rounded(line.part.right)};
  auto const from = sources(leaf, wedge.least_height(), wedge.greatest_height());
  for (std::size_t k = 0; k < from.size() - 2 * cell_.inner.size(); ++k) {
    Edge const& source = from[k];
    boost::container::small_vector<WedgeVolumes, 4> wedges;
    for (auto const& f : tree_.leaf(leaf).blockers)
      if (wedge.is_ahead_of(f.edge)) wedges.push_back(wedge.wedge(source, f.edge));
    for (auto const& [s, t] : sampled_positions(funnel, source, target)) {
      if (!(t > 0 && t < 1)) continue;
      if (std::ranges::any_of(wedges, [s = s, t = t](auto const& w) { return !(w.at(s, t) > 0); })) continue;
      for (double const step : {0x1p-14, 0x1p-24}) {
        Point3d const p = between(between(source.left, source.right, s), near_middle_, step);
        Point3d const q = between(p, between(between(target.left, target.right, t), line.inside, step), 1 + step / 16);
        if (!in_interior(view_, p) || !pierces<A>(p, q, corners)) continue;
        bool const is_held_against_scene = !(options_.occluder_shrink > 0);
        counts_.shots += is_held_against_scene;
        // An edge in the plane of a wall is not before it, but before q.
        auto const blocker = !is_held_against_scene ? std::nullopt
                             : is_wall              ? shot_.first_blocker(p, q, gate)
                                                    : shot_.first_blocker(p, q);
        if (!blocker) {
          if (found_occludee(piece, exact(p), piercing_point(p, q, corners))) return Find::visible;
        } else if (brings_in(leaf, *blocker)) {
          return Find::blocked;
        }
      }
    }
  }
  return Find::nothing;
}

/// The questions that a line puts in a leaf (`gate` holds it, or is crossed beyond), one for each source. An answer
/// runs to the line; moved a little towards the inside of the cell and of the piece it must still be free.
template <Arithmetic A>
auto Search<A>::decide(Index leaf, Funnel const& funnel, std::uint32_t piece, ExposedLine const& line,
                       SeamWedge const& wedge, Edge const& gate) -> Find
{
  PortalSequence::ConstructedEdge const target{line.part.left, line.part.right};
  for (auto const& source : sources(leaf, wedge.least_height(), wedge.greatest_height())) {
    auto const question =
      PortalQuestion<A>(funnel, source, target).within(horizontal(line.part.left), horizontal(line.part.right));
    auto const find = ask(question, leaf, gate, [&](Point3q const& start, Point3q const& end) {
      return confirm(
        leaf,
        [&](RationalNumber const& step) {
          return std::pair(between(start, middle_, step), between(end, exact(line.inside), step));
        },
        [&](auto const& p, auto const& q) { return shot_.first_blocker(p, q); },
        [&](Point3q const& p, Point3q const& q) { return found_occludee(piece, p, q); });
    });
    if (find != Find::nothing) return find;
  }
  return Find::nothing;
}

/// Accepts a sight line that stays above the edges that it crosses before its end, unless it ends below a column.
template <Arithmetic A>
bool Search<A>::found_occludee(std::uint32_t piece, Point3q const& from, Point3q const& to)
{
  bool const is_faithful = A::is_exact && options_.occluder_shrink == 0 && contacts_.all_occlude;
  if (is_faithful && !is_free(field_, from, to)) return false;
  auto const object = occludees_->pieces()[piece].object;
  is_found_[object] = true;
  if (options_.witnesses && is_faithful) occludee_witnesses_.push_back({object, from, to});
  return true;
}

}  // namespace visibility::exact_25d
