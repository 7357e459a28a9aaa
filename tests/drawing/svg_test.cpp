#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/xml.hpp"

#include "visibility/drawing/write_picture.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace visibility;
using namespace visibility::test;

namespace {

/// The numbers of all path data of a document; letters are commands.
std::vector<double> numbers_of_paths(XmlDocument const& document)
{
  std::vector<double> out;
  for (auto const& e : document.elements) {
    if (e.name != "path") continue;
    std::string data;
    for (char const c : e.attributes.at("d")) {
      if (c == '-') data += ' ';
      data += std::isalpha(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
    }
    std::istringstream in(data);
    for (std::string word; in >> word;) out.push_back(std::stod(word));
  }
  return out;
}

std::vector<std::uint32_t> every(std::size_t n, std::size_t k)
{
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < n; i += k) out.push_back(static_cast<std::uint32_t>(i));
  return out;
}

std::size_t count(std::vector<PlanRole> const& roles, PlanRole role)
{
  return static_cast<std::size_t>(std::ranges::count(roles, role));
}

constexpr PlanRegion everything{{-1e5, -1e5}, {1e5, 1e5}};

}  // namespace

TEST_CASE("picture: as many objects of each role are drawn as the sets have", "[drawing]")
{
  Scene const scene = generate("city,n=300");
  PreparedScene const prepared(scene);
  ViewCell const cell(Box{{-400, -400, 0}, {400, 400, 5}});
  auto const first = every(scene.objects.size(), 3), second = every(scene.objects.size(), 2);
  auto const roles = plan_roles_of(prepared, cell, first, second);
  std::vector<std::uint32_t> both;
  std::ranges::set_intersection(first, second, std::back_inserter(both));
  REQUIRE(count(roles, PlanRole::visible) + count(roles, PlanRole::touching) == both.size());
  REQUIRE(count(roles, PlanRole::only_first) == first.size() - both.size());
  REQUIRE(count(roles, PlanRole::only_second) == second.size() - both.size());
  REQUIRE(count(roles, PlanRole::touching) > 0);

  auto picture = plan_picture(cell, everything);
  add_objects(picture, scene, roles);
  auto const document = parse_xml(to_svg(picture));
  REQUIRE(document.fault.empty());
  constexpr std::array groups{"occluders", "hidden", "visible", "touching", "only-first", "only-second"};
  for (std::size_t i = 0; i < groups.size(); ++i) {
    CAPTURE(groups[i]);
    auto const wanted = count(roles, static_cast<PlanRole>(i));
    REQUIRE(picture.objects_of[i] == wanted);
    auto const paths = elements_in(document, groups[i], "path");
    REQUIRE(paths.size() == wanted);
    auto const titles = elements_in(document, groups[i], "title");
    REQUIRE(titles.size() == wanted);
  }
}

TEST_CASE("picture: what lies beyond the region is cut, and counted all the same", "[drawing]")
{
  Scene const scene = generate("city,n=300");
  PreparedScene const prepared(scene);
  ViewCell const cell(Box{{-40, -40, 0}, {40, 40, 5}});
  auto const roles = plan_roles_of(prepared, cell, every(scene.objects.size(), 7));
  auto picture = plan_picture(cell, {{-300, -200}, {300, 200}});
  add_objects(picture, scene, roles);
  REQUIRE(picture.objects.size() < scene.objects.size() / 2);
  REQUIRE(picture.objects_of[1] + picture.objects_of[2] + picture.objects_of[3] == scene.objects.size());
  auto const document = parse_xml(to_svg(picture));
  REQUIRE(document.fault.empty());
  for (double const x : numbers_of_paths(document)) REQUIRE(std::abs(x) < 5000);
  REQUIRE(document.elements.front().attributes.at("width") == "1000");
}

TEST_CASE("picture: crowds become a few paths, small enough to look at", "[drawing]")
{
  Scene const scene = generate("city,n=20000");
  PreparedScene const prepared(scene);
  ViewCell const cell(Box{{-40, -40, 0}, {40, 40, 5}});
  auto const roles = plan_roles_of(prepared, cell, every(scene.objects.size(), 100));
  auto picture = plan_picture(cell, default_region(scene, roles, cell));
  add_objects(picture, scene, roles);
  std::string const svg = to_svg(picture);
  REQUIRE(svg == to_svg(picture));
  auto const document = parse_xml(svg);
  REQUIRE(document.fault.empty());
  REQUIRE(elements_in(document, "hidden", "path").size() < 40);
  REQUIRE(elements_in(document, "visible", "path").size() == count(roles, PlanRole::visible));
  REQUIRE(svg.size() < 1'500'000);
}

TEST_CASE("picture: any scene, cell and names give well-formed XML with small finite numbers", "[drawing][law]")
{
  std::array<char const*, 5> const names{"a<b>&\"'", "\xE4\xB8\xAD\xE5\x8D\x97", "]]>", "--", "&amp;"};
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    double const scale = std::pow(10.0, random.between(-20, 19));
    double const offset = scale * std::pow(10.0, random.below(12));
    auto const coordinate = [&] { return offset + scale * random.unit(); };
    SceneBuilder builder("test");
    int const n = random.between(1, 8);
    for (int i = 0; i < n; ++i) {
      builder.begin_object(names[static_cast<std::size_t>(random.below(5))]);
      Point3d const p{coordinate(), coordinate(), 0}, q{coordinate(), coordinate(), scale};
      switch (random.below(3)) {
      case 0: builder.add(Ball{p, scale * random.unit() * (random.below(4) == 0 ? 1e6 : 1)}); break;
      case 1:
        builder.add(Box{{std::min(p.x, q.x), std::min(p.y, q.y), 0}, {std::max(p.x, q.x), std::max(p.y, q.y), scale}});
        break;
      default: {
        auto const a = builder.add_vertex(p), b = builder.add_vertex(q), c = builder.add_vertex({p.x, q.y, 0});
        builder.add_triangle(a, b, c);
      }
      }
    }
    Scene const scene = builder.finish();
    PreparedScene const prepared(scene);
    ViewCell const cell(Box{{offset, offset, 0}, {offset + scale / 4, offset + scale / 4, scale}});
    auto const roles = plan_roles_of(prepared, cell, every(scene.objects.size(), 2));
    auto picture = plan_picture(cell, default_region(scene, roles, cell));
    add_objects(picture, scene, roles);
    picture.title = names[static_cast<std::size_t>(random.below(5))];
    picture.sight_lines.push_back({{offset, offset}, {coordinate(), coordinate() * 3}});
    PictureStyle style;
    style.size = random.between(200, 1200);
    auto const document = parse_xml(to_svg(picture, style));
    REQUIRE(document.fault.empty());
    REQUIRE(document.elements[1].text == picture.title);
    auto const numbers = numbers_of_paths(document);
    REQUIRE(numbers.size() > 20);
    for (double const x : numbers) REQUIRE(std::abs(x) < 20'000);
  }
}

TEST_CASE("picture: a region that cannot be drawn is bad input", "[drawing]")
{
  ViewCell const cell(Box{{0, 0, 0}, {1, 1, 1}});
  double const most = std::numeric_limits<double>::max();
  REQUIRE_THROWS_AS(plan_picture(cell, {{0, 0}, {0, 1}}), BadInput);
  REQUIRE_THROWS_AS(plan_picture(cell, {{1, 0}, {0, 1}}), BadInput);
  REQUIRE_THROWS_AS(plan_picture(cell, {{-most, 0}, {most, 1}}), BadInput);
  REQUIRE_THROWS_AS(plan_picture(cell, {{0, 0}, {1e-310, 1e-310}}), BadInput);
  REQUIRE_THROWS_AS(plan_picture(cell, {{0, 0}, {NAN, 1}}), BadInput);
  auto const wide = plan_picture(cell, {{0, 0}, {1000, 1}}).region;
  REQUIRE((wide.max.x - wide.min.x) / (wide.max.y - wide.min.y) == Approx(2.5));
  REQUIRE_THROWS_AS(to_svg(plan_picture(cell, everything), {.size = 0}), std::invalid_argument);
}
