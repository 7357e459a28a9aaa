#include "slice_projector.hpp"

#include <algorithm>

namespace visibility::extended_projection {

SliceProjector::SliceProjector(PreparedScene const& scene, ViewCell const& cell, OccluderProjector const& occluders)
  : scene_(scene), cell_(cell)
{
  if (occluders.is_above_ground()) ground_ = Ground{occluders.ground(), occluders.deep()};
}

bool SliceProjector::encloses_from_outside(EnclosingShell const& shell) const
{
  return cell_.bounds().min.z >= shell.floor && !meet(cell_.bounds(), shell.bounds);
}

bool SliceProjector::crosses(std::uint32_t object, ProjectionMap const& map) const
{
  return std::ranges::any_of(scene_.shells().of_object(object), [&](EnclosingShell const& shell) {
    Box const b = map.cell().frame(shell.bounds);
    return b.min.z < map.plane() && map.plane() <= b.max.z;
  });
}

std::int64_t SliceProjector::add(std::uint32_t object, ProjectionMap& map)
{
  std::int64_t pixels = 0;
  for (auto const& shell : scene_.shells().of_object(object)) {
    Box const b = map.cell().frame(shell.bounds);
    if (!(b.min.z < map.plane() && map.plane() <= b.max.z)) continue;
    if (!map.slice_seems_useful(b) || !encloses_from_outside(shell)) continue;
    bool const stands_above = ground_ && shell.bounds.min.z >= ground_->level;
    auto const section = slice(shell, map.cell().frame, map.plane(), stands_above ? &*ground_ : nullptr);
    if (!section) continue;
    ++count_;
    pixels += map.add_slice(section->edges, section->error, section->at, section->low);
  }
  return pixels;
}

}  // namespace visibility::extended_projection
