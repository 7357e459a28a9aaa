#include "reading.hpp"
#include "support/random.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace visibility;
using namespace visibility::test;

namespace {

std::string const hostile[] = {"nan",
                               "NaN",
                               "-inf",
                               "1e308",
                               "-1e308",
                               "1e999",
                               "1e-999",
                               "1000000000",
                               "4294967295",
                               "4294967296",
                               "9223372036854775807",
                               "18446744073709551616",
                               "-1",
                               "0.1e-400",
                               "null",
                               "[]",
                               "{}",
                               "\"\"",
                               "[[[[[[",
                               "]]]]",
                               "\xff\xfe",
                               std::string("\0\0", 2),
                               "\n",
                               "\\\n",
                               "\x1e",
                               "/",
                               "#",
                               "true",
                               "5e-324"};

bool is_value(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+'; }

std::string mutate(std::string text, std::string const& other, Random& random)
{
  for (int n = random.between(1, 4); n > 0 && !text.empty(); --n) {
    auto const at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
    switch (random.below(6)) {
    case 0: text.resize(at); break;
    case 1: text[at] = static_cast<char>(random.bits()); break;
    case 2: text[at] = static_cast<char>(text[at] ^ (1 << random.below(8))); break;
    case 3: {  // splice
      auto const from = static_cast<std::size_t>(random.below(static_cast<int>(other.size())));
      text = text.substr(0, at) + other.substr(from);
      break;
    }
    case 4: {  // copy a stretch
      auto const length = static_cast<std::size_t>(random.between(1, 60));
      text.insert(at, text.substr(static_cast<std::size_t>(random.below(static_cast<int>(text.size()))), length));
      break;
    }
    default: {  // put a hostile value in the place of a word
      auto first = at, last = at;
      while (first > 0 && is_value(text[first - 1])) --first;
      while (last < text.size() && is_value(text[last])) ++last;
      text.replace(first, last - first,
                   hostile[static_cast<std::size_t>(random.below(static_cast<int>(std::size(hostile))))]);
    }
    }
  }
  return text;
}

std::vector<std::string> seeds(std::string const& format)
{
  std::vector<std::filesystem::path> paths;
  for (auto const& entry :
       std::filesystem::directory_iterator(std::filesystem::path(VISIBILITY_FUZZ_CORPUS_DIR) / format))
    paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<std::string> out;
  for (auto const& p : paths) {
    std::ifstream in(p, std::ios::binary);
    out.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return out;
}

void fuzz(std::string const& folder, SceneFormat format, int trials)
{
  auto const corpus = seeds(folder);
  REQUIRE(!corpus.empty());
  Random random(11);
  int read = 0, refused = 0;
  for (auto const& text : corpus) {
    CAPTURE(text);
    REQUIRE_NOTHROW(read_scene_text(text, format, "input").validate());  // seeds are good files
  }
  for (int trial = 0; trial < trials; ++trial) {
    auto const pick = [&] { return corpus[static_cast<std::size_t>(random.below(static_cast<int>(corpus.size())))]; };
    auto const text = mutate(pick(), pick(), random);
    CAPTURE(folder, trial, text);
    try {
      read_scene_text(text, format, "input").validate();
      ++read;
    } catch (BadInput const& e) {
      REQUIRE(std::string(e.what()).find('\n') == std::string::npos);
      ++refused;
    } catch (std::exception const& e) {
      FAIL("threw something else than BadInput: " << e.what());
    }
  }
  REQUIRE(read > trials / 100);
  REQUIRE(refused > trials / 10);
}

}  // namespace

TEST_CASE("mutations: damaged OBJ is read or refused", "[readers][fuzz]") { fuzz("obj", SceneFormat::obj, 8000); }
TEST_CASE("mutations: damaged PLY is read or refused", "[readers][fuzz]") { fuzz("ply", SceneFormat::ply, 8000); }
TEST_CASE("mutations: damaged CityJSON is read or refused", "[readers][fuzz]")
{
  fuzz("cityjson", SceneFormat::json, 8000);
}
TEST_CASE("mutations: damaged GeoJSON is read or refused", "[readers][fuzz]")
{
  fuzz("geojson", SceneFormat::json, 8000);
}
TEST_CASE("mutations: damaged native scenes are read or refused", "[readers][fuzz]")
{
  fuzz("native", SceneFormat::json, 8000);
}
