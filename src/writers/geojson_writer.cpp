#include "writers.hpp"

#include "readers/numbers.hpp"

namespace visibility::writers {

using readers::shortest;

namespace {

// Tells readers, ours among them, that these are no longitudes and latitudes.
constexpr char const* local_metres = R"("crs":{"type":"name","properties":{"name":"urn:visibility:local-metres"}})";

std::vector<Prism> footprints(Scene const& scene, Object const& o)
{
  if (o.balls.size() + o.polyhedra.size() + o.triangles.size() > 0) cannot_hold(o, "anything but prisms and boxes");
  std::vector<Prism> out(scene.prisms.begin() + o.prisms.first, scene.prisms.begin() + o.prisms.last);
  for (auto i = o.boxes.first; i < o.boxes.last; ++i) {
    auto const& b = scene.boxes[i];
    if (!b.has_interior()) cannot_hold(o, "a flat box");
    out.push_back(
      {{{{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {b.min.x, b.max.y}}}, b.min.z, b.max.z});
  }
  for (auto const& p : out)
    if (p.bottom != out[0].bottom || p.top != out[0].top) cannot_hold(o, "several heights in one object");
  return out;
}

/// Properties from which a reader gets bottom and top back bit for bit.
std::string heights(Prism const& p, Object const& o)
{
  double const height = p.top - p.bottom;
  if (p.bottom == 0) return R"("height":)" + shortest(p.top);
  if (p.bottom + height == p.top) return R"("ground":)" + shortest(p.bottom) + R"(,"height":)" + shortest(height);
  if (p.top > 0) return R"("min_height":)" + shortest(p.bottom) + R"(,"height":)" + shortest(p.top);
  cannot_hold(o, "its exact height");
}

void write_polygon(std::ostream& out, Prism const& p)
{
  out << '[';
  for (std::size_t r = 0; r < p.rings.size(); ++r) {
    out << (r > 0 ? ",[" : "[");
    for (auto const& v : p.rings[r]) out << '[' << shortest(v.x) << ',' << shortest(v.y) << "],";
    out << '[' << shortest(p.rings[r][0].x) << ',' << shortest(p.rings[r][0].y) << "]]";
  }
  out << ']';
}

}  // namespace

void write_geojson(std::ostream& out, Scene const& scene, bool lines)
{
  if (!lines) out << R"({"type":"FeatureCollection",)" << local_metres << ",\"features\":[\n";
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    auto const& o = scene.objects[i];
    auto const prisms = footprints(scene, o);
    out << R"({"type":"Feature",)";
    if (lines) out << local_metres << ',';
    out << R"("id":)" << json_string(o.name) << R"(,"properties":{)" << heights(prisms[0], o)
        << R"(},"geometry":{"type":)"
        << (prisms.size() == 1 ? R"("Polygon","coordinates":)" : R"("MultiPolygon","coordinates":[)");
    for (std::size_t k = 0; k < prisms.size(); ++k) {
      if (k > 0) out << ',';
      write_polygon(out, prisms[k]);
    }
    out << (prisms.size() == 1 ? "}}" : "]}}") << (lines || i + 1 == scene.objects.size() ? "\n" : ",\n");
  }
  if (!lines) out << "]}\n";
}

}  // namespace visibility::writers
