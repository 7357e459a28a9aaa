#include "command.hpp"
#include "support/catch.hpp"

#include <array>

using namespace visibility;
using namespace visibility::test;

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
  REQUIRE(refused("gen:urban,n=50", ""));  // decks and ledges
  REQUIRE(!refused("gen:urban,n=50", " --grounded"));
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
  REQUIRE(visibility_command(folder, "check " + wall + " " + out + " --rays 20000").exit_code == 0);
  // A set that lacks what can be seen is found out.
  auto lacking = result;
  lacking.visible = {"near"};
  auto const false_set = folder.write("false.json", to_json({lacking}));
  auto const found = visibility_command(folder, "check " + wall + " " + false_set + " --rays 20000");
  REQUIRE(found.exit_code == 1);
  REQUIRE(found.out.find("over: seen from") != std::string::npos);
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

TEST_CASE("command line: --tally says which layer decided, and changes nothing else", "[commands]")
{
  Folder const folder;
  auto const plain = folder / "plain.json", tallied = folder / "tallied.json";
  for (std::string const method : {"strong-occlusion", "exact-2.5d"}) {
    CAPTURE(method);
    std::string const pvs = "pvs gen:city,n=100 --cell=-30,-30,0,30,30,10 --method " + method + " -o ";
    REQUIRE(visibility_command(folder, pvs + plain).exit_code == 0);
    REQUIRE(visibility_command(folder, pvs + tallied + " --tally").exit_code == 0);
    auto const without = read_results(plain).front();
    auto with = read_results(tallied).front();
    REQUIRE(with.visible == without.visible);
    REQUIRE(with.statistics.at("signs_filter") > 0);
    for (auto const* layer : {"signs_filter", "signs_interval", "signs_exact"})
      REQUIRE(with.statistics.erase(layer) == 1);
    REQUIRE(with.statistics == without.statistics);
    REQUIRE(visibility_command(folder, pvs + tallied + " --tally --arithmetic rational").exit_code == 2);
  }
  REQUIRE(visibility_command(folder, "pvs gen:city,n=100 --cell=-3,-3,0,3,3,1 --method ray-space --tally").exit_code ==
          2);
}
