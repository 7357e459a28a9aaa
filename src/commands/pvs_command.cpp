#include "cell_arguments.hpp"
#include "commands.hpp"
#include "methods.hpp"
#include "output.hpp"
#include "plan_map.hpp"
#include "progress.hpp"
#include "scene_argument.hpp"

#include "visibility/kernel/processor_seconds.hpp"
#include "visibility/methods/exact_25d/explanation_file.hpp"
#include "visibility/scene/result_file.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>
#include <tuple>

namespace visibility::commands {

namespace {

/// With more cells than this the summary shows their average only.
constexpr std::size_t most_lines = 20;

struct Arguments {
  SceneArgument scene;
  CellArguments cells;
  MethodArguments method;
  std::string output;
  unsigned threads = 0;
  bool map = false;
};

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// `scene`: of the objects that were looked for.
Result make_result(Arguments const& a, std::string const& source, Scene const& scene, ViewCell const& cell,
                   PotentiallyVisibleSet const& set)
{
  Result r;
  r.source = source;
  if (!a.method.occludees.empty()) r.occludees = scene.source;
  r.grounded = a.scene.grounded;
  r.moving = a.scene.moving;
  r.objects = scene.objects.size();
  r.primitives = scene.primitive_count();
  r.cell.assign(cell.vertices().begin(), cell.vertices().end());
  if (cell.is_box()) r.cell_box = cell.bounds();
  r.method = a.method.method;
  r.arithmetic = a.method.arithmetic;
  r.options = a.method.options();
  r.guarantee = set.guarantee;
  r.statistics = set.statistics;
  for (auto const i : set.visible) r.visible.push_back(scene.objects[i].name);
  std::ranges::sort(r.visible);
  for (auto const& w : set.witnesses) r.witnesses.push_back({scene.objects[w.object].name, w.from, w.to});
  std::ranges::sort(r.witnesses, {}, &NamedWitness::object);
  return r;
}

void print_summary(std::vector<Result> const& results, std::string const& file)
{
  Result const& first = results.front();
  std::cout << "scene   " << first.source << (first.grounded ? ", grounded" : "")
            << (first.occludees.empty() ? "" : ", occludees " + first.occludees) << ": " << first.objects
            << " objects, " << first.primitives << " primitives\n"
            << "method  " << first.method << ", " << first.arithmetic << " arithmetic: " << to_string(first.guarantee)
            << '\n';
  auto const percent_hidden = [&](double visible) {
    return 100.0 * (static_cast<double>(first.objects) - visible) / static_cast<double>(first.objects);
  };
  std::cout << std::fixed;
  if (results.size() <= most_lines) {
    for (auto const& r : results)
      std::cout << "visible " << r.visible.size() << " of " << r.objects << " (" << std::setprecision(2)
                << percent_hidden(static_cast<double>(r.visible.size())) << " % hidden) in " << std::setprecision(4)
                << r.seconds.query << " s\n";
  } else {
    double sum = 0, seconds = 0;
    std::size_t least = first.objects, most = 0;
    for (auto const& r : results) {
      sum += static_cast<double>(r.visible.size());
      seconds += r.seconds.query;
      least = std::min(least, r.visible.size());
      most = std::max(most, r.visible.size());
    }
    double const n = static_cast<double>(results.size());
    std::cout << "cells   " << results.size() << ", visible on average " << std::setprecision(1) << sum / n << " of "
              << first.objects << " (" << std::setprecision(2) << percent_hidden(sum / n) << " % hidden), " << least
              << " to " << most << ", in " << std::setprecision(4) << seconds / n << " s a cell\n";
  }
  std::cout << "read " << std::setprecision(3) << first.seconds.read << " s, built " << first.seconds.build
            << " s\nwritten to " << file << '\n';
}

/// Cells, and what the method says of each.
struct Answers {
  std::vector<ViewCell> cells;
  std::vector<CellSet> sets;
  std::vector<exact_25d::Explanation> explanations{};  ///< if they were asked for
  std::vector<double> processor_seconds{};             ///< unless the sets were refined
};

Answers one_by_one(MethodRunner const& method, std::vector<ViewCell> cells, bool explain)
{
  Answers out{std::move(cells), {}};
  out.sets.resize(out.cells.size());
  out.processor_seconds.resize(out.cells.size());
  if (explain) out.explanations.resize(out.cells.size());
  Progress progress(method.steps_per_cell() > 1 ? "rays" : "cells", out.cells.size() * method.steps_per_cell());
  oneapi::tbb::parallel_for(std::size_t{0}, out.cells.size(), [&](std::size_t i) {
    auto const start = std::chrono::steady_clock::now();
    double const busy = thread_seconds();
    if (explain) {
      std::tie(out.sets[i].set, out.explanations[i]) = method.explain(out.cells[i]);
      progress.advance(1);
    } else {
      out.sets[i].set = method(out.cells[i], [&](std::uint64_t n) { progress.advance(n); });
    }
    out.sets[i].seconds = seconds_since(start);
    out.processor_seconds[i] = thread_seconds() - busy;
  });
  return out;
}

std::vector<ViewCell> finest_cells(Partition const& partition)
{
  std::size_t const finest = partition.levels() - 1;
  std::vector<ViewCell> cells;
  for (std::size_t i = 0; i < partition.cell_count(finest); ++i) cells.emplace_back(partition.cell(finest, i));
  return cells;
}

Answers coarse_to_fine(MethodRunner const& method, Partition const& partition)
{
  std::size_t total = 0;
  for (std::size_t level = 0; level < partition.levels(); ++level) total += partition.cell_count(level);
  Progress progress("cells", total);
  auto sets = method.refine(partition, [&](std::uint64_t n) { progress.advance(n); });
  return {finest_cells(partition), std::move(sets)};
}

void run(Arguments const& a)
{
  a.method.validate();
  if (!a.scene.moving.empty() && !(a.method.occludees.empty() && a.method.explain.empty()))
    throw BadInput("--moving and " + std::string(a.method.explain.empty() ? "--occludees" : "--explain") +
                   " do not go together: give one of them");
  auto const partition = a.cells.partition();
  auto cells = partition ? std::vector<ViewCell>{} : a.cells.load();
  auto start = std::chrono::steady_clock::now();
  Scene const scene = a.scene.load();
  std::optional<Scene> occludees;
  if (!a.method.occludees.empty()) occludees = a.scene.load_another(a.method.occludees);
  Scene const& looked_for = occludees ? *occludees : scene;
  double const read = seconds_since(start);
  start = std::chrono::steady_clock::now();
  double const busy = process_seconds();
  MethodRunner const method(a.method, scene, occludees ? &*occludees : nullptr);
  double const build = seconds_since(start), build_processor = process_seconds() - busy;

  unsigned const threads = a.threads != 0 ? a.threads : std::max(1U, std::thread::hardware_concurrency());
  oneapi::tbb::global_control const limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
  auto const answers =
    partition && partition->levels() > 1
      ? coarse_to_fine(method, *partition)
      : one_by_one(method, partition ? finest_cells(*partition) : std::move(cells), !a.method.explain.empty());
  std::vector<Result> results;
  for (std::size_t i = 0; i < answers.cells.size(); ++i) {
    results.push_back(make_result(a, scene.source, looked_for, answers.cells[i], answers.sets[i].set));
    results.back().seconds = {read, build, answers.sets[i].seconds,
                              answers.processor_seconds.empty() ? 0 : answers.processor_seconds[i], build_processor};
  }
  if (!a.method.explain.empty()) write_output(a.method.explain, to_json(scene, answers.cells, answers.explanations));
  if (a.output.empty()) {
    std::cout << to_json(results);
    return;
  }
  write_output(a.output, to_json(results));
  if (a.map)
    for (std::size_t i = 0; i < answers.cells.size(); ++i)
      std::cout << plan_map(looked_for, answers.cells[i], answers.sets[i].set)
                << "# visible  . hidden  C view cell\n\n";
  print_summary(results, a.output);
}

}  // namespace

void add_pvs(CLI::App& app)
{
  auto const a = std::make_shared<Arguments>();
  auto* const command = app.add_subcommand("pvs", "The potentially visible set of each view cell");
  a->scene.add_to(*command);
  a->cells.add_to(*command);
  a->method.add_to(*command);
  command->add_option("-o,--output", a->output, "result file (default: standard output)");
  command->add_option("--threads", a->threads, "threads over cells and rays (default: all cores)");
  command->add_flag("--map", a->map, "with -o: also print a plan of the scene with the set");
  command->callback([a] { run(*a); });
}

}  // namespace visibility::commands
