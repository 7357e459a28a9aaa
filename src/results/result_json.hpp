#pragma once

#include "visibility/kernel/point.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace visibility::detail {

using Json = nlohmann::ordered_json;

/// Parses, or throws BadInput with `name` and the position of the fault. Depth is limited, so hostile nesting is a
/// fault like any other.
Json parse_json(std::string_view text, std::string const& name);

/// The whole file. Throws BadInput if it cannot be read.
std::string read_text(std::string const& file);

Json to_json(Point3d const& p);
/// Each coordinate a number where it is a double, else a string "numerator/denominator".
Json to_json(Point3q const& p);
Point3d point_from_json(Json const& value, std::string const& where);
Point3q rational_point_from_json(Json const& value, std::string const& where);
Point2d plan_point_from_json(Json const& value, std::string const& where);
/// A number, or a string "numerator/denominator" or "integer".
RationalNumber rational_from_json(Json const& value, std::string const& where);

/// The elements of a list, or the value itself, each with its place in words.
template <class Visit>
void for_each_entry(Json const& value, std::string const& name, Visit&& visit)
{
  if (!value.is_array()) return visit(value, name);
  for (std::size_t i = 0; i < value.size(); ++i) visit(value[i], name + ", entry " + std::to_string(i + 1));
}

}  // namespace visibility::detail
