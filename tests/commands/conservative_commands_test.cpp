#include "command.hpp"
#include "support/catch.hpp"

#include <array>

using namespace visibility;
using namespace visibility::test;

TEST_CASE("command line: ray-space, its options in the result", "[commands]")
{
  Folder const folder;
  auto const exact = folder / "exact.json", set = folder / "set.json";
  std::string const common = "pvs gen:city,n=400 --cell=-250,-250,0,-240,-240,10 --method ";
  REQUIRE(visibility_command(folder, common + "exact-2.5d -o " + exact).exit_code == 0);
  for (std::string const options : {"", " --umbra half --resolution 256", " --components 4 --bounds linear"}) {
    auto const run = visibility_command(folder, common + "ray-space" + options + " -o " + set);
    CAPTURE(options, run.err);
    REQUIRE(run.exit_code == 0);
    auto const result = read_results(set).front();
    REQUIRE(result.guarantee == Guarantee::conservative);
    REQUIRE(std::ranges::includes(result.visible, read_results(exact).front().visible));
    REQUIRE(result.options.contains("resolution"));
    REQUIRE(visibility_command(folder, "check gen:city,n=400 " + set + " --rays 100000").exit_code == 0);
  }
}

TEST_CASE("command line: extended-projection and occlusion-sweep keep the exact set", "[commands]")
{
  Folder const folder;
  auto const pvs = [&](std::string const& method) {
    auto const file = folder / "pvs.json";
    auto const run =
      visibility_command(folder, "pvs gen:city,n=500 --cell=-20,-20,0,20,20,3 --method " + method + " -o " + file);
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    return read_results(file).front();
  };
  auto const exact = pvs("exact-2.5d");
  for (std::string const method : {"extended-projection", "occlusion-sweep"}) {
    auto const set =
      pvs(method + " --resolution 128 --plane-distances 200,400,800 --no-improved --no-slices --depth pixel");
    REQUIRE(set.method == method);
    REQUIRE(set.guarantee == Guarantee::conservative);
    REQUIRE(set.options.at("resolution") == "128");
    REQUIRE(set.options.at("improved") == "off");
    REQUIRE(set.options.at("slices") == "off");
    REQUIRE(set.options.at("depth") == "pixel");
    REQUIRE(set.options.at("plane-distances").starts_with("200"));
    REQUIRE(std::ranges::includes(set.visible, exact.visible));
    REQUIRE(set.visible.size() < set.objects);
    REQUIRE(visibility_command(folder, "check gen:city,n=500 " + (folder / "pvs.json") + " --rays 100000").exit_code ==
            0);
  }
}
