#include "visibility/raster/hierarchical_depth_map.hpp"

#include "support/catch.hpp"
#include "support/random.hpp"
#include "visibility/raster/pixel_region.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

/// A map written to in part, between refreshes: level k must be the maximum over blocks of 2^k pixels.
struct RandomMap {
  int width, height;
  Grid grid;
  HierarchicalDepthMap<float> map;

  explicit RandomMap(Random& random)
    : width(random.between(1, 90)), height(random.between(1, 70)),
      grid(Grid::covering({0, 0}, {double(width), double(height)}, width, height)), map(width, height)
  {
    for (int i = random.between(0, 12); i > 0; --i) write(random);
  }

  Spans random_polygon(Random& random) const
  {
    std::vector<Point2d> points;
    for (int k = random.between(1, 5); k > 0; --k)
      points.push_back({random.uniform(-0.2, 1.2) * width, random.uniform(-0.2, 1.2) * height});
    return outer(grid, Outline{points});
  }
  void write(Random& random)
  {
    std::vector<PixelDepth> depths;
    for (int k = random.between(1, 3); k > 0; --k)
      depths.push_back(
        PixelDepth::above(grid, {{0, 0}, double(random.between(0, 9)), {0.1 * random.between(-1, 1), 0.01}}));
    if (random.chance(0.5))
      map.write(random_polygon(random), depths);
    else
      map.write(random_polygon(random), depths.front());
    if (random.chance(0.4)) map.refresh();
  }
};

bool truly_hidden(DepthMap<float> const& map, Spans const& spans, float d)
{
  for (auto const& s : spans)
    for (int x = s.begin; x < s.end; ++x)
      if (!(map.at(x, s.row) < d)) return false;
  return true;
}

}  // namespace

TEST_CASE("hierarchical depth map: a pixel of a level is the farthest of those below, after partial refreshes",
          "[raster][law]")
{
  property("levels are maxima", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    RandomMap m(random);
    m.map.refresh();
    RC_ASSERT(m.map.level(m.map.levels() - 1).width() == 1);
    RC_ASSERT(m.map.level(m.map.levels() - 1).height() == 1);
    for (int k = 1; k < m.map.levels(); ++k) {
      DepthMap<float> expected(m.map.level(k).width(), m.map.level(k).height());
      for (int y = 0; y < expected.height(); ++y)
        for (int x = 0; x < expected.width(); ++x) expected.row(y)[x] = -HUGE_VALF;
      for (int y = 0; y < m.height; ++y)
        for (int x = 0; x < m.width; ++x) {
          float& e = expected.row(y >> k)[x >> k];
          e = std::max(e, m.map.map().at(x, y));
        }
      RC_ASSERT(m.map.level(k) == expected);
    }
  });
}

TEST_CASE("hierarchical depth map: queries are those of all pixels, before and after a refresh", "[raster][law]")
{
  int hidden = 0, seen = 0;
  property("hidden == every pixel is nearer", [&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    RandomMap m(random);
    for (int i = 0; i < 20; ++i) {
      auto const spans = m.random_polygon(random);
      auto const d = static_cast<float>(random.between(0, 20));
      PixelRectangle r{random.below(m.width), random.below(m.height), random.between(1, m.width),
                       random.between(1, m.height)};
      Spans rows;
      for (int y = r.y0; y < r.y1 && r.x0 < r.x1; ++y) rows.push_back({y, r.x0, r.x1});
      bool const expected = truly_hidden(m.map.map(), spans, d), expected_r = truly_hidden(m.map.map(), rows, d);
      RC_ASSERT(m.map.hidden(spans, d) == expected);
      RC_ASSERT(m.map.hidden(r, d) == expected_r);
      auto const slanted =
        PixelDepth::below(m.grid, {{0, 0}, double(d), {0.1 * random.between(-2, 2), 0.1 * random.between(-2, 2)}});
      bool all = true;
      for (auto const& s : spans)
        for (int x = s.begin; x < s.end; ++x) all &= m.map.map().at(x, s.row) < slanted(x, s.row);
      RC_ASSERT(m.map.hidden(spans, slanted) == all);
      m.map.refresh();
      RC_ASSERT(m.map.hidden(spans, d) == expected);
      RC_ASSERT(m.map.hidden(r, d) == expected_r);
      ++(expected ? hidden : seen);
      m.write(random);
    }
  });
  REQUIRE(hidden > 100);
  REQUIRE(seen > 100);
}

TEST_CASE("hierarchical depth map: out of the map nothing is hidden; equal depths are not hidden", "[raster]")
{
  auto const grid = Grid::covering({0, 0}, {40, 40}, 40, 40);
  HierarchicalDepthMap<double> map(40, 40);
  Spans all;
  for (int y = 0; y < 40; ++y) all.push_back({y, 0, 40});
  map.write(all, PixelDepth::above(grid, {{0, 0}, 3, {0, 0}}));
  CHECK(map.hidden(PixelRectangle{0, 0, 40, 40}, 4));
  map.refresh();
  CHECK(map.hidden(PixelRectangle{0, 0, 40, 40}, 4));
  CHECK_FALSE(map.hidden(PixelRectangle{5, 5, 6, 6}, 3));
  CHECK_FALSE(map.hidden(PixelRectangle{-1, 0, 4, 4}, 4));
  CHECK_FALSE(map.hidden(PixelRectangle{0, 0, 41, 4}, 4));
  CHECK(map.hidden(PixelRectangle{7, 7, 7, 9}, 0));
  CHECK_FALSE(map.hidden(Spans{{39, 38, 41}}, PixelDepth::below(grid, {{0, 0}, 9, {1, 0}})));
  map.clear();
  CHECK_FALSE(map.hidden(PixelRectangle{0, 0, 40, 40}, 4));
}
