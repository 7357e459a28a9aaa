#pragma once

#include <cmath>
#include <cstdint>

namespace visibility::generators {

/// Cell (i, j) of the square grid whose lines x = 0 and y = 0 cross in the origin: [i, i+1] x [j, j+1].
struct Site {
  std::int64_t i, j;
};

/// Cell number `index` when the grid is filled ring by ring from the origin: the first 4 k^2 fill the square
/// [-k, k]^2. So a scene of n sites is nearly square for every n, and a larger one only adds to its rim.
inline Site ring_site(std::uint64_t index)
{
  // k = floor(sqrt(index) / 2); the double root may be off by one near a square, which the loops repair.
  auto k = static_cast<std::int64_t>(std::sqrt(static_cast<double>(index)) / 2);
  auto const in_square = [index](std::int64_t half) { return index < static_cast<std::uint64_t>(4 * half * half); };
  while (in_square(k)) --k;
  while (!in_square(k + 1)) ++k;
  auto const r = static_cast<std::int64_t>(index) - 4 * k * k;  // place in the ring of 4 sides of 2k+1 cells
  auto const along = r % (2 * k + 1), back = -k - 1;
  switch (r / (2 * k + 1)) {
  case 0: return {back + along, back};
  case 1: return {k, back + along};
  case 2: return {k - along, k};
  default: return {back, k - along};
  }
}

/// Middle of lot i along one axis of a town: an avenue about 0, lots in blocks, between blocks a street or, every so
/// many blocks, another avenue. Symmetric about 0; lot 0 is the first on the positive side.
struct TownAxis {
  double lot, street, avenue;  ///< widths, m
  std::int64_t block, blocks;  ///< lots to a block; blocks between avenues, 0: no avenue but the one in the middle

  double operator()(std::int64_t i) const
  {
    if (i < 0) return -(*this)(-1 - i);
    std::int64_t const gaps = i / block, avenues = blocks == 0 ? 0 : gaps / blocks;
    return (static_cast<double>(avenues) + 0.5) * avenue + static_cast<double>(gaps - avenues) * street +
           (static_cast<double>(i) + 0.5) * lot;
  }
};

}  // namespace visibility::generators
