#include "writers.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <bit>

namespace visibility::writers {

namespace {

/// Little endian, whatever the machine.
void put(std::ostream& out, std::uint64_t bits, int bytes)
{
  char buffer[8];
  for (int i = 0; i < bytes; ++i) buffer[i] = static_cast<char>(bits >> (8 * i));
  out.write(buffer, bytes);
}

void put(std::ostream& out, Point3d const& p)
{
  for (double const c : {p.x, p.y, p.z}) put(out, std::bit_cast<std::uint64_t>(c), 8);
}

}  // namespace

void write_ply(std::ostream& out, Scene const& scene)
{
  std::vector<std::vector<std::vector<Point3d>>> solids;  // faces per object
  std::uint64_t vertices = scene.vertices.size(), faces = scene.triangles.size();
  for (auto const& o : scene.objects) {
    for (auto const& face : solids.emplace_back(solid_faces(scene, o))) vertices += face.size();
    faces += solids.back().size();
  }
  if (vertices > INT32_MAX)
    throw BadInput(scene.source + ": too many vertices for a PLY file; write a .json scene instead");

  out << "ply\nformat binary_little_endian 1.0\ncomment units metre, z up\nelement vertex " << vertices
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << faces
      << "\nproperty list uint int vertex_indices\nproperty int object\nend_header\n";
  for (auto const& v : scene.vertices) put(out, v);
  for (auto const& solid : solids)
    for (auto const& face : solid)
      for (auto const& v : face) put(out, v);

  std::uint64_t next = scene.vertices.size();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    auto const& o = scene.objects[i];
    for (auto t = o.triangles.first; t < o.triangles.last; ++t) {
      put(out, 3, 4);
      for (auto const v : scene.triangles[t]) put(out, v, 4);
      put(out, i, 4);
    }
    for (auto const& face : solids[i]) {
      put(out, face.size(), 4);
      for (std::size_t k = 0; k < face.size(); ++k) put(out, next++, 4);
      put(out, i, 4);
    }
  }
}

}  // namespace visibility::writers
