#include "visibility/methods/exact_25d/method.hpp"

#include "visibility/methods/exact_25d/search.hpp"
#include "visibility/methods/exact_25d/sight_line.hpp"

#include <algorithm>
#include <tuple>

namespace visibility {

namespace {

using namespace exact_25d;

template <Arithmetic A>
Guarantee guarantee(Search<A> const& search, Options const& options, bool apart)
{
  if (!A::is_exact || options.occluder_shrink > 0) return Guarantee::none;
  auto const& contacts = search.contacts();
  bool const is_exact = (apart ? contacts.all_occlude : contacts.exact) && options.occlusion == Occlusion::exact;
  return is_exact ? Guarantee::exact : Guarantee::conservative;
}

template <Arithmetic A>
std::map<std::string, double> statistics(Search<A> const& search)
{
  auto const& c = search.counts();
  std::size_t blockers = 0;
  for (auto const& leaf : search.tree().leaves()) blockers += leaf.blockers.size();
  return {{"nodes_tested", double(c.nodes_tested)},
          {"nodes_hidden", double(c.nodes_hidden)},
          {"portal_tests", double(c.portal_tests)},
          {"wedge_hidden", double(c.wedge_hidden)},
          {"sampled_visible", double(c.sampled_visible)},
          {"decisions", double(c.decisions)},
          {"decided_visible", double(c.decided_visible)},
          {"shots", double(c.shots)},
          {"shots_blocked", double(c.shots_blocked)},
          {"occluders_inserted", double(c.occluders_inserted)},
          {"line_space_cells", double(search.tree().leaves().size())},
          {"occluders_per_cell", double(blockers) / double(search.tree().leaves().size())}};
}

/// What a search found. Requires: it was run.
template <Arithmetic A>
PotentiallyVisibleSet answer(Search<A> const& search, HeightField const& field, Options const& options, bool apart)
{
  PotentiallyVisibleSet set;
  set.guarantee = guarantee(search, options, apart);
  for (std::uint32_t o = 0; o < search.is_visible().size(); ++o)
    if (search.is_visible()[o]) set.visible.push_back(o);
  if (set.guarantee != Guarantee::none && options.occlusion == Occlusion::exact) {
    for (auto const& line : search.lines())
      if (auto w = witness(field, line)) set.witnesses.push_back(std::move(*w));
    set.witnesses.insert(set.witnesses.end(), search.occludee_witnesses().begin(), search.occludee_witnesses().end());
  }
  std::ranges::sort(set.witnesses, {}, &Witness::object);
  set.statistics = statistics(search);
  return set;
}

template <Arithmetic A>
std::vector<LineSpaceCell> line_space_cells(Search<A> const& search)
{
  std::vector<LineSpaceCell> out;
  for (auto const& leaf : search.tree().leaves()) {
    auto& cell = out.emplace_back();
    cell.entry = search.cell().entry(leaf.entry);
    cell.exit = search.cell().exit(leaf.exit);
    for (auto const& v : leaf.lines.vertices()) cell.bounds.push_back({v.p, v.q});
    for (auto const& b : leaf.blockers) cell.occluders.push_back(b.edge);
  }
  return out;
}

/// Lines that fall over an occluder start at the near side of a flat cell, lines that rise at the far one.
std::vector<Shadow> shadows(CellOutline const& outline, std::vector<LineSpaceCell> const& cells)
{
  std::vector<Shadow> out;
  for (auto const& c : cells)
    for (auto const& o : c.occluders) {
      if (!outline.flat || std::min(o.left.z, o.right.z) < outline.top) out.push_back({c.exit, o});
      if (!outline.flat || std::max(o.left.z, o.right.z) >= outline.top) out.push_back({c.entry, o});
    }
  auto const key = [](Shadow const& s) {
    auto const point = [](Point3d const& p) { return std::tie(p.x, p.y, p.z); };
    return std::tuple(point(s.source.left), point(s.source.right), point(s.occluder.left), point(s.occluder.right));
  };
  std::ranges::sort(out, [&](auto const& a, auto const& b) { return key(a) < key(b); });
  auto const twice = std::ranges::unique(out, [&](auto const& a, auto const& b) { return key(a) == key(b); });
  out.erase(twice.begin(), twice.end());
  return out;
}

}  // namespace

template <Arithmetic A>
PotentiallyVisibleSet Exact25d<A>::operator()(HeightField const& field, ViewCell const& cell) const
{
  Search<A> search(field, cell, options_);
  search.run();
  return answer(search, field, options_, false);
}

template <Arithmetic A>
PotentiallyVisibleSet Exact25d<A>::operator()(HeightField const& occluders, Occludees const& occludees,
                                              ViewCell const& cell) const
{
  Search<A> search(occluders, cell, options_, &occludees);
  search.run();
  return answer(search, occluders, options_, true);
}

template <Arithmetic A>
std::pair<PotentiallyVisibleSet, Explanation> Exact25d<A>::explain(HeightField const& field, ViewCell const& cell) const
{
  Search<A> search(field, cell, options_);
  search.keep_all();
  search.run();
  Explanation explanation{search.visible_edges(), line_space_cells(search), {}};
  explanation.shadows = shadows(search.cell(), explanation.cells);
  return {answer(search, field, options_, false), std::move(explanation)};
}

template class Exact25d<Filtered>;
template class Exact25d<TalliedFiltered>;
template class Exact25d<Rational>;
template class Exact25d<Double>;

}  // namespace visibility
