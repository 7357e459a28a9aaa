#include "visibility/evidence/check_occludees.hpp"

#include "cell_points.hpp"

#include "visibility/evidence/sight_line.hpp"
#include "visibility/scene/meets_cell.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace visibility {

namespace {

using detail::Random;

constexpr std::uint64_t batch = 1024;  // rays between looks at the clock
/// A ray that gets so far, in shares of its way, is worth an exact test: it may end on an occluder's own face.
constexpr double nearly_there = 1 - 0x1p-10;

/// The pieces of one occludee that the set lacks.
struct Wanted {
  std::uint32_t object;
  std::vector<std::uint32_t> pieces;
};

std::vector<Wanted> lacking(Occludees const& occludees, std::span<std::uint32_t const> visible)
{
  std::vector<bool> is_member(occludees.object_count());
  for (auto const o : visible) {
    if (o >= is_member.size()) throw std::invalid_argument("the set names occludee " + std::to_string(o));
    is_member[o] = true;
  }
  std::vector<Wanted> out;
  for (std::uint32_t o = 0; o < is_member.size(); ++o)
    if (!is_member[o]) out.push_back({o, {}});
  auto const pieces = occludees.pieces();
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    auto const w = std::ranges::lower_bound(out, pieces[i].object, {}, &Wanted::object);
    if (w != out.end() && w->object == pieces[i].object) w->pieces.push_back(i);
  }
  return out;
}

/// A point of the relative interior of a convex polygon, as a sum of its corners with weights that are doubles.
Point3q inside(std::span<Point3d const> corners, Random& random)
{
  Point3q sum{0, 0, 0};
  RationalNumber total = 0;
  for (auto const& c : corners) {
    // The weights of a few corners dominate now and then, so that rims are looked at as well.
    RationalNumber const w(0x1p-30 + std::ldexp(random.unit(), random.chance(0.3) ? 0 : -12));
    sum = {sum.x + w * RationalNumber(c.x), sum.y + w * RationalNumber(c.y), sum.z + w * RationalNumber(c.z)};
    total += w;
  }
  return {sum.x / total, sum.y / total, sum.z / total};
}

}  // namespace

CheckReport check(RayScene const& occluders, Occludees const& occludees, ViewCell const& cell,
                  std::span<std::uint32_t const> visible, Guarantee claimed, CheckOptions const& options)
{
  using Clock = std::chrono::steady_clock;
  auto const start = Clock::now();
  auto const seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  CheckReport report;
  auto wanted = lacking(occludees, visible);
  std::erase_if(wanted, [&](Wanted const& w) {
    bool const meets = meets_cell(occludees.scene(), cell, w.object);
    if (meets) report.missing.push_back(w.object);
    return meets || w.pieces.empty();
  });
  detail::CellPoints const points(cell, occluders);
  Random random(options.seed);
  for (std::size_t turn = 0; report.rays < options.rays && !wanted.empty(); ++turn) {
    if (report.rays % batch == 0 && report.rays > 0) {
      if (options.progress) options.progress(batch);
      if (options.seconds > 0 && seconds() > options.seconds) break;
    }
    ++report.rays;
    auto const i = static_cast<std::ptrdiff_t>(turn % wanted.size());
    auto const& w = wanted[static_cast<std::size_t>(i)];
    auto const& piece = occludees.pieces()[w.pieces[random.below(w.pieces.size())]];
    Point3q const to = inside(occludees.corners(piece), random);
    Point3d const near = detail::rounded(to), from = points.any(random);
    Point3d const way{near.x - from.x, near.y - from.y, near.z - from.z};
    if (way == Point3d{0, 0, 0} || occluders.first_hit(from, way).distance < nearly_there) continue;
    Point3q const eye = exact(from);
    if (!in_interior(cell, from) || blocker<FilteredRational>(occluders.scene(), enclosed(eye), enclosed(to))) {
      ++report.rejected;
      continue;
    }
    report.missing.push_back(w.object);
    report.witnesses.push_back({w.object, eye, to});
    wanted.erase(wanted.begin() + i);
  }
  std::ranges::sort(report.missing);
  std::ranges::sort(report.witnesses, {}, &Witness::object);
  report.seconds = seconds();
  report.fault = !report.missing.empty() && (claimed == Guarantee::exact || claimed == Guarantee::conservative);
  return report;
}

}  // namespace visibility
