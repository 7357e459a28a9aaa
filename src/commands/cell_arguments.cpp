#include "cell_arguments.hpp"

#include "visibility/scene/result_file.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>

#include <charconv>
#include <stdexcept>

namespace visibility::commands {

namespace {

/// The numbers of a comma-separated list. Throws BadInput naming the option.
std::vector<double> parse_numbers(std::string const& option, std::string const& text, std::string const& expected)
{
  auto const fail = [&](std::string const& what) {
    return BadInput(option + " " + text + ": " + what + " (expected " + expected + ")");
  };
  std::vector<double> x;
  char const* at = text.data();
  char const* const end = text.data() + text.size();
  for (;;) {
    double value = 0;
    auto const [next, error] = std::from_chars(at, end, value);
    if (error != std::errc{}) throw fail("number " + std::to_string(x.size() + 1) + " is missing or out of range");
    x.push_back(value);
    if (next == end) return x;
    if (*next != ',') throw fail("a comma is missing after number " + std::to_string(x.size()));
    at = next + 1;
  }
}

Box parse_box(std::string const& option, std::string const& text)
{
  constexpr char const* expected = "X0,Y0,Z0,X1,Y1,Z1";
  auto const x = parse_numbers(option, text, expected);
  if (x.size() != 6)
    throw BadInput(option + " " + text + ": six numbers are needed, not " + std::to_string(x.size()) + " (expected " +
                   expected + ")");
  return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
}

ViewCell parse_cell(std::string const& text)
{
  Box const box = parse_box("--cell", text);
  try {
    return ViewCell(box);
  } catch (std::invalid_argument const& e) {
    throw BadInput("--cell " + text + ": " + e.what() + " (expected X0,Y0,Z0,X1,Y1,Z1)");
  }
}

/// One number is the width and depth of cells as high as the region.
Point3d parse_size(std::string const& text, Box const& region)
{
  auto const x = parse_numbers("--cell-size", text, "S or SX,SY,SZ");
  if (x.size() == 1) return {x[0], x[0], region.max.z - region.min.z};
  if (x.size() == 3) return {x[0], x[1], x[2]};
  throw BadInput("--cell-size " + text + ": one or three numbers are needed (expected S or SX,SY,SZ)");
}

}  // namespace

PlanRegion parse_plan_region(std::string const& option, std::string const& text)
{
  constexpr char const* expected = "X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1";
  auto const x = parse_numbers(option, text, expected);
  if (x.size() != 4 || !(x[0] < x[2] && x[1] < x[3])) throw BadInput(option + " " + text + ": expected " + expected);
  return {{x[0], x[1]}, {x[2], x[3]}};
}

Point3d parse_point(std::string const& option, std::string const& text)
{
  auto const x = parse_numbers(option, text, "X,Y,Z");
  if (x.size() != 3) throw BadInput(option + " " + text + ": three numbers are needed (expected X,Y,Z)");
  Point3d const p{x[0], x[1], x[2]};
  if (!is_finite(p)) throw BadInput(option + " " + text + ": not finite (expected X,Y,Z)");
  return p;
}

void CellArguments::add_to(CLI::App& command)
{
  command.add_option("--cell", boxes, "view cell X0,Y0,Z0,X1,Y1,Z1 (metres); may be repeated")
    ->allow_extra_args(false)
    ->delimiter('\0');
  command.add_option("--cells", file, R"(JSON file with a list of cells: {"min":..,"max":..} or {"vertices":..})");
  command.add_option("--region", region, "divide this box into cells, X0,Y0,Z0,X1,Y1,Z1 (metres)")
    ->allow_extra_args(false)
    ->delimiter('\0');
  command.add_option("--cell-size", sizes, "with --region: S, or SX,SY,SZ; repeat it, smaller, to refine coarse cells")
    ->allow_extra_args(false)
    ->delimiter('\0');
}

std::optional<Partition> CellArguments::partition() const
{
  if (region.empty()) {
    if (!sizes.empty()) throw BadInput("--cell-size needs --region X0,Y0,Z0,X1,Y1,Z1");
    return {};
  }
  if (!boxes.empty() || !file.empty()) throw BadInput("give --region or single cells, not both");
  if (sizes.empty()) throw BadInput("--region needs --cell-size, S or SX,SY,SZ in metres");
  Box const box = parse_box("--region", region);
  std::vector<Point3d> parsed;
  for (auto const& text : sizes) parsed.push_back(parse_size(text, box));
  try {
    return Partition(box, parsed);
  } catch (std::invalid_argument const& e) {
    throw BadInput("--region " + region + ": " + e.what());
  }
}

std::vector<ViewCell> CellArguments::load() const
{
  std::vector<ViewCell> cells;
  for (auto const& text : boxes) cells.push_back(parse_cell(text));
  if (!file.empty())
    for (auto& cell : read_cells(file)) cells.push_back(std::move(cell));
  if (cells.empty())
    throw BadInput("no view cell: give --cell X0,Y0,Z0,X1,Y1,Z1, --cells FILE or --region with --cell-size");
  return cells;
}

}  // namespace visibility::commands
