#pragma once

#include "report.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace visibility::bench {

/// An experiment by the name that the command line gives it.
template <class Size>
using Experiment = std::pair<std::string, std::function<void(Report&, Size)>>;

/// The command line of a program of experiments: NAME... [--json FILE] [--smoke], where NAME is one of them or all.
/// Tables go to standard output, JSON to FILE. Returns the exit code: 1 if an experiment throws, 2 for bad arguments.
template <class Size>
int run_experiments(std::string const& subject, std::vector<Experiment<Size>> const& all, int argc, char** argv)
{
  auto size = Size::full;
  std::string const program = subject + "_bench";
  std::string json, command = program;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    command += std::string(" ") + argv[i];
    if (std::strcmp(argv[i], "--smoke") == 0)
      size = Size::smoke;
    else if (std::strcmp(argv[i], "--json") == 0 && i + 1 < argc)
      json = argv[++i];
    else
      names.emplace_back(argv[i]);
  }
  Report report(subject, command);
  std::size_t run = 0;
  try {
    for (auto const& [name, experiment] : all)
      if (std::ranges::find(names, name) != names.end() || std::ranges::find(names, "all") != names.end()) {
        experiment(report, size);
        ++run;
      }
    if (run == 0 || (run < names.size() && run < all.size())) {
      std::cerr << "usage: " << program << " NAME... [--json FILE] [--smoke]; NAME is all";
      for (auto const& [name, experiment] : all) std::cerr << ", " << name;
      std::cerr << '\n';
      return 2;
    }
    report.print(std::cout);
    if (!json.empty()) report.write_json(json);
  } catch (std::exception const& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace visibility::bench
