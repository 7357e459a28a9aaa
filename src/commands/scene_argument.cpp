#include "scene_argument.hpp"

#include "visibility/scene/generators.hpp"
#include "visibility/scene/grounded.hpp"

#include <CLI/CLI.hpp>

#include <map>

namespace visibility::commands {

void SceneArgument::add_to(CLI::App& command)
{
  command
    .add_option("SCENE", scene,
                "scene file (.obj .ply .json .jsonl .geojson .geojsonl, also .gz), or gen:KIND,key=value,...")
    ->required();
  command.add_option("--object-property", options.object_property,
                     "PLY: face property that names the object of a face");
  command.add_option("--height-property", options.height_property, "GeoJSON: property with the height in metres");
  command.add_option("--ground-property", options.ground_property, "GeoJSON: property with the ground level in metres");
  static std::map<std::string, CoordinateUnit> const units{
    {"automatic", CoordinateUnit::automatic}, {"metres", CoordinateUnit::metres}, {"degrees", CoordinateUnit::degrees}};
  command
    .add_option("--coordinates", options.coordinates, "GeoJSON: automatic, metres or degrees (longitude, latitude)")
    ->transform(CLI::CheckedTransformer(units, CLI::ignore_case));
  command.add_flag("--grounded", grounded,
                   "everything below an upper surface is solid down to the lowest point of the scene");
  command.add_option("--moving", moving,
                     R"(JSON list of regions in which something moves, {"name","min","max","polygons"}; looked for, )"
                     "but hiding nothing");
}

Scene SceneArgument::load(std::vector<MovingObject> const& moving_objects) const
{
  Scene loaded = load_another(scene);
  if (grounded) loaded = visibility::grounded(loaded);
  return with_moving_objects(std::move(loaded), moving_objects);
}

std::vector<MovingObject> SceneArgument::load_moving() const
{
  return moving.empty() ? std::vector<MovingObject>{} : read_moving_objects(moving);
}

Scene SceneArgument::load_another(std::string const& name) const
{
  constexpr std::string_view prefix = "gen:";
  if (!name.starts_with(prefix)) return read_scene(name, options);
  Scene loaded = generate(std::string_view(name).substr(prefix.size()));
  loaded.source = name;
  return loaded;
}

}  // namespace visibility::commands
