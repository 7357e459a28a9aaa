#include "command.hpp"
#include "support/catch.hpp"

#include <array>

using namespace visibility;
using namespace visibility::test;

TEST_CASE("command line: pvs writes a result that check and compare accept", "[commands]")
{
  Folder const folder;
  auto const pvs = folder / "pvs.json", sampled = folder / "sampled.json";
  auto const city = std::string("gen:city,n=100");
  auto run = visibility_command(folder, "pvs " + city + " --cell=-30,-30,0,30,30,50 -o " + pvs + " --map");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  REQUIRE(run.out.find('#') != std::string::npos);
  REQUIRE(run.err.empty());  // no progress bar in a pipe
  auto const result = read_results(pvs).front();
  REQUIRE(result.guarantee == Guarantee::conservative);
  REQUIRE(result.visible.size() > 4);
  REQUIRE(result.visible.size() < result.objects);

  run = visibility_command(folder,
                           "pvs " + city + " --cell=-30,-30,0,30,30,50 --method sampling --rays 100000 -o " + sampled);
  REQUIRE(run.exit_code == 0);
  REQUIRE(visibility_command(folder, "compare " + pvs + " " + sampled).exit_code == 0);
  run = visibility_command(folder, "check " + city + " " + pvs + " --rays 100000");
  REQUIRE(run.exit_code == 0);
  REQUIRE(run.out.find("no fault") != std::string::npos);
}

TEST_CASE("command line: check and compare find a missing object and exit with 1", "[commands]")
{
  Folder const folder;
  auto const pvs = folder / "pvs.json", sampled = folder / "sampled.json";
  std::string const common = "gen:city,n=100 --cell=-30,-30,0,30,30,50 ";
  REQUIRE(visibility_command(folder, "pvs " + common + "-o " + pvs).exit_code == 0);
  REQUIRE(visibility_command(folder, "pvs " + common + "--method sampling --rays 100000 -o " + sampled).exit_code == 0);
  auto results = read_results(pvs);
  std::erase(results.front().visible, read_results(sampled).front().visible.front());
  auto const damaged = folder.write("damaged.json", to_json(results));
  auto const check = visibility_command(folder, "check gen:city,n=100 " + damaged + " --rays 2e5");
  REQUIRE(check.exit_code == 1);
  REQUIRE(check.out.find("FAULT") != std::string::npos);
  REQUIRE(visibility_command(folder, "compare " + damaged + " " + sampled).exit_code == 1);
}

TEST_CASE("command line: without -o the result goes to standard output; several cells make an array", "[commands]")
{
  Folder const folder;
  auto const cells = folder.write("cells.json", R"([{"min":[-30,-30,0],"max":[30,30,50]},
    {"vertices":[[0,0,0],[10,0,0],[0,10,0],[0,0,10]]}])");
  auto const run =
    visibility_command(folder, "pvs gen:city,n=100 --cells " + cells + " --cell 0,0,0,1,1,1 --threads 2");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  auto const results = results_from_json(run.out, "standard output");
  REQUIRE(results.size() == 3);
  REQUIRE(results[2].cell.size() == 4);
  // A smaller cell inside a larger one never sees more.
  REQUIRE(std::ranges::includes(results[1].visible, results[0].visible));
}

TEST_CASE("command line: a region is divided into cells, on one level or from coarse to fine, with the same sets",
          "[commands]")
{
  Folder const folder;
  std::string const common = "pvs gen:city,n=100 --region=-80,-80,0,80,80,50 ";
  auto const one = visibility_command(folder, common + "--cell-size 40");
  auto const two =
    visibility_command(folder, common + "--cell-size 80 --cell-size 40,40,50 --coarse-granularity object");
  INFO(one.err << two.err);
  REQUIRE(one.exit_code == 0);
  REQUIRE(two.exit_code == 0);
  auto const direct = results_from_json(one.out, "one"), refined = results_from_json(two.out, "two");
  REQUIRE(direct.size() == 16);
  REQUIRE(refined.size() == 16);
  for (std::size_t i = 0; i < 16; ++i) {
    REQUIRE(direct[i].cell_box == refined[i].cell_box);
    REQUIRE(direct[i].visible == refined[i].visible);
  }
  auto const many = visibility_command(folder, common + "--cell-size 20 -o " + (folder / "many.json"));
  REQUIRE(many.exit_code == 0);
  REQUIRE(many.out.find("cells   64") != std::string::npos);
}

TEST_CASE("command line: optimizations can be switched off, and are recorded", "[commands]")
{
  Folder const folder;
  std::string const common = "pvs gen:city,n=100 --cell=-30,-30,0,30,30,50 ";
  auto const all = visibility_command(folder, common),
             some = visibility_command(folder, common + "--without groups,hull-rays");
  REQUIRE(all.exit_code == 0);
  REQUIRE(some.exit_code == 0);
  auto const with = results_from_json(all.out, "a").front(), without = results_from_json(some.out, "b").front();
  REQUIRE(with.visible == without.visible);
  REQUIRE(with.options.at("groups") == "on");
  REQUIRE(without.options.at("groups") == "off");
  REQUIRE(without.options.at("cache") == "on");
  REQUIRE(with.statistics.at("rays") < without.statistics.at("rays"));
}

TEST_CASE("command line: generate writes what info and pvs read back as the same scene", "[commands]")
{
  Folder const folder;
  for (std::string const name : {"city.obj", "city.ply", "city.json"}) {
    auto const file = folder / name;
    auto run = visibility_command(folder, "generate city n=100 seed=3 -o " + file);
    INFO(name << run.err);
    REQUIRE(run.exit_code == 0);
    REQUIRE(visibility_command(folder, "info " + file).exit_code == 0);
    auto const from_file = visibility_command(folder, "pvs " + file + " --cell=-30,-30,0,30,30,50");
    auto const generated = visibility_command(folder, "pvs gen:city,n=100,seed=3 --cell=-30,-30,0,30,30,50");
    REQUIRE(from_file.exit_code == 0);
    REQUIRE(results_from_json(from_file.out, "a").front().visible.size() ==
            results_from_json(generated.out, "b").front().visible.size());
  }
}

TEST_CASE("command line: bad input is one line, exit code 2 and no file", "[commands][degenerate]")
{
  Folder const folder;
  auto const nan = folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  auto const truncated = folder.write("truncated.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 3\n");
  auto const empty = folder.write("empty.geojson", "");
  auto const set = folder.write("set.json", R"({"format":"visibility-pvs/1","visible":["nobody"],"guarantee":"exact",
    "cell":{"min":[0,0,0],"max":[1,1,1]}})");
  std::size_t const before = folder.files();
  std::string const cell = " --cell 0,0,0,1,1,1 ";
  std::vector<std::string> const bad{"",
                                     "nonsense",
                                     "pvs",
                                     "pvs gen:city",
                                     "pvs gen:castle" + cell,
                                     "pvs gen:city,n=0" + cell,
                                     "pvs gen:city,colour=3" + cell,
                                     "pvs gen:city --cell 0,0,0,1,1",
                                     "pvs gen:city --cell 0,0,0,1,1,1,1",
                                     "pvs gen:city --cell 0,0,0,1,nan,1",
                                     "pvs gen:city --cell 0,0,0,1,1e999,1",
                                     "pvs gen:city --cell 0,0,0,0,1,1",
                                     "pvs gen:city" + cell + "--method guess",
                                     "pvs gen:city" + cell + "--arithmetic float",
                                     "pvs gen:city" + cell + "--granularity atom",
                                     "pvs gen:city" + cell + "--coarse-granularity atom",
                                     "pvs gen:city" + cell + "--without everything",
                                     "pvs gen:city" + cell + "--method sampling --without groups",
                                     "pvs gen:city" + cell + "--cell-size 10",
                                     "pvs gen:city" + cell + "--region 0,0,0,1,1,1 --cell-size 1",
                                     "pvs gen:city --region 0,0,0,1,1,1",
                                     "pvs gen:city --region 0,0,0,1,1 --cell-size 1",
                                     "pvs gen:city --region 0,0,0,1,0,1 --cell-size 1",
                                     "pvs gen:city --region 0,0,0,1,1,1 --cell-size 0",
                                     "pvs gen:city --region 0,0,0,1,1,1 --cell-size 1,1",
                                     "pvs gen:city --region 0,0,0,1,1,1 --cell-size 0.5 --cell-size 1",
                                     "pvs gen:city --region 0,0,0,1,1,1 --cell-size 0.00001",
                                     "pvs gen:city --region 0,0,0,9,9,1 --cell-size 9 --cell-size 3 --method sampling",
                                     "pvs gen:city" + cell + "--unknown",
                                     "pvs gen:city" + cell + "--method sampling --rays 0",
                                     "pvs gen:city" + cell + "--method sampling --rays 1.5",
                                     "pvs gen:city" + cell + "--method sampling --rays many",
                                     "pvs gen:city" + cell + "--method extended-projection --resolution 0",
                                     "pvs gen:city" + cell + "--method extended-projection --plane-distances=5,-1",
                                     "pvs gen:city" + cell + "--method occlusion-sweep --arithmetic rational",
                                     "pvs gen:city" + cell + "--method occlusion-sweep --kernel 1",
                                     "pvs gen:city" + cell + "--method ray-space --resolution 4",
                                     "pvs gen:city" + cell + "--method ray-space --components 0",
                                     "pvs gen:city" + cell + "--method ray-space --umbra most",
                                     "pvs gen:city" + cell + "--method ray-space --bounds loose",
                                     "pvs gen:city" + cell + "--method ray-space --arithmetic rational",
                                     "pvs gen:city" + cell + "--cells " + empty,
                                     "pvs gen:city,n=10" + cell + "-o " + (folder / "no/such/folder/pvs.json"),
                                     "pvs " + (folder / "missing.obj") + cell + "-o " + (folder / "out.json"),
                                     "pvs " + nan + cell + "-o " + (folder / "out.json"),
                                     "pvs " + truncated + cell + "-o " + (folder / "out.json"),
                                     "pvs " + empty + cell + "-o " + (folder / "out.json"),
                                     "info " + nan,
                                     "generate city n=10 -o " + (folder / "city.unknown"),
                                     "generate spheres n=3 -o " + (folder / "spheres.obj"),
                                     "generate castle -o " + (folder / "castle.obj"),
                                     "compare " + set + " " + nan,
                                     "check gen:city,n=10 " + set,
                                     "check gen:city,n=10 " + nan};
  for (auto const& arguments : bad) {
    auto const run = visibility_command(folder, arguments);
    CAPTURE(arguments, run.out, run.err);
    REQUIRE(run.exit_code == 2);
    REQUIRE(is_one_line(run.err));
    REQUIRE(run.out.empty());
    REQUIRE(folder.files() == before);
  }
}

TEST_CASE("command line: help and version succeed", "[commands]")
{
  Folder const folder;
  for (auto const* arguments : {"--help", "--version", "pvs --help", "generate --help"}) {
    auto const run = visibility_command(folder, arguments);
    REQUIRE(run.exit_code == 0);
    REQUIRE_FALSE(run.out.empty());
  }
}
