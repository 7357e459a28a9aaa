#include "result_json.hpp"

#include "visibility/scene/moving_objects.hpp"
#include "visibility/scene/scene_builder.hpp"

namespace visibility {

namespace {

using detail::Json;

MovingObject moving_object(Json const& value, std::string const& where)
{
  if (!value.is_object() || !value.contains("name") || !value["name"].is_string() || !value.contains("min") ||
      !value.contains("max"))
    throw BadInput(where + R"(: expected {"name": ..., "min": [x,y,z], "max": [x,y,z]})");
  MovingObject m{
    value["name"].get<std::string>(),
    {detail::point_from_json(value["min"], where + ".min"), detail::point_from_json(value["max"], where + ".max")}};
  if (m.region.is_empty()) throw BadInput(where + ": min exceeds max");
  if (!value.contains("polygons")) return m;
  constexpr std::uint64_t most = std::uint64_t{1} << 53;  // sums of millions fit
  auto const& polygons = value["polygons"];
  if (!polygons.is_number_unsigned() || polygons.get<std::uint64_t>() > most)
    throw BadInput(where + ": \"polygons\" is not a count");
  m.polygons = polygons.get<std::uint64_t>();
  return m;
}

}  // namespace

std::vector<MovingObject> moving_objects_from_json(std::string_view text, std::string const& name)
{
  Json const list = detail::parse_json(text, name);
  if (!list.is_array() || list.empty()) throw BadInput(name + ": expected a list of moving objects");
  std::vector<MovingObject> out;
  for (std::size_t i = 0; i < list.size(); ++i)
    out.push_back(moving_object(list[i], name + ", entry " + std::to_string(i + 1)));
  return out;
}

std::vector<MovingObject> read_moving_objects(std::filesystem::path const& file)
{
  return moving_objects_from_json(detail::read_text(file.string()), file.string());
}

}  // namespace visibility
