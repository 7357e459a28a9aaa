#include "writers.hpp"

#include "readers/numbers.hpp"
#include "readers/readers.hpp"

namespace visibility::writers {

using readers::shortest;

namespace {

void write_vertex(std::ostream& out, Point3d const& v)
{
  out << "v " << shortest(v.x) << ' ' << shortest(v.y) << ' ' << shortest(v.z) << '\n';
}

}  // namespace

void write_obj(std::ostream& out, Scene const& scene)
{
  std::size_t vertices = scene.vertices.size();
  for (auto const& v : scene.vertices) write_vertex(out, v);
  for (auto const& o : scene.objects) {
    out << "o " << readers::printable(o.name) << '\n';
    for (auto i = o.triangles.first; i < o.triangles.last; ++i) {
      auto const& t = scene.triangles[i];
      out << "f " << t[0] + 1ul << ' ' << t[1] + 1ul << ' ' << t[2] + 1ul << '\n';
    }
    for (auto const& face : solid_faces(scene, o)) {
      for (auto const& v : face) write_vertex(out, v);
      out << 'f';
      for (std::size_t i = 0; i < face.size(); ++i) out << ' ' << ++vertices;
      out << '\n';
    }
  }
}

}  // namespace visibility::writers
