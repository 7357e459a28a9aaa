#include "support.hpp"

using namespace visibility;

TEST_CASE("urban: the triangles of each shape", "[generators]")
{
  struct Case {
    char const* shape;
    std::size_t parts;
  };
  auto const c = GENERATE(values<Case>({{"h=0,t=0", 1}, {"h=0,t=1", 2}, {"h=1,t=0", 3}}));
  auto const decks = GENERATE(0, 2);
  CAPTURE(c.shape, decks);
  auto const scene =
    generate("urban,n=40,low=5,high=5," + std::string(c.shape) + (decks == 0 ? ",decks=0" : ",decks=1,deck-floors=2"));
  std::size_t two_decks = 0;
  for (auto const& o : scene.objects) {
    auto const boxes = o.triangles.size() / 12;
    if (decks == 0) {
      REQUIRE(boxes == c.parts * 5);
    } else {
      REQUIRE((boxes == c.parts * 10 || boxes == c.parts * 15));  // five boxes a deck, one or two decks
      two_decks += boxes == c.parts * 15 ? 1 : 0;
    }
  }
  if (decks != 0) REQUIRE((two_decks > 5 && two_decks < 35));
}

TEST_CASE("urban: every floor, slab and column is a convex solid", "[generators]")
{
  auto const specification = GENERATE("urban,n=30", "urban,n=30,h=1,t=0,decks=1",
                                      "urban,n=30,t=1,h=0,decks=1,ledge=0.4", "urban,n=30,tilt=30,decks=1");
  CAPTURE(specification);
  auto const scene = generate(specification);
  scene.validate();
  for (auto const& o : scene.objects) {
    REQUIRE(test::is_closed(scene, o));
    REQUIRE(test::volume(scene, o) > 0);
  }
  REQUIRE(12 * test::convex_solids(scene) == scene.triangles.size());
  REQUIRE(bounding_box(scene).min.z >= 0);
  REQUIRE(bounding_box(scene).min.z < 0.1);
}

TEST_CASE("urban: buildings keep to their lots and the avenues are free", "[generators]")
{
  auto const scene = generate("urban,n=300,density=1,regularity=0,block=2,blocks=2");
  REQUIRE(test::are_apart(scene));
  for (auto const& o : scene.objects) {
    auto const b = bounding_box(scene, o);
    REQUIRE_FALSE(meet(b, Box{{-1e4, -15, 0}, {1e4, 15, 1}}));
    REQUIRE_FALSE(meet(b, Box{{-15, -1e4, 0}, {15, 1e4, 1}}));
    // The next avenue: 15 + 4 lots of 20 + a street of 12, and 30 wide.
    REQUIRE_FALSE(meet(b, Box{{107, -1e4, 0}, {137, 1e4, 1}}));
    REQUIRE_FALSE(meet(b, Box{{-1e4, -137, 0}, {1e4, -107, 1}}));
  }
}

TEST_CASE("urban: sizes and rotation are within their bounds and use them", "[generators]")
{
  auto const scene = generate("urban,n=500,h=0,t=0,decks=0,ledge=0,low=1,high=1");
  double least = 1e9, greatest = 0, steepest = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    auto const* v = &scene.vertices[8 * i];
    for (int k : {1, 3}) {
      double const dx = v[k].x - v[0].x, dy = v[k].y - v[0].y, side = std::sqrt(dx * dx + dy * dy);
      least = std::min(least, side);
      greatest = std::max(greatest, side);
    }
    steepest = std::max(steepest, std::abs((v[1].y - v[0].y) / (v[1].x - v[0].x)));
  }
  REQUIRE((least >= 9 - 1e-9 && least < 9.1));
  REQUIRE((greatest <= 12 + 1e-9 && greatest > 11.9));
  REQUIRE((steepest <= std::sqrt(1.0 / 3) + 1e-9 && steepest > 0.55));  // tan 30 degrees
}

TEST_CASE("urban: shares and heights are distributed as asked", "[generators]")
{
  auto const shapes = generate("urban,n=2000,low=1,high=1,decks=0");
  std::array<int, 4> of{};
  for (auto const& o : shapes.objects) ++of[o.triangles.size() / 12];
  REQUIRE(std::abs(of[3] - 400) < 90);  // H; 5 sigma
  REQUIRE(std::abs(of[2] - 400) < 90);  // T
  REQUIRE(of[1] + of[2] + of[3] == 2000);

  auto const open = generate("urban,n=2000,low=1,high=1,h=0,t=0,deck-floors=1");
  auto const decked = std::ranges::count_if(open.objects, [](Object const& o) { return o.triangles.size() == 72; });
  REQUIRE(std::abs(decked - 600) < 105);

  auto const floors = [](std::string const& skew) {
    auto const scene = generate("urban,n=2000,h=0,t=0,decks=0,low=1,high=9,skew=" + skew);
    return static_cast<double>(scene.triangles.size()) / 12 / 2000;
  };
  REQUIRE(std::abs(floors("1") - 5) < 0.3);
  REQUIRE(floors("3") < 3.5);
}

TEST_CASE("urban: density thins out the lots, regularity lines the buildings up", "[generators]")
{
  auto const side = [](std::string const& specification) {
    auto const b = bounding_box(generate(specification));
    return b.max.x - b.min.x;
  };
  double const full = side("urban,n=1000,density=1"), quarter = side("urban,n=1000,density=0.25");
  REQUIRE(std::abs(quarter / full - 2) < 0.2);
  auto const scene = generate("urban,n=100,density=1,regularity=1,rotation=0,h=0,t=0");
  for (auto const& o : scene.objects) {
    auto const b = bounding_box(scene, o);
    double const x = std::abs(b.min.x + b.max.x) / 2 - 25;    // the first lot is 20 wide, beside half an avenue of 30
    double const within = x - 92 * std::floor((x + 1) / 92);  // blocks of four lots and a street repeat every 92 m
    REQUIRE(std::abs(within - 20 * std::round(within / 20)) < 1e-9);
  }
}
