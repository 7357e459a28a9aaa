#pragma once

#include "visibility/scene/read_scene.hpp"

#include "json_value.hpp"

#include <string>
#include <string_view>

/// The readers behind read_scene_text. All throw BadInput.
namespace visibility::readers {

Scene read_obj(std::string_view bytes, std::string const& source);
Scene read_ply(std::string_view bytes, std::string const& source, ReadOptions const& options);

/// Each of these gets the first JSON document of the stream, already parsed, and reads on from there.
Scene read_cityjson(JsonValue first, JsonStream& stream);
Scene read_geojson(JsonValue first, JsonStream& stream, ReadOptions const& options);
Scene read_native(JsonValue const& document, std::string const& source);

/// Throws BadInput: "source, where: what".
[[noreturn]] void fail(std::string const& source, std::string const& where, std::string const& what);

/// A text fit for a name or a message: valid UTF-8 without control characters, both replaced by '?'.
std::string printable(std::string_view text);

}  // namespace visibility::readers
