#pragma once

#include "visibility/kernel/point.hpp"
#include "visibility/raster/grid.hpp"
#include "visibility/raster/span.hpp"

#include <cstdint>

namespace visibility {

/// The closed half-plane a x + b y + c >= 0 of the plane. `error` bounds, for every point of the raster, how far that
/// value may be from the one that is meant (because a, b, c were rounded); 0 if they are exact. Requires: error >= 0.
struct HalfPlane {
  double a, b, c, error = 0;
};

/// Which side of a rounding is safe. `inside`: a pixel counts only if it lies wholly in the set. `touching`: a pixel
/// counts if it shares a point with the (closed) set.
enum class Cover { inside, touching };

/// The pixels (i, j) with a i + b j + c >= 0, in integers: |a|, |b| <= 2^48, |c| <= 2^62, so that no pixel of any
/// raster overflows. What is on the safe side is folded into c.
struct PixelHalfPlane {
  std::int64_t a, b, c;
};

/// The pixels that the half-plane covers. Exact where the arithmetic is; otherwise off by less than 2^-33 of a pixel
/// (and by what `error` amounts to), to the safe side. Non-finite coefficients, or such as overflow: no pixel is
/// inside, every one is touched.
PixelHalfPlane pixels_of(Grid const&, HalfPlane const&, Cover);

}  // namespace visibility
