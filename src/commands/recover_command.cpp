#include "cell_arguments.hpp"
#include "commands.hpp"
#include "output.hpp"

#include "visibility/scene/scene_builder.hpp"
#include "visibility/viewspace/sets_file.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <optional>

namespace visibility::commands {

namespace {

struct Arguments {
  std::string file, output, at;
  std::optional<std::uint64_t> index;
  bool all = false;
};

std::size_t wanted_cell(Arguments const& a, DeltaSets const& sets)
{
  if (a.index) {
    if (*a.index >= sets.size())
      throw BadInput("--index " + std::to_string(*a.index) + ": " + a.file + " has cells 0 to " +
                     std::to_string(sets.size() - 1));
    return *a.index;
  }
  auto const cell = sets.cell_at(parse_point("--at", a.at));
  if (!cell) throw BadInput("--at " + a.at + ": no cell of " + a.file + " contains this point");
  return *cell;
}

void print_description(StoredSets const& stored)
{
  auto const sizes = stored_sizes(stored.sets);
  std::cout << stored.about.source << ", " << stored.about.method << ", " << to_string(stored.about.guarantee) << ": "
            << stored.sets.object_count() << " objects, " << stored.sets.size() << " cells, " << stored.sets.key_count()
            << " of them key cells; sets " << sizes.differences << " bytes as differences, " << sizes.whole
            << " as whole sets\n";
}

void run(Arguments const& a)
{
  int const ways = (a.at.empty() ? 0 : 1) + (a.index ? 1 : 0) + (a.all ? 1 : 0);
  if (ways != 1) throw BadInput("say which sets: one of --at X,Y,Z, --index K and --all");
  auto const stored = read_stored_sets(a.file);
  std::vector<Result> results;
  if (a.all) {
    auto const sets = stored.sets.all();
    for (std::size_t i = 0; i < sets.size(); ++i) results.push_back(stored.result(i, sets[i]));
  } else {
    results.push_back(stored.result(wanted_cell(a, stored.sets)));
  }
  if (a.output.empty()) {
    std::cout << to_json(results);
    return;
  }
  write_output(a.output, to_json(results));
  print_description(stored);
}

}  // namespace

void add_recover(CLI::App& app)
{
  auto const a = std::make_shared<Arguments>();
  auto* const command = app.add_subcommand("recover", "Sets out of a file of preprocess, as results that pvs writes");
  command->add_option("FILE", a->file, "file of format visibility-sets/1")->required();
  command->add_option("--at", a->at, "the cell that contains this point, X,Y,Z (metres)")
    ->allow_extra_args(false)
    ->delimiter('\0');
  command->add_option("--index", a->index, "the cell of this position, from 0");
  command->add_flag("--all", a->all, "all cells");
  command->add_option("-o,--output", a->output, "result file (default: standard output)");
  command->callback([a] { run(*a); });
}

}  // namespace visibility::commands
