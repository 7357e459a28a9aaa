/// Signs of predicates, per arithmetic and per layer.
///
/// Families, 512 queries each, seed 1 (tests/support/recipes.hpp):
///   random        coordinates uniform in [-1000, 1000): the filter decides all
///   axis-aligned  small integers and equal heights: zeros that need no arithmetic
///   nearly        on one plane (orient2d: line; balls: sphere, tangent) up to a unit in the last place
///   zero          exactly degenerate, products round, not axis-aligned: the exact layer decides
/// `per_query` is the time of one sign; `filter`, `interval` and `exact` are the shares of the layers of `Filtered`.
/// JSON: --benchmark_format=json --benchmark_repetitions=5.
#include "harness.hpp"
#include "support/recipes.hpp"
#include "visibility/predicates/in_ball.hpp"
#include "visibility/predicates/line_ball.hpp"
#include "visibility/predicates/line_side.hpp"
#include "visibility/predicates/orient2d.hpp"

using namespace visibility;
using namespace visibility::bench;
using test::PointSource;
using test::Recipe;

namespace {

constexpr int count = 512;
constexpr std::uint64_t seed = 1;

struct Query {
  Point3d a, b, c, d;
  double radius = 0;
};

std::vector<Query> from_recipe(Recipe recipe)
{
  PointSource source(recipe, seed);
  std::vector<Query> queries;
  for (int i = 0; i < count; ++i) {
    auto const [a, b, c, d] = source.tuple<4>();
    queries.push_back({a, b, c, d, std::fabs(d.x)});
  }
  return queries;
}

/// Points on a sphere and lines tangent to it: c + k (2, 3, 6), |(2, 3, 6)| = 7; `nearly`: the radius one ulp off.
std::vector<Query> tangent(bool nearly)
{
  test::Random random(seed);
  std::vector<Query> queries;
  for (int i = 0; i < count; ++i) {
    double const k = double(1 + (random.bits() >> 36)), m = 1000.0 * random.between(-99, 99),
                 n = 1000.0 * random.between(1, 99);
    Point3d const c{double(random.below(1 << 20)), double(random.below(1 << 20)), double(random.below(1 << 20))};
    Point3d const on{c.x + 2 * k, c.y + 3 * k, c.z + 6 * k};
    Point3d const p{on.x - 3 * m - 3 * n, on.y + 2 * m, on.z + n}, q{on.x + 3 * m + 3 * n, on.y - 2 * m, on.z - n};
    queries.push_back({p, q, c, on, nearly ? std::nextafter(7 * k, HUGE_VAL) : 7 * k});
  }
  return queries;
}

template <class Ask>
void add_families(std::string const& subject, Recipe nearly, Recipe zero, Ask const& ask)
{
  add_all(subject, "random", from_recipe(Recipe::uniform), ask);
  add_all(subject, "axis-aligned", from_recipe(Recipe::grid), ask);
  add_all(subject, "nearly", from_recipe(nearly), ask);
  add_all(subject, "zero", from_recipe(zero), ask);
}

template <class Ask>
void add_ball_families(std::string const& subject, Ask const& ask)
{
  add_all(subject, "random", from_recipe(Recipe::uniform), ask);
  add_all(subject, "axis-aligned", from_recipe(Recipe::grid), ask);
  add_all(subject, "nearly", tangent(true), ask);
  add_all(subject, "zero", tangent(false), ask);
}

}  // namespace

int main(int argc, char** argv)
{
  add_families("orient2d", Recipe::nextafter, Recipe::collinear,
               []<class A>(Query const& q) { return orient2d<A>(horizontal(q.a), horizontal(q.b), horizontal(q.c)); });
  add_families("orient3d", Recipe::rounded, Recipe::coplanar,
               []<class A>(Query const& q) { return orient3d<A>(q.a, q.b, q.c, q.d); });
  add_families("line_side", Recipe::rounded, Recipe::coplanar,
               []<class A>(Query const& q) { return line_side<A>(q.a, q.b, q.c, q.d); });
  add_ball_families("in_ball", []<class A>(Query const& q) { return in_ball<A>(q.d, q.c, q.radius); });
  add_ball_families("line_ball", []<class A>(Query const& q) { return line_ball<A>(q.a, q.b, q.c, q.radius); });
  return run(argc, argv);
}
