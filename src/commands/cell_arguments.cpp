#include "cell_arguments.hpp"

#include "visibility/scene/result_file.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <charconv>
#include <stdexcept>

namespace visibility::commands {

namespace {

ViewCell parse_box(std::string const& text)
{
  auto const fail = [&](std::string const& what) {
    return BadInput("--cell " + text + ": " + what + " (expected X0,Y0,Z0,X1,Y1,Z1)");
  };
  std::array<double, 6> x{};
  char const* at = text.data();
  char const* const end = text.data() + text.size();
  for (std::size_t i = 0; i < x.size(); ++i) {
    auto const [next, error] = std::from_chars(at, end, x[i]);
    if (error != std::errc{}) throw fail("number " + std::to_string(i + 1) + " is missing or out of range");
    at = next;
    if (i + 1 < x.size() && (at == end || *at++ != ',')) throw fail("a comma is missing");
  }
  if (at != end) throw fail("something follows the sixth number");
  try {
    return ViewCell(Box{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}});
  } catch (std::invalid_argument const& e) {
    throw fail(e.what());
  }
}

}  // namespace

void CellArguments::add_to(CLI::App& command)
{
  command.add_option("--cell", boxes, "view cell X0,Y0,Z0,X1,Y1,Z1 (metres); may be repeated")
    ->allow_extra_args(false)
    ->delimiter('\0');
  command.add_option("--cells", file, R"(JSON file with a list of cells: {"min":..,"max":..} or {"vertices":..})");
}

std::vector<ViewCell> CellArguments::load() const
{
  std::vector<ViewCell> cells;
  for (auto const& text : boxes) cells.push_back(parse_box(text));
  if (!file.empty())
    for (auto& cell : read_cells(file)) cells.push_back(std::move(cell));
  if (cells.empty()) throw BadInput("no view cell: give --cell X0,Y0,Z0,X1,Y1,Z1 or --cells FILE");
  return cells;
}

}  // namespace visibility::commands
