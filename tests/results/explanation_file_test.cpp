#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/methods/exact_25d/explanation_file.hpp"
#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/grounded.hpp"
#include "visibility/scene/scene_builder.hpp"

using namespace visibility;
using namespace visibility::exact_25d;

TEST_CASE("explanation file: what is written is read again, exactly", "[results][law]")
{
  Scene const scene = grounded(generate("slanted,n=200"));
  HeightField const field(scene);
  std::vector<ViewCell> const cells{ViewCell(Box{{-5, -5, 0}, {5, 5, 3}}), ViewCell(Box{{0, 0, 0}, {1, 1, 7}})};
  std::vector<Explanation> explanations;
  for (auto const& cell : cells) explanations.push_back(Exact25d<>().explain(field, cell).second);
  std::size_t roots = 0;
  auto const read = explanations_from_json(to_json(scene, cells, explanations), "lines.json", scene);
  REQUIRE(read.size() == cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    auto const& [cell, found] = read[i];
    Explanation const& wanted = explanations[i];
    REQUIRE(std::ranges::equal(cell, cells[i].vertices()));
    REQUIRE(found.edges.size() == wanted.edges.size());
    for (std::size_t k = 0; k < wanted.edges.size(); ++k) {
      auto const &a = found.edges[k], &b = wanted.edges[k];
      REQUIRE((a.object == b.object && a.edge == b.edge && a.sees_top == b.sees_top));
      REQUIRE(a.parts.size() == b.parts.size());
      for (std::size_t p = 0; p < b.parts.size(); ++p) {
        REQUIRE(is_zero(compare(a.parts[p].low, b.parts[p].low)));
        REQUIRE(is_zero(compare(a.parts[p].high, b.parts[p].high)));
        if (b.parts[p].high.d != 0) ++roots;
      }
    }
    REQUIRE(found.cells.size() == wanted.cells.size());
    for (std::size_t k = 0; k < wanted.cells.size(); ++k) {
      auto const &a = found.cells[k], &b = wanted.cells[k];
      REQUIRE((a.entry == b.entry && a.exit == b.exit && a.bounds == b.bounds && a.occluders == b.occluders));
    }
    REQUIRE(found.shadows.size() == wanted.shadows.size());
    for (std::size_t k = 0; k < wanted.shadows.size(); ++k)
      REQUIRE((found.shadows[k].source == wanted.shadows[k].source &&
               found.shadows[k].occluder == wanted.shadows[k].occluder));
  }
  REQUIRE(roots > 0);
  REQUIRE(!explanations[0].edges.empty());
}

TEST_CASE("explanation file: faults are named", "[results]")
{
  Scene const scene = generate("city,n=5");
  auto const fault = [&](std::string const& edges) -> std::string {
    try {
      explanations_from_json(R"({"format": "visibility-lines/1", "cell": {"vertices": []}, "funnels": [],
        "shadow_planes": [], "edges": )" +
                               edges + '}',
                             "lines.json", scene);
      return "";
    } catch (BadInput const& e) {
      return e.what();
    }
  };
  std::string const edge = R"([{"object": ")" + scene.objects[0].name + R"(", "left": [0,0,0], "right": [1,0,0], )";
  REQUIRE(fault(edge + R"("parts": [[0, 0.5]]}])").empty());
  REQUIRE(fault(edge + R"("exact_parts": [[["0"], ["1/3", "-2", "3"]]]}])").empty());
  REQUIRE(fault("[]").empty());
  for (auto const* bad : {R"("parts": [[0]]}])", R"("parts": 3}])", R"("parts": [["x", 1]]}])", R"("sees": "top"}])",
                          R"("exact_parts": [[["0"], ["1", "2"]]]}])", R"("exact_parts": [[["1/0"], ["1"]]]}])",
                          R"("exact_parts": [[["0"], ["1", "1", "-1"]]]}])"}) {
    CAPTURE(bad);
    REQUIRE(fault(edge + bad).find("lines.json") != std::string::npos);
  }
  REQUIRE(fault(R"([{"object": "nobody", "left": [0,0,0], "right": [1,0,0], "parts": []}])").find("nobody") !=
          std::string::npos);
  REQUIRE(fault("{}").find("edges") != std::string::npos);
}

TEST_CASE("explanation file: damaged files are read or refused, never worse", "[results][fuzz]")
{
  Scene const scene = grounded(generate("slanted,n=12"));
  HeightField const field(scene);
  std::vector<ViewCell> const cells{ViewCell(Box{{-5, -5, 0}, {5, 5, 3}})};
  std::string const whole = to_json(scene, cells, {Exact25d<>().explain(field, cells[0]).second});
  int read = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::string text = whole;
    for (int k = random.between(1, 3); k > 0; --k) {
      constexpr std::string_view bytes = "0-[]{},\"/e1.x";
      auto const at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
      switch (random.below(3)) {
      case 0: text[at] = bytes[static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())))]; break;
      case 1: text.erase(at, static_cast<std::size_t>(random.between(1, 5))); break;
      default: text.insert(at, text.substr(static_cast<std::size_t>(random.below(static_cast<int>(at + 1))), 3));
      }
    }
    try {
      for (auto const& entry : explanations_from_json(text, "lines.json", scene))
        for (auto const& e : entry.explanation.edges)
          for (auto const& p : e.parts) REQUIRE(p.low.d >= 0);
      ++read;
    } catch (BadInput const& e) {
      REQUIRE(std::string(e.what()).find('\n') == std::string::npos);
      ++refused;
    }
  }
  REQUIRE((read > 20 && refused > 20));
}
