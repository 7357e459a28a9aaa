#pragma once

#include "json_value.hpp"
#include "polygon_triangulation.hpp"

#include "visibility/kernel/point.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace visibility::readers {

/// `transform` of a CityJSON file; the identity if there is none. Throws BadInput.
class CityJsonVertices {
public:
  /// Vertices are `document["vertices"]`, transformed by `transform` (may be null: taken as they are).
  static std::vector<Point3d> read(JsonValue const& document, JsonValue const* transform, std::string const& source,
                                   std::string const& where);
};

/// Shared geometry that objects place with a matrix.
struct CityJsonTemplates {
  std::vector<JsonValue const*> geometries;
  std::vector<Point3d> vertices;
  static CityJsonTemplates read(JsonValue const& document, std::string const& source);
};

/// Level of detail: "2.2", 2, 1.3 ... A geometry that names none counts as 1.
double level_of_detail(JsonValue const& geometry);

/// Turns boundaries into triangles of the builder's current object.
class CityJsonSurfaces {
public:
  CityJsonSurfaces(SceneBuilder& builder, std::string const& source) : builder_(builder), source_(source) {}

  /// MultiSurface, CompositeSurface, Solid, MultiSolid, CompositeSolid or GeometryInstance. `vertices` must stay the
  /// same between calls unless `new_vertices` is called. Throws BadInput naming `object`.
  void add(JsonValue const& geometry, std::vector<Point3d> const& vertices, CityJsonTemplates const& templates,
           std::string const& object);
  void new_vertices() { scene_index_.clear(); }
  void note() const;  ///< tells the builder what was dropped

private:
  void add_instance(JsonValue const& geometry, std::vector<Point3d> const& vertices, CityJsonTemplates const& templates,
                    std::string const& object);
  void add_nested(JsonValue const& boundaries, int depth, std::vector<Point3d> const& vertices,
                  std::string const& object);
  void add_surface(JsonValue const& rings, std::vector<Point3d> const& vertices, std::string const& object);
  VertexIndex scene_vertex(VertexIndex i, std::vector<Point3d> const& vertices);

  SceneBuilder& builder_;
  std::string const& source_;
  DroppedPolygons dropped_;
  std::size_t unknown_ = 0;
  std::vector<VertexIndex> scene_index_;  // of a file vertex; ~0: not in the scene yet
  std::vector<std::vector<VertexIndex>> rings_;
  std::vector<IndexTriangle> triangles_;
};

}  // namespace visibility::readers
