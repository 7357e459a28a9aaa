// CityJSON 1.0, 1.1, 2.0 and CityJSONSeq [cityjson.org/specs]: buildings, each CityObject with geometry an object.
#include "cityjson_geometry.hpp"
#include "numbers.hpp"
#include "readers.hpp"

#include <algorithm>
#include <map>

namespace visibility::readers {

namespace {

/// What stands between an eye in the street and the rest of the city. Rooms and furniture are behind walls; terrain,
/// roads, water and plants are no buildings.
constexpr std::string_view building_types[] = {"Building", "BuildingPart", "BuildingInstallation",
                                               "BuildingConstructiveElement"};

class CityJsonReader {
public:
  CityJsonReader(JsonValue const& first, std::string const& source)
    : source_(source), builder_(source), surfaces_(builder_, source_)
  {
    auto const version = first.text("version");
    if (!version.starts_with("1.") && !version.starts_with("2."))
      fail(source, {},
           "CityJSON version '" + std::string(version) +
             "' cannot be read (1.0, 1.1 and 2.0 can); upgrade it with cjio");
    templates_ = CityJsonTemplates::read(first, source);
    transform_ = first.find("transform");
  }

  /// The CityObjects of a whole file or of one CityJSONFeature.
  void objects(JsonValue const& document, std::string const& where)
  {
    auto const* objects = document.find("CityObjects");
    if (objects == nullptr || objects->as_object() == nullptr)
      fail(source_, where.empty() ? where : where.substr(0, where.size() - 2),
           "has no 'CityObjects'; is the file complete?");
    auto const vertices = CityJsonVertices::read(document, transform_, source_, where);
    surfaces_.new_vertices();
    for (auto const& [id, object] : *objects->as_object()) read_object(id, object, vertices);
  }

  Scene finish()
  {
    for (auto const& [type, count] : skipped_)
      builder_.note(std::to_string(count) + " objects of type " + printable(type) + " skipped");
    if (without_geometry_ > 0)
      builder_.note(std::to_string(without_geometry_) + " building objects without own geometry");
    if (footprints_ > 0)
      builder_.note(std::to_string(footprints_) + " building objects with a footprint (LoD 0) only skipped");
    surfaces_.note();
    return builder_.finish();
  }

private:
  void read_object(std::string const& id, JsonValue const& object, std::vector<Point3d> const& vertices)
  {
    auto const type = object.text("type");
    if (type.empty()) fail(source_, "object '" + id + "'", "has no type");
    if (std::ranges::find(building_types, type) == std::end(building_types)) {
      ++skipped_[std::string(type)];
      return;
    }
    auto const& geometries = object.list("geometry");
    if (geometries.empty()) {
      ++without_geometry_;
      return;
    }
    double best = 0;
    for (auto const& g : geometries) best = std::max(best, detail(g));
    if (!(best >= 1)) {
      ++footprints_;
      return;
    }
    builder_.begin_object(id);
    for (auto const& g : geometries)
      if (detail(g) == best) surfaces_.add(g, vertices, templates_, id);
  }

  /// An instance has the level of its template.
  double detail(JsonValue const& geometry) const
  {
    auto const* which = geometry.find("template");
    auto const index = which == nullptr ? std::nullopt : which->as_number();
    bool const valid = index && *index >= 0 && *index < static_cast<double>(templates_.geometries.size());
    return level_of_detail(valid ? *templates_.geometries[static_cast<std::size_t>(*index)] : geometry);
  }

  std::string source_;
  JsonValue const* transform_ = nullptr;
  CityJsonTemplates templates_;
  SceneBuilder builder_;
  CityJsonSurfaces surfaces_;
  std::map<std::string, std::size_t> skipped_;
  std::size_t without_geometry_ = 0, footprints_ = 0;
};

}  // namespace

Scene read_cityjson(JsonValue first, JsonStream& stream)
{
  CityJsonReader reader(first, stream.source());
  bool sequence = false;
  while (auto const feature = stream.next()) {
    std::string const line = "line " + std::to_string(stream.line());
    if (feature->text("type") != "CityJSONFeature")
      fail(stream.source(), line, "a CityJSONFeature was expected behind the first line");
    if (!sequence && first.find("CityObjects") != nullptr && first.find("vertices") != nullptr)
      reader.objects(first, {});
    sequence = true;
    reader.objects(*feature, line + ", ");
  }
  if (!sequence) reader.objects(first, {});
  return reader.finish();
}

}  // namespace visibility::readers
