#include "cell_arguments.hpp"
#include "commands.hpp"
#include "count_option.hpp"
#include "methods.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scene_argument.hpp"

#include "visibility/scene/scene_builder.hpp"
#include "visibility/viewspace/sets_file.hpp"

#include <CLI/CLI.hpp>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <memory>
#include <thread>

namespace visibility::commands {

namespace {

struct Arguments {
  SceneArgument scene;
  CellArguments cells;
  MethodArguments method;
  PreprocessOptions options;
  std::string output;
  unsigned threads = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<ViewCell> initial_cells(CellArguments const& arguments)
{
  auto const partition = arguments.partition();
  if (!partition) return arguments.load();
  if (partition->levels() > 1)
    throw BadInput("preprocess divides cells by itself: give --cell-size once, for the initial cells");
  std::vector<ViewCell> cells;
  for (std::size_t i = 0; i < partition->cell_count(0); ++i) cells.emplace_back(partition->cell(0, i));
  return cells;
}

/// What the file says of all cells.
Result about(Arguments const& a, Scene const& scene, PreprocessedCells const& cells, std::size_t initial)
{
  Result r;
  r.source = scene.source;
  r.grounded = a.scene.grounded;
  r.moving = a.scene.moving;
  r.objects = scene.objects.size();
  r.primitives = scene.primitive_count();
  r.method = a.method.method;
  r.arithmetic = a.method.arithmetic;
  r.options = a.method.options();
  r.options["budget"] = std::to_string(a.options.budget);
  r.options["min-size"] = std::to_string(a.options.min_size);
  r.guarantee = cells.leaves.front().set.set.guarantee;
  r.statistics = {{"initial_cells", double(initial)},
                  {"cells", double(cells.leaves.size())},
                  {"evaluated_cells", double(cells.evaluated)}};
  return r;
}

void print_summary(StoredSets const& stored, PreprocessedCells const& cells, std::uint64_t budget,
                   std::string const& file, std::size_t bytes)
{
  Result const& r = stored.about;
  std::uint64_t all = 0;
  for (auto const n : stored.polygons) all += n;
  double visible = 0, polygons = 0;
  std::size_t over = 0;
  for (auto const& leaf : cells.leaves) {
    visible += static_cast<double>(leaf.set.set.visible.size());
    polygons += static_cast<double>(leaf.polygons);
    over += leaf.polygons > budget ? 1 : 0;
  }
  auto const n = static_cast<double>(cells.leaves.size());
  auto const sizes = stored_sizes(stored.sets);
  std::cout << "scene   " << r.source << (r.grounded ? ", grounded" : "")
            << (r.moving.empty() ? "" : ", moving " + r.moving) << ": " << r.objects << " objects, " << all
            << " polygons\nmethod  " << r.method << ", " << r.arithmetic << " arithmetic: " << to_string(r.guarantee)
            << "\ncells   " << r.statistics.at("initial_cells") << " initial, " << cells.leaves.size() << " now, "
            << cells.evaluated << " evaluated, " << over << " over the budget of " << budget << " polygons\n"
            << std::fixed << std::setprecision(1) << "visible on average " << visible / n << " objects, "
            << std::setprecision(0) << polygons / n << " polygons (" << std::setprecision(2)
            << 100 * (1 - polygons / n / static_cast<double>(std::max<std::uint64_t>(all, 1)))
            << " % of polygons hidden), " << std::setprecision(4)
            << cells.seconds / static_cast<double>(cells.evaluated) << " s a cell evaluated\nsets    "
            << sizes.differences << " bytes as differences, " << sizes.whole << " as whole sets; "
            << stored.sets.key_count() << " key cells\nread " << std::setprecision(3) << r.seconds.read << " s, built "
            << r.seconds.build << " s, preprocess " << r.seconds.query << " s\nwritten to " << file << " (" << bytes
            << " bytes)\n";
}

void run(Arguments const& a)
{
  a.method.validate();
  if (!a.method.occludees.empty() || !a.method.explain.empty() || a.method.witnesses)
    throw BadInput("preprocess keeps sets alone: leave out --occludees, --explain and --witnesses");
  if (!(a.options.min_size > 0)) throw BadInput("--min-size must be positive, in metres");
  auto const initial = initial_cells(a.cells);
  auto start = std::chrono::steady_clock::now();
  auto const moving = a.scene.load_moving();
  Scene const scene = a.scene.load(moving);
  auto const polygons = polygon_counts(scene, moving);
  double const read = seconds_since(start);
  start = std::chrono::steady_clock::now();
  MethodRunner const method(a.method, scene);
  auto const query = method.query();
  double const build = seconds_since(start);

  unsigned const threads = a.threads != 0 ? a.threads : std::max(1U, std::thread::hardware_concurrency());
  oneapi::tbb::global_control const limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
  start = std::chrono::steady_clock::now();
  auto const cells = [&] {
    Progress progress("cells", initial.size());
    return preprocess(query, initial, polygons, a.options, [&] { progress.advance(); });
  }();

  std::vector<ViewCell> leaves;
  std::vector<DeltaSets::Objects> sets;
  std::vector<std::uint32_t> origins;
  for (auto const& leaf : cells.leaves) {
    leaves.push_back(leaf.cell);
    sets.push_back(leaf.set.set.visible);
    origins.push_back(leaf.initial);
  }
  std::vector<std::string> names;
  for (auto const& o : scene.objects) names.push_back(o.name);
  auto const object_count = static_cast<std::uint32_t>(names.size());
  StoredSets stored{about(a, scene, cells, initial.size()), std::move(names), polygons, std::move(origins),
                    DeltaSets(std::move(leaves), sets, object_count)};
  stored.about.seconds = {read, build, seconds_since(start)};
  auto const bytes = to_bytes(stored);
  write_output(a.output, bytes);
  print_summary(stored, cells, a.options.budget, a.output, bytes.size());
}

}  // namespace

void add_preprocess(CLI::App& app)
{
  auto const a = std::make_shared<Arguments>();
  auto* const command = app.add_subcommand(
    "preprocess", "Sets of many cells in one file; cells that see too much are divided (recover gets them out)");
  a->scene.add_to(*command);
  a->cells.add_to(*command);
  a->method.add_to(*command);
  add_count_option(*command, "--budget", a->options.budget, "divide a cell that sees more polygons than this");
  command->get_option("--budget")->required();
  command->add_option("--min-size", a->options.min_size,
                      "but not into cells with a longest extent of less than this, metres (default 1)");
  command->add_option("-o,--output", a->output, "file of format visibility-sets/1")->required();
  command->add_option("--threads", a->threads, "threads over cells (default: all cores)");
  command->callback([a] { run(*a); });
}

}  // namespace visibility::commands
