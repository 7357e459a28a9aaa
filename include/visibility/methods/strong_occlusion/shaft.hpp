#pragma once

#include "visibility/methods/strong_occlusion/hull_rays.hpp"
#include "visibility/methods/strong_occlusion/silhouette.hpp"
#include "visibility/scene/segment_probe.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace visibility::strong_occlusion {

/// All sight lines from a cell to one target at a time, and what tells quickly that a body, or any body in a box,
/// cannot block them all. What `may_block_all` refuses certainly does not: culling only.
class Shaft {
public:
  /// Which sight lines stand for all of them.
  enum class Rays { all, hull_edges };

  /// What bounding boxes are tested against.
  enum class Culling { leading_ray, all_rays };

  /// Keeps a reference to the cell.
  Shaft(ViewCell const& cell, Rays kind, Culling culling) : cell_(&cell), kind_(kind), culling_(culling) {}

  /// Aims at a target. Requires: it shares no point with the cell; its vertices stay where they are.
  void aim(Target const& target)
  {
    target_ = target;
    rays_.clear();
    if (kind_ == Rays::hull_edges) {
      append_hull_rays(*cell_, target, rays_);
    } else {
      for (auto const& s : target.vertices)
        for (auto const& p : cell_->vertices()) rays_.push_back({p, s});
    }
    failed_ = 0;
  }

  /// Prepares `may_block_all` for the target aimed at; the verdict on a single body needs no culling.
  void prepare_culling()
  {
    probes_.clear();
    silhouette_.clear();
    if (culling_ == Culling::leading_ray) {
      auto const height = [](Ray const& r) { return std::pair(r.from.z, r.to.z); };
      Ray const& leading = *std::ranges::max_element(rays_, {}, height);
      probes_.emplace_back(leading.from, leading.to);
    } else if (cell_->is_box()) {
      add_supporting_lines(&Point3d::x, &Point3d::y, 1, 2);
      add_supporting_lines(&Point3d::x, &Point3d::z, 1, 4);
      add_supporting_lines(&Point3d::y, &Point3d::z, 2, 4);
    } else {
      for (auto const& r : rays_) probes_.emplace_back(r.from, r.to);
    }
  }

  ViewCell const& cell() const { return *cell_; }
  Target const& target() const { return target_; }
  /// Never empty. If a convex body meets them all, and `decides(its bounds)`, it meets every sight line.
  std::span<Ray const> rays() const { return rays_; }
  bool decides(Box const& body) const
  {
    return kind_ == Rays::all || !(meet(body, cell_->bounds()) || meet(body, target_.bounds));
  }

  /// Whether no sight line passes beside the box in one coordinate: exact, and for an axis-aligned box the first half
  /// of segment_meets<End::excluded> for all sight lines at once. [p, s) passes on the low side iff p < min and s <=
  /// min.
  bool within_slabs(Box const& b) const
  {
    Box const &c = cell_->bounds(), &t = target_.bounds;
    auto const low = [&](double Point3d::*k) { return b.min.*k <= c.min.*k || b.min.*k < t.min.*k; };
    auto const high = [&](double Point3d::*k) { return b.max.*k >= c.max.*k || b.max.*k > t.max.*k; };
    return low(&Point3d::x) && high(&Point3d::x) && low(&Point3d::y) && high(&Point3d::y) && low(&Point3d::z) &&
           high(&Point3d::z);
  }

  /// Whether the box may be met by every sight line, or by the leading ray: that from the highest point of the cell to
  /// the highest of the target. Where heights are bounded it is the hardest to block, and meets the fewest candidates.
  /// Requires: prepare_culling().
  bool may_block_all(Box const& b)
  {
    if (culling_ == Culling::leading_ray) return !probes_.front().certainly_misses(b);
    if (!within_slabs(b)) return false;
    if (cell_->is_box()) return !silhouette_.certainly_inside_one(b);
    std::uint64_t tests = 0;
    return all_of(tests, [&](std::size_t i) { return !probes_[i].certainly_misses(b); });
  }

  /// Whether `meets(ray)` holds for all of rays(). `tests` counts the calls.
  template <class Meets>
  bool all_rays(std::uint64_t& tests, Meets&& meets)
  {
    return all_of(tests, [&](std::size_t i) { return meets(rays_[i]); });
  }

private:
  /// The ray that failed last comes first: it is likely to fail again.
  template <class Meets>
  bool all_of(std::uint64_t& tests, Meets&& meets)
  {
    ++tests;
    if (!meets(failed_)) return false;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      if (i == failed_) continue;
      ++tests;
      if (meets(i)) continue;
      failed_ = i;
      return false;
    }
    return true;
  }

  /// The supporting lines of cell and target as seen along the axis that is neither u nor v; bits as in Box::corner.
  void add_supporting_lines(double Point3d::*u, double Point3d::*v, int bit_u, int bit_v)
  {
    for (int const quadrant : {0, bit_u, bit_v, bit_u | bit_v}) {
      Point3d const c = cell_->bounds().corner(quadrant);
      bool const up_u = (quadrant & bit_u) != 0, up_v = (quadrant & bit_v) != 0;
      if (target_.is_box) {
        silhouette_.add(u, v, up_u, up_v, c, target_.bounds.corner(quadrant));
      } else if (auto const* const s = outermost(u, v, up_u, up_v, c)) {
        silhouette_.add(u, v, up_u, up_v, c, *s);
      }
    }
  }

  /// The vertex s for which the rest of the target lies, to within rounding, inside the line from c to s.
  Point3d const* outermost(double Point3d::*u, double Point3d::*v, bool up_u, bool up_v, Point3d const& c) const
  {
    Point3d const* best = nullptr;
    double best_u = 0, best_v = 0;
    for (auto const& s : target_.vertices) {
      // In coordinates that grow outward, the line rises on one side of c and falls on the other.
      double const du = up_u ? s.*u - c.*u : c.*u - s.*u, dv = up_v ? s.*v - c.*v : c.*v - s.*v;
      if (!(du * dv < 0)) continue;
      // The outward normal of (best_u, best_v) is (|best_v|, |best_u|).
      if (best == nullptr || std::fabs(best_v) * du + std::fabs(best_u) * dv > 0) best = &s, best_u = du, best_v = dv;
    }
    return best;
  }

  ViewCell const* cell_;
  Rays kind_;
  Culling culling_;
  Target target_;
  std::vector<Ray> rays_;
  Silhouette silhouette_;             // where the cell is a box
  std::vector<SegmentProbe> probes_;  // otherwise; or of the leading ray alone
  std::size_t failed_ = 0;
};

}  // namespace visibility::strong_occlusion
