#pragma once

#include "support/random.hpp"

#include "visibility/line_space/portal_sequence.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace visibility::test {

/// Named families of portal sequences, from harmless to vicious.
enum class PortalFamily {
  random,          ///< edges roughly across the x axis, all numbers with full mantissas
  grid,            ///< small integers: parallel and coplanar edges, equal heights, shared end points
  nearly_aligned,  ///< one plane and equal widths on a rotated wall, then single coordinates moved by one ulp
  city             ///< millimetres at an offset of 10^6, parallel walls, few heights
};

inline constexpr std::array all_portal_families{PortalFamily::random, PortalFamily::grid, PortalFamily::nearly_aligned,
                                                PortalFamily::city};

inline std::string_view name(PortalFamily family)
{
  static constexpr std::array<std::string_view, 4> names{"random", "grid", "nearly_aligned", "city"};
  return names[static_cast<std::size_t>(family)];
}

/// Makes portal sequences of one family. The end points are among the points.
class PortalSource {
public:
  PortalSource(PortalFamily family, std::uint64_t seed) : family_(family), random_(seed) {}

  Random& random() { return random_; }

  PortalSequence sequence(int occluders)
  {
    begin();
    PortalSequence s;
    s.source = edge(0, 0);
    s.target = edge(100, 0);
    for (int i = 0; i < occluders; ++i) s.occluders.push_back(edge(place(), drop_));
    add_end_points(s);
    return s;
  }

private:
  void begin()
  {
    drop_ = random_.chance(0.5) ? 0 : random_.uniform(0, 5);
    angle_ = random_.uniform(0, 6.28);
    slope_ = random_.chance(0.5) ? 0 : random_.uniform(-0.1, 0.1);
    height_ = random_.uniform(3, 20);
    half_width_ = random_.uniform(1, 5);
  }

  double place()
  {
    if (family_ == PortalFamily::grid || family_ == PortalFamily::nearly_aligned) return 10.0 * random_.between(1, 9);
    return random_.uniform(3, 97);
  }

  PortalSequence::Edge edge(double x, double drop)
  {
    switch (family_) {
    case PortalFamily::random: {
      double const along = random_.uniform(-2, 2), l = random_.uniform(0.5, 5), r = random_.uniform(0.5, 5);
      return {{x + along, l, random_.uniform(8, 15) - drop}, {x - along, -r, random_.uniform(8, 15) - drop}};
    }
    case PortalFamily::grid: {
      double const skew = random_.chance(0.3) ? random_.between(-2, 2) : 0, z = random_.between(0, 3);
      double const dz = random_.chance(0.3) ? random_.between(-1, 1) : 0;
      return {{x / 10 + skew, double(random_.between(0, 3)), z}, {x / 10, -double(random_.between(0, 3)), z + dz}};
    }
    case PortalFamily::nearly_aligned: return {ulp(wall(x, half_width_)), ulp(wall(x, -half_width_))};
    case PortalFamily::city: break;
    }
    double const l = half_width_ * random_.between(1, 3), r = half_width_ * random_.between(1, 3);
    double const z = 3.5 * random_.between(1, 4) + (random_.chance(0.3) ? random_.uniform(-1, 1) : 0);
    auto const millimetres = [&](double y) {
      Point3d const p = wall(x, y);
      auto const round = [](double v) { return std::round(v * 1000) / 1000; };
      return Point3d{round(954321.007 + p.x), round(1843210.111 + p.y), round(z)};
    };
    return {millimetres(l), millimetres(-r)};
  }

  /// Of the plane in which all edges of a nearly aligned sequence lie, rotated about z.
  Point3d wall(double x, double y) const
  {
    return {x * std::cos(angle_) - y * std::sin(angle_), x * std::sin(angle_) + y * std::cos(angle_),
            height_ + slope_ * x};
  }

  Point3d ulp(Point3d p)
  {
    for (double* v : {&p.x, &p.y, &p.z})
      if (random_.chance(0.3)) *v = std::nextafter(*v, random_.chance(0.5) ? HUGE_VAL : -HUGE_VAL);
    return p;
  }

  PortalFamily family_;
  Random random_;
  double drop_ = 0, angle_ = 0, slope_ = 0, height_ = 0, half_width_ = 0;
};

}  // namespace visibility::test
