#include "sight_line_search.hpp"

#include "progress.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/evidence/check_occludees.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace visibility::commands {

namespace {

constexpr std::uint64_t rays_cast = 500'000;

Point2d rounded(Point3q const& p) { return {CGAL::to_double(p.x), CGAL::to_double(p.y)}; }

/// Up to `most` of the segments, evenly spaced in the order of their angles.
std::vector<PlanPicture::Segment> spread(std::vector<PlanPicture::Segment> all, std::size_t most)
{
  if (all.size() <= most) return all;
  std::ranges::stable_sort(
    all, {}, [](PlanPicture::Segment const& s) { return std::atan2(s.to.y - s.from.y, s.to.x - s.from.x); });
  std::vector<PlanPicture::Segment> out;
  for (std::size_t i = 0; i < most; ++i) out.push_back(all[i * all.size() / most]);
  return out;
}

}  // namespace

std::vector<PlanPicture::Segment> sight_lines_of(Result const& result, std::size_t most)
{
  std::vector<PlanPicture::Segment> out;
  for (auto const& w : result.witnesses) out.push_back({rounded(w.from), rounded(w.to)});
  return spread(std::move(out), most);
}

std::vector<PlanPicture::Segment> find_sight_lines(Scene const& scene, PreparedScene const* occludees,
                                                   ViewCell const& cell, std::span<std::uint32_t const> visible,
                                                   std::size_t most)
{
  std::optional<PreparedScene> own;
  PreparedScene const& occluders = own.emplace(scene);
  PreparedScene const& looked_for = occludees != nullptr ? *occludees : occluders;
  // `check` hunts for whatever a set lacks: here, for all that is said to be visible.
  std::vector<std::uint32_t> hidden;
  for (std::uint32_t i = 0; i < looked_for.scene().objects.size(); ++i)
    if (!std::ranges::binary_search(visible, i)) hidden.push_back(i);
  CheckOptions options;
  options.rays = rays_cast;
  Progress progress("rays", options.rays);
  options.progress = [&](std::uint64_t n) { progress.advance(n); };
  RayScene const rays(occluders);
  auto const report = occludees != nullptr ? check(rays, Occludees(*occludees), cell, hidden, Guarantee::none, options)
                                           : check(rays, cell, hidden, Guarantee::none, options);
  std::vector<PlanPicture::Segment> out;
  for (auto const& w : report.witnesses) out.push_back({rounded(w.from), rounded(w.to)});
  return spread(std::move(out), most);
}

}  // namespace visibility::commands
