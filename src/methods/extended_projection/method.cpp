#include "visibility/methods/extended_projection/method.hpp"

#include "slice_projector.hpp"

#include "visibility/methods/extended_projection/boxes_in_frame.hpp"
#include "visibility/methods/extended_projection/occludee_search.hpp"
#include "visibility/methods/extended_projection/occluder_projector.hpp"
#include "visibility/methods/extended_projection/occluder_selection.hpp"
#include "visibility/methods/extended_projection/plane_choice.hpp"

#include <algorithm>

namespace visibility {

namespace {

using namespace extended_projection;

/// How many occluders are added to the maps before their pyramids are brought up to date.
constexpr int refresh_after = 32;

/// Occluders that are seen smaller than this do not come in later.
constexpr double fewest_pixels = 16;

constexpr int default_planes = 8;

/// Of a plane at infinity, in sizes of scene and cell: its pixels are so large that the cell is nothing against them.
constexpr double infinite_distance = 0x1p24;

/// What is nearer to the cell than this share of the size of scene and cell is not projected to infinity.
constexpr double nearest_to_infinity = 0x1p-24;

/// The maps of one cell, filled from occluders of the largest solid angle first.
class Maps {
public:
  Maps(PreparedScene const& scene, ViewCell const& cell, Options const& options, ObjectSelection const* among)
    : scene_(scene), cell_(cell), resolution_(options.resolution), projector_(scene, cell, options.depth),
      slices_(scene, cell, projector_), with_slices_(options.slices && !options.infinity && scene.shells().size() > 0),
      sliced_(with_slices_ ? scene.scene().objects.size() : 0), added_(scene.occluders().size()),
      at_infinity_(options.infinity)
  {
    cells_.reserve(frames.size());
    if (options.infinity) projector_.cut_nearer_than(nearest_to_infinity * size());
    for (auto const& f : frames_for(cell, options.directions)) cells_.emplace_back(f, cell);
    auto const selected = select_occluders(scene, cell, options.occluders, among);
    for (auto const& c : cells_)
      if (options.infinity)
        place_at_infinity(c, options);
      else
        place_planes(c, selected, options);
    for (auto const o : selected) add(o);
    refresh();
    for (auto const o : selected) add_slices(scene.occluders().object(o));
    refresh();
  }

  std::vector<ProjectionMap> const& maps() const { return maps_; }
  OccluderProjector const& projector() const { return projector_; }

  void add_object(std::uint32_t object)
  {
    auto const range = worthwhile_occluders(scene_, cell_, object);
    for (auto i = range.first; i < range.last; ++i)
      if (!added_[i] && approximate_pixels(scene_.occluders().bounds()[i], cell_, resolution_) >= fewest_pixels &&
          blocks(scene_, cell_, i))
        add(i);
    add_slices(object);
  }
  void refresh()
  {
    for (auto& m : maps_) m.refresh();
    since_refresh_ = 0;
  }
  std::size_t added() const { return count_; }
  std::size_t slices() const { return slices_.count(); }
  std::int64_t pixels() const { return pixels_; }

private:
  void place_planes(CellViews const& cell, std::vector<std::uint32_t> const& selected, Options const& options)
  {
    std::vector<Box> boxes;
    for (auto const o : selected) {
      Box const b = occluder_box(scene_.occluders(), o, cell.frame);
      if (b.max.z > cell.near) boxes.push_back(b);
    }
    std::vector<double> planes;
    for (double const d : options.distances) planes.push_back(cell.near + d);
    if (planes.empty())
      planes = choose_planes(cell, boxes, options, options.planes > 0 ? options.planes : default_planes);
    // Sight lines to what is behind a plane pass it above the ground.
    double const lowest = cell.frame.has_vertical_v() && projector_.is_above_ground()
                            ? projector_.ground() - 0.125 * (cell.bounds.max.y - projector_.ground())
                            : -HUGE_VAL;
    for (double const plane : planes)
      if (auto const grid = choose_grid(cell, boxes, plane, lowest, options); grid && plane > cell.near)
        maps_.emplace_back(cell, plane, *grid);
  }

  /// The largest extent of scene and cell.
  double size() const
  {
    Box all = scene_.object_hierarchy().nodes()[0].bounds;
    all.extend(cell_.bounds());
    return std::max({all.max.x - all.min.x, all.max.y - all.min.y, all.max.z - all.min.z});
  }

  void place_at_infinity(CellViews const& cell, Options const& options)
  {
    double const plane = cell.near + infinite_distance * size();
    if (auto const grid = raster_over(extended_rectangle(cell, plane, options.extent), options.resolution))
      maps_.emplace_back(cell, plane, *grid);
  }

  void add(std::uint32_t occluder)
  {
    added_[occluder] = true;
    ++count_;
    CellViews const* cell = nullptr;  // maps of one direction stand together
    Box box;
    for (auto& m : maps_) {
      if (&m.cell() != cell) {
        cell = &m.cell();
        box = occluder_box(scene_.occluders(), occluder, cell->frame);
      }
      if (at_infinity_ || m.seems_useful(box)) pixels_ += projector_.add(occluder, m);
    }
    if (++since_refresh_ == refresh_after) refresh();
  }

  void add_slices(std::uint32_t object)
  {
    if (!with_slices_ || sliced_[object]) return;
    sliced_[object] = true;
    for (auto& m : maps_) pixels_ += slices_.add(object, m);
  }

  PreparedScene const& scene_;
  ViewCell const& cell_;
  int resolution_;
  OccluderProjector projector_;
  SliceProjector slices_;
  bool with_slices_;
  std::vector<bool> sliced_;
  std::vector<CellViews> cells_;
  std::vector<ProjectionMap> maps_;
  std::vector<bool> added_;
  std::size_t count_ = 0;
  std::int64_t pixels_ = 0;
  int since_refresh_ = 0;
  bool at_infinity_;
};

/// Of all objects, or of some; no others occlude.
PotentiallyVisibleSet visible_set(PreparedScene const& scene, ViewCell const& cell, Options const& options,
                                  ObjectSelection const* among)
{
  Maps maps(scene, cell, options, among);
  OccludeeSearch search(scene, cell, maps.maps(), maps.projector(), options.improved);
  PotentiallyVisibleSet set;
  set.guarantee = Guarantee::conservative;
  if (options.more_occluders) {
    auto const before = maps.added(), slices_before = maps.slices();
    set.visible = search.visible_objects([&](std::uint32_t o) { maps.add_object(o); }, among);
    maps.refresh();
    if (maps.added() > before || maps.slices() > slices_before)
      std::erase_if(set.visible, [&](std::uint32_t o) { return search.hides_object(o); });
  } else {
    set.visible = search.visible_objects([](std::uint32_t) {}, among);
  }
  set.statistics = {{"planes", double(maps.maps().size())},
                    {"occluders", double(maps.added())},
                    {"slices", double(maps.slices())},
                    {"pixels", double(maps.pixels())},
                    {"boxes_tested", double(search.counts().boxes_tested)},
                    {"groups_hidden", double(search.counts().groups_hidden)}};
  return set;
}

}  // namespace

PotentiallyVisibleSet ExtendedProjection::operator()(PreparedScene const& scene, ViewCell const& cell) const
{
  return visible_set(scene, cell, options_, nullptr);
}

PotentiallyVisibleSet ExtendedProjection::operator()(PreparedScene const& scene, ViewCell const& cell,
                                                     std::span<std::uint32_t const> candidates) const
{
  ObjectSelection const among(scene.object_hierarchy(), candidates);
  return visible_set(scene, cell, options_, &among);
}

}  // namespace visibility
