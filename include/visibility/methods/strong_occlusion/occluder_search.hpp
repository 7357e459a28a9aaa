#pragma once

#include "visibility/methods/strong_occlusion/verdict.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace visibility::strong_occlusion {

struct SearchCounts {
  std::uint64_t targets = 0;     ///< boxes, parts and faces for which an occluder was sought
  std::uint64_t candidates = 0;  ///< occluders tried
  std::uint64_t rays = 0;        ///< segments tested against a candidate
};

/// Looks for a strong occluder of convex targets as seen from one cell.
///
/// Every strong occluder meets the leading ray, so the candidates are the bodies along it, nearest first
/// [Cohen-Or98, 5, optimization 1]. The ray from the highest vertex of the cell to the highest of the target is taken:
/// where heights are bounded it is the hardest to block, and meets the fewest candidates. Any choice gives the same
/// answer: "some body blocks all".
template <Arithmetic A>
class OccluderSearch {
public:
  OccluderSearch(PreparedScene const& scene, ViewCell const& cell)
    : scene_(scene), cell_(cell.vertices().begin(), cell.vertices().end())
  {
    highest_first(cell_);
  }

  /// A body that blocks every sight line from the cell to the convex hull of `target`, if there is one.
  /// Requires: the target shares no vertex with the cell. May reorder `target`.
  std::optional<std::uint32_t> find(std::vector<Point3d>& target)
  {
    ++counts_.targets;
    highest_first(target);
    collect_candidates(cell_.front(), target.front());
    for (auto const& [distance, body] : candidates_) {
      ++counts_.candidates;
      if (blocks_all<A>(scene_.bodies(), scene_.bodies().bodies()[body], cell_, target, counts_.rays)) return body;
    }
    return {};
  }

  SearchCounts const& counts() const { return counts_; }

private:
  static void highest_first(std::vector<Point3d>& points)
  {
    std::ranges::sort(points, [](Point3d const& a, Point3d const& b) { return a.z > b.z; });
  }

  void collect_candidates(Point3d const& from, Point3d const& to)
  {
    candidates_.clear();
    SegmentProbe const probe(from, to);
    auto const bounds = scene_.bodies().bounds();
    scene_.body_hierarchy().any_along(probe, [&](std::uint32_t i) {
      if (!scene_.bodies().bodies()[i].occludes || probe.certainly_misses(bounds[i])) return false;
      Box start;
      start.extend(from);
      candidates_.emplace_back(approximate_squared_distance(start, bounds[i]), i);
      return false;
    });
    std::ranges::sort(candidates_);
  }

  PreparedScene const& scene_;
  std::vector<Point3d> cell_;
  std::vector<std::pair<double, std::uint32_t>> candidates_;
  SearchCounts counts_;
};

}  // namespace visibility::strong_occlusion
