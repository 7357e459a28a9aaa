// What a project that uses the library writes; built against the install tree and by add_subdirectory.

#include <visibility/visibility.hpp>

#include <cstdio>

namespace {

/// One if the compiler fuses a * b - c, which would break the proofs of the floating-point filters.
bool contracts()
{
  double volatile x = 1 + 0x1p-30, y = 1 + 0x1p-29;
  double const a = x, b = y;
  return a * a - b != 0;
}

}  // namespace

int main()
{
  using namespace visibility;
  SceneBuilder builder("consumer");
  builder.begin_object("wall");
  builder.add(Box{{3, -5, -5}, {4, 6, 6}});
  builder.begin_object("behind");
  builder.add(Box{{6, 0, 0}, {7, 1, 1}});
  Scene const scene = builder.finish();
  PreparedScene const prepared(scene, InnerBodyOptions{});
  Box const region{{0, 0, 0}, {1, 1, 1}};
  auto const set = StrongOcclusion<>{}(prepared, ViewCell(region));
  std::vector<Point3d> const sizes{{1, 1, 1}, {0.5, 0.5, 1}};
  auto const sets = refine(prepared, Partition(region, sizes), std::vector<StrongOcclusion<>>(2));
  std::printf("%zu visible\n", set.visible.size());
  return set.visible.size() == 1 && sets[1].size() == 4 && sets[1][3].set.visible == set.visible &&
             generate("city,n=10").objects.size() > 1 && !contracts()
           ? 0
           : 1;
}
