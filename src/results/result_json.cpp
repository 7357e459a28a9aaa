#include "result_json.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace visibility::detail {

namespace {

constexpr int max_depth = 64;

/// Depth of nesting of JSON text, strings skipped; needs no recursion.
int nesting(std::string_view text)
{
  int depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char const c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

double coordinate(Json const& value, std::string const& where)
{
  if (!value.is_number()) throw BadInput(where + ": expected a number");
  double const x = value.get<double>();
  if (!std::isfinite(x)) throw BadInput(where + ": a coordinate is not finite");
  return x;
}

Json number(RationalNumber const& x)
{
  double const rounded = CGAL::to_double(x);
  if (std::isfinite(rounded) && RationalNumber(rounded) == x) return rounded;
  std::ostringstream text;
  text << x.numerator() << '/' << x.denominator();
  return text.str();
}

void require_triple(Json const& value, std::string const& where)
{
  if (!value.is_array() || value.size() != 3) throw BadInput(where + ": expected [x, y, z]");
}

}  // namespace

RationalNumber rational_from_json(Json const& value, std::string const& where)
{
  if (!value.is_string()) return RationalNumber(coordinate(value, where));
  std::string const text = value.get<std::string>();
  std::size_t const slash = text.find('/');
  auto const is_integer = [](std::string_view s) {
    if (s.starts_with('-')) s.remove_prefix(1);
    return !s.empty() && std::ranges::all_of(s, [](char c) { return c >= '0' && c <= '9'; });
  };
  if (is_integer(text)) return RationalNumber(text);
  bool const ok = slash != std::string::npos && is_integer(std::string_view(text).substr(0, slash)) &&
                  is_integer(std::string_view(text).substr(slash + 1)) &&
                  text.find_first_not_of("0-", slash + 1) != std::string::npos;
  if (!ok) throw BadInput(where + ": expected a number or \"numerator/denominator\"");
  return RationalNumber(text);
}

Json parse_json(std::string_view text, std::string const& name)
{
  if (nesting(text) > max_depth) throw BadInput(name + ": nested deeper than " + std::to_string(max_depth) + " levels");
  try {
    return Json::parse(text);
  } catch (nlohmann::json::exception const& e) {
    std::string what = e.what();  // "[json.exception...] parse error at line 3, column 5: ..."
    if (auto const end = what.find("] "); end != std::string::npos) what.erase(0, end + 2);
    std::ranges::replace(what, '\n', ' ');
    throw BadInput(name + ": not valid JSON: " + what);
  }
}

std::string read_text(std::string const& file)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) {
    if (in && in.peek() == std::ifstream::traits_type::eof()) throw BadInput(file + ": empty file");
    throw BadInput(file + ": cannot read this file");
  }
  return std::move(text).str();
}

Json to_json(Point3d const& p) { return Json::array({p.x, p.y, p.z}); }

Json to_json(Point3q const& p) { return Json::array({number(p.x), number(p.y), number(p.z)}); }

Point3d point_from_json(Json const& value, std::string const& where)
{
  require_triple(value, where);
  return {coordinate(value[0], where), coordinate(value[1], where), coordinate(value[2], where)};
}

Point2d plan_point_from_json(Json const& value, std::string const& where)
{
  if (!value.is_array() || value.size() != 2) throw BadInput(where + ": expected [x, y]");
  return {coordinate(value[0], where), coordinate(value[1], where)};
}

Point3q rational_point_from_json(Json const& value, std::string const& where)
{
  require_triple(value, where);
  return {rational_from_json(value[0], where), rational_from_json(value[1], where),
          rational_from_json(value[2], where)};
}

}  // namespace visibility::detail
