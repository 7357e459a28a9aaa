#include "scenes.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/scene/read_scene.hpp"

#include <filesystem>
#include <random>
#include <stdexcept>

namespace visibility::bench::exact_25d {

namespace {

double uniform(std::mt19937_64& engine, double lo, double hi)
{
  return lo + (hi - lo) * (static_cast<double>(engine() >> 11) * 0x1p-53);
}

/// Whether no column meets the closed base.
bool is_free(HeightField const& field, Box const& base)
{
  Box shaft = base;
  shaft.min.z = HeightField::bottomless;
  auto const& columns = field.columns();
  return !field.column_hierarchy().any_item_meeting(shaft, [&](std::uint32_t i) {
    auto const corners = field.corners(columns[i]);
    if (corners.size() < 3) return true;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      auto const a = horizontal(corners[k]), b = horizontal(corners[(k + 1) % corners.size()]);
      bool outside = true;
      for (int c = 0; c < 4; ++c)
        outside = outside && is_negative(orient2d<Filtered>(a, b, horizontal(base.corner(c))));
      if (outside) return false;
    }
    return true;
  });
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
  build_seconds = median_seconds(1, 0, [&] { field = std::make_unique<HeightField>(scene); });
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

std::vector<ViewCell> free_cells(HeightField const& field, double perimeter, double height, int count,
                                 std::uint64_t seed)
{
  std::mt19937_64 engine(seed);
  auto const& scene = field.scene();
  Box const all = bounding_box(scene);
  double const side = perimeter / 4;
  std::vector<ViewCell> out;
  for (int attempt = 0; attempt < 100'000 && static_cast<int>(out.size()) < count; ++attempt) {
    Box const near = bounding_box(scene, scene.objects[engine() % scene.objects.size()]);
    double const x = uniform(engine, near.min.x - 20 - side, near.max.x + 20);
    double const y = uniform(engine, near.min.y - 20 - side, near.max.y + 20);
    auto const central = [](double v, double lo, double hi) { return std::fabs(2 * v - lo - hi) <= (hi - lo) / 2; };
    if (!central(x, all.min.x, all.max.x) || !central(y, all.min.y, all.max.y)) continue;
    Box const cell{{x, y, near.min.z}, {x + side, y + side, near.min.z + height}};
    if (is_free(field, cell)) out.emplace_back(cell);
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
