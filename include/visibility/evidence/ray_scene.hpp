#pragma once

#include "visibility/evidence/face.hpp"

#include <memory>

namespace visibility {

/// The nearest thing a floating-point ray meets.
struct RayHit {
  static constexpr std::uint32_t nothing = UINT32_MAX;
  std::uint32_t object = nothing;
  Face face;
  double distance = HUGE_VAL;  ///< in multiples of the direction's length
  Point3d point;               ///< rounded
  bool from_inside = false;    ///< the origin lies inside this solid, so the ray sees nothing
  bool hit() const { return object != nothing; }
};

/// All occluders of a scene for single-precision rays (Embree). Rays only propose sight lines: nothing is decided by
/// them. Coordinates are taken relative to the scene's centre, in units of its size: far offsets keep their
/// millimetres, and subnormal or huge scenes their shape.
/// Boxes take 24 bytes and the tree's share each; objects that occlude nothing are not there.
/// Rays may be cast in parallel.
class RayScene {
public:
  /// Keeps a reference to the scene, which must outlive this. Throws std::runtime_error if Embree fails.
  explicit RayScene(PreparedScene const& scene);
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  ~RayScene();

  PreparedScene const& scene() const;

  /// The nearest hit along the ray. Requires: a direction of finite length > 0.
  RayHit first_hit(Point3d const& origin, Point3d const& direction) const;

  /// The point of the single-precision grid of rays that is nearest: rays start only there.
  Point3d snapped(Point3d const& p) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace visibility
