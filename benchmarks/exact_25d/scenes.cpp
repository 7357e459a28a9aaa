#include "scenes.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/scene/read_scene.hpp"

#include <array>
#include <filesystem>
#include <random>
#include <span>
#include <stdexcept>

namespace visibility::bench::exact_25d {

namespace {

double uniform(std::mt19937_64& engine, double lo, double hi)
{
  return lo + (hi - lo) * (static_cast<double>(engine() >> 11) * 0x1p-53);
}

using Base = std::array<Point3d, 4>;  // counterclockwise in plan

/// Whether an edge of a has all of b strictly outside. Requires: a counterclockwise in plan.
bool an_edge_separates(std::span<Point3d const> a, std::span<Point3d const> b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    auto const p = horizontal(a[i]), q = horizontal(a[(i + 1) % a.size()]);
    if (std::ranges::all_of(b, [&](Point3d const& r) { return is_negative(orient2d<Filtered>(p, q, horizontal(r))); }))
      return true;
  }
  return false;
}

/// Whether no column meets the closed base.
bool is_free(HeightField const& field, Base const& base)
{
  Box shaft;
  for (auto const& p : base) shaft.extend(p);
  shaft.min.z = HeightField::bottomless;
  return !field.column_hierarchy().any_item_meeting(shaft, [&](std::uint32_t i) {
    auto const corners = field.corners(field.columns()[i]);
    return !(corners.size() > 2 && an_edge_separates(corners, base)) && !an_edge_separates(base, corners);
  });
}

/// Unit vector along a random edge of the object in plan.
Point2d direction(std::mt19937_64& engine, HeightField const& field, std::uint32_t object)
{
  auto const edges = field.edges();
  auto const [first, last] =
    std::ranges::equal_range(edges, object, {}, [&](HeightField::TopEdge const& e) { return field.object_of(e); });
  if (first == last) return {1, 0};
  auto const& e = *(first + static_cast<std::ptrdiff_t>(engine() % static_cast<std::uint64_t>(last - first)));
  double const x = e.b.x - e.a.x, y = e.b.y - e.a.y, length = std::hypot(x, y);
  return length > 0 ? Point2d{x / length, y / length} : Point2d{1, 0};
}

}  // namespace

std::string to_string(Paper p)
{
  switch (p) {
  case Paper::vienna: return "Vienna";
  case Paper::atlanta: return "Atlanta";
  case Paper::city: return "City";
  case Paper::random: return "Random";
  }
  return "";
}

std::string big_city(Size size) { return size == Size::full ? "gen:city,n=187750" : "gen:city,n=300"; }

std::vector<Source> sources(Size size)
{
  if (size == Size::smoke)
    return {{"gen:city,n=200,base=40,street=11.6,low=12,high=25", Paper::vienna},
            {"gen:city,n=300,base=20,street=23.4,low=4,high=30", Paper::atlanta},
            {big_city(size), Paper::city},
            {"gen:slanted,n=200", Paper::random}};
  return {{"gen:city,n=3000,base=40,street=11.6,low=12,high=25", Paper::vienna},
          {"city/tokyo_chuo.geojsonl.gz", Paper::vienna},
          {"city/munich.ply", Paper::vienna},
          {"gen:city,n=17000,base=20,street=23.4,low=4,high=30", Paper::atlanta},
          {"city/rotterdam_centre.ply", Paper::atlanta},
          {"city/lower_manhattan.ply", Paper::atlanta},
          {big_city(size), Paper::city},
          {"gen:slanted", Paper::random}};
}

Model::Model(std::string model_name, Scene s) : name(std::move(model_name)), scene(std::move(s))
{
  build_seconds = median_seconds<ProcessorClock>(1, 0, [&] { field = std::make_unique<HeightField>(scene); });
}

std::unique_ptr<Model> load(std::string const& name)
{
  if (name.starts_with("gen:")) return std::make_unique<Model>(name, generate(name.substr(4)));
  auto const path = std::filesystem::path(VISIBILITY_SCENES_DIR) / name;
  if (!std::filesystem::exists(path)) return nullptr;
  ReadOptions options;
  if (name.ends_with(".ply")) options.object_property = "building";
  return std::make_unique<Model>(name.substr(name.find('/') + 1), read_scene(path, options));
}

void for_each_model(Size size, std::vector<std::string>& notes,
                    std::function<void(Source const&, Model const&)> const& run)
{
  for (auto const& source : sources(size)) {
    if (auto const model = load(source.name))
      run(source, *model);
    else
      notes.push_back(source.name + " is not there");
  }
}

double street_width(Paper p)
{
  switch (p) {
  case Paper::vienna: return 8;
  case Paper::atlanta: return 15;
  case Paper::city: return 50;
  case Paper::random: return 9;
  }
  return 0;
}

std::vector<ViewCell> free_cells(HeightField const& field, CellShape const& shape, int count, std::uint64_t seed)
{
  std::mt19937_64 engine(seed);
  auto const& scene = field.scene();
  Box const all = bounding_box(scene);
  auto const central = [](double v, double lo, double hi) { return std::fabs(2 * v - lo - hi) <= (hi - lo) / 2; };
  double const half_width = std::min(shape.width, shape.perimeter / 4) / 2;
  double const half_length = shape.perimeter / 4 - half_width, reach = 20 + half_width;
  std::vector<ViewCell> out;
  for (int attempt = 0; attempt < 100'000 && static_cast<int>(out.size()) < count; ++attempt) {
    auto const object = static_cast<std::uint32_t>(engine() % scene.objects.size());
    Box const near = bounding_box(scene, scene.objects[object]);
    double const x = uniform(engine, near.min.x - reach, near.max.x + reach);
    double const y = uniform(engine, near.min.y - reach, near.max.y + reach);
    if (!central(x, all.min.x, all.max.x) || !central(y, all.min.y, all.max.y)) continue;
    auto const [c, s] = direction(engine, field, object);
    auto const corner = [&](double u, double v) {
      return Point3d{x + u * half_length * c - v * half_width * s, y + u * half_length * s + v * half_width * c,
                     near.min.z};
    };
    Base const base{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    if (!is_free(field, base)) continue;
    std::vector<Point3d> corners(base.begin(), base.end());
    for (auto const& p : base) corners.push_back({p.x, p.y, p.z + shape.height});
    out.push_back(ViewCell::hull(corners));
  }
  return out;
}

PotentiallyVisibleSet exact_set(HeightField const& field, ViewCell const& cell)
{
  auto set = Exact25d<>()(field, cell);
  if (set.guarantee != Guarantee::exact) throw std::runtime_error(field.scene().source + ": the answer is not exact");
  return set;
}

std::vector<std::uint32_t> difference(std::vector<std::uint32_t> const& a, std::vector<std::uint32_t> const& b)
{
  std::vector<std::uint32_t> out;
  std::ranges::set_difference(a, b, std::back_inserter(out));
  return out;
}

void Sums::add(PotentiallyVisibleSet const& set)
{
  for (auto const& [name, x] : set.statistics) add(name, x);
  add("visible", static_cast<double>(set.visible.size()));
  add("runs", 1);
}

double fitted_exponent(std::vector<std::pair<double, double>> const& points)
{
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (auto const& [px, py] : points) {
    double const x = std::log(px), y = std::log(py);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace visibility::bench::exact_25d
