#include "scenes.hpp"
#include "support/catch.hpp"
#include "visibility/evidence/check.hpp"
#include "visibility/evidence/witness.hpp"
#include "visibility/methods/sampling/method.hpp"

using namespace visibility;
using test::boxes;
using Ids = std::vector<std::uint32_t>;

namespace {

CheckOptions const quick{200'000, 0, 1, 1};

}  // namespace

TEST_CASE("check: any member that is removed is found again, with a proof", "[evidence][law]")
{
  auto const s = boxes(test::box_city(12, 7));
  auto const cell = test::street_cell(12);
  RayScene const rays(*s.prepared);
  auto const visible = Sampling({1'000'000, 0, 9, 0})(rays, cell).visible;
  REQUIRE(visible.size() > 30);
  int missed = 0;
  for (auto const id : visible) {
    Ids rest = visible;
    std::erase(rest, id);
    auto const report = check(rays, cell, rest, Guarantee::conservative, quick);
    bool const found = std::ranges::find(report.missing, id) != report.missing.end();
    missed += !found;
    REQUIRE(report.fault == !report.missing.empty());
    for (auto const& w : report.witnesses) REQUIRE(confirm(*s.prepared, cell, w));
  }
  CAPTURE(visible.size());
  CHECK(missed <= 1);
}

TEST_CASE("check: a set of all objects is accepted at once", "[evidence]")
{
  auto const s = boxes(test::box_city(4, 1));
  Ids all(s.scene->objects.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  auto const r = check(*s.prepared, test::street_cell(4), all, Guarantee::conservative);
  CHECK(r.missing.empty());
  CHECK(r.rays == 0);
  CHECK_FALSE(r.fault);
}

TEST_CASE("check: a complete set gives nothing to report", "[evidence]")
{
  auto const s = boxes({Box{{5, -50, -50}, {6, 50, 50}}, Box{{9, 0, 0}, {10, 1, 1}}, Box{{0, 9, 0}, {1, 10, 1}}});
  ViewCell const cell(Box{{0, 0, 0}, {1, 1, 1}});
  auto const r = check(*s.prepared, cell, Ids{0, 2}, Guarantee::exact, quick);
  CHECK(r.missing.empty());
  CHECK(r.unseen.empty());
  CHECK(r.rays == quick.rays);
  CHECK(r.objects_seen == 2);
}

TEST_CASE("check: an exact set with a hidden member is told as unseen, not as a fault", "[evidence]")
{
  auto const s = boxes({Box{{5, -50, -50}, {6, 50, 50}}, Box{{9, 0, 0}, {10, 1, 1}}, Box{{0, 9, 0}, {1, 10, 1}},
                        Box{{9, 5, 0}, {10, 6, 1}}});
  ViewCell const cell(Box{{0, 0, 0}, {1, 1, 1}});
  auto const r = check(*s.prepared, cell, Ids{0, 1, 2}, Guarantee::exact, quick);
  CHECK(r.unseen == Ids{1});
  CHECK_FALSE(r.fault);
}

TEST_CASE("check: an aggressive set may lack objects without fault; a missing object that meets the cell is reported",
          "[evidence]")
{
  auto const s = boxes({Box{{1, 0, 0}, {2, 1, 1}}, Box{{0, 9, 0}, {1, 10, 1}}});
  ViewCell const cell(Box{{0, 0, 0}, {1, 1, 1}});
  auto const r = check(*s.prepared, cell, Ids{}, Guarantee::aggressive, quick);
  CHECK(r.missing == Ids{0, 1});
  CHECK(r.witnesses.size() == 1);
  CHECK_FALSE(r.fault);
}

TEST_CASE("check: a set that names an unknown object is refused", "[evidence]")
{
  auto const s = boxes({Box{{1, 0, 0}, {2, 1, 1}}});
  CHECK_THROWS_AS(check(*s.prepared, ViewCell(Box{{0, 0, 0}, {1, 1, 1}}), Ids{5}, Guarantee::exact),
                  std::invalid_argument);
}
