#pragma once

#include "json_value.hpp"

#include "visibility/scene/read_scene.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>

namespace visibility::readers {

/// Reads heights and grounds of footprints from their properties, and remembers which properties served.
class FootprintHeights {
public:
  explicit FootprintHeights(ReadOptions const& options) : options_(options) {}

  struct Ground {
    double elevation;
    /// The height is measured from here; otherwise from the same zero as this elevation (OpenStreetMap's min_height).
    bool height_starts_here;
  };
  /// Metres; empty if the properties have none that is a positive number (also as text: "12.5", "12.5 m").
  std::optional<double> height(JsonValue const& properties);
  std::optional<Ground> ground(JsonValue const& properties);

  /// Names of properties that were there when no height was found, "a, b, c".
  std::string seen() const;
  std::size_t from_levels() const { return from_levels_; }  ///< heights that are a number of storeys times 3 m
  std::string used() const;                                 ///< "height from h; ground from Z_MIN_SOL"

  static constexpr double metres_per_level = 3;

private:
  ReadOptions const& options_;
  std::set<std::string> seen_, height_names_, ground_names_;
  std::size_t from_levels_ = 0;
};

}  // namespace visibility::readers
