#include "commands.hpp"

#include "visibility/evidence/compare.hpp"
#include "visibility/scene/result_file.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace visibility::commands {

namespace {

bool is_superset(Guarantee g) { return g == Guarantee::exact || g == Guarantee::conservative; }
bool is_subset(Guarantee g) { return g == Guarantee::exact || g == Guarantee::aggressive; }

void print_names(std::string const& what, std::vector<std::string> const& names, std::size_t most)
{
  std::cout << what << ": " << names.size() << '\n';
  for (std::size_t i = 0; i < names.size() && i < most; ++i) std::cout << "  " << names[i] << '\n';
  if (names.size() > most) std::cout << "  ... and " << names.size() - most << " more (--all lists them)\n";
}

/// Prints one pair of results; returns whether their guarantees contradict each other.
bool print_comparison(Result const& a, Result const& b, std::size_t most)
{
  Comparison const c = compare(a.visible, b.visible);
  auto const describe = [](char const* which, Result const& r, std::size_t size) {
    std::cout << which << ": " << size << " objects, " << (r.method.empty() ? "unnamed method" : r.method) << ", "
              << to_string(r.guarantee) << '\n';
  };
  describe("A", a, c.size_a);
  describe("B", b, c.size_b);
  std::cout << "common: " << c.common << "\n|A| / |B|: " << c.overestimation() << "\n|A and B| / |B|: " << c.recall()
            << '\n';
  print_names("only in A", c.only_a, most);
  print_names("only in B", c.only_b, most);
  // A set that promises to hold all visible objects must contain one that promises to hold nothing else.
  bool const a_lacks = is_superset(a.guarantee) && is_subset(b.guarantee) && !c.only_b.empty();
  bool const b_lacks = is_superset(b.guarantee) && is_subset(a.guarantee) && !c.only_a.empty();
  if (a_lacks) std::cout << "FAULT: A is " << to_string(a.guarantee) << " and lacks objects of B\n";
  if (b_lacks) std::cout << "FAULT: B is " << to_string(b.guarantee) << " and lacks objects of A\n";
  return a_lacks || b_lacks;
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code)
{
  struct Arguments {
    std::string a, b;
    bool all = false;
  };
  auto const arguments = std::make_shared<Arguments>();
  auto* const command =
    app.add_subcommand("compare", "Two results side by side; exit code 1 if their guarantees clash");
  command->add_option("A", arguments->a, "result file")->required();
  command->add_option("B", arguments->b, "result file")->required();
  command->add_flag("--all", arguments->all, "list every difference");
  command->callback([arguments, &exit_code] {
    auto const a = read_results(arguments->a), b = read_results(arguments->b);
    if (a.size() != b.size())
      throw BadInput(arguments->a + " has " + std::to_string(a.size()) + " results, " + arguments->b + " has " +
                     std::to_string(b.size()) + ": compare files with the same cells");
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!a[i].cell.empty() && !b[i].cell.empty() && a[i].cell != b[i].cell)
        throw BadInput("result " + std::to_string(i + 1) + ": the two files are about different cells");
      if (a[i].grounded != b[i].grounded)
        std::cout << "note: only " << (a[i].grounded ? "A" : "B") << " is of the grounded scene\n";
      auto const looked_for = [](Result const& r) { return r.occludees.empty() ? r.source : r.occludees; };
      if (a[i].occludees != b[i].occludees && looked_for(a[i]) != looked_for(b[i]))
        std::cout << "note: A looks for " << looked_for(a[i]) << ", B for " << looked_for(b[i]) << '\n';
      if (print_comparison(a[i], b[i], arguments->all ? SIZE_MAX : 10)) exit_code = 1;
    }
  });
}

}  // namespace visibility::commands
