#include "support/catch.hpp"
#include "support/random_scenes.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"

#include <algorithm>
#include <numeric>

using namespace visibility;
using namespace visibility::test;
using strong_occlusion::Granularity;
using Set = std::vector<std::uint32_t>;

namespace {

template <Arithmetic A = Filtered>
Set visible(Scene const& scene, ViewCell const& cell, StrongOcclusion<>::Options options = {})
{
  typename StrongOcclusion<A>::Options const same = options;
  return StrongOcclusion<A>(same)(PreparedScene(scene), cell).visible;
}

bool is_subset(Set const& small, Set const& large) { return std::ranges::includes(large, small); }

/// The definition, without hierarchy, order, leading ray or filter.
Set brute_force(Scene const& scene, ViewCell const& cell)
{
  ConvexBodies const bodies(scene);
  auto const blocks = [&](ConvexBodies::Body const& body, Box const& target) {
    for (auto const& s : target.corners())
      for (auto const& c : cell.vertices())
        if (!segment_meets<Rational, End::excluded>(bodies, body, exact(c), exact(s))) return false;
    return body.occludes;
  };
  Set out;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    Box const box = bounding_box(scene, scene.objects[i]);
    bool const meets_cell = meet(box, cell.bounds());
    if (meets_cell || std::ranges::none_of(bodies.bodies(), [&](auto const& b) { return blocks(b, box); }))
      out.push_back(i);
  }
  return out;
}

struct Trial {
  Scene scene;
  ViewCell cell;
};

/// Odd seeds may have occluders inside the cell, even ones have none (but for balls, polyhedra and triangles).
Trial trial(int seed, Mix mix = Mix::all)
{
  Random random(static_cast<std::uint64_t>(seed));
  Box const cell = grid_box(random, -2, 2);
  return {grid_scene(random, random.between(2, 40), -12, 12, mix, seed % 2 == 0 ? cell : Box{}), ViewCell(cell)};
}

/// As `trial`, from a cell that is no box.
Trial with_any_cell(int seed)
{
  Trial t = trial(seed);
  Random random(static_cast<std::uint64_t>(seed) + 77);
  for (;;) {
    std::vector<Point3d> points;
    for (int i = random.between(4, 9); i > 0; --i) points.push_back(random.grid_point(-2, 2));
    try {
      t.cell = ViewCell::hull(points);
      return t;
    } catch (std::invalid_argument const&) {
      continue;  // all in one plane
    }
  }
}

constexpr std::array granularities{Granularity::object, Granularity::part, Granularity::face, Granularity::triangle};

/// The scene with every coordinate mapped; `map` must be exact.
template <class Map>
Scene mapped(Scene const& scene, Map&& map)
{
  Scene out = scene;
  for (auto& b : out.boxes) {
    Box image;
    image.extend(map(b.min));
    image.extend(map(b.max));
    b = image;
  }
  return out;
}

}  // namespace

TEST_CASE("strong occlusion: equals the definition evaluated in rationals", "[methods][oracle]")
{
  auto const seed = GENERATE(range(1, 61));
  CAPTURE(seed);
  auto const t = trial(seed);
  auto const expected = brute_force(t.scene, t.cell);
  for (bool const groups : {false, true})
    REQUIRE(visible(t.scene, t.cell, {.granularity = Granularity::object, .groups = groups}) == expected);
}

TEST_CASE("strong occlusion: hides something in most of these scenes", "[methods]")
{
  int hidden = 0;
  for (int seed = 1; seed <= 60; ++seed) {
    auto const t = trial(seed);
    hidden += visible(t.scene, t.cell).size() < t.scene.objects.size();
  }
  REQUIRE(hidden > 30);
}

TEST_CASE("strong occlusion: filtered and rational arithmetic agree", "[methods][oracle]")
{
  auto const seed = GENERATE(range(1, 41));
  CAPTURE(seed);
  auto const t = trial(seed);
  REQUIRE(visible<Filtered>(t.scene, t.cell) == visible<Rational>(t.scene, t.cell));
}

TEST_CASE("strong occlusion: a finer granularity never gives more", "[methods][law]")
{
  auto const seed = GENERATE(range(1, 41));
  CAPTURE(seed);
  auto const t = trial(seed);
  Set coarser(t.scene.objects.size());
  std::iota(coarser.begin(), coarser.end(), 0U);
  for (auto const g : granularities) {
    auto const set = visible(t.scene, t.cell, {.granularity = g});
    REQUIRE(is_subset(set, coarser));
    coarser = set;
  }
}

TEST_CASE("strong occlusion: optimizations save work and change nothing, each alone, left out, and all",
          "[methods][law]")
{
  using O = StrongOcclusion<>::Options;
  auto const g = GENERATE(from_range(granularities));
  auto const seed = GENERATE(range(1, 31));
  CAPTURE(seed, to_string(g));
  auto const t = seed % 3 == 0 ? with_any_cell(seed) : trial(seed);
  auto const expected = visible(t.scene, t.cell, O::naive(g));
  REQUIRE(visible(t.scene, t.cell, {.granularity = g}) == expected);
  for (auto const& [name, optimization] : strong_occlusion::optimizations) {
    O alone = O::naive(g), others{.granularity = g};
    alone.*optimization = true;
    others.*optimization = false;
    REQUIRE(visible(t.scene, t.cell, alone) == expected);
    REQUIRE(visible(t.scene, t.cell, others) == expected);
  }
}

TEST_CASE("strong occlusion: a cell inside a cell has the same set from its remainder as from the scene",
          "[methods][law]")
{
  auto const coarse = GENERATE(from_range(granularities)), fine = GENERATE(from_range(granularities));
  if (coarse > fine) return;
  auto const seed = GENERATE(range(1, 31));
  CAPTURE(seed, to_string(coarse), to_string(fine));
  auto const t = trial(seed);
  Box const b = t.cell.bounds();
  Box const half{b.min, {(b.min.x + b.max.x) / 2, b.max.y, b.max.z}},
    quarter{half.min, {half.max.x, (b.min.y + b.max.y) / 2, b.max.z}};
  PreparedScene const prepared(t.scene);
  StrongOcclusion<> const upper({.granularity = coarse}), lower({.granularity = fine});
  auto const [set, rest] =
    upper.refine(upper.refine(StrongOcclusion<>::Remainder(prepared), t.cell).second, ViewCell(half));
  REQUIRE(set.visible == upper(prepared, ViewCell(half)).visible);
  REQUIRE(lower(rest, ViewCell(quarter)).visible == lower(prepared, ViewCell(quarter)).visible);
}

TEST_CASE("strong occlusion: adding an occluder never makes anything visible", "[methods][law]")
{
  auto const seed = GENERATE(range(1, 31));
  CAPTURE(seed);
  auto const t = trial(seed);
  Random random(static_cast<std::uint64_t>(seed) + 1000);
  Scene more = t.scene;
  Box const added = grid_box(random, -12, 12);
  Object o;
  auto const end = [](auto const& v) { return IndexRange{std::uint32_t(v.size()), std::uint32_t(v.size())}; };
  o.name = "added";
  o.boxes = end(more.boxes), o.balls = end(more.balls), o.prisms = end(more.prisms);
  o.polyhedra = end(more.polyhedra), o.triangles = end(more.triangles);
  more.boxes.push_back(added);
  ++o.boxes.last;
  more.objects.push_back(o);
  more.validate();
  auto with = visible(more, t.cell);
  std::erase(with, std::uint32_t(more.objects.size() - 1));
  REQUIRE(is_subset(with, visible(t.scene, t.cell)));
}

TEST_CASE("strong occlusion: a smaller cell never sees more", "[methods][law]")
{
  auto const seed = GENERATE(range(1, 31));
  CAPTURE(seed);
  auto const t = trial(seed);
  Box const b = t.cell.bounds();
  Box const half{b.min, {(b.min.x + b.max.x) / 2, b.max.y, (b.min.z + b.max.z) / 2}};
  REQUIRE(is_subset(visible(t.scene, ViewCell(half)), visible(t.scene, t.cell)));
}

TEST_CASE("strong occlusion: exact similarities of the input change nothing", "[methods][law]")
{
  auto const seed = GENERATE(range(1, 31));
  CAPTURE(seed);
  auto const t = trial(seed, Mix::boxes);
  auto const expected = visible(t.scene, t.cell);
  auto const check = [&](auto&& map) {
    Box cell;
    cell.extend(map(t.cell.bounds().min));
    cell.extend(map(t.cell.bounds().max));
    REQUIRE(visible(mapped(t.scene, map), ViewCell(cell)) == expected);
  };
  check([](Point3d const& p) { return Point3d{p.x + 4096, p.y - 0x1p40, p.z + 0.5}; });
  check([](Point3d const& p) { return Point3d{p.y, p.z, p.x}; });
  check([](Point3d const& p) { return Point3d{-p.y, p.x, p.z}; });
  check([](Point3d const& p) { return Point3d{p.x * 0x1p-1060, p.y * 0x1p-1060, p.z * 0x1p-1060}; });
  check([](Point3d const& p) { return Point3d{p.x * 0x1p1000, p.y * 0x1p1000, p.z * 0x1p1000}; });
  check([](Point3d const& p) { return Point3d{p.x * 0x1p-700, p.y * 0x1p500, p.z}; });
}

TEST_CASE("strong occlusion: the order of objects changes nothing", "[methods][law]")
{
  auto const seed = GENERATE(range(1, 21));
  CAPTURE(seed);
  auto const t = trial(seed, Mix::boxes);
  std::vector<std::uint32_t> order(t.scene.objects.size());
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937_64 engine(static_cast<std::uint64_t>(seed));
  std::ranges::shuffle(order, engine);
  SceneBuilder builder("shuffled");
  for (auto const i : order) {
    builder.begin_object(t.scene.objects[i].name);
    builder.add(t.scene.boxes[i]);
  }
  Set back;
  for (auto const i : visible(builder.finish(), t.cell)) back.push_back(order[i]);
  std::ranges::sort(back);
  REQUIRE(back == visible(t.scene, t.cell));
}

namespace {

/// A rational point in the relative interior of some face of the body; of a ball, a pole.
Point3q point_on(ConvexBodies const& bodies, ConvexBodies::Body const& body, Random& random)
{
  using NT = RationalNumber;
  auto const between = [&](NT const& a, NT const& b) -> NT { return a + (b - a) * NT(random.between(1, 15), 16); };
  auto const inside = [&](std::array<Point3d, 3> const& t) {
    NT const u(random.between(1, 7), 16), v(random.between(1, 7), 16);
    auto const mix = [&](double a, double b, double c) -> NT {
      return NT(a) + u * (NT(b) - NT(a)) + v * (NT(c) - NT(a));
    };
    return Point3q{mix(t[0].x, t[1].x, t[2].x), mix(t[0].y, t[1].y, t[2].y), mix(t[0].z, t[1].z, t[2].z)};
  };
  switch (body.kind) {
  case ConvexBodies::Kind::box: {
    Box const& b = bodies.box(body);
    Point3q s{between(b.min.x, b.max.x), between(b.min.y, b.max.y), between(b.min.z, b.max.z)};
    int const face = random.below(6);
    Point3d const corner = face % 2 == 0 ? b.min : b.max;
    (face < 2 ? s.x : face < 4 ? s.y : s.z) = NT(face < 2 ? corner.x : face < 4 ? corner.y : corner.z);
    return s;
  }
  case ConvexBodies::Kind::ball: {
    Ball const& b = bodies.ball(body);
    Point3q s = exact(b.centre);
    int const pole = random.below(6);
    NT const r = pole % 2 == 0 ? NT(b.radius) : -NT(b.radius);
    if (pole < 2)
      s.x = s.x + r;
    else if (pole < 4)
      s.y = s.y + r;
    else
      s.z = s.z + r;
    return s;
  }
  case ConvexBodies::Kind::prism: {
    ConvexPrism const& p = bodies.prism(body);
    auto const n = p.footprint.size(), i = static_cast<std::size_t>(random.below(static_cast<int>(n)));
    auto const &a = p.footprint[i], &b = p.footprint[(i + 1) % n];
    NT const t(random.between(1, 15), 16);
    return {NT(a.x) + t * (NT(b.x) - NT(a.x)), NT(a.y) + t * (NT(b.y) - NT(a.y)), between(p.bottom, p.top)};
  }
  case ConvexBodies::Kind::polyhedron: {
    auto const& p = bodies.polyhedron(body);
    auto const& f = p.facets[static_cast<std::size_t>(random.below(static_cast<int>(p.facets.size())))];
    return inside({p.vertices[f.vertices[0]], p.vertices[f.vertices[1]], p.vertices[f.vertices[2]]});
  }
  case ConvexBodies::Kind::triangle: break;
  }
  return inside(bodies.triangle(body).vertices);
}

}  // namespace

TEST_CASE("strong occlusion: no kind of body that a rational sight line sees is dropped at any granularity",
          "[methods][conservative]")
{
  int seen = 0;
  for (int seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    auto const t = trial(seed);
    Random random(static_cast<std::uint64_t>(seed) + 900);
    ConvexBodies const bodies(t.scene);
    std::vector<Set> sets;
    for (auto const g : granularities) sets.push_back(visible(t.scene, t.cell, {.granularity = g}));
    Box const& c = t.cell.bounds();
    auto const inside = [&](double lo, double hi) {
      return RationalNumber(lo) + (RationalNumber(hi) - RationalNumber(lo)) * RationalNumber(random.between(1, 15), 16);
    };
    for (auto const& body : bodies.bodies())
      for (int k = 0; k < 40; ++k) {
        Point3q const s = point_on(bodies, body, random);
        Point3q const p{inside(c.min.x, c.max.x), inside(c.min.y, c.max.y), inside(c.min.z, c.max.z)};
        if (p == s) continue;
        bool const free = std::ranges::none_of(bodies.bodies(), [&](auto const& other) {
          return other.occludes && segment_meets<Rational, End::excluded>(bodies, other, p, s);
        });
        if (!free) continue;
        ++seen;
        for (auto const& set : sets) REQUIRE(std::ranges::binary_search(set, body.object));
      }
  }
  REQUIRE(seen > 500);
}

TEST_CASE("strong occlusion: nothing that a rational sight line sees is dropped", "[methods][conservative]")
{
  auto const seed = 2 * GENERATE(range(1, 41));
  CAPTURE(seed);
  auto const t = trial(seed, Mix::boxes);
  Random random(static_cast<std::uint64_t>(seed) + 500);
  ConvexBodies const bodies(t.scene);
  auto const set = visible(t.scene, t.cell);
  auto const inside = [&](double lo, double hi) {  // a rational strictly between, on a coarse grid
    return RationalNumber(lo) + (RationalNumber(hi) - RationalNumber(lo)) * RationalNumber(random.between(1, 15), 16);
  };
  int seen = 0;
  for (std::uint32_t i = 0; i < t.scene.objects.size(); ++i)
    for (int k = 0; k < 60; ++k) {
      Box const &c = t.cell.bounds(), &b = t.scene.boxes[i];
      Point3q const p{inside(c.min.x, c.max.x), inside(c.min.y, c.max.y), inside(c.min.z, c.max.z)};
      Point3q s{inside(b.min.x, b.max.x), inside(b.min.y, b.max.y), inside(b.min.z, b.max.z)};
      int const face = random.below(6);
      RationalNumber& fixed = face < 2 ? s.x : face < 4 ? s.y : s.z;
      Point3d const corner = face % 2 == 0 ? b.min : b.max;
      fixed = RationalNumber(face < 2 ? corner.x : face < 4 ? corner.y : corner.z);
      if (p == s) continue;
      bool const free = std::ranges::none_of(
        bodies.bodies(), [&](auto const& body) { return segment_meets<Rational, End::excluded>(bodies, body, p, s); });
      if (!free) continue;
      ++seen;
      REQUIRE(std::ranges::binary_search(set, i));
    }
  REQUIRE(seen > 0);
}
