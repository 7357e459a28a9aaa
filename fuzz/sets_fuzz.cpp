#include "visibility/scene/scene_builder.hpp"
#include "visibility/viewspace/sets_file.hpp"

#include <zlib.h>

#include <cstdlib>
#include <iostream>
#include <string>

/// The input lacks the checksum at the end, so that it gets past it.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
  std::string bytes(reinterpret_cast<char const*>(data), size);
  auto const crc = crc32_z(0, data, size);
  for (int i = 0; i < 32; i += 8) bytes += static_cast<char>(crc >> i & 0xff);
  try {
    auto const stored = visibility::stored_sets_from_bytes(bytes, "fuzz");
    for (auto const& set : stored.sets.all())
      if (!set.empty() && set.back() >= stored.names.size()) std::abort();
    (void)stored.sets.cell_at({0, 0, 0});
  } catch (visibility::BadInput const& e) {
    if (std::string_view(e.what()).find('\n') == std::string_view::npos) return 0;
    std::cerr << "message of several lines: " << e.what() << '\n';
    std::abort();
  }
  return 0;
}
