#include "geojson_heights.hpp"

#include "numbers.hpp"
#include "readers.hpp"

#include <cmath>

namespace visibility::readers {

namespace {

// In the order they are tried. docs/readers.md repeats the lists.
constexpr std::string_view height_names[] = {
  "height",        "h",      "HAUTEUR", "hauteur",     "measuredHeight",  "measured_height",      "building:height",
  "render_height", "Height", "HEIGHT",  "roof_height", "building_height", "heightroof",           "HEIGHTROOF",
  "ROOF_HEIGHT",   "hoehe",  "altura",  "bldg_height", "BLDG_HT",         "fill-extrusion-height"};
constexpr std::string_view level_names[] = {"building:levels", "levels", "num_floors", "NB_ETAGES",
                                            "storeysAboveGround"};

struct GroundName {
  std::string_view name;
  bool height_starts_here;
  double factor;
};
constexpr GroundName ground_names[] = {{"Z_MIN_SOL", true, 1},
                                       {"ground", true, 1},
                                       {"ground_height", true, 1},
                                       {"ground_elevation", true, 1},
                                       {"groundelev", true, 1},
                                       {"GROUNDELEV", true, 1},
                                       {"z_ground", true, 1},
                                       {"base_elevation", true, 1},
                                       {"base_height", false, 1},
                                       {"min_height", false, 1},
                                       {"render_min_height", false, 1},
                                       {"building:min_height", false, 1},
                                       {"fill-extrusion-base", false, 1},
                                       {"building:min_level", false, FootprintHeights::metres_per_level}};

/// A finite number, also one written as text and followed by the unit metre.
std::optional<double> metres(JsonValue const* value)
{
  if (value == nullptr) return std::nullopt;
  auto number = value->as_number();
  if (auto const* text = value->as_string()) {
    std::string_view rest = *text;
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    number = take_double(rest);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    while (rest.ends_with(' ')) rest.remove_suffix(1);
    if (!rest.empty() && rest != "m" && rest != "metres" && rest != "meters") return std::nullopt;
  }
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string joined(std::set<std::string> const& names)
{
  std::string out;
  for (auto const& n : names) (out += out.empty() ? "" : ", ") += n;
  return out;
}

}  // namespace

std::optional<double> FootprintHeights::height(JsonValue const& properties)
{
  auto const positive = [&](std::string_view name) {
    auto const h = metres(properties.find(name));
    return h && *h > 0 ? h : std::nullopt;
  };
  if (!options_.height_property.empty()) {
    if (auto const h = positive(options_.height_property)) return h;
  } else {
    for (auto const name : height_names)
      if (auto const h = positive(name)) {
        if (height_names_.size() < std::size(height_names)) height_names_.emplace(name);
        return h;
      }
    for (auto const name : level_names)
      if (auto const levels = positive(name)) {
        height_names_.emplace(name);
        ++from_levels_;
        return *levels * metres_per_level;
      }
  }
  if (auto const* members = properties.as_object())
    for (auto const& [name, value] : *members)
      if (seen_.size() < 20) seen_.insert(printable(name));
  return std::nullopt;
}

std::optional<FootprintHeights::Ground> FootprintHeights::ground(JsonValue const& properties)
{
  auto const& wanted = options_.ground_property;
  for (auto const& g : ground_names) {
    if (!wanted.empty() && wanted != g.name) continue;
    auto const z = metres(properties.find(g.name));
    if (!z) continue;
    ground_names_.emplace(g.name);
    return Ground{*z * g.factor, g.height_starts_here};
  }
  if (wanted.empty()) return std::nullopt;
  auto const z = metres(properties.find(wanted));
  if (!z) return std::nullopt;
  ground_names_.insert(printable(wanted));
  return Ground{*z, true};
}

std::string FootprintHeights::seen() const { return seen_.empty() ? "none" : joined(seen_); }

std::string FootprintHeights::used() const
{
  auto const& h = options_.height_property;
  std::string out = "height from " + (h.empty() ? joined(height_names_) : printable(h));
  return out + "; ground " + (ground_names_.empty() ? "at 0" : "from " + joined(ground_names_));
}

}  // namespace visibility::readers
