#pragma once

#include <string>

namespace visibility::commands {

/// Writes the whole text or leaves the file as it was. Throws BadInput if it cannot be written.
void write_output(std::string const& file, std::string const& text);

}  // namespace visibility::commands
