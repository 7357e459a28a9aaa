#include "command.hpp"
#include "support/catch.hpp"

#include <sstream>
#include <vector>

using namespace visibility;
using namespace visibility::test;

namespace {

std::string const streets =
  R"([{"name":"near street","min":[-250,-250,0],"max":[-230,-240,2],"polygons":50},
      {"name":"far street","min":[300,300,0],"max":[310,310,1],"polygons":50}])";
std::string const scene = "gen:city,n=400";

}  // namespace

TEST_CASE("command line: preprocess and recover, and compare and check of what comes out", "[commands]")
{
  Folder const folder;
  auto const sets = folder / "sets.vis", all = folder / "all.json", one = folder / "one.json";
  auto const moving = folder.write("moving.json", streets);
  for (std::string const method :
       {"exact-2.5d", "strong-occlusion", "extended-projection --resolution 64", "occlusion-sweep --resolution 64"}) {
    CAPTURE(method);
    auto const run = visibility_command(
      folder, "preprocess " + scene + " --region=-260,-260,0,-180,-220,2 --cell-size 40 " + "--method " + method +
                " --budget 60 --min-size 15 --moving " + moving + " -o " + sets);
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    REQUIRE(run.out.find("2 initial") != std::string::npos);
    REQUIRE(visibility_command(folder, "recover " + sets + " --all -o " + all).exit_code == 0);
    auto const results = read_results(all);
    REQUIRE(results.size() > 2);
    // Each leaf's exact set is in it.
    std::string cells;
    for (auto const& r : results) {
      Box const b = *r.cell_box;
      std::ostringstream text;
      text << " --cell=" << b.min.x << ',' << b.min.y << ',' << b.min.z << ',' << b.max.x << ',' << b.max.y << ','
           << b.max.z;
      cells += text.str();
    }
    auto const exact = folder / "exact.json";
    REQUIRE(
      visibility_command(folder, "pvs " + scene + cells + " --method exact-2.5d --moving " + moving + " -o " + exact)
        .exit_code == 0);
    REQUIRE(visibility_command(folder, "compare " + all + " " + exact).exit_code == 0);
    auto const exact_results = read_results(exact);
    for (std::size_t i = 0; i < results.size(); ++i) {
      REQUIRE(std::ranges::includes(results[i].visible, exact_results[i].visible));
      if (method == "exact-2.5d") REQUIRE(results[i].visible == exact_results[i].visible);
    }
    REQUIRE(std::ranges::binary_search(results[0].visible, "near street"));
    REQUIRE(visibility_command(folder, "check " + scene + " " + all + " --rays 20000 --moving " + moving).exit_code ==
            0);
    REQUIRE(visibility_command(folder, "check " + scene + " " + all + " --rays 100").exit_code == 2);

    REQUIRE(visibility_command(folder, "recover " + sets + " --at=-259,-259,1 -o " + one).exit_code == 0);
    auto const first = read_results(one).front();
    REQUIRE(contains(*first.cell_box, Point3d{-259, -259, 1}));
    auto const index = visibility_command(folder, "recover " + sets + " --index 0");
    REQUIRE(results_from_json(index.out, "x").front().visible == results[0].visible);
  }
}

TEST_CASE("command line: check finds what a set with moving objects lacks", "[commands]")
{
  Folder const folder;
  auto const moving = folder.write("moving.json", streets);
  auto const set = folder / "set.json";
  REQUIRE(visibility_command(folder, "pvs " + scene + " --cell=-228,-250,0,-220,-240,2 --method exact-2.5d --moving " +
                                       moving + " -o " + set)
            .exit_code == 0);
  auto result = read_results(set).front();
  auto const arguments = "check " + scene + " " + set + " --rays 50000 --moving " + moving;
  REQUIRE(visibility_command(folder, arguments).exit_code == 0);
  REQUIRE(std::erase(result.visible, "near street") == 1);
  folder.write("set.json", to_json({result}));
  auto const run = visibility_command(folder, arguments);
  REQUIRE(run.exit_code == 1);
  REQUIRE(run.out.find("near street") != std::string::npos);
}

TEST_CASE("command line: preprocess and recover refuse bad input in one line and leave no file",
          "[commands][degenerate]")
{
  Folder const folder;
  auto const cells = folder.write("cells.json", R"([{"min":[0,0,0],"max":[1,1,1]}])");
  auto const bad = folder.write("bad.json", R"([{"name":"a"}])");
  auto const taken = folder.write("taken.json", R"([{"name":"building 1","min":[0,0,0],"max":[1,1,1]}])");
  auto const damaged = folder.write("damaged.vis", "visibility-sets/1\nabcdefgh");
  std::string const start = "preprocess gen:city,n=20 --cells " + cells + " -o " + (folder / "out.vis");
  auto const before = folder.files();
  for (auto const& arguments : std::vector<std::string>{
         start, start + " --budget 0", start + " --budget 10 --min-size 0", start + " --budget 10 --method sampling",
         start + " --budget 10 --arithmetic double", start + " --budget 10 --moving " + bad,
         start + " --budget 10 --moving " + taken, start + " --budget 10 --moving nowhere.json",
         start + " --budget 10 --method exact-2.5d --witnesses",
         "preprocess gen:city,n=20 --budget 10 -o " + (folder / "out.vis"),
         "preprocess gen:city,n=20 --region=0,0,0,9,9,9 --cell-size 9 --cell-size 3 --budget 10 -o " +
           (folder / "out.vis"),
         "recover " + damaged + " --all", "recover " + cells + " --all", "recover nowhere.vis --all",
         "recover " + damaged, std::string("pvs gen:city,n=20 --cell=0,0,0,1,1,1 --method sampling --moving ") + bad}) {
    CAPTURE(arguments);
    auto const run = visibility_command(folder, arguments);
    REQUIRE(run.exit_code == 2);
    REQUIRE(is_one_line(run.err));
    REQUIRE(folder.files() == before);
  }
  REQUIRE(visibility_command(folder, start + " --budget 10").exit_code == 0);
  auto const out = folder / "out.vis";
  for (auto const& arguments : std::vector<std::string>{
         "recover " + out, "recover " + out + " --all --index 0", "recover " + out + " --index 1",
         "recover " + out + " --at 1,2", "recover " + out + " --at 100,0,0", "recover " + out + " --at nan,0,0"}) {
    CAPTURE(arguments);
    auto const run = visibility_command(folder, arguments);
    REQUIRE(run.exit_code == 2);
    REQUIRE(is_one_line(run.err));
  }
}
