#pragma once

#include "visibility/kernel/number_types.hpp"
#include "visibility/line_space/penumbra_wedge.hpp"
#include "visibility/scene/seams.hpp"

#include <array>

namespace visibility::exact_25d {

/// The part of a seam with its ends enclosed by doubles: penumbra wedges that hide it, decided by intervals. Says yes
/// only if it is certain.
class SeamWedge {
public:
  explicit SeamWedge(SeamPart const& part) : ends_{enclose(part.left), enclose(part.right)} {}

  /// Whether the part lies ahead of the line of an edge as sight lines cross it, so that the edge comes before it.
  bool is_ahead_of(PortalSequence::Edge const& f) const
  {
    CGAL::Protect_FPU_rounding<true> const upward;
    for (auto const& e : ends_) {
      Interval const side = visibility::detail::Orient2dFormula{}(Interval(f.left.x), Interval(f.left.y),
                                                                  Interval(f.right.x), Interval(f.right.y), e[0], e[1]);
      if (!(side.inf() > 0)) return false;
    }
    return true;
  }

  /// The penumbra wedge of an edge under a source, as seen along the part.
  WedgeVolumes wedge(PortalSequence::Edge const& source, PortalSequence::Edge const& f) const
  {
    WedgeVolumes out;
    {
      CGAL::Protect_FPU_rounding<true> const upward;
      for (std::size_t i = 0; i < 4; ++i) {
        Interval const v = above((i & 1) == 0 ? source.left : source.right, ends_[i / 2], f);
        out.volume[i] = v.inf() / 2 + v.sup() / 2;
        out.error = std::max(out.error, v.sup() - v.inf());
      }
    }
    out.widen();
    return out;
  }

  double least_height() const { return std::min(ends_[0][2].inf(), ends_[1][2].inf()); }
  double greatest_height() const { return std::max(ends_[0][2].sup(), ends_[1][2].sup()); }

private:
  using Interval = IntervalNumber;
  using End = std::array<Interval, 3>;

  static End enclose(Point3q const& p)
  {
    return {Interval(CGAL::to_interval(p.x)), Interval(CGAL::to_interval(p.y)), Interval(CGAL::to_interval(p.z))};
  }
  static Interval above(Point3d const& a, End const& e, PortalSequence::Edge const& f)
  {
    return visibility::detail::Orient3dFormula{}(Interval(a.x), Interval(a.y), Interval(a.z), e[0], e[1], e[2],
                                                 Interval(f.right.x), Interval(f.right.y), Interval(f.right.z),
                                                 Interval(f.left.x), Interval(f.left.y), Interval(f.left.z));
  }

  std::array<End, 2> ends_;
};

}  // namespace visibility::exact_25d
