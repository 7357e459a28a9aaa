#include "visibility/scene/write_scene.hpp"

#include "io/atomic_file.hpp"
#include "writers.hpp"

#include "visibility/scene/scene_builder.hpp"

namespace visibility {

SceneFileKind scene_file_kind(std::filesystem::path const& path)
{
  auto const extension = path.extension();
  if (extension == ".json") return SceneFileKind::native;
  if (extension == ".obj") return SceneFileKind::obj;
  if (extension == ".ply") return SceneFileKind::ply;
  if (extension == ".geojson") return SceneFileKind::geojson;
  if (extension == ".geojsonl") return SceneFileKind::geojson_lines;
  throw BadInput(path.string() + ": unknown kind of file to write; name it .json, .obj, .ply, .geojson or .geojsonl");
}

void write_scene(std::ostream& out, Scene const& scene, SceneFileKind kind)
{
  for (auto const& o : scene.objects)
    if (!o.occludes) throw BadInput("object '" + o.name + "' hides nothing, which scene files cannot say");
  switch (kind) {
  case SceneFileKind::native: return writers::write_native(out, scene);
  case SceneFileKind::obj: return writers::write_obj(out, scene);
  case SceneFileKind::ply: return writers::write_ply(out, scene);
  case SceneFileKind::geojson: return writers::write_geojson(out, scene, false);
  case SceneFileKind::geojson_lines: return writers::write_geojson(out, scene, true);
  }
}

void write_scene(std::filesystem::path const& path, Scene const& scene)
{
  auto const kind = scene_file_kind(path);
  io::AtomicFile file(path);
  write_scene(file.stream(), scene, kind);
  file.commit();
}

}  // namespace visibility
