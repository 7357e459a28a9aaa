#include "methods.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/methods/ray_space/method.hpp"
#include "visibility/methods/sampling/method.hpp"
#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/moving_objects.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <tuple>

namespace visibility::commands {

std::vector<std::string> applicable_methods(Scene const& scene)
{
  auto names = method_names();
  bool const moves = std::ranges::any_of(scene.objects, [](Object const& o) { return !o.occludes; });
  if (!scene.balls.empty() || HeightField(moves ? split(scene).first : scene).raised() > 0)
    std::erase(names, "exact-2.5d");
  if (moves) std::erase(names, "sampling");
  return names;
}

namespace {

template <Arithmetic A>
std::vector<CellSet> refine_strong_occlusion(strong_occlusion::Options fine, strong_occlusion::Granularity coarse,
                                             PreparedScene const& scene, Partition const& partition,
                                             std::function<void(std::uint64_t)> const& progress)
{
  std::vector<StrongOcclusion<A>> methods(partition.levels(), StrongOcclusion<A>(fine));
  fine.granularity = std::min(fine.granularity, coarse);
  std::fill(methods.begin(), methods.end() - 1, StrongOcclusion<A>(fine));
  return std::move(visibility::refine(scene, partition, methods, [&](std::size_t) { progress(1); }).back());
}

/// The set of a query that runs on this thread alone, and which layers decided its signs.
template <class Query>
PotentiallyVisibleSet tallied(Query const& query)
{
  ThreadTally::reset();
  auto set = query();
  auto const& counts = ThreadTally::counts;
  set.statistics["signs_filter"] = double(counts.filter);
  set.statistics["signs_interval"] = double(counts.interval);
  set.statistics["signs_exact"] = double(counts.exact);
  return set;
}

/// Below what hangs over sight lines pass that a height field does not know.
void require_height_field(HeightField const& field)
{
  if (field.raised() == 0) return;
  throw BadInput(
    "--method exact-2.5d: " + std::to_string(field.raised()) +
    " objects have room below them (they hang over, lack a wall or end above the lowest point), so the scene "
    "is no height field; give --grounded to have everything below an upper surface count as solid");
}

/// Two sets of parts of a scene as one of the scene. `of_a`, `of_b`: positions of the parts' objects in it.
PotentiallyVisibleSet merged(PotentiallyVisibleSet a, std::vector<std::uint32_t> const& of_a, PotentiallyVisibleSet b,
                             std::vector<std::uint32_t> const& of_b)
{
  for (auto& o : a.visible) o = of_a[o];
  for (auto& w : a.witnesses) w.object = of_a[w.object];
  for (auto const o : b.visible) a.visible.push_back(of_b[o]);
  for (auto& w : b.witnesses) a.witnesses.push_back({of_b[w.object], std::move(w.from), std::move(w.to)});
  for (auto const& [name, x] : b.statistics) a.statistics["moving_" + name] = x;
  std::ranges::sort(a.visible);
  std::ranges::sort(a.witnesses, {}, &Witness::object);
  return a;
}

}  // namespace

MethodRunner::MethodRunner(MethodArguments arguments, Scene const& scene, Scene const* occludees)
  : arguments_(std::move(arguments))
{
  bool const moves = std::ranges::any_of(scene.objects, [](Object const& o) { return !o.occludes; });
  if (moves && arguments_.method == "sampling")
    throw BadInput("--moving does not apply to sampling, which sees only what occludes");
  if (arguments_.method == "exact-2.5d") {
    if (moves) split_off_moving(scene);
    height_field_.emplace(apart_ ? apart_->still : scene);
    require_height_field(*height_field_);
    if (apart_) occludees_.emplace(targets_.emplace(apart_->moving));
    if (occludees != nullptr) occludees_.emplace(targets_.emplace(*occludees));
  } else if (arguments_.method != "sampling" && !arguments_.no_inner_bodies) {
    scene_.emplace(scene, InnerBodyOptions{.shells = uses_slices(arguments_)});
  } else {
    scene_.emplace(scene);
  }
  if (arguments_.method == "sampling") rays_.emplace(*scene_);
}

void MethodRunner::split_off_moving(Scene const& scene)
{
  auto& apart = apart_.emplace();
  std::tie(apart.still, apart.moving) = split(scene);
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o)
    (scene.objects[o].occludes ? apart.still_objects : apart.moving_objects).push_back(o);
}

PotentiallyVisibleSet MethodRunner::operator()(ViewCell const& cell,
                                               std::function<void(std::uint64_t)> const& progress) const
{
  if (rays_)
    return Sampling(
      {.rays = arguments_.rays, .seconds = arguments_.seconds, .seed = arguments_.seed, .progress = progress})(*rays_,
                                                                                                               cell);
  auto set = one_cell(cell);
  progress(1);
  return set;
}

PotentiallyVisibleSet MethodRunner::one_cell(ViewCell const& cell) const
{
  if (height_field_) return exact_25d(cell);
  if (arguments_.method == "occlusion-sweep") return OcclusionSweep(projection_options(arguments_))(*scene_, cell);
  if (arguments_.method == "extended-projection")
    return ExtendedProjection(projection_options(arguments_))(*scene_, cell);
  if (arguments_.method == "ray-space") return RaySpace(ray_space_options(arguments_))(*scene_, cell);
  return strong_occlusion(cell);
}

template <Arithmetic A>
PotentiallyVisibleSet MethodRunner::exact_25d(ViewCell const& cell) const
{
  exact_25d::Options options;
  options.witnesses = arguments_.witnesses;
  Exact25d<A> const method(options);
  if (apart_)
    return merged(method(*height_field_, cell), apart_->still_objects, method(*height_field_, *occludees_, cell),
                  apart_->moving_objects);
  return occludees_ ? method(*height_field_, *occludees_, cell) : method(*height_field_, cell);
}

PotentiallyVisibleSet MethodRunner::exact_25d(ViewCell const& cell) const
{
  require_above_ground(cell);
  if (arguments_.tally) return tallied([&] { return exact_25d<TalliedFiltered>(cell); });
  if (arguments_.arithmetic == "rational") return exact_25d<Rational>(cell);
  if (arguments_.arithmetic == "double") return exact_25d<Double>(cell);
  return exact_25d<Filtered>(cell);
}

std::pair<PotentiallyVisibleSet, exact_25d::Explanation> MethodRunner::explain(ViewCell const& cell) const
{
  require_above_ground(cell);
  exact_25d::Options options;
  options.witnesses = arguments_.witnesses;
  if (arguments_.arithmetic == "rational") return Exact25d<Rational>(options).explain(*height_field_, cell);
  return Exact25d<Filtered>(options).explain(*height_field_, cell);
}

void MethodRunner::require_above_ground(ViewCell const& cell) const
{
  if (cell.bounds().min.z < height_field_->ground())
    throw BadInput("--method exact-2.5d: a cell reaches below the lowest point of the scene, z = " +
                   std::to_string(height_field_->ground()));
}

PotentiallyVisibleSet MethodRunner::strong_occlusion(ViewCell const& cell) const
{
  auto const options = strong_occlusion_options(arguments_);
  if (arguments_.tally) return tallied([&] { return StrongOcclusion<TalliedFiltered>(options)(*scene_, cell); });
  if (arguments_.arithmetic == "rational") return StrongOcclusion<Rational>(options)(*scene_, cell);
  if (arguments_.arithmetic == "double") return StrongOcclusion<Double>(options)(*scene_, cell);
  return StrongOcclusion<Filtered>(options)(*scene_, cell);
}

std::vector<CellSet> MethodRunner::refine(Partition const& partition,
                                          std::function<void(std::uint64_t)> const& progress) const
{
  if (arguments_.method != "strong-occlusion")
    throw BadInput("--method " + arguments_.method + " cannot refine cells: give --cell-size once");
  if (arguments_.tally) throw BadInput("--tally counts cell by cell: give --cell-size once");
  auto const options = strong_occlusion_options(arguments_);
  auto const coarse = strong_occlusion::granularity_from_string(arguments_.coarse_granularity);
  if (arguments_.arithmetic == "rational")
    return refine_strong_occlusion<Rational>(options, coarse, *scene_, partition, progress);
  if (arguments_.arithmetic == "double")
    return refine_strong_occlusion<Double>(options, coarse, *scene_, partition, progress);
  return refine_strong_occlusion<Filtered>(options, coarse, *scene_, partition, progress);
}

CellQuery MethodRunner::query() const
{
  if (arguments_.method == "sampling" || arguments_.arithmetic == "double")
    throw BadInput("sets of " + (rays_ ? "sampling" : std::string("--arithmetic double")) +
                   " may lack visible objects, and what is missing would be missing from all parts of a cell");
  if (arguments_.method == "extended-projection")
    return cell_query(*scene_, ExtendedProjection(projection_options(arguments_)));
  if (arguments_.method == "occlusion-sweep")
    return cell_query(*scene_, OcclusionSweep(projection_options(arguments_)));
  if (arguments_.method == "strong-occlusion") {
    auto const options = strong_occlusion_options(arguments_);
    if (arguments_.arithmetic == "rational") return cell_query(*scene_, StrongOcclusion<Rational>(options));
    return cell_query(*scene_, StrongOcclusion<Filtered>(options));
  }
  return [this](ViewCell const& cell, ParentCell const*) { return std::pair(one_cell(cell), CellState()); };
}

std::uint64_t MethodRunner::steps_per_cell() const { return rays_ ? arguments_.rays : 1; }

}  // namespace visibility::commands
