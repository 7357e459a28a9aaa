#include "visibility/viewspace/neighbours.hpp"

#include "visibility/scene/bounding_hierarchy.hpp"

#include <algorithm>

namespace visibility {

namespace {

constexpr std::size_t most = 48;  // of one cell

Box grown(Box const& b, double by)
{
  return {{b.min.x - by, b.min.y - by, b.min.z - by}, {b.max.x + by, b.max.y + by, b.max.z + by}};
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours(std::span<ViewCell const> cells)
{
  std::vector<Box> bounds;
  for (auto const& c : cells) bounds.push_back(c.bounds());
  BoundingHierarchy const hierarchy(bounds);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    Box const& own = bounds[i];
    double const size = std::max({own.max.x - own.min.x, own.max.y - own.min.y, own.max.z - own.min.z});
    std::size_t found = 0;
    // Doubled, the reach passes all that is finite after some two thousand rounds.
    for (double reach = 0; found == 0 && cells.size() > 1 && reach < HUGE_VAL; reach = std::max(size, 2 * reach))
      hierarchy.any_item_meeting(reach > 0 ? grown(own, reach) : own, [&](std::uint32_t j) {
        if (j != i) out.emplace_back(std::min(i, j), std::max(i, j)), ++found;
        return found == most;
      });
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace visibility
