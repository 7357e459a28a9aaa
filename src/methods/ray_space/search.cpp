#include "visibility/methods/ray_space/search.hpp"

#include "visibility/scene/faces.hpp"

#include <algorithm>
#include <array>
#include <queue>

namespace visibility::ray_space {

namespace {

constexpr int families = 4;

std::vector<Frame> frames_of(Box const& cell, int resolution)
{
  std::vector<Frame> out;
  for (int f = 0; f < families; ++f) out.emplace_back(cell, f, resolution, std::max(1, resolution / 8));
  return out;
}

std::vector<OcclusionMap> maps_of(std::vector<Frame> const& frames, int components)
{
  std::vector<OcclusionMap> out;
  for (auto const& f : frames) out.emplace_back(f, components);
  return out;
}

std::vector<RefinedMap> refined_maps_of(std::vector<Frame> const& frames, std::vector<OcclusionMap>& maps,
                                        Options const& options)
{
  std::vector<RefinedMap> out;
  if (options.halvings() == 0) return out;
  for (std::size_t f = 0; f < frames.size(); ++f) out.emplace_back(frames[f], maps[f], options);
  return out;
}

std::vector<OccludeeTest::Family> together(std::vector<Frame> const& frames, std::vector<OcclusionMap> const& maps,
                                           std::vector<RefinedMap>& refined)
{
  std::vector<OccludeeTest::Family> out;
  for (std::size_t i = 0; i < frames.size(); ++i)
    out.push_back({&frames[i], &maps[i], refined.empty() ? nullptr : &refined[i]});
  return out;
}

/// No sight line goes lower: neither the cell nor anything to be seen does.
double floor_of(PreparedScene const& scene, Box const& cell)
{
  return std::min(scene.object_hierarchy().nodes().front().bounds.min.z, cell.min.z);
}

/// A node or an object that waits for its turn.
struct Waiting {
  double distance;
  std::uint32_t index;
  bool is_object;
  friend bool operator<(Waiting const& a, Waiting const& b) { return a.distance > b.distance; }
};

/// Whether the part lies in the body but for a twentieth of the body's sides in plan. A choice of what to leave out.
bool nearly_contains(Box const& body, Box const& part)
{
  double const x = 0.05 * (body.max.x - body.min.x), y = 0.05 * (body.max.y - body.min.y);
  return body.min.x - x <= part.min.x && part.max.x <= body.max.x + x && body.min.y - y <= part.min.y &&
         part.max.y <= body.max.y + y && body.min.z <= part.min.z && part.max.z <= body.max.z;
}

}  // namespace

Search::Search(PreparedScene const& scene, ViewCell const& cell, Options const& options)
  : scene_(&scene), cell_(&cell), options_(options), frames_(frames_of(cell.bounds(), options.first_resolution())),
    maps_(maps_of(frames_, options.components)), refined_(refined_maps_of(frames_, maps_, options)),
    test_(together(frames_, maps_, refined_)), floor_(floor_of(scene, cell.bounds())), writer_(floor_, options)
{
}

std::vector<std::uint32_t> Search::run()
{
  std::vector<std::uint32_t> visible;
  auto const& hierarchy = scene_->object_hierarchy();
  Box const& cell = cell_->bounds();
  std::priority_queue<Waiting> queue;
  auto const wait = [&](std::uint32_t index, bool is_object, Box const& bounds) {
    queue.push({approximate_squared_distance(cell, bounds), index, is_object});
  };
  wait(0, false, hierarchy.nodes().front().bounds);
  while (!queue.empty()) {
    Waiting const next = queue.top();
    queue.pop();
    if (next.is_object) {
      ++counts_.objects;
      if (!is_visible(next.index)) continue;
      visible.push_back(next.index);
      enter(next.index);
      continue;
    }
    auto const& node = hierarchy.nodes()[next.index];
    ++counts_.nodes;
    if (!meet(node.bounds, cell) && test_.hidden(node.bounds)) continue;
    if (node.is_leaf()) {
      for (auto i = node.first; i < node.first + node.count; ++i)
        wait(hierarchy.items()[i], true, hierarchy.item_bounds()[i]);
    } else {
      for (auto const child : {node.first, node.first + 1}) wait(child, false, hierarchy.nodes()[child].bounds);
    }
  }
  for (auto const& r : refined_) counts_.parts_of_pixels += r.size();
  std::ranges::sort(visible);
  return visible;
}

/// Whether some part of the object may be visible. Whatever meets the box around the cell counts as visible.
bool Search::is_visible(std::uint32_t object)
{
  Box const& bounds = scene_->object_bounds()[object];
  if (meet(bounds, cell_->bounds())) return true;
  if (test_.hidden(bounds)) return false;
  if (options_.granularity == Granularity::object) return true;
  auto const& bodies = scene_->bodies();
  auto const all = bodies.bodies_of(object);
  auto const boxes = bodies.bounds_of(object);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (is_part_visible(all[i], boxes[i])) return true;
  return false;
}

bool Search::is_part_visible(ConvexBodies::Body const& body, Box const& bounds)
{
  ++counts_.parts;
  vertices_.clear();
  auto const& bodies = scene_->bodies();
  bodies.append_vertices(body, vertices_);
  if (test_.hidden(bounds, vertices_)) return false;
  if (options_.granularity == Granularity::part || !has_polygons(body)) return true;
  return any_face_towards(*cell_, bodies, body, [&](std::span<Point3d const> face) {
    if (options_.granularity == Granularity::face) return is_polygon_visible(face);
    for (std::size_t i = 2; i < face.size(); ++i)
      if (is_polygon_visible(std::array{face[0], face[i - 1], face[i]})) return true;
    return false;
  });
}

bool Search::is_polygon_visible(std::span<Point3d const> polygon)
{
  ++counts_.parts;
  Box bounds;
  for (auto const& p : polygon) bounds.extend(p);
  return meet(bounds, cell_->bounds()) || !test_.hidden(bounds, polygon);
}

/// Bodies inside the object first: they join what its parts hold one by one, and parts that they fill add next to
/// nothing.
void Search::enter(std::uint32_t object)
{
  auto const& occluders = scene_->occluders();
  auto const first = occluders.first_of_object()[object], last = occluders.first_of_object()[object + 1];
  inner_.clear();
  for (auto i = first; i < last; ++i)
    if (!occluders.is_body(i) && enter_occluder(object, i)) inner_.push_back(occluders.bounds()[i]);
  for (auto i = first; i < last; ++i)
    if (occluders.is_body(i) &&
        std::ranges::none_of(inner_, [&](Box const& b) { return nearly_contains(b, occluders.bounds()[i]); }))
      enter_occluder(object, i);
}

/// Returns whether it is an occluder from this cell; one that is hidden is not entered.
bool Search::enter_occluder(std::uint32_t object, std::uint32_t i)
{
  auto const& occluders = scene_->occluders();
  Box const& owner = scene_->object_bounds()[object];
  bool const blocks = occluders.blocks_from(*cell_, i, owner);
  if (!blocks && !occluders.blocks_beyond_owner(i, floor_)) return false;
  Box const& bounds = occluders.bounds()[i];
  if (!meet(bounds, cell_->bounds()) && test_.hidden(bounds, OccludeeTest::Pixels::whole)) return true;
  occluders.visit(i, [&](auto const& shape) { chords_of(shape, chords_); });
  ++counts_.occluders;
  for (std::size_t f = 0; f < frames_.size(); ++f)
    counts_.pixels += writer_.write(chords_, bounds, frames_[f], maps_[f], refined_.empty() ? nullptr : &refined_[f],
                                    blocks ? nullptr : &owner);
  return true;
}

std::vector<std::uint32_t> Search::triangles_of(std::vector<std::uint32_t> const& objects)
{
  std::vector<std::uint32_t> out;
  Scene const& scene = scene_->scene();
  for (auto const o : objects)
    for (auto i = scene.objects[o].triangles.first; i < scene.objects[o].triangles.last; ++i)
      if (is_polygon_visible(scene.triangle(i).vertices)) out.push_back(i);
  return out;
}

}  // namespace visibility::ray_space
