#pragma once

// The only file that knows which Embree is there.
#if VISIBILITY_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace visibility::detail {

/// Nearest hit of one incoherent ray.
inline void intersect(RTCScene scene, RTCRayHit& ray)
{
#if VISIBILITY_EMBREE_MAJOR >= 4
  rtcIntersect1(scene, &ray, nullptr);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
#endif
}

}  // namespace visibility::detail
