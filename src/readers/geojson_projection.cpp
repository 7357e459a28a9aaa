#include "geojson_projection.hpp"

#include "numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace visibility::readers {

namespace {

template <class Use>
void for_each_point(std::span<Prism const> prisms, Use&& use)
{
  for (auto const& p : prisms)
    for (auto const& ring : p.rings)
      for (auto const& v : ring) use(v);
}

struct Extent {
  double min_x = HUGE_VAL, max_x = -HUGE_VAL, min_y = HUGE_VAL, max_y = -HUGE_VAL;
  void extend(Point2d const& v)
  {
    min_x = std::min(min_x, v.x), max_x = std::max(max_x, v.x);
    min_y = std::min(min_y, v.y), max_y = std::max(max_y, v.y);
  }
  double width() const { return std::max(max_x - min_x, max_y - min_y); }
};

}  // namespace

ReferenceSystem classify_reference_system(std::string_view name)
{
  if (name.empty()) return ReferenceSystem::none;
  if (name.find("CRS84") != std::string_view::npos || name.find("CRS:84") != std::string_view::npos)
    return ReferenceSystem::degrees;
  auto const digits = name.find_last_not_of("0123456789");
  auto const code = digits == std::string_view::npos ? name : name.substr(digits + 1);
  // Geographic systems in use: WGS 84, ETRS89, NAD83, RGF93, JGD2000, JGD2011, SIRGAS 2000, CGCS2000, GDA94, GDA2020.
  constexpr std::string_view geographic[] = {"4326", "4979", "4258", "4937", "4269", "4171", "4612",
                                             "6668", "6697", "4674", "4490", "4283", "7844"};
  return std::ranges::find(geographic, code) != std::end(geographic) ? ReferenceSystem::degrees
                                                                     : ReferenceSystem::metres;
}

bool are_degrees(std::span<Prism const> prisms, ReferenceSystem system, CoordinateUnit wish)
{
  if (wish != CoordinateUnit::automatic) return wish == CoordinateUnit::degrees;
  if (system != ReferenceSystem::none) return system == ReferenceSystem::degrees;
  bool on_globe = true;
  for_each_point(prisms,
                 [&](Point2d const& v) { on_globe = on_globe && std::fabs(v.x) <= 180 && std::fabs(v.y) <= 90; });
  if (!on_globe || prisms.empty()) return false;
  std::vector<double> widths;
  for (auto const& p : prisms) {
    Extent e;
    for (auto const& v : p.rings.front()) e.extend(v);
    widths.push_back(e.width());
  }
  auto const middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::ranges::nth_element(widths, middle);
  return *middle <= 0.05;
}

std::string project(std::span<Prism> prisms)
{
  Extent e;
  for_each_point(prisms, [&](Point2d const& v) { e.extend(v); });
  // Any origin is valid; a short decimal is easy to repeat elsewhere.
  auto const short_decimal = [](double degrees) { return std::round(degrees * 1e4) / 1e4; };
  double const lambda = short_decimal(0.5 * e.min_x + 0.5 * e.max_x),
               phi = short_decimal(0.5 * e.min_y + 0.5 * e.max_y);
  constexpr double radian = std::numbers::pi / 180;
  constexpr double a = 6378137, flattening = 1 / 298.257223563;  // WGS 84
  constexpr double e2 = flattening * (2 - flattening);
  double const s = std::sin(phi * radian), w = 1 - e2 * s * s;
  double const east = a / std::sqrt(w) * std::cos(phi * radian) * radian;
  double const north = a * (1 - e2) / (w * std::sqrt(w)) * radian;
  for (auto& p : prisms)
    for (auto& ring : p.rings)
      for (auto& v : ring) v = {(v.x - lambda) * east, (v.y - phi) * north};
  return "longitude and latitude projected to metres east and north of " + shortest(lambda) + ", " + shortest(phi) +
         " (local equirectangular, WGS 84)";
}

}  // namespace visibility::readers
