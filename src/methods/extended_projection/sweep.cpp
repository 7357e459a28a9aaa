#include "visibility/methods/extended_projection/sweep.hpp"

#include "visibility/methods/extended_projection/occluder_projector.hpp"
#include "visibility/methods/extended_projection/occluder_selection.hpp"
#include "visibility/methods/extended_projection/plane_choice.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace visibility {

namespace {

using namespace extended_projection;

constexpr int default_planes = 15;

/// Of the distances of a plane and the next, unless their number would not reach the end of the scene. The formula of
/// the paper knows no bound, and sends the second plane out of the scene if the cell is small against its distance.
constexpr double widest_ratio = 1.4;

/// How many occluders are added to a map before its pyramid is brought up to date.
constexpr std::size_t refresh_after = 64;

/// So many occluders tell where the first plane stands.
constexpr std::size_t most_important = 200;

/// Objects of more bodies are tested as a whole only.
constexpr std::size_t most_parts = 64;

/// One sweep after the other over one scene; what is hidden stays so.
class Sweeps {
public:
  Sweeps(PreparedScene const& scene, ViewCell const& cell, Options const& options)
    : scene_(scene), cell_(cell), options_(options), projector_(scene, cell),
      important_(select_occluders(scene, cell, most_important)), hidden_nodes_(scene.object_hierarchy().nodes().size()),
      hidden_(scene.scene().objects.size())
  {
  }

  void run(Frame const& frame)
  {
    CellViews const views(frame, cell_);
    std::optional<ProjectionMap> map;
    double before = views.near;
    for (double const plane : planes(views)) {
      auto const grid = choose_grid(views, plane);
      if (!grid) continue;
      if (map)
        map = ProjectionMap(*map, plane, *grid, options_.reprojection);
      else
        map.emplace(views, plane, *grid);
      ++plane_count_;
      map->refresh();
      add_occluders(*map, before);
      map->refresh();
      if (!test(*map, before)) break;  // nothing is left behind the plane
      before = plane;
    }
  }

  PotentiallyVisibleSet result() const
  {
    PotentiallyVisibleSet set;
    set.guarantee = Guarantee::conservative;
    std::vector<bool> seen(hidden_.size());
    walk(
      scene_.object_hierarchy(), [](Box const&) { return true; }, [&](std::uint32_t o) { seen[o] = !hidden_[o]; });
    for (std::uint32_t o = 0; o < seen.size(); ++o)
      if (seen[o]) set.visible.push_back(o);
    set.statistics = {{"planes", double(plane_count_)},
                      {"occluders", double(occluders_)},
                      {"pixels", double(pixels_)},
                      {"boxes_tested", double(boxes_tested_)},
                      {"groups_hidden", double(groups_hidden_)}};
    return set;
  }

private:
  /// Where the planes stand: from just behind the first important occluder on, so far apart that the image of the cell
  /// is as many pixels as the kernel, by the formula of [Durand00, 5.2], but not farther than widest_ratio; farther if
  /// their number would not reach the end of the scene.
  std::vector<double> planes(CellViews const& views) const
  {
    std::vector<double> out;
    for (double const d : options_.distances) out.push_back(views.near + d);
    std::ranges::sort(out);
    if (!out.empty()) return out;
    double const last = views.frame(scene_.object_hierarchy().nodes()[0].bounds).max.z - views.near;
    double const size = std::max(views.bounds.max.x - views.bounds.min.x, views.bounds.max.y - views.bounds.min.y);
    double first = HUGE_VAL;
    for (auto const o : important_) {
      Box const b = views.frame(scene_.occluders().bounds()[o]);
      double const d = b.max.z - views.near;
      Rectangle const r = extended_rectangle(views, b.max.z, options_.extent);
      if (d > 0 && common(r, {{b.min.x, b.min.y}, {b.max.x, b.max.y}}).area() > 0) first = std::min(first, d);
    }
    if (!(first < last)) return out;
    int const count = options_.planes > 0 ? options_.planes : default_planes;
    first = std::max(first, size);
    double const least_ratio = std::pow(last / first, 1.0 / count);
    for (double d = first; static_cast<int>(out.size()) < count && d < last;) {
      out.push_back(views.near + d);
      double const plane_size = size + 2 * options_.extent * d;
      double const step = d * (options_.kernel - 1) * plane_size / (size * options_.resolution);
      d = std::max(std::min(d + step, widest_ratio * d), d * least_ratio);
    }
    return out;
  }

  /// The part of the plane that sight lines to what is behind it pass: within the heights of scene and cell.
  std::optional<Grid> choose_grid(CellViews const& views, double plane) const
  {
    Rectangle r = extended_rectangle(views, plane, options_.extent);
    if (views.frame.has_vertical_v()) {
      Box const all = views.frame(scene_.object_hierarchy().nodes()[0].bounds);
      double const low = std::min(all.min.y, views.bounds.min.y), high = std::max(all.max.y, views.bounds.max.y);
      r = common(r, {{-HUGE_VAL, low - 0.03 * (high - low)}, {HUGE_VAL, high + 0.03 * (high - low)}});
    }
    return raster_over(r, options_.resolution);
  }

  /// Those with a part between the plane before and this one; of them all that is before this one.
  void add_occluders(ProjectionMap& map, double before)
  {
    auto const& frame = map.cell().frame;
    auto const& occluders = scene_.occluders();
    auto const is_between = [&](Box const& box) {
      Box const b = frame(box);
      return b.max.z > before && b.min.z < map.plane();
    };
    walk(scene_.object_hierarchy(), is_between, [&](std::uint32_t object) {
      if (hidden_[object]) return;
      auto const range = worthwhile_occluders(scene_, cell_, object);
      for (auto o = range.first; o < range.last; ++o) {
        if (!is_between(occluders.bounds()[o]) || !map.seems_useful(frame(occluders.bounds()[o]))) continue;
        if (!blocks(scene_, cell_, o)) continue;
        ++occluders_;
        pixels_ += projector_.add(o, map, map.plane());
        if (occluders_ % refresh_after == 0) map.refresh();
      }
    });
  }

  /// Tests what is behind the plane before; returns whether anything is left behind this one.
  bool test(ProjectionMap const& map, double before)
  {
    bool left = false;
    auto const hides = [&](Box const& box) {
      Box const b = map.cell().frame(box);
      if (b.min.z < before) return false;
      ++boxes_tested_;
      return map.hides(b) || (options_.improved && cell_.is_box() && map.hides_improved(b));
    };
    auto const& hierarchy = scene_.object_hierarchy();
    walk_nodes(
      hierarchy,
      [&](std::uint32_t node, Box const& box) {
        if (map.cell().frame(box).max.z <= before) return false;
        if (!hides(box)) return true;
        hidden_nodes_[node] = true;
        ++groups_hidden_;
        return false;
      },
      [&](std::uint32_t o) {
        if (hidden_[o]) return;
        Box const& box = scene_.object_bounds()[o];
        auto const parts = scene_.bodies().bounds_of(o);
        hidden_[o] =
          hides(box) || (parts.size() > 1 && parts.size() <= most_parts && std::ranges::all_of(parts, hides));
        left = left || (!hidden_[o] && map.cell().frame(box).max.z > map.plane());
      });
    return left;
  }

  /// Visits nodes that are not hidden. Nodes of the hierarchy of objects have the same numbers in the other.
  template <class Enter, class Visit>
  void walk_nodes(BoundingHierarchy const& hierarchy, Enter&& enter, Visit&& visit) const
  {
    hierarchy.front_to_back(
      cell_.bounds(),
      [&](std::uint32_t node, Box const& box) {
        return (node >= hidden_nodes_.size() || !hidden_nodes_[node]) && enter(node, box);
      },
      visit);
  }
  template <class Enter, class Visit>
  void walk(BoundingHierarchy const& hierarchy, Enter&& enter, Visit&& visit) const
  {
    walk_nodes(
      hierarchy, [&](std::uint32_t, Box const& box) { return enter(box); }, visit);
  }

  PreparedScene const& scene_;
  ViewCell const& cell_;
  Options const& options_;
  OccluderProjector projector_;
  std::vector<std::uint32_t> important_;
  std::vector<char> hidden_nodes_, hidden_;  // of objects
  std::size_t plane_count_ = 0, occluders_ = 0, boxes_tested_ = 0, groups_hidden_ = 0;
  std::int64_t pixels_ = 0;
};

}  // namespace

PotentiallyVisibleSet OcclusionSweep::operator()(PreparedScene const& scene, ViewCell const& cell) const
{
  Sweeps sweeps(scene, cell, options_);
  for (auto const& frame : frames) sweeps.run(frame);
  return sweeps.result();
}

}  // namespace visibility
