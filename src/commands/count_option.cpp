#include "count_option.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>

namespace visibility::commands {

void add_count_option(CLI::App& command, std::string const& name, std::uint64_t& value, std::string const& help)
{
  command.add_option_function<std::string>(
    name,
    [name, &value](std::string const& text) {
      double x = 0;
      auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
      bool const whole = error == std::errc{} && end == text.data() + text.size() && x == std::floor(x);
      if (!whole || x < 1 || x > 0x1p53) throw BadInput(name + " '" + text + "' is not a whole number of at least 1");
      value = static_cast<std::uint64_t>(x);
    },
    help);
}

}  // namespace visibility::commands
