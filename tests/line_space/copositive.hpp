#pragma once

#include "visibility/line_space/plucker_line.hpp"

#include <vector>

namespace visibility::test {

/// A certificate that s q is nowhere positive on the cone of some vectors: while s b(u, v) > 0 for two of them, split
/// the cone at a vector w of that edge for which s b(u, w) and s b(v, w) are not positive. False where it is positive
/// somewhere, or where `budget` splits do not tell. Knows nothing of faces and lines.
inline bool never_positive(std::vector<PluckerLine<RationalNumber>> const& rays, int s, int& budget)
{
  RationalNumber const sign(s);
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (sign * plucker_form(rays[i]) > 0) return false;
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      RationalNumber const b = sign * plucker_product(rays[i], rays[j]);
      if (b <= 0) continue;
      RationalNumber const a = -sign * plucker_form(rays[i]), c = -sign * plucker_form(rays[j]);
      if (b * b > a * c || --budget < 0) return false;
      RationalNumber const weight = (b / c + a / b) / RationalNumber(2);
      auto const w = combination<RationalNumber>(RationalNumber(1), rays[i], weight, rays[j]);
      for (auto const k : {i, j}) {
        auto part = rays;
        part[k] = w;
        if (!never_positive(part, s, budget)) return false;
      }
      return true;
    }
  return true;
}

inline bool never_positive(std::vector<PluckerLine<RationalNumber>> const& rays, int s)
{
  int budget = 200;
  return never_positive(rays, s, budget);
}

}  // namespace visibility::test
