#include "scenes.hpp"

namespace visibility::bench::exact_25d {

namespace {

/// Horizontal extent in square kilometres.
double area(Scene const& scene)
{
  Box const b = bounding_box(scene);
  return (b.max.x - b.min.x) * (b.max.y - b.min.y) * 1e-6;
}

}  // namespace

void models(Report& report, Size size)
{
  auto& table = report.table("Table 1: the scenes (of the paper | ours)",
                             {"scene", "primitives", "occluders", "occludees", "km2", "columns", "raised", "build, s"});
  table.add({"Vienna", 8'123'675.0, 15'243.0, 7'731.0, 8.0, Value(), Value(), Value()});
  table.add({"Atlanta", 181'678.0, 90'839.0, 90'839.0, 32.0, Value(), Value(), Value()});
  table.add({"City", 2'153'382.0, 1'018'350.0, 1'018'350.0, 40.0, Value(), Value(), Value()});
  table.add({"Random", 42'801.0, 42'801.0, 42'801.0, 1.0, Value(), Value(), Value()});
  for_each_model(size, table.notes, [&](Source const& source, Model const& m) {
    table.add({to_string(source.counterpart) + ": " + m.name, double(m.scene.primitive_count()),
               double(m.field->edges().size()), double(m.scene.objects.size()), area(m.scene),
               double(m.field->columns().size()), double(m.field->raised()), m.build_seconds});
  });
  table.notes.insert(table.notes.begin(),
                     {"Primitives: triangles, boxes, prisms. Occluders: top edges. Occludees: objects; the paper's are",
                      "boxes in Vienna and the occluders themselves elsewhere. Area: of the bounding rectangle."});
}

}  // namespace visibility::bench::exact_25d
