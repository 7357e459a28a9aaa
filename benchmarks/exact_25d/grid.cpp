#include "ends.hpp"
#include "scenes.hpp"

#include "visibility/raster/contours.hpp"
#include "visibility/raster/pixel_region.hpp"
#include "visibility/scene/occludees.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <optional>
#include <stdexcept>

namespace visibility::bench::exact_25d {

namespace {

constexpr double pixels[] = {8, 4, 2, 1};  // m

std::vector<Point2d> footprint(Box const& b)
{
  return {{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {b.min.x, b.max.y}};
}

/// Pixels of one solid as boxes: runs of a row, joined with the same run of the next rows.
void add_runs(SceneBuilder& builder, Grid const& grid, Spans const& spans, double bottom, double top)
{
  auto const box = [&](Span const& s, int rows) {
    return Box{{grid.column_line(s.begin), grid.row_line(s.row), bottom},
               {grid.column_line(s.end), grid.row_line(s.row + rows), top}};
  };
  for (std::size_t i = 0, j = 0; i < spans.size(); i = j) {
    while (j < spans.size() && spans[j].begin == spans[i].begin && spans[j].end == spans[i].end &&
           spans[j].row == spans[i].row + static_cast<int>(j - i))
      ++j;
    builder.add(box(spans[i], static_cast<int>(j - i)));
  }
}

/// The solids of a scene of boxes and prisms, each replaced by the pixels that lie wholly inside it. Empty if the grid
/// would be too large or nothing is left.
std::optional<Scene> on_grid(Scene const& scene, double pixel)
{
  Box const all = bounding_box(scene);
  int const width = static_cast<int>(std::ceil((all.max.x - all.min.x) / pixel));
  int const height = static_cast<int>(std::ceil((all.max.y - all.min.y) / pixel));
  if (std::max(width, height) > Grid::max_size) return {};
  auto const grid =
    Grid::covering({all.min.x, all.min.y}, {all.min.x + width * pixel, all.min.y + height * pixel}, width, height);
  SceneBuilder builder("grid");
  bool any = false;
  for (auto const& object : scene.objects) {
    builder.begin_object(object.name);
    auto const add = [&](Spans const& spans, double bottom, double top) {
      any |= !spans.empty();
      add_runs(builder, grid, spans, bottom, top);
    };
    for (auto i = object.boxes.first; i < object.boxes.last; ++i) {
      Box const& b = scene.boxes[i];
      auto const corners = footprint(b);
      Outline const outline{corners};
      add(inner(grid, std::span(&outline, 1)), b.min.z, b.max.z);
    }
    for (auto i = object.prisms.first; i < object.prisms.last; ++i) {
      Prism const& p = scene.prisms[i];
      add(inner_even_odd(grid, p.rings), p.bottom, p.top);
    }
  }
  if (!any) return {};
  return builder.finish();
}

bool is_of_solids(Scene const& s) { return s.triangles.empty() && s.polyhedra.empty() && s.balls.empty(); }

}  // namespace

void grid(Report& report, Size size)
{
  std::vector<std::string> columns{"scene", "perimeter"};
  for (double const p : pixels) columns.push_back(std::to_string(static_cast<int>(p)) + " m");
  columns.insert(columns.end(), {"exact", "2 m / exact", "time at 2 m / exact"});
  auto& table =
    report.table("Section 6.3: mean sets with occluders on a grid of the plan, by pixel (paper | ours)", columns);
  table.add({"paper: Vienna", Value(), Value(), Value(), Value(), Value(), Value(), 1.17, "comparable"});
  for_each_model(size, table.notes, [&](Source const& source, Model const& m) {
    if (source.counterpart != Paper::vienna && source.counterpart != Paper::atlanta) return;
    if (!is_of_solids(m.scene)) return;
    double const perimeter = source.counterpart == Paper::vienna ? 36 : 89;
    auto const places =
      answered_cells(m, {perimeter, 2, street_width(source.counterpart)}, size == Size::full ? 6 : 2, table.notes);
    if (places.empty()) return;
    PreparedScene const prepared(m.scene);
    Occludees const occludees(prepared);
    Exact25d<> const method;
    double const n = static_cast<double>(places.size());
    double exact = 0, exact_seconds = 0, seconds_at_2 = 0, size_at_2 = 0;
    for (auto const& cell : places) {
      exact_seconds += median_seconds<ProcessorClock>(3, 0, [&] { method(*m.field, occludees, cell); });
      exact += static_cast<double>(method(*m.field, occludees, cell).visible.size()) / n;
    }
    std::vector<Value> row{m.name, perimeter};
    for (double const pixel : pixels) {
      auto const occluders = on_grid(m.scene, pixel);
      if (!occluders) {
        row.emplace_back();
        continue;
      }
      HeightField const field(*occluders);
      double mean = 0, seconds = 0;
      for (auto const& cell : places) {
        auto const set = method(field, occludees, cell);
        if (!std::ranges::includes(set.visible, method(*m.field, occludees, cell).visible))
          throw std::runtime_error(m.name + ": fewer occluders, fewer visible objects");
        mean += static_cast<double>(set.visible.size()) / n;
        seconds += median_seconds<ProcessorClock>(3, 0, [&] { method(field, occludees, cell); });
      }
      row.emplace_back(mean);
      if (pixel == 2) seconds_at_2 = seconds, size_at_2 = mean;
    }
    row.emplace_back(exact);
    row.push_back(size_at_2 > 0 ? Value(size_at_2 / exact) : Value());
    row.push_back(size_at_2 > 0 ? Value(seconds_at_2 / exact_seconds) : Value());
    table.add(row);
  });
  table.notes.emplace_back(
    "Each solid is replaced by the pixels that lie wholly inside it; the objects that are looked for "
    "stay as they are (separate occludees). What [WWS00] lose besides, by sampling the cell, is not "
    "simulated.");
}

}  // namespace visibility::bench::exact_25d
