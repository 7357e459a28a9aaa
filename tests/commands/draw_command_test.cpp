#include "command.hpp"
#include "support/catch.hpp"
#include "support/xml.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

std::string bytes(std::string const& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A number of four bytes of a PNG.
unsigned number_at(std::string const& png, std::size_t at)
{
  unsigned out = 0;
  for (std::size_t i = at; i < at + 4; ++i) out = out << 8U | static_cast<unsigned char>(png.at(i));
  return out;
}

bool has_png(Run const& run) { return run.err.find("without cairo") == std::string::npos; }

std::string const city = "gen:city,n=100";
std::string const common = " --cell=-30,-30,0,30,30,10 --method ";

}  // namespace

TEST_CASE("command line: draw shows what a set holds, as SVG and PNG", "[commands]")
{
  Folder const folder;
  auto const pvs = folder / "pvs.json", loose = folder / "loose.json", lines = folder / "lines.json";
  auto const svg = folder / "a.svg", png = folder / "a.png";
  REQUIRE(
    visibility_command(folder, "pvs " + city + common + "exact-2.5d --witnesses --explain " + lines + " -o " + pvs)
      .exit_code == 0);
  REQUIRE(visibility_command(folder, "pvs " + city + common + "strong-occlusion -o " + loose).exit_code == 0);
  auto const set = read_results(pvs).front(), larger = read_results(loose).front();

  auto const draw =
    "draw " + city + ' ' + pvs + " --sight-lines 9 --explanation " + lines + " --funnels 2 --shadows 3 -o ";
  auto run = visibility_command(folder, draw + svg);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  REQUIRE((run.err.empty() && is_one_line(run.out)));
  auto const document = parse_xml(bytes(svg));
  REQUIRE(document.fault.empty());
  std::vector<std::string> drawn;
  for (auto const* group : {"visible", "touching"})
    for (auto const& title : elements_in(document, group, "title")) drawn.push_back(title.text);
  std::ranges::sort(drawn);
  REQUIRE(drawn == set.visible);
  REQUIRE(elements_in(document, "sight-lines", "path").size() == 2);
  REQUIRE(!elements_in(document, "edges", "path").empty());
  REQUIRE(!elements_in(document, "funnels", "path").empty());
  REQUIRE(elements_in(document, "shadows", "path").size() == 6);
  auto const first = bytes(svg);
  REQUIRE(visibility_command(folder, draw + svg).exit_code == 0);
  REQUIRE(bytes(svg) == first);

  REQUIRE(visibility_command(folder, "draw " + city + ' ' + loose + " --compare " + pvs + " -o " + svg).exit_code == 0);
  auto const compared = parse_xml(bytes(svg));
  REQUIRE(elements_in(compared, "only-first", "title").size() == larger.visible.size() - set.visible.size());

  run = visibility_command(folder, draw + png + " --size 640");
  if (has_png(run)) {
    REQUIRE(run.exit_code == 0);
    auto const image = bytes(png);
    REQUIRE(image.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    REQUIRE(number_at(image, 16) == 640);
    REQUIRE(number_at(image, 20) > 400);
    REQUIRE(visibility_command(folder, draw + png + " --size 640").exit_code == 0);
    REQUIRE(bytes(png) == image);
  } else {
    REQUIRE((run.exit_code == 2 && is_one_line(run.err)));
  }
}

TEST_CASE("command line: draw takes one result of several, and occludees apart from occluders", "[commands]")
{
  Folder const folder;
  auto const pvs = folder / "pvs.json", svg = folder / "a.svg";
  REQUIRE(
    visibility_command(folder, "pvs " + city + " --cell 0,0,0,1,1,1 --cell=-30,-30,0,30,30,50 -o " + pvs).exit_code ==
    0);
  auto const results = read_results(pvs);
  REQUIRE(results[0].visible.size() < results[1].visible.size());
  for (std::size_t k : {1, 2}) {
    REQUIRE(visibility_command(folder, "draw " + city + ' ' + pvs + " --index " + std::to_string(k) + " -o " + svg)
              .exit_code == 0);
    auto const document = parse_xml(bytes(svg));
    REQUIRE(elements_in(document, "visible", "title").size() + elements_in(document, "touching", "title").size() ==
            results[k - 1].visible.size());
  }
  auto const targets = folder.write("targets.json", R"({"format": "visibility-scene/1", "objects": [
    {"name": "near", "boxes": [5,0,0,6,1,3]}]})");
  REQUIRE(visibility_command(folder, "pvs " + city + " --cell=-1,-1,0,1,1,2 --method exact-2.5d --occludees " +
                                       targets + " -o " + pvs)
            .exit_code == 0);
  REQUIRE(
    visibility_command(folder, "draw " + city + ' ' + pvs + " --sight-lines 3 --region=-500,-500,500,500 -o " + svg)
      .exit_code == 0);
  auto const document = parse_xml(bytes(svg));
  REQUIRE(elements_in(document, "visible", "title").size() == 1);
  REQUIRE(!elements_in(document, "occluders", "title").empty());
  REQUIRE(elements_in(document, "sight-lines", "path").size() == 2);
}

TEST_CASE("command line: draw refuses bad input in one line and leaves no file", "[commands]")
{
  Folder const folder;
  auto const pvs = folder / "pvs.json", lines = folder / "lines.json", other = folder / "other.json";
  REQUIRE(
    visibility_command(folder, "pvs " + city + common + "exact-2.5d --explain " + lines + " -o " + pvs).exit_code == 0);
  REQUIRE(visibility_command(folder, "pvs " + city + " --cell 0,0,0,1,1,1 -o " + other).exit_code == 0);
  auto const no_cell = folder.write("no_cell.json", R"({"format": "visibility-pvs/1", "visible": []})");
  auto const half = folder.write("half.json", bytes(lines).substr(0, 100));
  auto const strange = folder.write("strange.json", R"({"format": "visibility-lines/1", "cell": {"vertices": []},
    "edges": [{"object": "nobody", "left": [0,0,0], "right": [1,0,0], "parts": []}], "funnels": [], "shadow_planes": []})");
  auto const files = folder.files();
  auto const refused = [&](std::string const& arguments, std::string const& output) {
    auto const run = visibility_command(folder, "draw " + arguments + " -o " + (folder / output));
    CAPTURE(arguments, run.err, run.exit_code);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK(run.out.empty());
    CHECK(folder.files() == files);
    return run.err;
  };
  auto const good = city + ' ' + pvs;
  refused(good, "a.pdf");
  refused(good, "a");
  refused(good, "no/such/folder.svg");
  REQUIRE(refused("gen:city,n=50 " + pvs, "a.svg").find("gen:city,n=50") != std::string::npos);  // another scene
  refused(city + ' ' + no_cell, "a.svg");
  refused(good + " --index 2", "a.svg");
  refused(good + " --index 0", "a.svg");
  refused(good + " --compare " + other, "a.svg");
  refused(good + " --region 0,0,1", "a.svg");
  refused(good + " --region 1,0,0,1", "a.svg");
  refused(good + " --region 0,0,nan,1", "a.svg");
  refused(good + " --region=-1e308,0,1e308,1", "a.svg");
  refused(good + " --size 10", "a.svg");
  refused(good + " --labels many", "a.svg");
  refused(good + " --funnels 3", "a.svg");
  refused(good + " --explanation " + half, "a.svg");
  REQUIRE(refused(good + " --explanation " + strange, "a.svg").find("nobody") != std::string::npos);
  refused(city + ' ' + other + " --explanation " + lines, "a.svg");
}
