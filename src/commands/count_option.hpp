#pragma once

#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace visibility::commands {

/// An option whose value is a whole number from 1 to 2^53, also written like 1e7.
void add_count_option(CLI::App& command, std::string const& name, std::uint64_t& value, std::string const& help);

}  // namespace visibility::commands
