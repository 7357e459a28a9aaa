#include "commands.hpp"
#include "count_option.hpp"
#include "progress.hpp"
#include "scene_argument.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/evidence/check_occludees.hpp"
#include "visibility/scene/moving_objects.hpp"
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

/// What is looked for apart from what hides.
struct Apart {
  explicit Apart(Scene s) : scene(std::move(s)), prepared(scene), occludees(prepared) {}
  Apart(Apart const&) = delete;
  Apart& operator=(Apart const&) = delete;

  Scene scene;
  PreparedScene prepared;
  Occludees occludees;
};

/// Hunts, prints what came out, and returns whether it is a fault.
template <class... Targets>
bool report_on(Arguments const& a, Result const& r, Scene const& looked_for, std::vector<std::uint32_t> const& members,
               RayScene const& rays, Targets const&... targets)
{
  std::cout << "set     " << members.size() << " of " << looked_for.objects.size() << " objects, "
            << (r.method.empty() ? "unnamed method" : r.method) << ", " << to_string(r.guarantee) << '\n';
  auto const report = [&] {
    Progress progress("rays", a.options.rays);
    CheckOptions options = a.options;
    options.progress = [&](std::uint64_t n) { progress.advance(n); };
    return check(rays, targets..., cell_of(r), members, r.guarantee, options);
  }();
  print_report(looked_for, report, a.all ? SIZE_MAX : 10);
  if (report.fault)
    std::cout << "FAULT: a " << to_string(r.guarantee) << " set lacks visible objects\n";
  else
    std::cout << "no fault found\n";
  return report.fault;
}

void run(Arguments const& a, int& exit_code)
{
  auto const results = read_results(a.results);
  if (!a.scene.grounded && std::ranges::any_of(results, &Result::grounded))
    throw BadInput(a.results + ": the set is of the grounded scene: add --grounded");
  if (auto const r = std::ranges::find_if(results, [](Result const& x) { return !x.moving.empty(); });
      a.scene.moving.empty() && r != results.end())
    throw BadInput(a.results + ": moving objects were looked for: add --moving " + r->moving);
  std::string const elsewhere = results.empty() ? "" : results.front().occludees;
  if (std::ranges::any_of(results, [&](Result const& r) { return r.occludees != elsewhere; }))
    throw BadInput(a.results + ": results for different occludees; give them one by one");
  Scene const scene = a.scene.load();
  std::optional<std::pair<Scene, Scene>> parts;
  if (!a.scene.moving.empty()) parts = split(scene);
  Scene const& still = parts ? parts->first : scene;
  PreparedScene const prepared(still);
  RayScene const rays(prepared);
  std::optional<Apart> apart;
  if (!elsewhere.empty())
    apart.emplace(a.scene.load_another(elsewhere));
  else if (parts)
    apart.emplace(parts->second);
  for (auto const& r : results) {
    auto members = objects_of(r, elsewhere.empty() ? scene : apart->scene);
    bool fault = false;
    if (elsewhere.empty()) {
      // What moves comes after the objects of the scene.
      auto const first = static_cast<std::uint32_t>(still.objects.size());
      auto const split_at = std::ranges::lower_bound(members, first);
      fault = report_on(a, r, still, {members.begin(), split_at}, rays);
      members.erase(members.begin(), split_at);
      for (auto& m : members) m -= first;
    }
    if (apart) fault = report_on(a, r, apart->scene, members, rays, apart->occludees) || fault;
    if (fault) exit_code = 1;
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
