#pragma once

#include <filesystem>
#include <string>

namespace visibility::readers {

/// The content of a file, unpacked if it is gzipped. Throws BadInput if it cannot be read or the packing is damaged.
std::string file_bytes(std::filesystem::path const& path);

}  // namespace visibility::readers
