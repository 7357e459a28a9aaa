#include "cell_arguments.hpp"
#include "commands.hpp"
#include "count_option.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scene_argument.hpp"
#include "sight_line_search.hpp"

#include "visibility/drawing/explained_picture.hpp"
#include "visibility/drawing/write_picture.hpp"
#include "visibility/methods/exact_25d/explanation_file.hpp"
#include "visibility/scene/result_file.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

namespace visibility::commands {

namespace {

struct Arguments {
  SceneArgument scene;
  std::string results, other, explanation, output, region, title;
  std::size_t index = 1;
  ExplanationShown shown;
  std::size_t sight_lines = 0;
  PictureStyle style;
};

enum class Format { svg, png };

Format format_of(std::string const& file)
{
  if (file.ends_with(".svg")) return Format::svg;
  if (file.ends_with(".png")) return Format::png;
  throw BadInput(file + ": a picture's name ends in .svg or .png");
}

/// The entry of a file that --index names, counted from 1. Throws BadInput if there is none.
template <class Entry>
Entry entry_of(std::vector<Entry> entries, std::size_t index, std::string const& file)
{
  if (index < 1 || index > entries.size())
    throw BadInput("--index " + std::to_string(index) + ": " + file + " has entries 1 to " +
                   std::to_string(entries.size()));
  return std::move(entries[index - 1]);
}

/// The same vertices, in any order.
bool same_cell(std::vector<Point3d> a, std::vector<Point3d> b)
{
  auto const before = [](Point3d const& p, Point3d const& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  std::ranges::sort(a, before);
  std::ranges::sort(b, before);
  return a == b;
}

void require_grounded(Arguments const& a, Result const& r, std::string const& file)
{
  if (r.grounded && !a.scene.grounded) throw BadInput(file + ": the set is of the grounded scene: add --grounded");
}

std::string method_of(Result const& r)
{
  return (r.method.empty() ? "unnamed method" : r.method) + " (" + to_string(r.guarantee) + ')';
}

void set_titles(PlanPicture& picture, Arguments const& a, Result const& first, std::optional<Result> const& second,
                Scene const& looked_for)
{
  picture.title = a.title;
  if (a.title.empty())
    picture.title =
      a.scene.scene.starts_with("gen:") ? a.scene.scene : std::filesystem::path(a.scene.scene).filename().string();
  std::string const of = " of " + std::to_string(looked_for.objects.size()) + " objects";
  picture.subtitle = second ? "A: " + method_of(first) + ", " + std::to_string(first.visible.size()) +
                                "; B: " + method_of(*second) + ", " + std::to_string(second->visible.size()) + of
                            : method_of(first) + ": " + std::to_string(first.visible.size()) + of + " visible";
}

PlanPicture make_picture(Arguments const& a)
{
  Result const result = entry_of(read_results(a.results), a.index, a.results);
  require_grounded(a, result, a.results);
  std::optional<Result> other;
  if (!a.other.empty()) {
    other = entry_of(read_results(a.other), a.index, a.other);
    require_grounded(a, *other, a.other);
    if (other->occludees != result.occludees || !same_cell(other->cell, result.cell))
      throw BadInput("--compare " + a.other + ": the two results are about different cells or occludees");
  }
  ViewCell const cell = cell_of(result);
  Scene const scene = a.scene.load();
  std::optional<Scene> occludees;
  if (!result.occludees.empty()) occludees = a.scene.load_another(result.occludees);
  Scene const& looked_for = occludees ? *occludees : scene;
  auto const visible = objects_of(result, looked_for);
  PreparedScene const prepared(looked_for);
  auto const roles = other ? plan_roles_of(prepared, cell, visible, objects_of(*other, looked_for))
                           : plan_roles_of(prepared, cell, visible);

  PlanPicture picture = plan_picture(cell, a.region.empty() ? default_region(looked_for, roles, cell)
                                                            : parse_plan_region("--region", a.region));
  if (occludees) add_objects(picture, scene, std::vector<PlanRole>(scene.objects.size(), PlanRole::occluder));
  add_objects(picture, looked_for, roles);
  set_titles(picture, a, result, other, looked_for);
  picture.sight_lines = sight_lines_of(result, a.sight_lines);
  if (picture.sight_lines.empty() && a.sight_lines > 0)
    picture.sight_lines = find_sight_lines(scene, occludees ? &prepared : nullptr, cell, visible, a.sight_lines);
  if (!a.explanation.empty()) {
    auto const explained = entry_of(exact_25d::read_explanations(a.explanation, scene), a.index, a.explanation);
    if (!same_cell(explained.cell, {cell.vertices().begin(), cell.vertices().end()}))
      throw BadInput("--explanation " + a.explanation + ": it is about another cell than the set");
    ExplanationShown shown = a.shown;
    shown.ground = bounding_box(scene).min.z;
    add_explanation(picture, explained.explanation, shown);
  }
  return picture;
}

void run(Arguments const& a)
{
  Format const format = format_of(a.output);
  if (a.explanation.empty() && a.shown.funnels + a.shown.shadows > 0)
    throw BadInput("--funnels and --shadows need --explanation FILE, which `pvs --explain FILE` writes");
  auto const picture = make_picture(a);
  write_output(a.output, format == Format::svg ? to_svg(picture, a.style) : to_png(picture, a.style));
  std::cout << a.output << ": " << picture.objects.size() << " objects drawn, " << picture.sight_lines.size()
            << " sight lines\n";
}

}  // namespace

void add_draw(CLI::App& app)
{
  auto const a = std::make_shared<Arguments>();
  auto* const command = app.add_subcommand("draw", "A picture of a set: the scene from above, as SVG or PNG");
  a->scene.add_to(*command);
  command->add_option("PVS", a->results, "result file")->required();
  command->add_option("-o,--output", a->output, "picture to write (.svg .png)")->required();
  command->add_option("--index", a->index, "which result of a file with several, from 1 (default 1)");
  command->add_option("--compare", a->other, "another result for the same cell: what only one of the two has");
  command->add_option("--explanation", a->explanation, "file of pvs --explain: visible parts of top edges");
  command->add_option("--funnels", a->shown.funnels, "with --explanation: so many funnels, deepest first (default 0)");
  command->add_option("--shadows", a->shown.shadows,
                      "with --explanation: shadows on the ground, nearest first (default 0)");
  command->add_option("--sight-lines", a->sight_lines,
                      "sight lines, spread over directions: the set's witnesses, or found by rays (default 0)");
  command->add_option("--region", a->region, "part to show, X0,Y0,X1,Y1 (default: the cell and all that is visible)")
    ->delimiter('\0');
  command->add_option("--size", a->style.size, "width in pixels (default 1000)")->check(CLI::Range(200, 20000));
  static std::map<std::string, PictureLabels> const labels{
    {"auto", PictureLabels::automatic}, {"off", PictureLabels::off}, {"on", PictureLabels::on}};
  command->add_option("--labels", a->style.labels, "names of objects: auto (where there are few), on or off")
    ->transform(CLI::CheckedTransformer(labels, CLI::ignore_case));
  command->add_option("--title", a->title, "title (default: the scene)");
  command->callback([a] { run(*a); });
}

}  // namespace visibility::commands
