#pragma once

#include "visibility/methods/strong_occlusion/object_walk.hpp"
#include "visibility/scene/potentially_visible_set.hpp"

#include <utility>

namespace visibility {

/// Strong occlusion: an object is hidden if one convex body blocks every sight line to it, or to each of its parts,
/// faces or triangles. Conservative: what is hidden by several bodies together is kept.
/// Takes any scene: boxes, prisms, polyhedra, balls and triangles are occluders, each on its own.
/// Source: [CohenOr98]; method and departures: docs/strong-occlusion.md.
template <Arithmetic A = Filtered>
class StrongOcclusion {
public:
  using Options = strong_occlusion::Options;
  using Remainder = strong_occlusion::Remainder;

  StrongOcclusion() = default;
  explicit StrongOcclusion(Options options) : options_(options) {}

  /// The potentially visible set: `conservative` (`none` with `Double`). Statistics: see strong_occlusion::Counts.
  PotentiallyVisibleSet operator()(PreparedScene const& scene, ViewCell const& cell) const
  {
    return operator()(Remainder(scene), cell);
  }
  /// The same set, for a cell inside one that has left this remainder. Requires: no finer granularity than now was
  /// used for that cell.
  PotentiallyVisibleSet operator()(Remainder const& remainder, ViewCell const& cell) const;
  /// The set, and what is left for cells inside this one.
  std::pair<PotentiallyVisibleSet, Remainder> refine(Remainder const& remainder, ViewCell const& cell) const;

private:
  Options options_;
};

namespace strong_occlusion {

/// What is left for cells inside this one, after an ObjectWalk.
template <Arithmetic A>
Remainder left_over(OccluderSearch<A> const& search, Remainder const& remainder,
                    std::vector<Remainder::Item> const& visible, ViewCell const& cell)
{
  std::vector<bool> is_visible(remainder.objects().items().size());
  for (auto const o : visible) is_visible[o] = true;
  std::vector<Remainder::Kept> kept;
  remainder.objects().front_to_back(
    cell.bounds(), [&](std::uint32_t node, Box const&) { return !search.is_hidden_node(node); },
    [&](Remainder::Item o) {
      kept.push_back({o, !is_visible[o]});
    });
  return remainder.keep(kept, [&](Remainder::Item occluder) { return search.is_hidden(occluder); });
}

template <Arithmetic A>
PotentiallyVisibleSet make_set(OccluderSearch<A> const& search, Remainder const& remainder,
                               std::vector<Remainder::Item> const& visible, std::uint64_t groups_hidden)
{
  PotentiallyVisibleSet set;
  set.guarantee = A::is_exact ? Guarantee::conservative : Guarantee::none;
  for (auto const o : visible) set.visible.push_back(remainder.object(o));
  std::ranges::sort(set.visible);
  auto const& c = search.counts();
  set.statistics = {{"targets", double(c.targets)}, {"candidates", double(c.candidates)},
                    {"rays", double(c.rays)},       {"face_rays", double(c.face_rays)},
                    {"probes", double(c.probes)},   {"groups_hidden", double(groups_hidden)}};
  return set;
}

}  // namespace strong_occlusion

template <Arithmetic A>
PotentiallyVisibleSet StrongOcclusion<A>::operator()(Remainder const& remainder, ViewCell const& cell) const
{
  strong_occlusion::OccluderSearch<A> search(remainder, cell, options_);
  strong_occlusion::ObjectWalk<A> walk(search, remainder, cell, options_);
  auto const visible = walk.run();
  return make_set(search, remainder, visible, walk.groups_hidden());
}

template <Arithmetic A>
auto StrongOcclusion<A>::refine(Remainder const& remainder, ViewCell const& cell) const
  -> std::pair<PotentiallyVisibleSet, Remainder>
{
  strong_occlusion::OccluderSearch<A> search(remainder, cell, options_);
  strong_occlusion::ObjectWalk<A> walk(search, remainder, cell, options_);
  auto const visible = walk.run();
  return {make_set(search, remainder, visible, walk.groups_hidden()), left_over(search, remainder, visible, cell)};
}

extern template class StrongOcclusion<Filtered>;
extern template class StrongOcclusion<TalliedFiltered>;
extern template class StrongOcclusion<Rational>;
extern template class StrongOcclusion<Double>;

}  // namespace visibility
