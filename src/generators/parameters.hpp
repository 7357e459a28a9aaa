#pragma once

#include "visibility/scene/generators.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace visibility::generators {

/// The values for one kind: its defaults, replaced by what a specification says. The only place that reads and
/// checks values.
class Parameters {
public:
  /// `text` is what follows the kind: empty or ",key=value,...". Throws BadInput. Keeps a reference to `kind`.
  Parameters(GeneratorKind const& kind, std::string_view text);

  double number(std::string_view name) const;          ///< throws std::logic_error if the kind has no such parameter
  std::uint64_t integer(std::string_view name) const;  ///< the same; requires: min >= 0
  std::uint64_t seed() const { return integer("seed"); }

  /// For what only holds between parameters. Throws BadInput with `what` unless `ok`.
  void require(bool ok, std::string const& what) const;

private:
  std::size_t index(std::string_view name) const;
  [[noreturn]] void fail(std::string const& what) const;
  double parse(GeneratorParameter const& parameter, std::string_view text) const;

  GeneratorKind const* kind_;
  std::vector<double> values_;
};

GeneratorParameter integer(std::string name, double value, double min, double max, std::string help);
GeneratorParameter number(std::string name, double value, double min, double max, std::string help);
GeneratorParameter seed();  ///< every kind has it

/// The double in decimal, as short as can be: for messages.
std::string text(double value);

}  // namespace visibility::generators
