#include "visibility/scene/read_scene.hpp"

#include "file_bytes.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cctype>
#include <new>

namespace visibility {

namespace readers {

namespace {

/// Length of the UTF-8 sequence at the front of the text; 0 if there is none.
std::size_t utf8_length(std::string_view s)
{
  auto const byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  auto const tail = [&](std::size_t n) {
    if (s.size() < n) return false;
    for (std::size_t i = 1; i < n; ++i)
      if ((byte(i) & 0xC0) != 0x80) return false;
    return true;
  };
  unsigned const b = byte(0);
  if (b < 0x80) return 1;
  if (b >= 0xC2 && b < 0xE0) return tail(2) ? 2 : 0;
  if (b >= 0xE0 && b < 0xF0) {
    if (!tail(3)) return 0;
    bool const overlong = b == 0xE0 && byte(1) < 0xA0, surrogate = b == 0xED && byte(1) >= 0xA0;
    return overlong || surrogate ? 0 : 3;
  }
  if (b >= 0xF0 && b < 0xF5) {
    if (!tail(4)) return 0;
    return (b == 0xF0 && byte(1) < 0x90) || (b == 0xF4 && byte(1) >= 0x90) ? 0 : 4;
  }
  return 0;
}

}  // namespace

std::string printable(std::string_view text)
{
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    auto const n = utf8_length(text);
    bool const control = static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7F;
    if (n == 0 || control)
      out += '?';
    else
      out += text.substr(0, n);
    text.remove_prefix(std::max<std::size_t>(n, 1));
  }
  return out;
}

void fail(std::string const& source, std::string const& where, std::string const& what)
{
  throw BadInput(source + (where.empty() ? "" : ", " + where) + ": " + what);
}

}  // namespace readers

namespace {

Scene read_json(std::string_view bytes, std::string const& source, ReadOptions const& options)
{
  readers::JsonStream stream(bytes, source);
  auto first = stream.next();
  if (!first) readers::fail(source, {}, "is empty");
  if (first->text("format").starts_with("visibility-scene/")) return readers::read_native(*first, source);
  auto const type = first->text("type");
  if (type == "CityJSON") return readers::read_cityjson(std::move(*first), stream);
  if (type == "CityJSONFeature")
    readers::fail(source, "line 1",
                  "a CityJSONFeature before the CityJSON line with the transform; put that line first");
  if (type == "Feature" || type == "FeatureCollection" || type == "Polygon" || type == "MultiPolygon")
    return readers::read_geojson(std::move(*first), stream, options);
  readers::fail(source, {},
                "JSON that is neither CityJSON, GeoJSON nor visibility-scene/1 (its \"type\" is '" + std::string(type) +
                  "'); convert it to one of these");
}

Scene dispatch(std::string_view bytes, SceneFormat format, std::string const& source, ReadOptions const& options)
{
  switch (format) {
  case SceneFormat::obj: return readers::read_obj(bytes, source);
  case SceneFormat::ply: return readers::read_ply(bytes, source, options);
  case SceneFormat::json: return read_json(bytes, source, options);
  }
  readers::fail(source, {}, "unknown scene format");
}

SceneFormat format_of(std::filesystem::path path, std::string_view bytes)
{
  auto const lower = [](std::string s) {
    std::ranges::transform(s, s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return s;
  };
  if (lower(path.extension().string()) == ".gz") path.replace_extension();
  auto const extension = lower(path.extension().string());
  if (extension == ".obj") return SceneFormat::obj;
  if (extension == ".ply") return SceneFormat::ply;
  if (extension.find("json") != std::string::npos) return SceneFormat::json;
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return SceneFormat::ply;
  auto const first = bytes.find_first_not_of(" \t\r\n\x1e\xEF\xBB\xBF");
  if (first != std::string_view::npos && bytes[first] == '{') return SceneFormat::json;
  readers::fail(path.string(), {},
                "unknown kind of file; name it .obj, .ply, .json, .jsonl, .geojson or .geojsonl (.gz may follow)");
}

}  // namespace

Scene read_scene_text(std::string_view bytes, SceneFormat format, std::string const& source, ReadOptions const& options)
{
  try {
    return dispatch(bytes, format, source, options);
  } catch (BadInput const& e) {
    throw BadInput(readers::printable(e.what()));  // names from the file may hold anything; the message is one line
  } catch (std::bad_alloc const&) {
    throw BadInput(source + ": too large for the memory of this machine; split the file");
  }
}

Scene read_scene(std::filesystem::path const& path, ReadOptions const& options)
{
  try {
    std::string const bytes = readers::file_bytes(path);
    return read_scene_text(bytes, format_of(path, bytes), path.string(), options);
  } catch (std::bad_alloc const&) {
    throw BadInput(path.string() + ": too large for the memory of this machine; split the file");
  }
}

}  // namespace visibility
