#include "segment_checks.hpp"
#include "visibility/scene/segment_probe.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("SegmentProbe: never says that a segment misses a box that it meets", "[geometry][conservative]")
{
  Random random(68);
  int met = 0, culled = 0, missed = 0;
  for (double const scale : {1.0, 0.1, 0x1p-1074, 0x1p-1000, 0x1p-600, 0x1p-540, 0x1p510, 0x1p1000, 0x1p1018})
    for (int i = 0; i < trials(3000); ++i) {
      Box box;
      box.extend(scaled(even_point(random, 6), scale));
      box.extend(scaled(even_point(random, 6), scale));
      if (random.chance(0.2)) box.max.x = box.min.x;
      Point3d p = special_point(landmarks(box), random, scale), q = special_point(landmarks(box), random, scale);
      for (double* x : {&p.x, &p.y, &p.z, &q.x, &q.y, &q.z})
        if (random.chance(0.2)) *x = std::nextafter(*x, random.chance(0.5) ? HUGE_VAL : -HUGE_VAL);
      if (p == q || !is_finite(p) || !is_finite(q)) continue;
      CAPTURE(scale, i);
      bool const truth = oracle::meets(box, p, q, End::included);
      bool const certain = SegmentProbe(p, q).certainly_misses(box);
      REQUIRE_FALSE((truth && certain));
      met += truth;
      missed += !truth;
      culled += certain;
    }
  REQUIRE(met > 1000);
  // Not so cautious that it is useless.
  REQUIRE(culled > missed / 2);
}

TEST_CASE("SegmentProbe: is right one unit in the last place from a corner", "[geometry][conservative][degenerate]")
{
  Random random(69);
  int certain = 0, unsure = 0;
  for (int i = 0; i < trials(20000); ++i) {
    // a segment whose line passes a corner of the box within rounding
    double const size = std::ldexp(1 + random.unit(), random.between(-20, 20));
    Point3d const lo = random.point(-1000, 1000);
    Box const box{lo, {lo.x + size, lo.y + size * random.unit(), lo.z + size * random.unit()}};
    Point3d const corner = box.corner(random.below(8)), d = random.point(-1, 1);
    double const s = random.uniform(-100, 0), t = random.uniform(0, 100);
    Point3d const p{corner.x + s * d.x, corner.y + s * d.y, corner.z + s * d.z},
      q{corner.x + t * d.x, corner.y + t * d.y, corner.z + t * d.z};
    if (p == q) continue;
    bool const misses = SegmentProbe(p, q).certainly_misses(box);
    certain += misses;
    unsure += !misses;
    if (misses) REQUIRE_FALSE(oracle::meets(box, p, q, End::included));
  }
  REQUIRE(unsure > certain);  // the inputs are where rounding decides
}
