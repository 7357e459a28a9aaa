#include "visibility/methods/sampling/method.hpp"

#include "hunt.hpp"

namespace visibility {

PotentiallyVisibleSet Sampling::operator()(PreparedScene const& scene, ViewCell const& cell) const
{
  return (*this)(RayScene(scene), cell);
}

PotentiallyVisibleSet Sampling::operator()(RayScene const& rays, ViewCell const& cell) const
{
  auto report =
    detail::hunt(rays, cell, {}, {options_.rays, options_.seconds, options_.seed, options_.threads, options_.progress});
  PotentiallyVisibleSet result;
  result.guarantee = Guarantee::aggressive;
  result.visible = std::move(report.found);
  result.witnesses = std::move(report.witnesses);
  result.statistics = {{"rays", double(report.rays)},
                       {"hits", double(report.hits)},
                       {"seen", double(report.seen.size())},
                       {"touching", double(result.visible.size() - result.witnesses.size())},
                       {"rejected", double(report.rejected)}};
  for (std::size_t i = 0; i < detail::strategies; ++i) {
    std::string const name(detail::strategy_names[i]);
    result.statistics["rays_" + name] = double(report.cast[i]);
    result.statistics["finds_" + name] = double(report.finds[i]);
  }
  return result;
}

}  // namespace visibility
