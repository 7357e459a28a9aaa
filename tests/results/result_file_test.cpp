#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/scene/result_file.hpp"
#include "visibility/scene/scene_builder.hpp"

using namespace visibility;
using test::Random;

namespace {

Result example()
{
  Result r;
  r.source = "gen:city";
  r.grounded = true;
  r.objects = 3;
  r.primitives = 4;
  r.cell_box = Box{{0.1, 0, 0}, {1, 1e-300, 3}};
  auto const corners = r.cell_box->corners();
  r.cell.assign(corners.begin(), corners.end());
  r.method = "strong-occlusion";
  r.arithmetic = "filtered";
  r.options = {{"granularity", "face"}, {"rays", "1000"}};
  r.guarantee = Guarantee::conservative;
  r.visible = {"a", "b \"quoted\"", "\xC3\xBC"};
  r.statistics = {{"rays", 12}, {"ratio", 0.1}};
  r.seconds = {1, 2, 0.25, 0.125, 0.0625};
  r.witnesses = {
    {"a", exact(Point3d{0.5, 0.1, 0.25}), Point3q{RationalNumber(1, 3), RationalNumber(-7), RationalNumber(2)}}};
  return r;
}

std::string fault(std::string const& text)
{
  try {
    auto const results = results_from_json(text, "pvs.json");
    for (auto const& r : results) (void)cell_of(r);
  } catch (BadInput const& e) {
    return e.what();
  }
  return {};
}

}  // namespace

TEST_CASE("result file: what is written is read back, exactly", "[results]")
{
  auto const back = results_from_json(to_json({example()}), "x");
  REQUIRE(back.size() == 1);
  auto const& r = back.front();
  Result const e = example();
  REQUIRE(r.source == e.source);
  REQUIRE(r.grounded);
  REQUIRE(r.objects == e.objects);
  REQUIRE(r.primitives == e.primitives);
  REQUIRE(r.options == e.options);
  REQUIRE(*r.cell_box == *e.cell_box);
  REQUIRE(r.method == e.method);
  REQUIRE(r.guarantee == e.guarantee);
  REQUIRE(r.visible == e.visible);
  REQUIRE(r.statistics == e.statistics);
  REQUIRE(r.seconds.query == e.seconds.query);
  REQUIRE(r.seconds.processor == e.seconds.processor);
  REQUIRE(r.seconds.build_processor == e.seconds.build_processor);
  REQUIRE(r.witnesses.size() == 1);
  REQUIRE(r.witnesses[0].from == e.witnesses[0].from);
  REQUIRE(r.witnesses[0].to == e.witnesses[0].to);
  REQUIRE(results_from_json(to_json({example(), example()}), "x").size() == 2);
}

TEST_CASE("result file: a set from elsewhere needs only format and names", "[results]")
{
  auto const r = results_from_json(R"({"format":"visibility-pvs/1","visible":["b","a","b"]})", "x").front();
  REQUIRE(r.visible == std::vector<std::string>{"a", "b"});
  REQUIRE(r.guarantee == Guarantee::none);
  REQUIRE_THROWS_AS(cell_of(r), BadInput);
}

TEST_CASE("result file: faults are one line that names the file", "[results][degenerate]")
{
  std::string const good = R"({"format":"visibility-pvs/1","visible":[],"cell":{"min":[0,0,0],"max":[1,1,1]}})";
  REQUIRE(fault(good).empty());
  std::vector<std::string> const bad{
    "",
    "[]",
    "{",
    "[1]",
    "{}",
    R"({"format":"visibility-pvs/2","visible":[]})",
    R"({"format":"visibility-pvs/1"})",
    R"({"format":"visibility-pvs/1","visible":[1]})",
    R"({"format":"visibility-pvs/1","visible":[],"cell":3})",
    R"({"format":"visibility-pvs/1","visible":[],"cell":{"min":[0,0],"max":[1,1,1]}})",
    R"({"format":"visibility-pvs/1","visible":[],"cell":{"min":[0,0,1e999],"max":[1,1,1]}})",
    R"({"format":"visibility-pvs/1","visible":[],"cell":{"min":[0,0,"x"],"max":[1,1,1]}})",
    R"({"format":"visibility-pvs/1","visible":[],"guarantee":"perfect","cell":{"min":[0,0,0],"max":[1,1,1]}})",
    R"({"format":"visibility-pvs/1","visible":[],"witnesses":[{"from":[0,0,"1/0"],"to":[0,0,0]}]})",
    R"({"format":"visibility-pvs/1","visible":[],"witnesses":[{"from":[0,0,"1/2/3"],"to":[0,0,0]}]})",
    std::string(100'000, '['),
    "{\"format\": \"\xFF\"}"};
  for (auto const& text : bad) {
    CAPTURE(text.substr(0, 100));
    auto const what = fault(text);
    REQUIRE(what.find("pvs.json") != std::string::npos);
    REQUIRE(what.find('\n') == std::string::npos);
  }
  REQUIRE_FALSE(fault(R"({"format":"visibility-pvs/1","visible":[],"cell":{"min":[0,0,0],"max":[1,1,0]}})").empty());
}

TEST_CASE("result file: truncated and damaged text never crashes", "[results][fuzz]")
{
  std::string const text = to_json({example(), example()});
  for (std::size_t n = 0; n < text.size(); ++n) (void)fault(text.substr(0, n));
  Random random(1);
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string damaged = text;
    for (int k = random.between(1, 4); k > 0; --k)
      damaged[static_cast<std::size_t>(random.below(static_cast<int>(damaged.size())))] =
        static_cast<char>(random.below(256));
    (void)fault(damaged);  // any exception but BadInput ends the test
  }
}

TEST_CASE("result file: cells are boxes or hulls", "[results]")
{
  auto const cells =
    cells_from_json(R"([{"min":[0,0,0],"max":[1,1,1]}, {"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]}])", "cells.json");
  REQUIRE(cells.size() == 2);
  REQUIRE(cells[0].is_box());
  REQUIRE(cells[1].vertices().size() == 4);
  REQUIRE_THROWS_AS(cells_from_json("[]", "x"), BadInput);
  REQUIRE_THROWS_AS(cells_from_json(R"([{"min":[0,0,0],"max":[1,1,0]}])", "x"), BadInput);
  REQUIRE_THROWS_AS(cells_from_json(R"([{"vertices":[[0,0,0],[1,0,0],[0,1,0],[1,1,0]]}])", "x"), BadInput);
}
