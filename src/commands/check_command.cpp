#include "commands.hpp"
#include "count_option.hpp"
#include "progress.hpp"
#include "scene_argument.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/evidence/check_occludees.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/result_file.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>

#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>

namespace visibility::commands {

namespace {

struct Arguments {
  SceneArgument scene;
  std::string results;
  CheckOptions options;
  bool all = false;
};

std::string text(Point3q const& p)
{
  std::ostringstream out;
  out << std::setprecision(17) << '(' << CGAL::to_double(p.x) << ", " << CGAL::to_double(p.y) << ", "
      << CGAL::to_double(p.z) << ')';
  return out.str();
}

void print_report(Scene const& scene, CheckReport const& report, std::size_t most)
{
  std::cout << "rays " << report.rays << " in " << std::fixed << std::setprecision(2) << report.seconds << " s, hit "
            << report.objects_seen << " objects (in single precision); " << report.rejected
            << " proposals refused by the exact test\n";
  std::cout << "missing " << report.missing.size() << '\n';
  std::size_t printed = 0;
  for (auto const i : report.missing) {
    if (printed++ == most) {
      std::cout << "  ... and " << report.missing.size() - most << " more (--all lists them)\n";
      break;
    }
    std::cout << "  " << scene.objects[i].name;
    auto const w = std::ranges::find(report.witnesses, i, &Witness::object);
    if (w == report.witnesses.end())
      std::cout << ": meets the closed cell\n";
    else
      std::cout << ": seen from " << text(w->from) << " at " << text(w->to) << '\n';
  }
  if (!report.unseen.empty())
    std::cout << "members that no ray saw (information, no fault): " << report.unseen.size() << '\n';
}

void run(Arguments const& a, int& exit_code)
{
  auto const results = read_results(a.results);
  if (!a.scene.grounded && std::ranges::any_of(results, &Result::grounded))
    throw BadInput(a.results + ": the set is of the grounded scene: add --grounded");
  std::string const apart = results.empty() ? "" : results.front().occludees;
  if (std::ranges::any_of(results, [&](Result const& r) { return r.occludees != apart; }))
    throw BadInput(a.results + ": results for different occludees; give them one by one");
  Scene const scene = a.scene.load();
  PreparedScene const prepared(scene);
  RayScene const rays(prepared);
  std::optional<Scene> other;
  std::optional<PreparedScene> targets;
  std::optional<Occludees> occludees;
  if (!apart.empty()) occludees.emplace(targets.emplace(other.emplace(a.scene.load_another(apart))));
  Scene const& looked_for = other ? *other : scene;
  for (auto const& r : results) {
    auto const members = objects_of(r, looked_for);
    std::cout << "set     " << members.size() << " of " << looked_for.objects.size() << " objects, "
              << (r.method.empty() ? "unnamed method" : r.method) << ", " << to_string(r.guarantee) << '\n';
    auto const report = [&] {
      Progress progress("rays", a.options.rays);
      CheckOptions options = a.options;
      options.progress = [&](std::uint64_t n) { progress.advance(n); };
      return occludees ? check(rays, *occludees, cell_of(r), members, r.guarantee, options)
                       : check(rays, cell_of(r), members, r.guarantee, options);
    }();
    print_report(looked_for, report, a.all ? SIZE_MAX : 10);
    if (report.fault) {
      exit_code = 1;
      std::cout << "FAULT: a " << to_string(r.guarantee) << " set lacks visible objects\n";
    } else {
      std::cout << "no fault found\n";
    }
  }
}

}  // namespace

void add_check(CLI::App& app, int& exit_code)
{
  auto const a = std::make_shared<Arguments>();
  auto* const command = app.add_subcommand(
    "check", "Hunt for visible objects that a set lacks; exit code 1 if a set that claims to hold all lacks one");
  a->scene.add_to(*command);
  command->add_option("PVS", a->results, "result file of any implementation")->required();
  add_count_option(*command, "--rays", a->options.rays, "rays per cell (default 10000000)");
  command->add_option("--seconds", a->options.seconds, "stop after this time (default 0: no limit)")
    ->check(CLI::NonNegativeNumber);
  command->add_option("--seed", a->options.seed, "seed (default 1)");
  command->add_option("--threads", a->options.threads, "threads (default 0: all cores)")->check(CLI::NonNegativeNumber);
  command->add_flag("--all", a->all, "list every missing object");
  command->callback([a, &exit_code] { run(*a, exit_code); });
}

}  // namespace visibility::commands
