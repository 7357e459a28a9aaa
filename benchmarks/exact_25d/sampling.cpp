#include "ends.hpp"
#include "scenes.hpp"

#include <numbers>
#include <stdexcept>

namespace visibility::bench::exact_25d {

namespace {

constexpr double resolutions[] = {512, 1024, 2048, 16384};

/// What a sample of the line space of [Leyvand03, 3.1] spans, as seen from the middle of the cell. Its second parameter
/// runs once around the outer square, so `resolution` samples share the full turn: 2 pi / resolution on average (4/pi
/// of it where an edge of the square is nearest, half of that at its corners). A line through the end of a far occluder
/// moves by half a sample of the second parameter for one of the first, so a sample lies wholly within the occluder
/// unless it is within 1.5 samples of the end: between 0 and 1.5 samples are lost at each end; one is taken here.
double radians(double resolution) { return 2 * std::numbers::pi / resolution; }

}  // namespace

void sampling(Report& report, Size size)
{
  std::vector<std::string> columns{"scene", "perimeter"};
  for (double const r : resolutions) columns.push_back(std::to_string(static_cast<int>(r)));
  columns.emplace_back("exact");
  columns.emplace_back("512 / exact");
  columns.emplace_back("16384 / exact");
  auto& table = report.table("Table 4: mean sets by resolution of a sampled line space (paper | ours)", columns);
  table.add({"paper: Vienna", Value(), 633.0, 535.0, 489.0, 455.0, 235.0, 633.0 / 235, 455.0 / 235});
  table.add(
    {"paper: Atlanta", Value(), 50'744.0, 25'751.0, 10'082.0, 2'656.0, 1'152.0, 50'744.0 / 1'152, 2'656.0 / 1'152});
  for_each_model(size, table.notes, [&](Source const& source, Model const& m) {
    if (source.counterpart != Paper::vienna && source.counterpart != Paper::atlanta) return;
    if (m.name.ends_with(".ply") && m.name != "rotterdam_centre.ply") return;  // minutes a cell
    double const perimeter = source.counterpart == Paper::vienna ? 36 : 89;
    auto const places = answered_cells(m, {perimeter, 2, street_width(source.counterpart)}, 2, table.notes);
    if (places.empty()) return;
    double const n = static_cast<double>(places.size());
    std::vector<double> sizes;
    double exact = 0;
    for (auto const& cell : places) exact += static_cast<double>(exact_set(*m.field, cell).visible.size()) / n;
    for (double const r : resolutions) {
      Options options;
      options.occluder_shrink = radians(r);
      double mean = 0;
      for (auto const& cell : places) {
        auto const set = Exact25d<>(options)(*m.field, cell);
        mean += static_cast<double>(set.visible.size()) / n;
      }
      sizes.push_back(mean);
    }
    std::vector<Value> row{m.name, perimeter};
    row.insert(row.end(), sizes.begin(), sizes.end());
    row.insert(row.end(), {exact, sizes.front() / exact, sizes.back() / exact});
    table.add(row);
  });
  table.notes.emplace_back(
    "Occluders shortened at both ends by 2 pi / resolution as seen from the middle of the cell.");
  table.notes.emplace_back("The paper counts boxes of buildings in Vienna, top edges in Atlanta; ours are objects.");
}

}  // namespace visibility::bench::exact_25d
