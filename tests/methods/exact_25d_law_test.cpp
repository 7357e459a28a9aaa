#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/scene/generators.hpp"

#include <numeric>

using namespace visibility;
using namespace visibility::test;
using exact_25d::Options;

namespace {

using Names = std::vector<std::string>;

Names names(Scene const& scene, PotentiallyVisibleSet const& set)
{
  Names out;
  for (auto const o : set.visible) out.push_back(scene.objects[o].name);
  std::ranges::sort(out);
  return out;
}

template <Arithmetic A = Filtered>
Names visible(Scene const& scene, std::vector<Point3d> const& cell, Options const& options = {})
{
  HeightField const field(scene);
  return names(scene, Exact25d<A>(options)(field, ViewCell::hull(cell)));
}

/// The boxes and triangles of a scene again, objects and triangle corners in another order.
Scene shuffled(Scene const& scene, Random& random)
{
  std::vector<std::size_t> order(scene.objects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = order.size(); k > 1; --k)
    std::swap(order[k - 1], order[static_cast<std::size_t>(random.below(int(k)))]);
  SceneBuilder builder("shuffled");
  for (auto const o : order) {
    auto const& object = scene.objects[o];
    builder.begin_object(object.name);
    for (auto i = object.boxes.first; i < object.boxes.last; ++i) builder.add(scene.boxes[i]);
    for (auto i = object.triangles.last; i-- > object.triangles.first;) {
      auto const [a, b, c] = scene.triangle(i).vertices;
      builder.add_triangle(builder.add_vertex(b), builder.add_vertex(c), builder.add_vertex(a));
    }
  }
  return builder.finish();
}

/// Every box as a prism with more corners than it needs, the first one in a random place.
Scene with_split_edges(Scene const& scene, Random& random)
{
  SceneBuilder builder("split");
  for (auto const& object : scene.objects) {
    builder.begin_object(object.name);
    for (auto i = object.boxes.first; i < object.boxes.last; ++i) {
      Box const& b = scene.boxes[i];
      double const x = b.min.x / 2 + b.max.x / 2, y = b.min.y / 2 + b.max.y / 2;
      std::vector<Point2d> ring{{b.min.x, b.min.y}, {x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, y},
                                {b.max.x, b.max.y}, {x, b.max.y}, {b.min.x, b.max.y}, {b.min.x, y}};
      std::ranges::rotate(ring, ring.begin() + random.below(8));
      builder.add(Prism{{ring}, b.min.z, b.max.z});
    }
  }
  return builder.finish();
}

template <class Law>
void for_cases(int base, Law const& law)
{
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(base); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(70000 + 1000 * int(kind) + trial));
      auto const c = height_case(random, kind, random.between(3, 14));
      law(c, random);
    }
}

}  // namespace

TEST_CASE("exact-2.5d: the set does not depend on the arithmetic, if exact", "[methods][law]")
{
  for_cases(10, [](HeightCase const& c, Random&) {
    CHECK(visible<Filtered>(c.scene, c.cell) == visible<Rational>(c.scene, c.cell));
  });
}

TEST_CASE("exact-2.5d: the set does not depend on what makes it fast", "[methods][law]")
{
  for_cases(15, [](HeightCase const& c, Random&) {
    auto const expected = visible(c.scene, c.cell);
    for (bool Options::*const switched :
         {&Options::hierarchical_culling, &Options::penumbra_wedges, &Options::sampled_lines}) {
      Options options;
      options.*switched = false;
      CHECK(visible(c.scene, c.cell, options) == expected);
    }
    Options bare;
    bare.hierarchical_culling = bare.penumbra_wedges = bare.sampled_lines = false;
    CHECK(visible(c.scene, c.cell, bare) == expected);
  });
}

TEST_CASE("exact-2.5d: groups of edges are dropped only if nothing of them is seen, from streets and from above",
          "[methods][law]")
{
  std::size_t hidden_groups = 0, fewer_inserted = 0;
  for (std::string const specification : {"city,n=150,base=40,street=11.6,low=12,high=25", "slanted,n=150"}) {
    Scene const scene = generate(specification);
    HeightField const field(scene);
    Box const all = bounding_box(scene);
    Random random(71);
    for (int trial = 0; trial < trials(12); ++trial) {
      CAPTURE(specification, trial);
      double const x = random.uniform(all.min.x, all.max.x), y = random.uniform(all.min.y, all.max.y);
      double const z = random.chance(0.5) ? 0.5 : all.max.z * random.uniform(0.5, 1.5);
      double const length = random.chance(0.3) ? 60 : 4;
      ViewCell const cell(Box{{x, y, z}, {x + length, y + 4, z + 2}});
      auto const set = Exact25d<>()(field, cell);
      if (set.guarantee != Guarantee::exact) continue;
      Options whole, every_edge;
      whole.hierarchical_culling = false;
      every_edge.sampled_lines = false;
      CHECK(Exact25d<>(whole)(field, cell).visible == set.visible);
      auto const full = Exact25d<>(every_edge)(field, cell);
      CHECK(full.visible == set.visible);
      hidden_groups += set.statistics.at("nodes_hidden") > 0;
      fewer_inserted += set.statistics.at("occluders_inserted") < full.statistics.at("occluders_inserted");
    }
  }
  CHECK(hidden_groups > std::size_t(trials(6)));
  CHECK(fewer_inserted > std::size_t(trials(6)));
}

TEST_CASE("exact-2.5d: the set does not depend on the order of objects and corners", "[methods][law]")
{
  for_cases(20, [](HeightCase const& c, Random& random) {
    auto const expected = visible(c.scene, c.cell);
    CHECK(visible(shuffled(c.scene, random), c.cell) == expected);
    if (c.scene.triangles.empty()) CHECK(visible(with_split_edges(c.scene, random), c.cell) == expected);
  });
}

TEST_CASE("exact-2.5d: every visible object has a witness that the definition confirms", "[methods][law]")
{
  int confirmed = 0, by_contact = 0;
  for_cases(20, [&](HeightCase const& c, Random&) {
    HeightField const field(c.scene);
    Options options;
    options.witnesses = true;
    auto const set = Exact25d<Filtered>(options)(field, ViewCell::hull(c.cell));
    if (set.guarantee != Guarantee::exact) return;
    auto const columns = oracle_columns(field);
    auto const cell = oracle_cell(c.cell);
    for (auto const& w : set.witnesses) {
      CAPTURE(w.object);
      CHECK(oracle::confirms(columns, cell, w));
      ++confirmed;
    }
    by_contact += int(set.visible.size() - set.witnesses.size());
    for (auto const o : set.visible) {
      bool const has_witness = std::ranges::any_of(set.witnesses, [&](Witness const& w) { return w.object == o; });
      bool const is_near = std::ranges::any_of(columns, [&](oracle::Column const& column) {
        if (column.object != o) return false;
        Box box, under = ViewCell::hull(c.cell).bounds();
        for (auto const& p : column.corners) box.extend(p);
        under.min.z = box.min.z;
        under.max.z = box.max.z;
        return meet(box, under);
      });
      CHECK((has_witness || is_near));
    }
  });
  CHECK(confirmed > trials(200));
  CHECK(by_contact < confirmed);
}

TEST_CASE("exact-2.5d: a larger cell sees no less, single wedges hide no more", "[methods][law]")
{
  int more = 0;
  for_cases(20, [&](HeightCase const& c, Random&) {
    auto const expected = visible(c.scene, c.cell);
    auto smaller = c.cell;
    for (auto& p : smaller) {
      double const x = (c.cell[0].x + c.cell[4].x) / 2, y = (c.cell[0].y + c.cell[4].y) / 2;
      p = {x + (p.x - x) / 2, y + (p.y - y) / 2, p.z};
    }
    auto const less = visible(c.scene, smaller);
    CHECK(std::ranges::includes(expected, less));
    Options options;
    options.occlusion = exact_25d::Occlusion::single_wedges;
    auto const loose = visible(c.scene, c.cell, options);
    CHECK(std::ranges::includes(loose, expected));
    more += loose.size() > expected.size();
  });
  CHECK(more > trials(2));
}

TEST_CASE("exact-2.5d: a tapering cell sees what lies between its core and its hull", "[methods][law]")
{
  for_cases(15, [](HeightCase const& c, Random&) {
    // The top shrunk to a point over the middle, half as high again, and the prisms inside and around.
    Point3d apex{0, 0, 0};
    auto const n = static_cast<double>(c.cell.size());
    for (auto const& p : c.cell) apex = {apex.x + p.x / n, apex.y + p.y / n, std::max(apex.z, p.z)};
    auto tapering = c.cell, around = c.cell;
    apex.z = 1.5 * apex.z;
    tapering.push_back(apex);
    for (std::size_t i = 1; i < around.size(); i += 2) around[i].z = apex.z;
    auto const inner = visible(c.scene, c.cell), middle = visible(c.scene, tapering), outer = visible(c.scene, around);
    CHECK(std::ranges::includes(middle, inner));
    CHECK(std::ranges::includes(outer, middle));
  });
}

TEST_CASE("exact-2.5d: cells one cannot see out of, empty surroundings, one object", "[methods][degenerate]")
{
  std::vector<Point3d> const cell{{-1, -1, 0}, {-1, -1, 2}, {1, -1, 0}, {1, -1, 2},
                                  {1, 1, 0},   {1, 1, 2},   {-1, 1, 0}, {-1, 1, 2}};
  auto const ring = [](double height) {
    SceneBuilder b("ring");
    b.begin_object("south");
    b.add(Box{{-3, -3, 0}, {3, -2, height}});
    b.begin_object("north");
    b.add(Box{{-3, 2, 0}, {3, 3, height}});
    b.begin_object("west");
    b.add(Box{{-3, -2, 0}, {-2, 2, height}});
    b.begin_object("east");
    b.add(Box{{2, -2, 0}, {3, 2, height}});
    b.begin_object("far");
    b.add(Box{{10, -1, 0}, {12, 1, 4}});
    return b.finish();
  };
  CHECK(visible(ring(20), cell) == Names{"east", "north", "south", "west"});
  CHECK(visible(ring(1), cell).size() == 5);
  SceneBuilder one("one");
  one.begin_object("only");
  one.add(Box{{1000, 1000, 0}, {1001, 1001, 1e-3}});
  CHECK(visible(one.finish(), cell) == Names{"only"});
}
