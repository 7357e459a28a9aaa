#pragma once

#include "support/random.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/scene_builder.hpp"
#include "visibility/scene/view_cell.hpp"

#include <memory>
#include <string>
#include <vector>

namespace visibility::test {

/// A scene built in place, with what shares its lifetime.
struct TestScene {
  explicit TestScene(Scene s)
    : scene(std::make_unique<Scene>(std::move(s))), prepared(std::make_unique<PreparedScene>(*scene))
  {
  }
  std::unique_ptr<Scene> scene;
  std::unique_ptr<PreparedScene> prepared;
};

/// One object per box, named by position.
inline TestScene boxes(std::vector<Box> const& list)
{
  SceneBuilder b("boxes");
  for (std::size_t i = 0; i < list.size(); ++i) b.begin_object(std::to_string(i)), b.add(list[i]);
  return TestScene(b.finish());
}

/// n x n blocks of houses on a grid of 30 m, streets of about 10 m, heights 5 to 25 m; shifted by `offset`.
inline std::vector<Box> box_city(int n, std::uint64_t seed, double offset = 0)
{
  Random random(seed);
  std::vector<Box> out;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      double const x = offset + 30 * i, y = offset + 30 * j, inset = random.uniform(3, 7);
      out.push_back({{x + inset, y + inset, 0}, {x + 30 - inset, y + 30 - inset, random.uniform(5, 25)}});
    }
  return out;
}

/// A street cell at the crossing nearest to the middle of box_city.
inline ViewCell street_cell(int n, double offset = 0)
{
  double const c = offset + 30 * (n / 2);
  return ViewCell(Box{{c - 1, c - 1, 1}, {c + 1, c + 1, 2}});
}

}  // namespace visibility::test
