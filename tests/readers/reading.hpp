#pragma once

#include "support/catch.hpp"

#include "visibility/scene/read_scene.hpp"

#include <string>

namespace visibility::test {

/// The scene, validated.
inline Scene read(std::string const& bytes, SceneFormat format, ReadOptions const& options = {})
{
  Scene scene = read_scene_text(bytes, format, "input", options);
  scene.validate();
  return scene;
}
inline Scene read_obj(std::string const& bytes) { return read(bytes, SceneFormat::obj); }
inline Scene read_ply(std::string const& bytes, ReadOptions const& options = {})
{
  return read(bytes, SceneFormat::ply, options);
}
inline Scene read_json(std::string const& bytes, ReadOptions const& options = {})
{
  return read(bytes, SceneFormat::json, options);
}

/// The message of the BadInput that reading must throw.
inline std::string refusal(std::string const& bytes, SceneFormat format, ReadOptions const& options = {})
{
  try {
    read_scene_text(bytes, format, "input", options);
  } catch (BadInput const& e) {
    return e.what();
  }
  return "(was read)";
}

inline std::vector<std::string> names(Scene const& scene)
{
  std::vector<std::string> out;
  for (auto const& o : scene.objects) out.push_back(o.name);
  return out;
}

inline bool has_note(Scene const& scene, std::string const& part)
{
  for (auto const& n : scene.notes)
    if (n.find(part) != std::string::npos) return true;
  return false;
}

using Names = std::vector<std::string>;

}  // namespace visibility::test
