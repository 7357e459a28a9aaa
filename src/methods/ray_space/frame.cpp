#include "visibility/methods/ray_space/frame.hpp"

#include <limits>

namespace visibility::ray_space {

namespace {

constexpr double up = 1 + 0x1p-50, down = 1 - 0x1p-50;

/// Rounded away from the origin, and towards -infinity or +infinity.
double lower(double x) { return x < 0 ? x * up : x * down; }
double upper(double x) { return x < 0 ? x * down : x * up; }

std::vector<double> lines(double limit, int n)
{
  std::vector<double> out(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) out[static_cast<std::size_t>(i)] = limit * (2.0 * i - n) / n;
  out.front() = -limit;
  out.back() = limit;
  return out;
}

}  // namespace

bool Frame::in_domain(Box const& c)
{
  constexpr double least = 0x1p-100, most = 0x1p100;
  auto const side = [&](double lo, double hi) {
    return std::fabs(lo) <= most && std::fabs(hi) <= most && hi - lo >= least;
  };
  return side(c.min.x, c.max.x) && side(c.min.y, c.max.y) && side(c.min.z, c.max.z);
}

Frame::Frame(Box const& cell, int family, int rows, int columns)
  : forward_(family < 2 ? &Point3d::x : &Point3d::y), sideways_(family < 2 ? &Point3d::y : &Point3d::x),
    sign_(family % 2 == 0 ? 1 : -1), centre_{0.5 * cell.min.x + 0.5 * cell.max.x, 0.5 * cell.min.y + 0.5 * cell.max.y,
                                             0},
    bottom_(cell.min.z), height_((cell.max.z - cell.min.z) * up)
{
  auto const half = [&](double Point3d::*k) {
    return std::max(cell.max.*k - centre_.*k, centre_.*k - cell.min.*k) * up;
  };
  a_ = half(forward_);
  h_ = half(sideways_);
  double const t = h_ / a_ * up;
  t_ = lines(t, rows);
  s_ = lines((h_ + t * a_) * up, columns);
  columns_per_unit_ = columns / (s_.back() - s_.front());
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      slices_.push_back(cell_slice(pixel(row, column)));
      auto const& k = slices_.back();
      exits_.push_back(k.u_in <= k.u_out ? k.u_out : std::numeric_limits<double>::infinity());
    }
}

int Frame::columns_below(double limit) const
{
  int const n = columns();
  if (!(limit >= s_[1])) return 0;
  if (limit >= s_.back()) return n;
  int c = static_cast<int>((limit - s_.front()) * columns_per_unit_);
  c = std::clamp(c, 0, n);
  while (c > 0 && s(c) > limit) --c;
  while (c < n && s(c + 1) <= limit) ++c;
  return c;
}

int Frame::columns_from(double limit) const
{
  int const n = columns();
  if (limit <= s_.front()) return 0;
  if (!(limit <= s_[static_cast<std::size_t>(n) - 1])) return n;
  int c = static_cast<int>((limit - s_.front()) * columns_per_unit_);
  c = std::clamp(c, 0, n);
  while (c < n && s(c) < limit) ++c;
  while (c > 0 && s(c - 1) >= limit) --c;
  return c;
}

CellSlice Frame::cell_slice(Pixel const& pixel) const
{
  auto const [s0, s1, t0, t1] = pixel;
  CellSlice k{-a_, a_, height_};
  // A line enters and leaves |v| <= h where v = -h and h if it rises, h and -h if it falls.
  double const flat = std::min(std::fabs(t0), std::fabs(t1)), steep = std::max(std::fabs(t0), std::fabs(t1));
  if (t0 > 0 || t1 < 0) {
    double const to_leave = (t0 > 0 ? h_ - s0 : h_ + s1), to_enter = (t0 > 0 ? h_ + s1 : h_ - s0);
    // The differences are off by 2^-53 of their terms, which are at most the last column line.
    double const slack = 0x1p-50 * s_.back();
    double const leave = to_leave + slack, enter = -(to_enter + slack);
    k.u_out = std::min(a_, upper(leave >= 0 ? leave / flat : leave / steep));
    k.u_in = std::max(-a_, lower(enter <= 0 ? enter / flat : enter / steep));
  }
  double const nearest = s0 > 0 ? s0 : s1 < 0 ? -s1 : 0;
  if (nearest * down > (h_ + steep * a_) * up) k.u_in = 2 * a_;
  return k;
}

}  // namespace visibility::ray_space
