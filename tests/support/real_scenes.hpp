#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace visibility::test {

/// Path of a real scene, e.g. "city/munich.ply", if this machine has it.
inline std::optional<std::filesystem::path> real_scene(std::string const& name)
{
  auto const path = std::filesystem::path(VISIBILITY_SCENES_DIR) / name;
  return std::filesystem::exists(path) ? std::optional(path) : std::nullopt;
}

}  // namespace visibility::test
