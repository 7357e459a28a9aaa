// proofs/visibility.md: "some free sight line" and "free sight lines of positive measure" are not the same.

#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/evidence/witness.hpp"
#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>

using namespace visibility;

namespace {

/// Two wedges that touch the wall's face along one line, and each other nowhere else.
Scene wedges()
{
  SceneBuilder b("wedges");
  b.begin_object("wall");
  b.add(Box{{0, -4, -4}, {1, 4, 4}});
  b.begin_object("left");
  b.add(Prism{{{{0, 0}, {0, 5}, {-1, 0.5}}}, -5, 5});
  b.begin_object("right");
  b.add(Prism{{{{0, 0}, {-1, -0.5}, {0, -5}}}, -5, 5});
  return b.finish();
}

ViewCell const cell(Box{{-10, -1, -1}, {-9, 1, 1}});

}  // namespace

TEST_CASE("readings of visible: the line where the wedges meet is seen", "[evidence][degenerate]")
{
  Scene const scene = wedges();
  PreparedScene const prepared(scene);
  REQUIRE(confirm(prepared, cell, {0, exact(Point3d{-9.5, 0, 0}), exact(Point3d{0, 0, 0})}));
  REQUIRE(confirm(prepared, cell, {0, exact(Point3d{-9.25, 0, 0.5}), exact(Point3d{0, 0, -3})}));
}

TEST_CASE("readings of visible: no other point of the wall is seen, so the free sight lines have measure zero",
          "[evidence][degenerate]")
{
  Scene const scene = wedges();
  PreparedScene const prepared(scene);
  test::Random random(1);
  for (int trial = 0; trial < 2'000; ++trial) {
    Point3d const p{random.uniform(-9.9, -9.1), random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9)};
    double const y = random.uniform(-3.9, 3.9) * (trial % 2 == 0 ? 1 : 0x1p-30);
    if (y == 0) continue;
    REQUIRE_FALSE(confirm(prepared, cell, {0, exact(p), exact(Point3d{0, y, random.uniform(-3.9, 3.9)})}));
  }
}

TEST_CASE("readings of visible: a conservative method keeps the wall", "[evidence][conservative]")
{
  Scene const scene = wedges();
  auto const set = StrongOcclusion<>{}(PreparedScene(scene), cell);
  REQUIRE(std::ranges::binary_search(set.visible, 0U));
}
