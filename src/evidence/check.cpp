#include "visibility/evidence/check.hpp"

#include "hunt.hpp"

#include <algorithm>
#include <stdexcept>

namespace visibility {

CheckReport check(PreparedScene const& scene, ViewCell const& cell, std::span<std::uint32_t const> visible,
                  Guarantee claimed, CheckOptions const& options)
{
  return check(RayScene(scene), cell, visible, claimed, options);
}

CheckReport check(RayScene const& rays, ViewCell const& cell, std::span<std::uint32_t const> visible, Guarantee claimed,
                  CheckOptions const& options)
{
  std::size_t const objects = rays.scene().scene().objects.size();
  std::vector<std::uint32_t> members(visible.begin(), visible.end());
  std::ranges::sort(members);
  members.erase(std::unique(members.begin(), members.end()), members.end());
  if (!members.empty() && members.back() >= objects)
    throw std::invalid_argument("the set names object " + std::to_string(members.back()) + ", but the scene has " +
                                std::to_string(objects));

  auto found =
    detail::hunt(rays, cell, members, {options.rays, options.seconds, options.seed, options.threads, options.progress});
  CheckReport report;
  report.missing = std::move(found.found);
  report.witnesses = std::move(found.witnesses);
  report.rays = found.rays;
  report.objects_seen = found.seen.size();
  report.rejected = found.rejected;
  report.seconds = found.seconds;
  report.fault = !report.missing.empty() && (claimed == Guarantee::exact || claimed == Guarantee::conservative);
  if (claimed == Guarantee::exact) std::ranges::set_difference(members, found.seen, std::back_inserter(report.unseen));
  return report;
}

}  // namespace visibility
