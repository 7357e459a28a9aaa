#include "support/catch.hpp"
#include "support/random_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/methods/ray_space/method.hpp"
#include "visibility/methods/ray_space/occludee.hpp"
#include "visibility/methods/ray_space/occluder.hpp"
#include "visibility/scene/generators.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::ray_space;

namespace {

/// All bodies of a scene in the maps of a cell, in any order, whether visible or not.
struct World {
  World(PreparedScene const& scene, Box const& cell, double floor, Random& random)
    : options{.resolution = 1 << random.between(4, 9),
              .coarse = 1 << random.between(3, 9),
              .components = random.between(1, 4)},
      writer(floor, options)
  {
    for (int f = 0; f < 4; ++f)
      frames.emplace_back(cell, f, options.first_resolution(), options.first_resolution() / 4);
    for (auto const& f : frames) maps.emplace_back(f, options.components);
    if (options.halvings() > 0)
      for (std::size_t f = 0; f < 4; ++f) refined.emplace_back(frames[f], maps[f], options);
    auto const& bodies = scene.bodies().bodies();
    std::vector<std::size_t> order(bodies.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i, std::swap(order[i], order[static_cast<std::size_t>(random.between(0, static_cast<int>(i)))]);
    Chords chords;
    for (auto const i : order) {
      if (!bodies[i].occludes) continue;
      visit_shape(scene.bodies(), bodies[i], [&](auto const& shape) { chords_of(shape, chords); });
      for (std::size_t f = 0; f < 4; ++f)
        pixels +=
          writer.write(chords, scene.bodies().bounds()[i], frames[f], maps[f], refined.empty() ? nullptr : &refined[f]);
    }
  }

  OccludeeTest test()
  {
    std::vector<OccludeeTest::Family> families;
    for (std::size_t f = 0; f < 4; ++f)
      families.push_back({&frames[f], &maps[f], refined.empty() ? nullptr : &refined[f]});
    return OccludeeTest(families);
  }

  Options options;
  OccluderWriter writer;
  std::vector<Frame> frames;
  std::vector<OcclusionMap> maps;
  std::vector<RefinedMap> refined;  // none if pixels are not divided
  std::size_t pixels = 0;
};

Box small_box(Random& random, int lo, int hi)
{
  for (;;) {
    Point3d const p = random.grid_point(lo, hi);
    Box const b{p, {p.x + random.uniform(0, 1), p.y + random.uniform(0, 1), p.z + random.uniform(0, 1)}};
    if (b.max.z <= hi) return b;
  }
}

bool blocked(ConvexBodies const& bodies, Point3d const& p, Point3d const& q)
{
  return std::ranges::any_of(bodies.bodies(), [&](auto const& b) {
    return b.occludes && segment_meets<Filtered, End::excluded>(bodies, b, p, q);
  });
}

Scene shifted(Scene s, Point3d const& by)
{
  auto const move = [&](Point3d& p) { p = {p.x + by.x, p.y + by.y, p.z + by.z}; };
  for (auto& b : s.boxes) move(b.min), move(b.max);
  for (auto& b : s.balls) move(b.centre);
  for (auto& v : s.vertices) move(v);
  for (auto& p : s.polyhedra)
    for (auto& v : p.vertices) move(v);
  for (auto& p : s.prisms) {
    for (auto& ring : p.rings)
      for (auto& v : ring) v = {v.x + by.x, v.y + by.y};
    p.bottom += by.z, p.top += by.z;
  }
  return s;
}

}  // namespace

TEST_CASE("ray-space: every sight line to what is called hidden is blocked", "[methods][conservative]")
{
  int hidden = 0;
  std::size_t pixels = 0;
  for (int trial = 0; trial < trials(70); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    Box cell = grid_box(random, -2, 2);
    bool const far = random.chance(0.3);
    Scene scene = grid_scene(random, random.between(5, 40), -8, 8, random.chance(0.5) ? Mix::all : Mix::boxes, cell);
    Point3d const by = far ? Point3d{1e6, -2e6, 300} : Point3d{0, 0, 0};
    scene = shifted(std::move(scene), by);
    auto const at = [&](Point3d const& p) { return Point3d{p.x + by.x, p.y + by.y, p.z + by.z}; };
    cell = {at(cell.min), at(cell.max)};
    PreparedScene const prepared(scene);
    World world(prepared, cell, at({0, 0, -8}).z, random);
    pixels += world.pixels;
    OccludeeTest test = world.test();
    for (int i = 0; i < 20; ++i) {
      Box box = small_box(random, -8, 8);
      box = {at(box.min), at(box.max)};
      auto const corners = box.corners();
      std::array<Point3d, 3> const triangle{corners[0], corners[3], corners[6]};
      bool const whole = random.chance(0.5);
      if (whole ? !test.hidden(box) : !test.hidden(box, triangle)) continue;
      ++hidden;
      for (int k = 0; k < 40; ++k) {
        Point3d const p{random.uniform(cell.min.x, cell.max.x), random.uniform(cell.min.y, cell.max.y),
                        random.uniform(cell.min.z, cell.max.z)};
        Point3d const from = random.chance(0.5) ? cell.corner(random.below(8)) : p;
        auto const pick = static_cast<std::size_t>(random.below(whole ? 8 : 3));
        Point3d const q = whole ? corners[pick] : triangle[pick];
        if (from != q) CHECK(blocked(prepared.bodies(), from, q));
      }
    }
  }
  CAPTURE(hidden, pixels);
  CHECK(hidden > trials(20));
}

namespace {

/// Points whose hull is the slice of the hull of points by the line (s, t): exact.
std::vector<std::pair<RationalNumber, RationalNumber>> slice(Frame const& frame, Box const& cell, int family,
                                                             std::vector<Point3d> const& points,
                                                             RationalNumber const& s, RationalNumber const& t)
{
  // The frame's middle is a double, and what it subtracts from is exact.
  Point3d const middle{0.5 * cell.min.x + 0.5 * cell.max.x, 0.5 * cell.min.y + 0.5 * cell.max.y, cell.min.z};
  REQUIRE(frame.local({middle.x, middle.y, middle.z}).u == 0);
  struct Exact {
    RationalNumber u, z, side;
  };
  std::vector<Exact> local;
  for (auto const& p : points) {
    RationalNumber const x = RationalNumber(p.x) - RationalNumber(middle.x);
    RationalNumber const y = RationalNumber(p.y) - RationalNumber(middle.y);
    RationalNumber const forward = family < 2 ? x : y, v = family < 2 ? y : x;
    RationalNumber const u = family % 2 == 0 ? forward : RationalNumber(-forward);
    local.push_back({u, RationalNumber(p.z) - RationalNumber(middle.z), s + t * u - v});
  }
  std::vector<std::pair<RationalNumber, RationalNumber>> out;
  for (auto const& a : local)
    for (auto const& b : local) {
      if (!(a.side <= 0 && b.side >= 0) || a.side == b.side) continue;
      RationalNumber const part = a.side / (a.side - b.side);
      out.emplace_back(a.u + part * (b.u - a.u), a.z + part * (b.z - a.z));
    }
  return out;
}

}  // namespace

TEST_CASE("ray-space: a gate of a pixel is no larger than the exact slice of any of its lines", "[methods][oracle]")
{
  std::size_t gates = 0, of_parts = 0, upright = 0;
  for (int trial = 0; trial < trials(90); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    double const far = random.chance(0.3) ? 1e6 : 0;
    Box const cell{{far - random.uniform(0.5, 3), -2, 0}, {far + random.uniform(0.5, 3), 1, random.uniform(0.5, 3)}};
    std::vector<Point3d> points;
    for (int i = random.between(3, 8); i > 0; --i)
      points.push_back({far + random.uniform(4, 12), random.uniform(-8, 8), random.uniform(-4, 9)});
    if (trial % 3 == 0) {  // an upright prism, below, at or above the cell
      double const low = random.uniform(-4, 6), high = low + random.uniform(0.1, 6);
      for (auto& p : points) p.z = low;
      for (std::size_t i = 0, n = points.size(); i < n; ++i) points.push_back({points[i].x, points[i].y, high});
    }
    Box bounds;
    for (auto const& p : points) bounds.extend(p);
    Chords chords;
    if (points.size() == 3)
      chords_of(Triangle{{points[0], points[1], points[2]}}, chords);
    else
      chords_of(ConvexPolyhedron::hull(points), chords);
    upright += chords.upright;
    CHECK((trial % 3 != 0 || chords.upright));
    Options options{.resolution = 128, .coarse = 16, .components = 1};
    options.bounds = random.chance(0.5) ? Bounds::exact : Bounds::linear;
    OccluderWriter writer(-1e9, options);
    for (int family : {0, 2}) {
      Frame const frame(cell, family, 24, 12);
      OcclusionMap map(frame, 1);
      RefinedMap refined(frame, map, options);
      writer.write(chords, bounds, frame, map, &refined);
      // Whatever part of a pixel the gate is of, it is compared with the slice of the cell by the whole pixel.
      auto const check_gate = [&](Gate const& g, Pixel const& pixel, CellSlice const& k) {
        // A corner of the pixel, or a line inside it.
        double const a = random.chance(0.5) ? random.below(2) : random.unit();
        RationalNumber const s =
          RationalNumber(pixel.s0) * (1 - RationalNumber(a)) + RationalNumber(pixel.s1) * RationalNumber(a);
        RationalNumber const t = RationalNumber(random.chance(0.5) ? pixel.t0 : pixel.t1);
        // A part of a pixel may hold for the lines that meet the cell alone.
        if (abs(s) > RationalNumber(frame.half_width()) + abs(t) * RationalNumber(frame.half_length())) return;
        RationalNumber const in(k.u_in), out(k.u_out), height(k.height);
        auto const points_of_slice = slice(frame, cell, family, points, s, t);
        REQUIRE(!points_of_slice.empty());
        bool top = false, bottom = false, top_separating = false, bottom_separating = false, near = false;
        for (auto const& [u, z] : points_of_slice) {
          REQUIRE(u > out);
          RationalNumber const rise = z - height;
          RationalNumber const upper = rise / (u - (rise >= 0 ? in : out)), lower = z / (u - (z >= 0 ? out : in));
          top |= upper >= RationalNumber(double(g.top.slope));
          top_separating |= lower >= RationalNumber(double(g.top.separating));
          bottom |= lower <= RationalNumber(double(g.bottom.slope));
          bottom_separating |= upper <= RationalNumber(double(g.bottom.separating));
          near |= u + RationalNumber(frame.half_length()) <= RationalNumber(double(g.beyond));
        }
        CHECK(top);
        CHECK(bottom);
        CHECK(top_separating);
        CHECK(bottom_separating);
        CHECK(near);
      };
      for (int row = 0; row < frame.rows(); ++row)
        for (int column = 0; column < frame.columns(); ++column) {
          auto const* const k = frame.cell_slice(row, column);
          if (k == nullptr || !random.chance(0.3)) continue;
          Gate const g = map.gate(row, column, 0);
          if (!std::isinf(g.beyond)) ++gates, check_gate(g, frame.pixel(row, column), *k);
          std::vector<std::uint32_t> path{refined.part(row, column)};
          auto const check_part = [&](std::uint32_t part) {
            for (auto const& h : refined.gates(part))
              if (!refined[part].is_empty()) ++of_parts, check_gate(h, refined[part].pixel(), *k);
          };
          for (int depth = random.between(1, 6); depth > 0; --depth) {
            auto const first = refined.halves(path.back(), random.uniform(0, 20));
            if (!first) break;
            for (auto const half : {*first, *first + 1}) refined.update(half, path.back()), check_part(half);
            path.push_back(*first + static_cast<std::uint32_t>(random.below(2)));
          }
          for (; !path.empty(); path.pop_back()) refined.raise(path.back()), check_part(path.back());
          refined.raise(row, column);
          Gate const raised = map.gate(row, column, 0);
          if (!std::isinf(raised.beyond)) check_gate(raised, frame.pixel(row, column), *k);
        }
    }
  }
  CHECK(upright > 0);
  CHECK(of_parts > gates);
  CHECK(gates > static_cast<std::size_t>(trials(100)));
}

TEST_CASE("ray-space: guided rays find nothing that is missing from towns with inner bodies", "[methods][conservative]")
{
  std::size_t hidden = 0, dropped = 0;
  for (int trial = 0; trial < trials(6); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    char const* const kinds[] = {"urban,n=30,seed=", "urban,n=20,tilt=10,seed=", "district,copies=1,seed="};
    Scene const scene = generate(kinds[trial % 3] + std::to_string(trial + 1));
    PreparedScene const prepared(scene, InnerBodyOptions{});
    Options options{.resolution = 1 << random.between(6, 11),
                    .coarse = 1 << random.between(5, 9),
                    .components = random.between(1, 3)};
    options.bounds = random.chance(0.5) ? Bounds::exact : Bounds::linear;
    // Some cells reach into buildings, whose inner bodies then hide what is behind all of their building alone.
    double const x = random.chance(0.5) ? random.uniform(-60, 60) : 0;
    ViewCell const cell(Box{{x - 5, x - 5, 0}, {x + 5, x + random.uniform(0, 5), random.uniform(1, 3)}});
    auto const set = RaySpace(options)(prepared, cell);
    hidden += scene.objects.size() - set.visible.size();
    CheckOptions hunt;
    hunt.rays = 20'000;
    hunt.threads = 1;
    CHECK(check(prepared, cell, set.visible, set.guarantee, hunt).missing == std::vector<std::uint32_t>{});
    auto const [objects, triangles] = RaySpace(options).triangles(prepared, cell);
    CHECK(objects.visible == set.visible);
    dropped += scene.triangles.size() - triangles.size();
    CHECK(std::ranges::is_sorted(triangles));
  }
  CHECK(hidden > 0);
  CHECK(dropped > 0);
}

TEST_CASE("ray-space: guided rays find nothing that is missing", "[methods][conservative]")
{
  std::size_t hidden = 0;
  for (int trial = 0; trial < trials(20); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    Options options{.resolution = 1 << random.between(5, 11),
                    .coarse = 1 << random.between(4, 9),
                    .components = random.between(1, 4)};
    options.umbra = random.chance(0.3) ? Umbra::half : Umbra::full;
    options.bounds = random.chance(0.5) ? Bounds::exact : Bounds::linear;
    options.granularity = static_cast<Granularity>(random.below(4));
    bool const field = random.chance(0.4);
    Box box = field ? Box{{-9, -9, 0}, {9, 9, 10}} : grid_box(random, -4, 4);
    Scene const scene =
      field ? generate("box-field,n=300,density=0.4,clear=10,height=18,seed=" + std::to_string(trial + 1))
            : grid_scene(random, random.between(20, 150), -10, 10, trial % 2 == 0 ? Mix::all : Mix::boxes, box);
    PreparedScene const prepared(scene);
    ViewCell cell(box);
    if (random.chance(0.3)) {
      auto const c = box.corners();
      cell = ViewCell::hull(std::vector<Point3d>{c[0], c[1], c[2], c[4], c[7]});
    }
    auto const set = RaySpace(options)(prepared, cell);
    hidden += scene.objects.size() - set.visible.size();
    CheckOptions hunt;
    hunt.rays = 20'000;
    hunt.threads = 1;
    auto const report = check(prepared, cell, set.visible, set.guarantee, hunt);
    CHECK(report.missing == std::vector<std::uint32_t>{});
  }
  CAPTURE(hidden);
  CHECK(hidden > 0);
}
