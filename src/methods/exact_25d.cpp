#include "visibility/methods/exact_25d/method.hpp"

#include "visibility/methods/exact_25d/search.hpp"
#include "visibility/methods/exact_25d/sight_line.hpp"

#include <algorithm>

namespace visibility {

template <Arithmetic A>
PotentiallyVisibleSet Exact25d<A>::operator()(HeightField const& field, ViewCell const& cell) const
{
  exact_25d::Search<A> search(field, cell, options_);
  search.run();
  PotentiallyVisibleSet set;
  bool const is_exact = search.contacts().exact && options_.occlusion == exact_25d::Occlusion::exact;
  set.guarantee = !A::is_exact || options_.occluder_shrink > 0 ? Guarantee::none
                  : is_exact                                   ? Guarantee::exact
                                                               : Guarantee::conservative;
  for (std::uint32_t o = 0; o < search.is_visible().size(); ++o)
    if (search.is_visible()[o]) set.visible.push_back(o);
  if (set.guarantee != Guarantee::none && options_.occlusion == exact_25d::Occlusion::exact)
    for (auto const& line : search.lines())
      if (auto w = exact_25d::witness(field, line)) set.witnesses.push_back(std::move(*w));
  std::ranges::sort(set.witnesses, {}, &Witness::object);
  auto const& c = search.counts();
  std::size_t blockers = 0;
  for (auto const& leaf : search.tree().leaves()) blockers += leaf.blockers.size();
  set.statistics = {{"nodes_tested", double(c.nodes_tested)},
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
  return set;
}

template class Exact25d<Filtered>;
template class Exact25d<Rational>;
template class Exact25d<Double>;

}  // namespace visibility
