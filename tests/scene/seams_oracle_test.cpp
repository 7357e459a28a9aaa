#include "seams.hpp"

#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"
#include "support/trials.hpp"

#include <ranges>

/// Seams against the definition, point by point in rational numbers.
using namespace visibility;
using namespace visibility::test;

namespace {

using NT = RationalNumber;
using Column = HeightField::Column;

struct Counts {
  int parts = 0, creases = 0, exposed = 0, hidden = 0, ends = 0;
};

/// Denominators that no coordinate has.
NT random_parameter(Random& random) { return NT(random.between(1, 10'006), 10'007); }

/// Pairs of boxes that share a wall, on a small grid: others stand along the walls within.
std::vector<Shape> doubled_boxes(Random& random, int count)
{
  std::vector<Shape> shapes;
  for (int i = 0; i < count; ++i) {
    Box a = grid_box(random, 0, 4);
    a.min.z = 0;
    a.max.z = random.between(1, 4);
    Box b = a;
    b.min.x = a.max.x;
    b.max.x += random.between(1, 2);
    shapes.push_back({{a, b}, {}, {}, {}});
  }
  return shapes;
}

/// All scenes of this file: objects of all kinds on a grid, and boxes or slanted columns that overlap.
Scene random_scene(Random& random)
{
  int const n = random.between(3, 12);
  switch (random.below(7)) {
  case 0: return height_case(random, HeightScene::grid, n).scene;
  case 1: return height_case(random, HeightScene::slanted_grid, n).scene;
  case 2: return height_case(random, HeightScene::general, n).scene;
  case 3: return height_case(random, HeightScene::slanted, n).scene;
  case 4: return scene_of(doubled_boxes(random, n));
  default: return scene_of(random_shapes(random, n, random.between(3, 6)));
  }
}

/// Height of an edge over a point of it.
NT height_over(HeightField::TopEdge const& e, Point2q const& m)
{
  auto const a = exact(e.a), b = exact(e.b);
  return a.z + (b.z - a.z) * (a.x != b.x ? (m.x - a.x) / (b.x - a.x) : (m.y - a.y) / (b.y - a.y));
}

/// At a point of the seam: S's top is the upper envelope just before it, and F is higher just behind.
bool holds_at(HeightField const& field, Seam const& seam, SeamPart const& part, Point2q const& m)
{
  auto const p = horizontal(part.left), q = horizontal(part.right);
  Column const &s = field.columns()[seam.column], &f = field.columns()[seam.other];
  if (!is_on_top(field, s, beside(m, p, q, false))) return false;
  if (!seam.is_crease() && !(height_over(field.edges()[seam.edge], m) > top_over(field, s, m))) return false;
  Point2q const behind = beside(m, p, q, true);
  return f.is_curtain() || (contains(field, f, behind) && top_over(field, f, behind) > top_over(field, s, behind));
}

/// The parts of all seams, position by position.
std::vector<std::vector<SeamPart>> all_parts(HeightField const& field)
{
  std::vector<std::vector<SeamPart>> out;
  for (auto const& s : field.seams()) out.push_back(exposed_parts(field, s));
  return out;
}

void check_parts(HeightField const& field, Random& random, Counts& counts)
{
  for (std::size_t i = 0; i < field.seams().size(); ++i) {
    auto const& seam = field.seams()[i];
    Box const& box = field.seam_bounds()[i];
    CAPTURE(seam.column, seam.other, seam.edge, seam.from_left);
    REQUIRE(field.columns()[seam.column].object != field.columns()[seam.other].object);
    std::optional<SeamPart> last;
    for (auto const& part : exposed_parts(field, seam)) {
      ++counts.parts;
      counts.creases += seam.is_crease();
      auto const p = horizontal(part.left), q = horizontal(part.right);
      REQUIRE(!(p == q));
      if (last)  // from left to right, and maximal: something lies between
        REQUIRE((q.x - p.x) * (p.x - last->right.x) + (q.y - p.y) * (p.y - last->right.y) > 0);
      last = part;
      for (auto const& r : {part.left, part.right}) {
        REQUIRE((NT(box.min.x) <= r.x && NT(box.min.y) <= r.y && NT(box.min.z) <= r.z));
        REQUIRE((r.x <= NT(box.max.x) && r.y <= NT(box.max.y) && r.z <= NT(box.max.z)));
        REQUIRE(r.z == top_over(field, field.columns()[seam.column], horizontal(r)));
      }
      for (int k = 0; k < 3; ++k) REQUIRE(holds_at(field, seam, part, between(p, q, random_parameter(random))));
    }
  }
}

/// Points of all edges over all columns: in a part of the seam, or not exposed.
void check_feet(HeightField const& field, Random& random, Counts& counts)
{
  auto const parts = all_parts(field);
  auto const& seams = field.seams();
  for (std::uint32_t s = 0; s < field.columns().size(); ++s)
    for (std::uint32_t e = 0; e < field.edges().size(); ++e) {
      auto const& edge = field.edges()[e];
      Column const &column = field.columns()[s], &other = field.columns()[edge.column];
      if (column.is_curtain() || column.object == other.object) continue;
      for (bool const from_left : {false, true}) {
        if (from_left && !other.is_curtain()) continue;
        auto const a = horizontal(exact(edge.a)), b = horizontal(exact(edge.b));
        Point2q const m = between(a, b, random_parameter(random));
        bool const found = std::ranges::any_of(std::views::iota(std::size_t{0}, seams.size()), [&](std::size_t i) {
          return seams[i] == Seam{s, edge.column, e, from_left} &&
                 std::ranges::any_of(parts[i], [&](SeamPart const& p) { return is_on(p, m); });
        });
        bool const exposed =
          is_on_top(field, column, beside(m, a, b, from_left)) && height_over(edge, m) > top_over(field, column, m);
        bool const inside = contains(field, column, beside(m, a, b, !from_left));
        CAPTURE(s, e, from_left, inside);
        (exposed && found ? counts.exposed : counts.hidden) += 1;
        if (inside || is_on_open_side(field, s, m)) {
          REQUIRE(found == exposed);
        } else if (found) {
          REQUIRE(exposed);
        }
      }
    }
}

/// Walks along a random line: where a column's top, or that of its object, stops being the upper envelope because of
/// other objects, there are seams with all of them.
void check_ends(HeightField const& field, Random& random, Counts& counts)
{
  auto const parts = all_parts(field);
  std::vector<std::uint32_t> tops;
  for (std::uint32_t c = 0; c < field.columns().size(); ++c)
    if (!field.columns()[c].is_curtain()) tops.push_back(c);
  if (tops.empty()) return;
  std::uint32_t const s = tops[static_cast<std::size_t>(random.below(static_cast<int>(tops.size())))];
  Column const& column = field.columns()[s];
  // A random direction through a random point inside the column.
  auto const corners = field.corners(column);
  Point2q u{0, 0};
  NT weights = 0;
  for (auto const& c : corners) {
    NT const w = random_parameter(random);
    u = {u.x + w * NT(c.x), u.y + w * NT(c.y)};
    weights += w;
  }
  u = {u.x / weights, u.y / weights};
  Point2q const v{u.x + random_parameter(random) - NT(1, 2), u.y + random_parameter(random) - NT(1, 2)};
  // Where it meets sides, and tops meet that of the column.
  std::set<NT> stops;
  auto const stop_at_zero = [&](NT const& at_u, NT const& at_v) {
    if (at_u != at_v) stops.insert(at_u / (at_u - at_v));
  };
  for (auto const g : tops) {
    auto const c = field.corners(field.columns()[g]);
    for (std::size_t i = 0; i < c.size(); ++i) {
      auto const p = horizontal(exact(c[i])), q = horizontal(exact(c[(i + 1) % c.size()]));
      stop_at_zero(turn(p, q, u), turn(p, q, v));
    }
    stop_at_zero(top_over(field, field.columns()[g], u) - top_over(field, column, u),
                 top_over(field, field.columns()[g], v) - top_over(field, column, v));
  }
  std::vector<NT> const t(stops.begin(), stops.end());
  for (std::size_t i = 1; i + 1 < t.size(); ++i) {
    if (!is_on_top(field, column, between(u, v, (t[i - 1] + t[i]) / 2))) continue;
    Point2q const end = between(u, v, t[i]), beyond = between(u, v, (t[i] + t[i + 1]) / 2);
    // The top of S's object beyond, if S itself goes on or has an open side there.
    if (!contains(field, column, beyond) && !is_on_open_side(field, s, end)) continue;
    std::optional<NT> own;
    for (auto const g : tops)
      if (field.columns()[g].object == column.object && contains(field, field.columns()[g], beyond))
        if (NT const z = top_over(field, field.columns()[g], beyond); !own || *own < z) own = z;
    if (!own) continue;
    for (auto const g : tops) {
      Column const& f = field.columns()[g];
      if (f.object == column.object || !contains(field, f, beyond) || top_over(field, f, beyond) <= *own) continue;
      CAPTURE(s, g);
      ++counts.ends;
      bool found = false;
      for (std::size_t k = 0; k < parts.size(); ++k)
        if (field.seams()[k].column == s && field.columns()[field.seams()[k].other].object == f.object)
          found |= std::ranges::any_of(parts[k], [&](SeamPart const& p) { return is_on(p, end); });
      REQUIRE(found);
    }
  }
}

}  // namespace

TEST_CASE("seams: every part is the end of what is exposed, every foot outside is not", "[scene][oracle]")
{
  Counts counts;
  for (int seed = 1; seed <= trials(70); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed) + 7000);
    Scene const scene = random_scene(random);
    HeightField const field(scene);
    check_parts(field, random, counts);
    check_feet(field, random, counts);
  }
  CAPTURE(counts.parts, counts.creases, counts.exposed, counts.hidden);
  REQUIRE(counts.parts > 800);
  REQUIRE(counts.creases > 150);
  REQUIRE(counts.exposed > 150);
  REQUIRE(counts.hidden > 5000);
}

TEST_CASE("seams: wherever others end what is exposed of a top there is a part", "[scene][oracle]")
{
  Counts counts;
  for (int seed = 1; seed <= trials(70); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed) + 9000);
    Scene const scene = random_scene(random);
    HeightField const field(scene);
    for (int k = 0; k < 20; ++k) check_ends(field, random, counts);
  }
  CAPTURE(counts.ends);
  REQUIRE(counts.ends > 120);
}
