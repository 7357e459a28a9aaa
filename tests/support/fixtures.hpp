#pragma once

#include "support/catch.hpp"
#include "support/real_scenes.hpp"
#include "visibility/kernel/sign.hpp"

#include <array>
#include <fstream>
#include <sstream>

namespace visibility::test {

/// Calls check(coordinates, sign) for each line "index coordinates... sign" of a fixture of exact signs
/// [Nanevski et al. 2001], if this machine has it.
template <std::size_t N, class Check>
void for_each_fixture(std::string const& file, Check const& check)
{
  auto const path = real_scene("hard/predicates/test/fixtures/" + file);
  if (!path) {
    WARN(file << " is not on this machine");
    return;
  }
  std::ifstream in(*path);
  int lines = 0;
  for (std::string line; std::getline(in, line); ++lines) {
    std::istringstream words(line);
    std::string index;
    std::array<double, N> x{};
    int sign = 2;
    words >> index;
    for (auto& c : x) {
      std::string word;
      words >> word;
      c = std::strtod(word.c_str(), nullptr);  // correctly rounded
    }
    words >> sign;
    CAPTURE(file, index);
    REQUIRE(words);
    check(x, static_cast<Sign>(sign));
  }
  REQUIRE(lines == 1000);
}

}  // namespace visibility::test
