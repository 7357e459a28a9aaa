#include "cell_arguments.hpp"
#include "commands.hpp"
#include "methods.hpp"
#include "output.hpp"
#include "plan_map.hpp"
#include "progress.hpp"
#include "scene_argument.hpp"

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
#include <thread>

namespace visibility::commands {

namespace {

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

Result make_result(Arguments const& a, PreparedScene const& scene, ViewCell const& cell,
                   PotentiallyVisibleSet const& set)
{
  Result r;
  r.source = scene.scene().source;
  r.objects = scene.scene().objects.size();
  r.primitives = scene.scene().primitive_count();
  r.cell.assign(cell.vertices().begin(), cell.vertices().end());
  if (cell.is_box()) r.cell_box = cell.bounds();
  r.method = a.method.method;
  r.arithmetic = a.method.arithmetic;
  r.options = a.method.options();
  r.guarantee = set.guarantee;
  r.statistics = set.statistics;
  for (auto const i : set.visible) r.visible.push_back(scene.scene().objects[i].name);
  std::ranges::sort(r.visible);
  for (auto const& w : set.witnesses) r.witnesses.push_back({scene.scene().objects[w.object].name, w.from, w.to});
  std::ranges::sort(r.witnesses, {}, &NamedWitness::object);
  return r;
}

void print_summary(std::vector<Result> const& results, std::string const& file)
{
  Result const& first = results.front();
  std::cout << "scene   " << first.source << ": " << first.objects << " objects, " << first.primitives
            << " primitives\n"
            << "method  " << first.method << ", " << first.arithmetic << " arithmetic: " << to_string(first.guarantee)
            << '\n';
  for (auto const& r : results) {
    double const percent = 100.0 * static_cast<double>(r.objects - r.visible.size()) / static_cast<double>(r.objects);
    std::cout << "visible " << r.visible.size() << " of " << r.objects << " (" << std::fixed << std::setprecision(2)
              << percent << " % hidden) in " << std::setprecision(4) << r.seconds.query << " s\n";
  }
  std::cout << "read " << std::setprecision(3) << first.seconds.read << " s, built " << first.seconds.build
            << " s\nwritten to " << file << '\n';
}

void run(Arguments const& a)
{
  a.method.validate();
  auto const cells = a.cells.load();
  auto start = std::chrono::steady_clock::now();
  Scene const scene = a.scene.load();
  double const read = seconds_since(start);
  start = std::chrono::steady_clock::now();
  PreparedScene const prepared(scene);
  MethodRunner const method(a.method, prepared);
  double const build = seconds_since(start);

  unsigned const threads = a.threads != 0 ? a.threads : std::max(1U, std::thread::hardware_concurrency());
  oneapi::tbb::global_control const limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
  std::vector<Result> results(cells.size());
  std::vector<std::string> maps(a.map ? cells.size() : 0);
  {
    Progress progress(method.steps_per_cell() > 1 ? "rays" : "cells", cells.size() * method.steps_per_cell());
    oneapi::tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t i) {
      auto const query_start = std::chrono::steady_clock::now();
      auto const set = method(cells[i], [&](std::uint64_t n) { progress.advance(n); });
      double const query = seconds_since(query_start);
      results[i] = make_result(a, prepared, cells[i], set);
      results[i].seconds = {read, build, query};
      if (a.map) maps[i] = plan_map(prepared, cells[i], set);
    });
  }
  if (a.output.empty()) {
    std::cout << to_json(results);
    return;
  }
  write_output(a.output, to_json(results));
  for (auto const& map : maps) std::cout << map << "# visible  . hidden  C view cell\n\n";
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
