#include "visibility/scene/result_file.hpp"

#include "result_json.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <unordered_map>

namespace visibility {

namespace {

using detail::Json;
constexpr auto format = "visibility-pvs/1";

Json cell_json(Result const& r)
{
  if (r.cell_box) return {{"min", detail::to_json(r.cell_box->min)}, {"max", detail::to_json(r.cell_box->max)}};
  Json vertices = Json::array();
  for (auto const& v : r.cell) vertices.push_back(detail::to_json(v));
  return {{"vertices", vertices}};
}

/// A number where the text is one, so that options read naturally.
Json option_json(std::string const& text)
{
  double x = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(x)) return text;
  if (x == std::floor(x) && std::fabs(x) < 0x1p53) return static_cast<std::int64_t>(x);
  return x;
}

/// Counts print as integers.
Json statistic_json(double x)
{
  if (std::isfinite(x) && x == std::floor(x) && std::fabs(x) < 0x1p53) return static_cast<std::int64_t>(x);
  return x;
}

Json result_json(Result const& r)
{
  Json options = Json::object(), statistics = Json::object();
  for (auto const& [key, value] : r.options) options[key] = option_json(value);
  for (auto const& [key, value] : r.statistics) statistics[key] = statistic_json(value);
  Json out{{"format", format},
           {"scene", {{"source", r.source}, {"objects", r.objects}, {"primitives", r.primitives}}},
           {"method", {{"name", r.method}, {"arithmetic", r.arithmetic}, {"options", options}}},
           {"guarantee", to_string(r.guarantee)},
           {"visible", r.visible},
           {"statistics", statistics},
           {"seconds", {{"read", r.seconds.read}, {"build", r.seconds.build}, {"query", r.seconds.query}}}};
  if (r.seconds.processor > 0) out["seconds"]["processor"] = r.seconds.processor;
  if (r.seconds.build_processor > 0) out["seconds"]["build_processor"] = r.seconds.build_processor;
  if (r.cell_box || !r.cell.empty()) out["cell"] = cell_json(r);
  if (r.grounded) out["scene"]["grounded"] = true;
  if (!r.moving.empty()) out["scene"]["moving"] = r.moving;
  if (!r.occludees.empty()) out["scene"]["occludees"] = r.occludees;
  if (r.witnesses.empty()) return out;
  Json witnesses = Json::array();
  for (auto const& w : r.witnesses)
    witnesses.push_back({{"object", w.object}, {"from", detail::to_json(w.from)}, {"to", detail::to_json(w.to)}});
  out["witnesses"] = std::move(witnesses);
  return out;
}

std::vector<Point3d> vertices_from_json(Json const& list, std::string const& where)
{
  if (!list.is_array()) throw BadInput(where + ": expected a list of points");
  std::vector<Point3d> out;
  for (auto const& v : list) out.push_back(detail::point_from_json(v, where));
  return out;
}

/// Sets the cell of a result from {"min","max"} or {"vertices"}.
void read_cell(Json const& value, Result& r, std::string const& where)
{
  if (value.is_object() && value.contains("min") && value.contains("max")) {
    r.cell_box =
      Box{detail::point_from_json(value["min"], where + ".min"), detail::point_from_json(value["max"], where + ".max")};
    auto const corners = r.cell_box->corners();
    r.cell.assign(corners.begin(), corners.end());
  } else if (value.is_object() && value.contains("vertices")) {
    r.cell = vertices_from_json(value["vertices"], where + ".vertices");
  } else {
    throw BadInput(where + R"(: expected {"min":[x,y,z],"max":[x,y,z]} or {"vertices":[[x,y,z],...]})");
  }
}

std::string text_or(Json const& value, char const* key, std::string otherwise)
{
  return value.contains(key) && value[key].is_string() ? value[key].get<std::string>() : otherwise;
}

std::size_t count_or_zero(Json const& value, char const* key)
{
  return value.contains(key) && value[key].is_number_unsigned() ? value[key].get<std::size_t>() : 0;
}

Result result_from_json(Json const& value, std::string const& where)
{
  if (!value.is_object() || text_or(value, "format", "") != format)
    throw BadInput(where + ": expected an object with \"format\": \"" + format + "\"");
  if (!value.contains("visible") || !value["visible"].is_array())
    throw BadInput(where + ": expected \"visible\", a list of object names");
  Result r;
  for (auto const& name : value["visible"]) {
    if (!name.is_string()) throw BadInput(where + ": \"visible\" holds something that is not a name");
    r.visible.push_back(name.get<std::string>());
  }
  std::ranges::sort(r.visible);
  r.visible.erase(std::unique(r.visible.begin(), r.visible.end()), r.visible.end());
  try {
    r.guarantee = guarantee_from_string(text_or(value, "guarantee", "none"));
  } catch (std::invalid_argument const& e) {
    throw BadInput(where + ": " + e.what());
  }
  if (value.contains("scene") && value["scene"].is_object()) {
    Json const& scene = value["scene"];
    r.source = text_or(scene, "source", "");
    r.grounded = scene.contains("grounded") && scene["grounded"] == true;
    r.occludees = text_or(scene, "occludees", "");
    r.moving = text_or(scene, "moving", "");
    r.objects = count_or_zero(scene, "objects");
    r.primitives = count_or_zero(scene, "primitives");
  }
  if (value.contains("cell")) read_cell(value["cell"], r, where + ", cell");
  if (value.contains("method") && value["method"].is_object()) {
    r.method = text_or(value["method"], "name", "");
    r.arithmetic = text_or(value["method"], "arithmetic", "");
    if (value["method"].contains("options") && value["method"]["options"].is_object())
      for (auto const& [key, x] : value["method"]["options"].items())
        if (x.is_string() || x.is_number()) r.options[key] = x.is_string() ? x.get<std::string>() : x.dump();
  }
  if (value.contains("statistics") && value["statistics"].is_object())
    for (auto const& [key, x] : value["statistics"].items())
      if (x.is_number()) r.statistics[key] = x.get<double>();
  if (value.contains("seconds") && value["seconds"].is_object()) {
    auto const get = [&](char const* key) {
      auto const& s = value["seconds"];
      return s.contains(key) && s[key].is_number() ? s[key].get<double>() : 0.0;
    };
    r.seconds = {get("read"), get("build"), get("query"), get("processor"), get("build_processor")};
  }
  if (value.contains("witnesses")) {
    if (!value["witnesses"].is_array()) throw BadInput(where + ": \"witnesses\" is not a list");
    for (auto const& w : value["witnesses"]) {
      if (!w.is_object() || !w.contains("from") || !w.contains("to"))
        throw BadInput(where + ": a witness needs \"object\", \"from\" and \"to\"");
      r.witnesses.push_back({text_or(w, "object", ""), detail::rational_point_from_json(w["from"], where + ", witness"),
                             detail::rational_point_from_json(w["to"], where + ", witness")});
    }
  }
  return r;
}

ViewCell view_cell(Result const& r, std::string const& where)
{
  try {
    return r.cell_box ? ViewCell(*r.cell_box) : ViewCell::hull(r.cell);
  } catch (std::invalid_argument const& e) {
    throw BadInput(where + ": " + e.what());
  }
}

}  // namespace

ViewCell cell_of(Result const& result)
{
  if (result.cell.empty()) throw BadInput("the result has no \"cell\"");
  return view_cell(result, "the result's cell");
}

std::vector<std::uint32_t> objects_of(Result const& result, Scene const& scene)
{
  std::unordered_map<std::string_view, std::uint32_t> index;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) index.emplace(scene.objects[i].name, i);
  std::vector<std::uint32_t> out;
  for (auto const& name : result.visible) {
    auto const found = index.find(name);
    if (found == index.end())
      throw BadInput("the set names object '" + name + "', which scene " + scene.source + " does not have");
    out.push_back(found->second);
  }
  std::ranges::sort(out);
  return out;
}

std::string to_json(std::vector<Result> const& results)
{
  if (results.size() == 1) return result_json(results.front()).dump(1) + "\n";
  Json all = Json::array();
  for (auto const& r : results) all.push_back(result_json(r));
  return all.dump(1) + "\n";
}

std::vector<Result> results_from_json(std::string_view text, std::string const& name)
{
  std::vector<Result> out;
  detail::for_each_entry(detail::parse_json(text, name), name, [&](Json const& value, std::string const& where) {
    out.push_back(result_from_json(value, where));
  });
  if (out.empty()) throw BadInput(name + ": no results");
  return out;
}

std::vector<Result> read_results(std::filesystem::path const& file)
{
  return results_from_json(detail::read_text(file.string()), file.string());
}

std::vector<ViewCell> cells_from_json(std::string_view text, std::string const& name)
{
  std::vector<ViewCell> out;
  detail::for_each_entry(detail::parse_json(text, name), name, [&](Json const& value, std::string const& where) {
    Result r;
    read_cell(value, r, where);
    out.push_back(view_cell(r, where));
  });
  if (out.empty()) throw BadInput(name + ": no cells");
  return out;
}

std::vector<ViewCell> read_cells(std::filesystem::path const& file)
{
  return cells_from_json(detail::read_text(file.string()), file.string());
}

}  // namespace visibility
