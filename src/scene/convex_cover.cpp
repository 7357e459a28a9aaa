#include "visibility/scene/convex_cover.hpp"

#include "convex_growth.hpp"

#include <algorithm>

namespace visibility {

std::vector<ConvexPrism> convex_cover(Prism const& prism, std::size_t most)
{
  using detail::plan::Polygon;
  auto pieces = convex_partition(prism);
  if (pieces.size() < 2) return {};
  std::ranges::sort(pieces, std::greater<>{}, [](ConvexPrism const& p) { return detail::plan::area(p.footprint); });
  std::vector<ConvexPrism> cover;
  for (auto const& piece : pieces) {
    if (cover.size() == most) break;
    Polygon const grown = detail::grow(prism.rings, piece.footprint);
    double const slack = 1e-7 * detail::plan::perimeter(grown);
    if (std::ranges::any_of(cover, [&](auto const& c) { return detail::plan::contains(c.footprint, grown, slack); }))
      continue;
    // Rounded corners may stick out of a wall by an ulp: shrink until they do not.
    for (double const by : {0.0, 1e-12, 1e-9, 1e-6, 1e-4}) {
      Polygon footprint = detail::plan::convex_hull(detail::plan::shrunk(grown, by));
      if (footprint.size() < 3) break;
      if (!detail::lies_inside(prism.rings, footprint)) continue;
      cover.push_back({std::move(footprint), prism.bottom, prism.top});
      break;
    }
  }
  std::ranges::stable_sort(cover, std::greater<>{},
                           [](ConvexPrism const& p) { return detail::plan::area(p.footprint); });
  return cover;
}

}  // namespace visibility
