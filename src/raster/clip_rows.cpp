#include "floor_division.hpp"
#include "visibility/raster/fixed_points.hpp"

#include <algorithm>

namespace visibility::detail {

namespace {

/// Calls f(row index, floor((b y + c) / divisor)) for each row: one division for the start and one for the step, then
/// additions with a carry, exactly.
template <class F>
void for_quotients(std::int64_t b, std::int64_t c, std::int64_t divisor, int y0, int y1, F const& f)
{
  auto [q, r] = floor_division(b * y0 + c, divisor);
  auto const [step_q, step_r] = floor_division(b, divisor);
  for (int k = 0, n = y1 - y0; k < n; ++k) {
    f(k, q);
    r += step_r - divisor;
    std::int64_t const borrow = r >> 63;  // -1 if there is no carry
    r += borrow & divisor;
    q += step_q + 1 + borrow;
  }
}

}  // namespace

void clip_rows(PixelHalfPlane const& h, PixelRectangle const& bounds, int* left, int* right)
{
  std::int64_t const x0 = bounds.x0, x1 = bounds.x1;
  if (h.a > 0)  // x >= -(b y + c) / a
    for_quotients(h.b, h.c, h.a, bounds.y0, bounds.y1, [=](int k, std::int64_t q) {
      left[k] = std::max(left[k], static_cast<int>(std::clamp(-q, x0, x1)));
    });
  else  // x <= (b y + c) / -a
    for_quotients(h.b, h.c, -h.a, bounds.y0, bounds.y1, [=](int k, std::int64_t q) {
      right[k] = std::min(right[k], static_cast<int>(std::clamp(q + 1, x0, x1)));
    });
}

}  // namespace visibility::detail
