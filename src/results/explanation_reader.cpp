#include "visibility/methods/exact_25d/explanation_file.hpp"

#include "result_json.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <string_view>
#include <unordered_map>

namespace visibility::exact_25d {

namespace {

using visibility::detail::Json;
using visibility::detail::plan_point_from_json;
using visibility::detail::point_from_json;
using visibility::detail::rational_from_json;
using Edge = PortalSequence::Edge;

/// The list under a key. Throws BadInput if it is not there, or not of `size` elements if that is not 0.
Json const& list(Json const& value, char const* key, std::string const& where, std::size_t size = 0)
{
  if (!value.is_object() || !value.contains(key) || !value[key].is_array() || (size > 0 && value[key].size() != size))
    throw BadInput(where + ": expected \"" + key + "\", a list" + (size > 0 ? " of " + std::to_string(size) : ""));
  return value[key];
}

Edge edge(Json const& value, std::string const& where)
{
  if (!value.is_array() || value.size() != 2) throw BadInput(where + ": expected an edge, [[x, y, z], [x, y, z]]");
  return {point_from_json(value[0], where), point_from_json(value[1], where)};
}

/// A number, or ["a"] or ["a", "b", "d"] for a + b sqrt(d).
Position position(Json const& value, std::string const& where)
{
  RationalNumber const zero(0), one(1);
  if (!value.is_array()) return {rational_from_json(value, where), zero, zero, one};
  if (value.size() == 1) return {rational_from_json(value[0], where), zero, zero, one};
  if (value.size() != 3) throw BadInput(where + ": expected [\"a\"] or [\"a\", \"b\", \"d\"]");
  Position const out{rational_from_json(value[0], where), rational_from_json(value[1], where),
                     rational_from_json(value[2], where), one};
  if (out.d < 0) throw BadInput(where + ": the root of a negative number");
  return out;
}

class Reader {
public:
  explicit Reader(Scene const& scene) : scene_(scene)
  {
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) index_.emplace(scene.objects[i].name, i);
  }

  ExplainedCell operator()(Json const& value, std::string const& where) const
  {
    if (!value.is_object() || !value.contains("format") || value["format"] != "visibility-lines/1")
      throw BadInput(where + ": expected an object with \"format\": \"visibility-lines/1\"");
    ExplainedCell out;
    if (!value.contains("cell")) throw BadInput(where + ": expected \"cell\"");
    for (auto const& v : list(value["cell"], "vertices", where + ", cell"))
      out.cell.push_back(point_from_json(v, where));
    for (auto const& e : list(value, "edges", where))
      out.explanation.edges.push_back(visible_edge(e, where + ", edges"));
    for (auto const& f : list(value, "funnels", where)) out.explanation.cells.push_back(funnel(f, where + ", funnels"));
    for (auto const& s : list(value, "shadow_planes", where))
      out.explanation.shadows.push_back({edge(list(s, "source", where + ", shadow_planes"), where),
                                         edge(list(s, "occluder", where + ", shadow_planes"), where)});
    return out;
  }

private:
  VisibleEdge visible_edge(Json const& value, std::string const& where) const
  {
    if (!value.is_object() || !value.contains("object") || !value["object"].is_string() || !value.contains("left") ||
        !value.contains("right"))
      throw BadInput(where + ": an edge needs \"object\", \"left\", \"right\" and \"parts\"");
    std::string const name = value["object"].get<std::string>();
    auto const found = index_.find(name);
    if (found == index_.end()) throw BadInput(where + ": object '" + name + "' is not in scene " + scene_.source);
    VisibleEdge out{found->second,
                    {point_from_json(value["left"], where), point_from_json(value["right"], where)},
                    value.contains("sees") && value["sees"] == "top",
                    {}};
    for (auto const& p : list(value, value.contains("exact_parts") ? "exact_parts" : "parts", where)) {
      if (!p.is_array() || p.size() != 2) throw BadInput(where + ": a part is [low, high]");
      out.parts.push_back({position(p[0], where), position(p[1], where)});
    }
    return out;
  }

  static LineSpaceCell funnel(Json const& value, std::string const& where)
  {
    LineSpaceCell out{edge(list(value, "entry", where), where), edge(list(value, "exit", where), where), {}, {}};
    for (auto const& l : list(value, "lines", where)) {
      if (!l.is_array() || l.size() != 2) throw BadInput(where + ": a line is two points");
      out.bounds.push_back({plan_point_from_json(l[0], where), plan_point_from_json(l[1], where)});
    }
    for (auto const& o : list(value, "occluders", where)) out.occluders.push_back(edge(o, where));
    return out;
  }

  Scene const& scene_;
  std::unordered_map<std::string_view, std::uint32_t> index_;
};

}  // namespace

std::vector<ExplainedCell> explanations_from_json(std::string_view text, std::string const& name, Scene const& scene)
{
  Reader const reader(scene);
  std::vector<ExplainedCell> out;
  detail::for_each_entry(detail::parse_json(text, name), name,
                         [&](Json const& value, std::string const& where) { out.push_back(reader(value, where)); });
  if (out.empty()) throw BadInput(name + ": no explanations");
  return out;
}

std::vector<ExplainedCell> read_explanations(std::filesystem::path const& file, Scene const& scene)
{
  return explanations_from_json(detail::read_text(file.string()), file.string(), scene);
}

}  // namespace visibility::exact_25d
