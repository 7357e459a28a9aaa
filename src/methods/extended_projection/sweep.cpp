#include "visibility/methods/extended_projection/sweep.hpp"

#include "hidden_objects.hpp"
#include "slice_projector.hpp"
#include "sweep_planes.hpp"

#include "visibility/methods/extended_projection/boxes_in_frame.hpp"
#include "visibility/methods/extended_projection/occluder_projector.hpp"
#include "visibility/methods/extended_projection/occluder_selection.hpp"

#include <algorithm>
#include <optional>

namespace visibility {

namespace {

using namespace extended_projection;

/// How many occluders are added to a map before its pyramid is brought up to date.
constexpr std::size_t refresh_after = 64;

/// So many occluders tell where the first plane stands.
constexpr std::size_t most_important = 200;

/// One sweep after the other over one scene; what is hidden stays so.
class Sweeps {
public:
  /// What is not `among` the objects of interest, if these are given, is taken as hidden.
  Sweeps(PreparedScene const& scene, ViewCell const& cell, Options const& options, ObjectSelection const* among)
    : scene_(scene), cell_(cell), options_(options), projector_(scene, cell, options.depth),
      slices_(scene, cell, projector_), important_(select_occluders(scene, cell, most_important, among)),
      hidden_(scene, cell, among)
  {
  }

  void run(Frame const& frame)
  {
    CellViews const views(frame, cell_);
    Box const all = frame(scene_.object_hierarchy().nodes()[0].bounds);
    std::vector<Box> important;
    for (auto const o : important_) important.push_back(occluder_box(scene_.occluders(), o, frame));
    std::optional<ProjectionMap> map;
    double before = views.near;
    for (double const plane : sweep_planes(views, all, important, options_)) {
      auto const grid = sweep_grid(views, all, plane, options_);
      if (!grid) continue;
      if (map)
        map = ProjectionMap(*map, plane, *grid, options_.reprojection);
      else
        map.emplace(views, plane, *grid);
      ++planes_;
      add_occluders(*map, before);
      map->refresh();
      if (options_.slices && scene_.shells().size() > 0) add_slices(*map);
      if (!test(*map, before)) break;  // nothing is left behind the plane
      before = plane;
    }
  }

  PotentiallyVisibleSet result() const
  {
    PotentiallyVisibleSet set;
    set.guarantee = Guarantee::conservative;
    set.visible = hidden_.rest();
    set.statistics = {
      {"planes", double(planes_)}, {"occluders", double(occluders_)},       {"slices", double(slices_.count())},
      {"pixels", double(pixels_)}, {"boxes_tested", double(boxes_tested_)}, {"groups_hidden", double(groups_hidden_)}};
    return set;
  }

private:
  /// Those with a part between the plane before and this one, or flat in this one; of them all that is before it.
  void add_occluders(ProjectionMap& map, double before)
  {
    auto const& frame = map.cell().frame;
    auto const& occluders = scene_.occluders();
    auto const reaches = [&](Box const& b) { return b.max.z > before && b.min.z <= map.plane(); };
    // What begins at the plane waits for the next one, unless it ends there, too.
    auto const is_between = [&](Box const& b) {
      return b.max.z > before && (b.min.z < map.plane() || b.max.z == map.plane());
    };
    auto const enter = [&](std::uint32_t, Box const& box) { return reaches(frame(box)); };
    hidden_.walk_rest(enter, [&](std::uint32_t object) {
      if (!reaches(object_box(scene_, object, frame))) return;
      auto const range = worthwhile_occluders(scene_, cell_, object);
      for (auto o = range.first; o < range.last; ++o) {
        Box const b = occluder_box(occluders, o, frame);
        if (!is_between(b) || !map.seems_useful(b) || !blocks(scene_, cell_, o)) continue;
        ++occluders_;
        pixels_ += projector_.add(o, map, map.plane());
        if (occluders_ % refresh_after == 0) map.refresh();
      }
    });
  }

  /// Adds the sections of meshes with the plane.
  void add_slices(ProjectionMap& map)
  {
    auto const& frame = map.cell().frame;
    auto const enter = [&](std::uint32_t, Box const& box) {
      Box const b = frame(box);
      return b.min.z < map.plane() && map.plane() <= b.max.z && map.slice_seems_useful(b);
    };
    hidden_.walk_rest(enter, [&](std::uint32_t object) { pixels_ += slices_.add(object, map); });
    map.refresh();
  }

  /// Tests what is behind the plane before; returns whether anything is left behind this one.
  bool test(ProjectionMap const& map, double before)
  {
    auto const& frame = map.cell().frame;
    auto const hides = [&](Box const& b) {
      if (b.min.z < before) return false;
      ++boxes_tested_;
      return map.hides(b) || (options_.improved && map.cell().is_box && map.hides_improved(b));
    };
    auto const hides_object = [&](std::uint32_t object, Box const& box) {
      if (hides(box)) return true;
      auto const& bodies = scene_.bodies();
      auto const first = bodies.first_of_object()[object], last = bodies.first_of_object()[object + 1];
      if (last - first < 2 || last - first > most_occludee_bodies) return false;
      for (auto b = first; b < last; ++b)
        if (!hides(body_box(bodies, b, frame))) return false;
      return true;
    };
    bool is_left = false;
    hidden_.walk_rest(
      [&](std::uint32_t node, Box const& box) {
        Box const b = frame(box);
        if (b.max.z <= before) return false;
        if (!projector_.may_hide(box) || !hides(b)) return true;
        hidden_.hide_group(node);
        ++groups_hidden_;
        return false;
      },
      [&](std::uint32_t object) {
        // What reaches beside the cell is not seen as a whole in this direction.
        Box const b = object_box(scene_, object, frame);
        if (!(b.min.z > map.cell().near) || !projector_.may_hide(scene_.object_bounds()[object])) return;
        if (hides_object(object, b))
          hidden_.hide(object);
        else
          is_left = is_left || b.max.z > map.plane();
      });
    return is_left;
  }

  PreparedScene const& scene_;
  ViewCell const& cell_;
  Options const& options_;
  OccluderProjector projector_;
  SliceProjector slices_;
  std::vector<std::uint32_t> important_;
  HiddenObjects hidden_;
  std::size_t planes_ = 0, occluders_ = 0, boxes_tested_ = 0, groups_hidden_ = 0;
  std::int64_t pixels_ = 0;
};

PotentiallyVisibleSet visible_set(PreparedScene const& scene, ViewCell const& cell, Options const& options,
                                  ObjectSelection const* among)
{
  Sweeps sweeps(scene, cell, options, among);
  for (auto const& frame : frames_for(cell, options.directions)) sweeps.run(frame);
  return sweeps.result();
}

}  // namespace

PotentiallyVisibleSet OcclusionSweep::operator()(PreparedScene const& scene, ViewCell const& cell) const
{
  return visible_set(scene, cell, options_, nullptr);
}

PotentiallyVisibleSet OcclusionSweep::operator()(PreparedScene const& scene, ViewCell const& cell,
                                                 std::span<std::uint32_t const> candidates) const
{
  ObjectSelection const among(scene.object_hierarchy(), candidates);
  return visible_set(scene, cell, options_, &among);
}

}  // namespace visibility
