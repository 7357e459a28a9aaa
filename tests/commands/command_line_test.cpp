#include "support/catch.hpp"

#include "visibility/scene/result_file.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

using namespace visibility;
namespace fs = std::filesystem;

namespace {

/// A folder of its own for each test case, removed afterwards.
class Folder {
public:
  Folder()
  {
    std::string name = (fs::temp_directory_path() / "visibility-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(std::string const& name) const { return (path_ / name).string(); }
  std::string write(std::string const& name, std::string const& text) const
  {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
  }
  std::size_t files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator{}));
  }

private:
  fs::path path_;
};

struct Run {
  int exit_code;
  std::string out, err;
};

Run visibility_command(Folder const& folder, std::string const& arguments)
{
  std::string const out = folder / "stdout", err = folder / "stderr";
  int const status =
    std::system((VISIBILITY_COMMAND " " + arguments + " >" + out + " 2>" + err + " </dev/null").c_str());
  auto const read = [](std::string const& file) {
    std::ifstream in(file);
    std::string const text{std::istreambuf_iterator<char>(in), {}};
    fs::remove(file);
    return text;
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
}

bool is_one_line(std::string const& text) { return !text.empty() && text.find('\n') == text.size() - 1; }

}  // namespace

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

TEST_CASE("command line: exact-2.5d, with witnesses, inside what strong occlusion keeps", "[commands]")
{
  Folder const folder;
  auto const exact = folder / "exact.json", rational = folder / "rational.json", loose = folder / "loose.json";
  std::string const cell = " --cell=-30,-30,0,30,30,10 --method ";
  auto const pvs = [&](std::string const& options, std::string const& file) {
    auto const run = visibility_command(folder, "pvs gen:city,n=100" + cell + options + " -o " + file);
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    return read_results(file).front();
  };
  auto const set = pvs("exact-2.5d --witnesses", exact);
  REQUIRE(set.guarantee == Guarantee::exact);
  REQUIRE(set.witnesses.size() == set.visible.size());
  REQUIRE(pvs("exact-2.5d --arithmetic rational", rational).visible == set.visible);
  auto const kept = pvs("strong-occlusion", loose).visible;
  REQUIRE(std::ranges::includes(kept, set.visible));
  REQUIRE(kept.size() > set.visible.size());
  REQUIRE(visibility_command(folder, "check gen:city,n=100 " + exact + " --rays 100000").exit_code == 0);

  auto const refused = [&](std::string const& scene, std::string const& options) {
    auto const run = visibility_command(folder, "pvs " + scene + cell + "exact-2.5d" + options);
    CAPTURE(scene, options, run.err);
    return run.exit_code == 2 && is_one_line(run.err);
  };
  REQUIRE(refused("gen:spheres,n=3", ""));  // balls have no edges
  REQUIRE(refused("gen:city,n=100", " --region=0,0,0,8,8,8 --cell-size 4 --cell-size 2"));
  auto const raised = folder.write("raised.json", R"({"format": "visibility-scene/1", "objects": [
    {"name": "ground", "boxes": [100,100,0,101,101,1]}, {"name": "cloud", "boxes": [50,0,40,60,10,50]}]})");
  REQUIRE(refused(raised, ""));
  REQUIRE(!refused(raised, " --grounded"));
  REQUIRE(refused(folder.write("high.json", R"({"format": "visibility-scene/1", "objects": [
    {"name": "high", "boxes": [50,0,40,60,10,50]}]})"),
                  ""));  // the cell lies below it
}

TEST_CASE("command line: exact-2.5d looks for the objects of another scene, which hide nothing", "[commands]")
{
  Folder const folder;
  auto const wall = folder.write("wall.json", R"({"format": "visibility-scene/1", "objects": [
    {"name": "wall", "boxes": [10,-50,0,11,50,20]}]})");
  auto const targets = folder.write("targets.json", R"({"format": "visibility-scene/1", "objects": [
    {"name": "near", "boxes": [5,-50,0,6,50,30]}, {"name": "behind", "boxes": [15,-5,0,16,5,5]},
    {"name": "over", "boxes": [15,-5,90,16,5,95]}]})");
  auto const out = folder / "pvs.json";
  std::string const pvs = "pvs " + wall + " --cell=-1,-1,0,1,1,2 -o " + out + " --method ";
  auto const run = visibility_command(folder, pvs + "exact-2.5d --witnesses --occludees " + targets);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  auto const result = read_results(out).front();
  REQUIRE(result.guarantee == Guarantee::exact);
  REQUIRE(result.visible == std::vector<std::string>{"near", "over"});
  REQUIRE(result.witnesses.size() == 2);
  REQUIRE(result.occludees == targets);
  REQUIRE(result.objects == 3);

  auto const refused = [&](std::string const& arguments) {
    auto const bad = visibility_command(folder, arguments);
    CAPTURE(arguments, bad.err);
    return bad.exit_code == 2 && is_one_line(bad.err);
  };
  REQUIRE(refused("check " + wall + " " + out));  // rays know one scene
  REQUIRE(refused(pvs + "strong-occlusion --occludees " + targets));
  REQUIRE(refused(pvs + "exact-2.5d --occludees gen:spheres,n=3"));
  REQUIRE(refused(pvs + "exact-2.5d --occludees " + (folder / "nothing.obj")));
}

TEST_CASE("command line: --explain writes the visible edges, funnels and shadow planes", "[commands]")
{
  Folder const folder;
  auto const lines = folder / "lines.json", out = folder / "pvs.json";
  std::string const pvs = "pvs gen:city,n=100 --cell=-30,-30,0,30,30,10 -o " + out + " --method ";
  auto const run = visibility_command(folder, pvs + "exact-2.5d --explain " + lines);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  std::ifstream in(lines);
  std::string const text{std::istreambuf_iterator<char>(in), {}};
  for (auto const* const key : {"visibility-lines/1", "edges", "exact_parts", "funnels", "shadow_planes"})
    REQUIRE(text.find(key) != std::string::npos);
  auto const result = read_results(out).front();
  for (auto const& name : result.visible) REQUIRE(text.find("\"object\":\"" + name + "\"") != std::string::npos);
  REQUIRE(visibility_command(folder, pvs + "strong-occlusion --explain " + lines).exit_code == 2);
  REQUIRE(visibility_command(folder, pvs + "exact-2.5d --arithmetic double --explain " + lines).exit_code == 2);
  REQUIRE(visibility_command(folder, pvs + "exact-2.5d --occludees gen:city,n=10 --explain " + lines).exit_code == 2);
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
    auto const set = pvs(method + " --resolution 128 --plane-distances 200,400,800 --no-improved");
    REQUIRE(set.method == method);
    REQUIRE(set.guarantee == Guarantee::conservative);
    REQUIRE(set.options.at("resolution") == "128");
    REQUIRE(set.options.at("improved") == "off");
    REQUIRE(set.options.at("plane-distances").starts_with("200"));
    REQUIRE(std::ranges::includes(set.visible, exact.visible));
    REQUIRE(set.visible.size() < set.objects);
    REQUIRE(visibility_command(folder, "check gen:city,n=500 " + (folder / "pvs.json") + " --rays 100000").exit_code ==
            0);
  }
}

TEST_CASE("command line: --grounded is recorded, and check asks for it", "[commands]")
{
  Folder const folder;
  // A shelf in the air hides what stands behind its foot only if it is solid down to the ground.
  auto const scene =
    folder.write("shelf.obj", "v 10 -50 1\nv 11 -50 1\nv 11 50 1\nv 10 50 1\no shelf\nf 1 2 3\nf 1 3 4\n"
                              "v 20 -1 0\nv 20 1 0\nv 20 0 0.5\no post\nf 5 6 7\n");
  auto const pvs = folder / "pvs.json";
  std::string const common = "pvs " + scene + " --cell=0,-1,0,1,1,0.9 ";
  auto const open = visibility_command(folder, common), closed = visibility_command(folder, common + "--grounded");
  REQUIRE((open.exit_code == 0 && closed.exit_code == 0));
  auto const above = results_from_json(open.out, "a").front(), solid = results_from_json(closed.out, "b").front();
  REQUIRE(above.visible == std::vector<std::string>{"post", "shelf"});
  REQUIRE(solid.visible == std::vector<std::string>{"shelf"});
  REQUIRE_FALSE(above.grounded);
  REQUIRE(solid.grounded);
  REQUIRE(solid.source == above.source);

  REQUIRE(visibility_command(folder, common + "--grounded -o " + pvs).out.find("grounded") != std::string::npos);
  auto const refused = visibility_command(folder, "check " + scene + " " + pvs + " --rays 10000");
  REQUIRE(refused.exit_code == 2);
  REQUIRE(refused.err.find("--grounded") != std::string::npos);
  REQUIRE(visibility_command(folder, "check " + scene + " " + pvs + " --grounded --rays 10000").exit_code == 0);
  auto const info = visibility_command(folder, "info " + scene + " --grounded");
  REQUIRE(info.exit_code == 0);
  REQUIRE(info.out.find("solid down to height 0") != std::string::npos);
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
