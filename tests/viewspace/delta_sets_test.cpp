#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/scene/scene_builder.hpp"
#include "visibility/viewspace/neighbours.hpp"
#include "visibility/viewspace/sets_file.hpp"

#include <algorithm>
#include <numeric>

using namespace visibility;
using test::Random;

namespace {

constexpr std::uint32_t object_count = 300;

/// Cells here and there: in rows, touching, apart, doubled, and a polytope.
std::vector<ViewCell> cells(Random& random, int n)
{
  std::vector<ViewCell> out;
  for (int i = 0; i < n; ++i) {
    Point3d const p = random.grid_point(0, random.below(3) == 0 ? 100 : 6);
    if (random.below(5) == 0)
      out.push_back(
        ViewCell::hull(std::vector<Point3d>{p, {p.x + 1, p.y, p.z}, {p.x, p.y + 1, p.z}, {p.x, p.y, p.z + 1}}));
    else
      out.emplace_back(Box{p, {p.x + 1, p.y + random.between(1, 2), p.z + 1}});
  }
  return out;
}

std::vector<DeltaSets::Objects> sets(Random& random, std::size_t n)
{
  std::vector<DeltaSets::Objects> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0 && random.below(4) > 0) out[i] = out[random.below(static_cast<int>(i))];  // like another one
    for (int k = random.below(20); k > 0; --k) {
      auto const o = static_cast<std::uint32_t>(random.below(object_count));
      auto const at = std::ranges::lower_bound(out[i], o);
      if (at != out[i].end() && *at == o)
        out[i].erase(at);
      else
        out[i].insert(at, o);
    }
  }
  return out;
}

StoredSets example(Random& random, int n)
{
  auto c = cells(random, n);
  auto const s = sets(random, c.size());
  StoredSets out{{}, {}, {}, {}, DeltaSets(std::move(c), s, object_count)};
  out.about.source = "gen:city";
  out.about.moving = "streets.json";
  out.about.method = "exact-2.5d";
  out.about.guarantee = Guarantee::exact;
  out.about.statistics = {{"cells", double(n)}};
  out.about.objects = object_count;
  for (std::uint32_t i = 0; i < object_count; ++i) {
    out.names.push_back("object \xC3\xBC " + std::to_string(i));
    out.polygons.push_back(std::uint64_t{1} << random.below(50));
  }
  for (int i = 0; i < n; ++i) out.initial.push_back(static_cast<std::uint32_t>(i / 2));
  return out;
}

/// The message if the bytes are refused; empty if they are read.
std::string fault(std::string const& bytes)
{
  try {
    auto const stored = stored_sets_from_bytes(bytes, "sets.vis");
    for (std::size_t i = 0; i < stored.sets.size(); ++i) (void)to_json({stored.result(i)});
  } catch (BadInput const& e) {
    return e.what();
  }
  return {};
}

/// The bytes with a right checksum at their end, in place of the last four: the check value of CRC-32, bit by bit.
std::string sealed(std::string bytes)
{
  if (bytes.size() < 4) return bytes;
  bytes.resize(bytes.size() - 4);
  std::uint32_t crc = 0xffffffff;
  for (char const c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
  }
  crc = ~crc;
  for (int i = 0; i < 32; i += 8) bytes += static_cast<char>(crc >> i & 0xff);
  return bytes;
}

}  // namespace

TEST_CASE("delta sets: every set is recovered, for any sets and neighbourhoods", "[viewspace][law]")
{
  test::property("set and all give what was stored", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    int const n = random.between(1, 60);
    auto c = cells(random, n);
    auto const s = sets(random, c.size());
    DeltaSets const delta(c, s, object_count);
    RC_ASSERT(delta.key_count() >= 1U);
    RC_ASSERT(delta.all() == s);
    for (std::size_t i = 0; i < s.size(); ++i) RC_ASSERT(delta.set(i) == s[i]);
    auto const sizes = stored_sizes(delta);
    // A key has one byte for its origin more than a whole set; another one up to two bytes here.
    RC_ASSERT(sizes.differences <= sizes.whole + 2 * s.size());
  });
}

TEST_CASE("delta sets: the forest is no larger than any of random ones", "[viewspace][law]")
{
  Random random(7);
  for (int trial = 0; trial < 30; ++trial) {
    auto c = cells(random, 25);
    auto const s = sets(random, c.size());
    auto const bytes = [&](auto const& entries) {
      std::size_t sum = 0;
      for (auto const& e : entries) sum += encoded_size(e.changed);
      return sum;
    };
    DeltaSets const best(c, s, object_count);
    auto const pairs = neighbours(c);
    for (int k = 0; k < 30; ++k) {
      // Each cell from a neighbour before it, or whole.
      std::vector<DeltaSets::Entry> entries;
      for (std::uint32_t i = 0; i < c.size(); ++i) {
        DeltaSets::Entry e{DeltaSets::Entry::key, s[i]};
        for (auto const& [a, b] : pairs)
          if (b == i && random.below(2) == 0) {
            e = {a, {}};
            std::ranges::set_symmetric_difference(s[a], s[i], std::back_inserter(e.changed));
          }
        entries.push_back(e);
      }
      DeltaSets const other(c, entries, object_count);
      REQUIRE(other.all() == s);
      REQUIRE(bytes(best.entries()) <= bytes(other.entries()));
    }
  }
}

TEST_CASE("delta sets: cells that touch are neighbours, and nobody is without one", "[viewspace]")
{
  auto const box = [](double x) { return ViewCell(Box{{x, 0, 0}, {x + 1, 1, 1}}); };
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  REQUIRE(neighbours(std::vector{box(0), box(1), box(2)}) == Pairs{{0, 1}, {1, 2}});
  REQUIRE(neighbours(std::vector{box(0), box(50)}) == Pairs{{0, 1}});
  REQUIRE(neighbours(std::vector{box(0)}).empty());
}

TEST_CASE("delta sets: the cell at a point", "[viewspace]")
{
  auto const box = [](double x) { return ViewCell(Box{{x, 0, 0}, {x + 1, 1, 1}}); };
  auto const corner = ViewCell::hull(std::vector<Point3d>{{4, 0, 0}, {5, 0, 0}, {4, 1, 0}, {4, 0, 1}});
  std::vector<DeltaSets::Objects> const none(4);
  DeltaSets const delta({box(0), box(1), box(1), corner}, none, 1);
  REQUIRE(delta.cell_at({0.5, 0.5, 0.5}) == 0U);
  REQUIRE(delta.cell_at({1, 1, 1}) == 0U);
  REQUIRE(delta.cell_at({1.5, 0.5, 0.5}) == 1U);
  REQUIRE(delta.cell_at({4.1, 0.1, 0.1}) == 3U);
  REQUIRE(delta.cell_at({4.25, 0.25, 0.5}) == 3U);
  REQUIRE_FALSE(delta.cell_at({4.25, 0.25, std::nextafter(0.5, 1.0)}));
  REQUIRE_FALSE(delta.cell_at({3, 0, 0}));
}

TEST_CASE("delta sets: refuses what is no forest of sets", "[viewspace][degenerate]")
{
  using Entry = DeltaSets::Entry;
  std::vector<ViewCell> const two{ViewCell(Box{{0, 0, 0}, {1, 1, 1}}), ViewCell(Box{{1, 0, 0}, {2, 1, 1}})};
  auto const make = [&](std::vector<Entry> entries) { return DeltaSets(two, std::move(entries), 3); };
  REQUIRE_NOTHROW(make({{Entry::key, {0, 2}}, {0, {1}}}));
  REQUIRE_THROWS_AS(make({{Entry::key, {0, 2}}}), std::invalid_argument);
  REQUIRE_THROWS_AS(make({{1, {}}, {0, {1}}}), std::invalid_argument);
  REQUIRE_THROWS_AS(make({{Entry::key, {}}, {1, {1}}}), std::invalid_argument);
  REQUIRE_THROWS_AS(make({{Entry::key, {}}, {2, {1}}}), std::invalid_argument);
  REQUIRE_THROWS_AS(make({{Entry::key, {0, 3}}, {0, {1}}}), std::invalid_argument);
  REQUIRE_THROWS_AS(make({{Entry::key, {1, 1}}, {0, {1}}}), std::invalid_argument);
  std::vector<DeltaSets::Objects> const unordered{{2, 1}, {}};
  REQUIRE_THROWS_AS(DeltaSets(two, unordered, 3), std::invalid_argument);
}

TEST_CASE("sets file: what is written is read back, exactly", "[viewspace][results]")
{
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    auto const stored = example(random, random.between(1, 40));
    auto const bytes = to_bytes(stored);
    auto const back = stored_sets_from_bytes(bytes, "x");
    REQUIRE(back.names == stored.names);
    REQUIRE(back.polygons == stored.polygons);
    REQUIRE(back.initial == stored.initial);
    REQUIRE(back.about.method == "exact-2.5d");
    REQUIRE(back.about.moving == "streets.json");
    REQUIRE(back.about.guarantee == Guarantee::exact);
    REQUIRE(std::ranges::equal(back.sets.entries(), stored.sets.entries()));
    for (std::size_t i = 0; i < stored.sets.size(); ++i) {
      REQUIRE(back.sets.cells()[i].bounds() == stored.sets.cells()[i].bounds());
      REQUIRE(back.sets.cells()[i].vertices().size() == stored.sets.cells()[i].vertices().size());
    }
    REQUIRE(to_bytes(back) == bytes);
    auto const result = back.result(0);
    REQUIRE(results_from_json(to_json({result}), "y").front().visible == result.visible);
    REQUIRE(result.visible.size() == stored.sets.set(0).size());
    REQUIRE(sealed(bytes) == bytes);
  }
}

TEST_CASE("sets file: truncated and damaged files are refused in one line", "[viewspace][fuzz]")
{
  Random random(4);
  auto const bytes = to_bytes(example(random, 6));
  REQUIRE(fault(bytes).empty());
  auto const is_refused = [](std::string const& what) {
    return what.find("sets.vis") != std::string::npos && what.find('\n') == std::string::npos;
  };
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 50) REQUIRE(is_refused(fault(bytes.substr(0, n))));
  for (int trial = 0; trial < 2000; ++trial) {
    auto damaged = bytes;
    auto const at = static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())));
    damaged[at] = static_cast<char>(damaged[at] ^ 1 << random.below(8));
    REQUIRE(is_refused(fault(damaged)));
  }
}

TEST_CASE("sets file: no bytes under a right checksum do harm", "[viewspace][fuzz]")
{
  Random random(5);
  auto const bytes = to_bytes(example(random, 6)), other = to_bytes(example(random, 3));
  std::size_t refused = 0, read = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    auto damaged = bytes;
    for (int k = random.between(1, 3); k > 0; --k) {
      // Half of them where the numbers are: behind header and names.
      auto const size = static_cast<int>(damaged.size());
      auto const at =
        static_cast<std::size_t>(random.below(2) == 0 ? random.below(size) : size - 1 - random.below(size / 6));
      switch (random.below(4)) {
      case 0: damaged[at] = static_cast<char>(random.bits()); break;
      case 1: damaged[at] = static_cast<char>(0xff); break;
      case 2: damaged.resize(at + 1); break;
      default:
        damaged =
          damaged.substr(0, at) + other.substr(static_cast<std::size_t>(random.below(static_cast<int>(other.size()))));
        break;
      }
    }
    auto const what = fault(sealed(damaged));  // any exception but BadInput ends the test
    REQUIRE(what.find('\n') == std::string::npos);
    ++(what.empty() ? read : refused);
  }
  REQUIRE(refused > 1000);
  REQUIRE(read > 50);  // such as other polygon counts
}
