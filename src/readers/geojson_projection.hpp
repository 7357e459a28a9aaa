#pragma once

#include "visibility/scene/footprint.hpp"
#include "visibility/scene/read_scene.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace visibility::readers {

/// What a reference system name says about units.
enum class ReferenceSystem { none, degrees, metres };
ReferenceSystem classify_reference_system(std::string_view name);

/// Whether the footprints are longitudes and latitudes. Without a reference system GeoJSON means degrees [RFC 7946],
/// but local metres are common: coordinates beyond ±180 / ±90 are metres, and so are footprints of which half are wider
/// than 0.05 (5 km, were it degrees).
bool are_degrees(std::span<Prism const> prisms, ReferenceSystem system, CoordinateUnit wish);

/// Replaces longitude and latitude (WGS 84) by metres east and north of the middle of all coordinates, and says so.
/// Local equirectangular projection: x = N(phi0) cos(phi0) (lambda - lambda0), y = M(phi0) (phi - phi0) with the
/// ellipsoid's radii of curvature [Snyder 1987, sec. 4]. It keeps order and equality along each axis, so shared walls
/// stay shared; east-west lengths y metres north of the origin are off by tan(phi0) y / 6.4e6: 1.6 in 1,000 at 10 km,
/// 45 N.
std::string project(std::span<Prism> prisms);

}  // namespace visibility::readers
