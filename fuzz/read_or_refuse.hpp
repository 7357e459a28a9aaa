#pragma once

#include "visibility/scene/read_scene.hpp"

#include <cstdlib>
#include <iostream>

namespace visibility::fuzz {

/// Any outcome but a valid scene or BadInput with a one-line message is a fault; libFuzzer reports whatever else is
/// thrown.
inline void read_or_refuse(std::uint8_t const* data, std::size_t size, SceneFormat format,
                           ReadOptions const& options = {})
{
  try {
    read_scene_text({reinterpret_cast<char const*>(data), size}, format, "fuzz", options).validate();
  } catch (BadInput const& e) {
    if (std::string_view(e.what()).find('\n') == std::string_view::npos) return;
    std::cerr << "message of several lines: " << e.what() << '\n';
    std::abort();
  }
}

}  // namespace visibility::fuzz
