#pragma once

#include "visibility/methods/ray_space/frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

/// Where lines cross a chord of a body, bounded. proofs/ray_space.md, "Bounds over a pixel".
namespace visibility::ray_space {

/// Where the lines of one slope cross the chord from p to q in plan: affine in s, as the width between its ends is the
/// same for all. Requires where it is used: the line passes below p and above q, by their margins.
class Crossing {
public:
  Crossing(LocalPoint const& p, LocalPoint const& q, double margins, double scale, double t)
    : u_(p.u), z_(p.z), along_u_(q.u - p.u), along_z_(q.z - p.z), below_(t * p.u - p.v)
  {
    double const inverse = 1 / ((t * q.u - q.v) - below_), off = 0.25 * margins * std::fabs(inverse) + 0x1p-50;
    rate_ = -inverse;
    du_ = off * std::fabs(along_u_) + 0x1p-48 * (std::fabs(p.u) + std::fabs(q.u) + scale);
    dz_ = off * std::fabs(along_z_) + 0x1p-48 * (std::fabs(p.z) + std::fabs(q.z) + scale);
  }

  SlicePoint operator()(double s) const
  {
    double const part = (s + below_) * rate_, u = u_ + part * along_u_, z = z_ + part * along_z_;
    return {u - du_, u + du_, z - dz_, z + dz_};
  }

private:
  double u_, z_, along_u_, along_z_, below_, rate_, du_, dz_;
};

/// The crossing as the paper's appendix bounds it over the whole footprint of a chord: distance and height are
/// first-order rational functions with one denominator, the width between the ends as the line sees them. Of the two,
/// the one that changes less becomes a constant, the other a plane: its numerator over the least or the greatest width.
class LinearCrossing {
public:
  LinearCrossing(Frame const& frame, LocalPoint const& p, LocalPoint const& q, double margins)
    : p_(&p), q_(&q), margins_(margins), scale_(frame.half_length() + frame.height()),
      height_is_constant_(std::fabs(q.z - p.z) * (std::fabs(p.u) + std::fabs(q.u)) <=
                          std::fabs(q.u - p.u) * (std::fabs(p.z) + std::fabs(q.z)))
  {
    // Slopes of lines of the frame to the ends; the width depends on the slope alone.
    double low = frame.t(frame.rows()), high = frame.t(0);
    double const s = frame.s(frame.columns());
    for (auto const* e : {&p, &q}) {
      low = e->u > 0 ? std::min(low, (e->v - s) / e->u) : frame.t(0);
      high = e->u > 0 ? std::max(high, (e->v + s) / e->u) : frame.t(frame.rows());
    }
    low = std::max(low, frame.t(0)), high = std::min(high, frame.t(frame.rows()));
    double const a = low * (q.u - p.u) - (q.v - p.v), b = high * (q.u - p.u) - (q.v - p.v);
    least_ = std::min(a, b) - margins;
    most_ = std::max(a, b) + margins;
  }

  SlicePoint operator()(double s, double t) const
  {
    LocalPoint const &p = *p_, &q = *q_;
    double const below = s + t * p.u - p.v, above = s + t * q.u - q.v;
    auto const constant = [](double x, double y) { return std::pair(std::min(x, y), std::max(x, y)); };
    // (above x - below y) / width, within the values at the ends.
    auto const plane = [&](double x, double y) {
      double const numerator = above * x - below * y;
      double const off =
        margins_ * (std::fabs(x) + std::fabs(y)) + 0x1p-48 * (std::fabs(above * x) + std::fabs(below * y));
      auto [low, high] = constant(x, y);
      if (!(least_ > 0)) return std::pair(low, high);
      low = std::max(low, std::min((numerator - off) / most_, (numerator - off) / least_));
      high = std::min(high, std::max((numerator + off) / most_, (numerator + off) / least_));
      return std::pair(low, high);
    };
    auto const [u0, u1] = height_is_constant_ ? plane(p.u, q.u) : constant(p.u, q.u);
    auto const [z0, z1] = height_is_constant_ ? constant(p.z, q.z) : plane(p.z, q.z);
    double const du = 0x1p-47 * (std::fabs(p.u) + std::fabs(q.u) + scale_);
    double const dz = 0x1p-47 * (std::fabs(p.z) + std::fabs(q.z) + scale_);
    return {u0 - du, u1 + du, z0 - dz, z1 + dz};
  }

private:
  LocalPoint const *p_, *q_;
  double margins_, scale_, least_ = 0, most_ = 0;
  bool height_is_constant_;
};

}  // namespace visibility::ray_space
