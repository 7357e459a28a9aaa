#include "parameters.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace visibility::generators {

namespace {

constexpr double last_integer = 0x1p53;  // up to here every integer is a double

std::string names(GeneratorKind const& kind)
{
  std::string list;
  for (auto const& p : kind.parameters) (list += list.empty() ? "" : ", ") += p.name;
  return list;
}

/// Appended piece by piece: with g++ 12, "..." + string draws a false -Wrestrict.
std::string quoted(std::string_view text)
{
  std::string q(1, '\'');
  q += text;
  q += '\'';
  return q;
}

}  // namespace

std::string text(double value)
{
  std::array<char, 32> buffer{};
  auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

GeneratorParameter integer(std::string name, double value, double min, double max, std::string help)
{
  return {std::move(name), GeneratorParameter::Type::integer, value, min, max, std::move(help)};
}

GeneratorParameter number(std::string name, double value, double min, double max, std::string help)
{
  return {std::move(name), GeneratorParameter::Type::number, value, min, max, std::move(help)};
}

GeneratorParameter seed()
{
  return integer("seed", 1, 0, last_integer, "start of the random numbers: another seed, another scene");
}

Parameters::Parameters(GeneratorKind const& kind, std::string_view text) : kind_(&kind)
{
  for (auto const& p : kind.parameters) values_.push_back(p.value);
  std::vector<bool> given(values_.size(), false);
  while (!text.empty()) {
    text.remove_prefix(1);  // the comma
    auto const item = text.substr(0, text.find(','));
    text.remove_prefix(item.size());
    auto const equals = item.find('=');
    if (equals == std::string_view::npos || equals == 0) fail(quoted(item) + " is not key=value; keys: " + names(kind));
    auto const key = item.substr(0, equals);
    auto const i = index(key);
    if (i == values_.size()) fail(quoted(key) + " is not a key; keys: " + names(kind));
    if (given[i]) fail(quoted(key) + " is given twice");
    given[i] = true;
    values_[i] = parse(kind.parameters[i], item.substr(equals + 1));
  }
}

double Parameters::parse(GeneratorParameter const& p, std::string_view text) const
{
  bool const integral = p.type == GeneratorParameter::Type::integer;
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  bool const ok = error == std::errc() && end == text.data() + text.size() && value >= p.min && value <= p.max &&
                  (!integral || value == std::floor(value));  // NaN fails the comparisons
  if (!ok)
    fail(p.name + "=" + std::string(text) + " is not valid; it takes " + (integral ? "an integer" : "a number") +
         " from " + generators::text(p.min) + " to " + generators::text(p.max) + " (" + p.help + ")");
  return value;
}

std::size_t Parameters::index(std::string_view name) const
{
  std::size_t i = 0;
  while (i < values_.size() && kind_->parameters[i].name != name) ++i;
  return i;
}

double Parameters::number(std::string_view name) const
{
  auto const i = index(name);
  if (i == values_.size()) throw std::logic_error("generator " + kind_->name + " has no " + std::string(name));
  return values_[i];
}

std::uint64_t Parameters::integer(std::string_view name) const { return static_cast<std::uint64_t>(number(name)); }

void Parameters::require(bool ok, std::string const& what) const
{
  if (!ok) fail(what);
}

void Parameters::fail(std::string const& what) const { throw BadInput("generator '" + kind_->name + "': " + what); }

}  // namespace visibility::generators
