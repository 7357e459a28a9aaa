#pragma once

#include "support/random.hpp"

#include "visibility/line_space/plucker_cone.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <vector>

/// Extreme rays of a cone in R^6 by trying all subsets of its half-spaces, in rationals; shares no code with
/// PluckerCone.
namespace visibility::test {

using SmallVector = std::array<int, 6>;  ///< of a half-space {l : b(l, h) >= 0}: direction, moment
using RationalVector = std::array<RationalNumber, 6>;

template <class NT>
PluckerLine<NT> as_line(SmallVector const& h)
{
  PluckerLine<NT> l;
  for (std::size_t i = 0; i < 6; ++i) l[i] = NT(h[i]);
  return l;
}

/// A ray is named by the half-spaces that it touches: faces of a cone are.
struct ConeSummary {
  std::size_t lineality;
  std::set<std::vector<bool>> rays;
  friend bool operator==(ConeSummary const&, ConeSummary const&) = default;
};

/// A basis of {x : row . x = 0 for all rows}.
inline std::vector<RationalVector> null_space(std::vector<RationalVector> rows)
{
  std::vector<std::size_t> pivot;
  std::size_t rank = 0;
  for (std::size_t c = 0; c < 6; ++c) {
    std::size_t r = rank;
    while (r < rows.size() && rows[r][c] == 0) ++r;
    if (r == rows.size()) continue;
    std::swap(rows[r], rows[rank]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank || rows[i][c] == 0) continue;
      RationalNumber const f = rows[i][c] / rows[rank][c];
      for (std::size_t j = 0; j < 6; ++j) rows[i][j] -= f * rows[rank][j];
    }
    pivot.push_back(c);
    ++rank;
  }
  std::vector<RationalVector> basis;
  for (std::size_t c = 0; c < 6; ++c) {
    if (std::find(pivot.begin(), pivot.end(), c) != pivot.end()) continue;
    RationalVector v{};
    v[c] = 1;
    for (std::size_t i = 0; i < rank; ++i) v[pivot[i]] = -rows[i][c] / rows[i][pivot[i]];
    basis.push_back(v);
  }
  return basis;
}

/// The row with row . l = b(l, h).
inline RationalVector polar(SmallVector const& h)
{
  return {RationalNumber(h[3]), RationalNumber(h[4]), RationalNumber(h[5]),
          RationalNumber(h[0]), RationalNumber(h[1]), RationalNumber(h[2])};
}

inline ConeSummary brute_force(std::vector<SmallVector> const& half_spaces)
{
  std::vector<RationalVector> rows;
  for (auto const& h : half_spaces) rows.push_back(polar(h));
  ConeSummary summary{null_space(rows).size(), {}};
  std::size_t const free = summary.lineality + 1;  // dimension of the space of a ray and the lineality space
  auto const try_ray = [&](RationalVector const& v) {
    std::vector<bool> tight(rows.size());
    int side = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      RationalNumber dot = 0;
      for (std::size_t j = 0; j < 6; ++j) dot += rows[i][j] * v[j];
      int const s = static_cast<int>(CGAL::sign(dot));
      tight[i] = s == 0;
      if (s != 0 && side == -s) return;
      if (s != 0) side = s;
    }
    if (side != 0) summary.rays.insert(tight);  // of v or -v; both would need side 0
  };
  for (unsigned subset = 0; subset < 1u << rows.size(); ++subset) {
    if (static_cast<std::size_t>(std::popcount(subset)) != 6 - free) continue;
    std::vector<RationalVector> chosen;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if ((subset >> i & 1) != 0) chosen.push_back(rows[i]);
    auto const space = null_space(chosen);
    if (space.size() != free) continue;
    for (auto const& v : space) try_ray(v);  // those in the lineality space have side 0
  }
  return summary;
}

/// Some vector is on the strict side of all half-spaces: none is touched by all rays.
inline bool has_interior(ConeSummary const& summary)
{
  if (summary.rays.empty()) return summary.lineality == 6;
  std::vector<bool> everywhere(summary.rays.begin()->size(), true);
  for (auto const& tight : summary.rays)
    for (std::size_t i = 0; i < tight.size(); ++i) everywhere[i] = everywhere[i] && tight[i];
  return std::find(everywhere.begin(), everywhere.end(), true) == everywhere.end();
}

/// A few half-spaces with small components: general ones, lines through grid points, few dimensions, repeats,
/// opposites, sums of others.
inline std::vector<SmallVector> small_half_spaces(Random& random)
{
  int const n = random.between(1, 10), style = random.below(4), reach = random.between(1, 4);
  int const dimensions = style == 1 ? random.between(2, 5) : 6;
  bool const narrow = random.chance(0.5);
  std::vector<SmallVector> list;
  auto const any = [&]() -> SmallVector const& {
    return list[static_cast<std::size_t>(random.below(static_cast<int>(list.size())))];
  };
  while (static_cast<int>(list.size()) < n) {
    SmallVector h{};
    if (style == 2) {
      std::array<int, 3> p{}, q{};
      for (std::size_t i = 0; i < 3; ++i) p[i] = random.between(-reach, reach), q[i] = random.between(-reach, reach);
      h = {q[0] - p[0],
           q[1] - p[1],
           q[2] - p[2],
           p[1] * q[2] - p[2] * q[1],
           p[2] * q[0] - p[0] * q[2],
           p[0] * q[1] - p[1] * q[0]};
    } else {
      for (int i = 0; i < dimensions; ++i) h[static_cast<std::size_t>(i)] = random.between(-reach, reach);
    }
    if (narrow && h[0] < 0)
      for (int& x : h) x = -x;  // around one axis: interior is common
    if (!list.empty() && style == 3 && random.chance(0.3)) {
      SmallVector const a = any(), b = any();
      int const f = random.between(-1, 1);
      for (std::size_t i = 0; i < 6; ++i) h[i] = a[i] + f * b[i];
    }
    list.push_back(h);
  }
  return list;
}

}  // namespace visibility::test
