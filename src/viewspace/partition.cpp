#include "visibility/viewspace/partition.hpp"

#include <cmath>
#include <stdexcept>

namespace visibility {

namespace {

constexpr double most_cells = 1e8;

double component(Point3d const& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// The fewest equal parts of `length` that are not longer than `size`, the product being rounded: 1.1 is eleven 0.1.
double parts(double length, double size)
{
  double const n = std::max(1.0, std::round(length / size));
  return n * size < length ? n + 1 : n;
}

double longest(std::vector<double> const& cuts)
{
  double out = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) out = std::max(out, cuts[i] - cuts[i - 1]);
  return out;
}

std::vector<double> divide(std::vector<double> const& cuts, std::size_t n)
{
  std::vector<double> out;
  for (std::size_t i = 1; i < cuts.size(); ++i)
    for (std::size_t k = 0; k < n; ++k) {
      // Multiplied first: a length of 400 in 20 parts is cut at multiples of 20, without rounding.
      double const length = cuts[i] - cuts[i - 1];
      double const cut = k == 0 ? cuts[i - 1] : cuts[i - 1] + length * static_cast<double>(k) / static_cast<double>(n);
      if (!out.empty() && !(cut > out.back()))
        throw std::invalid_argument("the cells are too thin for coordinates of this size");
      out.push_back(cut);
    }
  if (!(cuts.back() > out.back())) throw std::invalid_argument("the cells are too thin for coordinates of this size");
  out.push_back(cuts.back());
  return out;
}

}  // namespace

Partition::Partition(Box const& region, std::span<Point3d const> sizes)
{
  if (!is_finite(region.min) || !is_finite(region.max))
    throw std::invalid_argument("a region coordinate is not finite");
  if (!region.has_interior())
    throw std::invalid_argument("the region has no interior (min must be below max on every axis)");
  if (sizes.empty()) throw std::invalid_argument("no cell size");
  Cuts cuts;
  for (int axis = 0; axis < 3; ++axis)
    cuts[static_cast<std::size_t>(axis)] = {component(region.min, axis), component(region.max, axis)};
  for (std::size_t level = 0; level < sizes.size(); ++level) {
    std::array<std::size_t, 3> n{};
    double cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
      auto const a = static_cast<std::size_t>(axis);
      double const size = component(sizes[level], axis);
      if (!(size > 0)) throw std::invalid_argument("a cell size is not positive");
      if (level > 0 && size > component(sizes[level - 1], axis))
        throw std::invalid_argument("cell sizes must not grow from one level to the next");
      double const length = longest(cuts[a]);
      if (!std::isfinite(length)) throw std::invalid_argument("the region is too large");
      double const k = parts(length, size);
      cells *= k * static_cast<double>(cuts[a].size() - 1);
      if (!(cells <= most_cells)) throw std::invalid_argument("more than 10^8 cells");
      n[a] = static_cast<std::size_t>(k);
    }
    for (std::size_t a = 0; a < 3; ++a) cuts[a] = divide(cuts[a], n[a]);
    cuts_.push_back(cuts);
    parts_.push_back(n);
  }
}

std::array<std::size_t, 3> Partition::shape(std::size_t level) const
{
  auto const& c = cuts_[level];
  return {c[0].size() - 1, c[1].size() - 1, c[2].size() - 1};
}

std::size_t Partition::cell_count(std::size_t level) const
{
  auto const n = shape(level);
  return n[0] * n[1] * n[2];
}

std::array<std::size_t, 3> Partition::position(std::size_t level, std::size_t index) const
{
  auto const n = shape(level);
  return {index % n[0], index / n[0] % n[1], index / n[0] / n[1]};
}

Box Partition::cell(std::size_t level, std::size_t index) const
{
  auto const& c = cuts_[level];
  auto const [i, j, k] = position(level, index);
  return {{c[0][i], c[1][j], c[2][k]}, {c[0][i + 1], c[1][j + 1], c[2][k + 1]}};
}

std::vector<std::size_t> Partition::children(std::size_t level, std::size_t index) const
{
  auto const [i, j, k] = position(level, index);
  auto const n = shape(level + 1);
  auto const& p = parts_[level + 1];
  std::vector<std::size_t> out;
  for (std::size_t z = k * p[2]; z < (k + 1) * p[2]; ++z)
    for (std::size_t y = j * p[1]; y < (j + 1) * p[1]; ++y)
      for (std::size_t x = i * p[0]; x < (i + 1) * p[0]; ++x) out.push_back(x + n[0] * (y + n[1] * z));
  return out;
}

}  // namespace visibility
