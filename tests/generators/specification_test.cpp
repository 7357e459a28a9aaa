#include "support/catch.hpp"

#include "visibility/scene/generators.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <set>

using namespace visibility;

namespace {

/// The message of the BadInput that the specification gives; empty if it gives a scene.
std::string complaint(std::string const& specification)
{
  try {
    generate(specification);
    return {};
  } catch (BadInput const& e) {
    return e.what();
  }
}

}  // namespace

TEST_CASE("specification: what cannot be made is refused in one line that says what is valid", "[generators]")
{
  struct Case {
    std::string specification, says;
  };
  auto const c = GENERATE(values<Case>({
    {"", "unknown generator ''; generators: city, spheres"},
    {"cty", "unknown generator 'cty'; generators: city, spheres"},
    {"City", "unknown generator"},
    {"gen:city", "unknown generator"},
    {"city,", "'' is not key=value; keys: seed, n, triples"},
    {"city,,n=9", "'' is not key=value"},
    {"city,n", "'n' is not key=value"},
    {"city,=9", "'=9' is not key=value"},
    {"city,m=9", "'m' is not a key; keys: seed, n, triples"},
    {"city, n=9", "' n' is not a key"},
    {"city,n=9,n=9", "'n' is given twice"},
    {"city,n=", "n= is not valid; it takes an integer from 5 to 1e+07"},
    {"city,n=4", "n=4 is not valid"},
    {"city,n=9.5", "n=9.5 is not valid"},
    {"city,n=1e99", "n=1e99 is not valid"},
    {"city,n=1e999", "n=1e999 is not valid"},
    {"city,n=nan", "n=nan is not valid"},
    {"city,n=inf", "n=inf is not valid"},
    {"city,n=9x", "n=9x is not valid"},
    {"city,n=-9", "n=-9 is not valid"},
    {"city,n=9 ", "n=9  is not valid"},
    {"city,seed=-1", "seed=-1 is not valid"},
    {"city,seed=9007199254740994", "is not valid"},
    {"city,triples=1.5", "triples=1.5 is not valid; it takes a number from 0 to 1"},
    {"city,low=5,high=4", "low must not exceed high"},
    {"spheres,radius=100", "spacing must be at least twice the radius"},
    {"box-field,n=1,height=17", "height must be at least"},
    {"box-field,n=1,small=11", "small must not exceed large"},
  }));
  CAPTURE(c.specification);
  auto const message = complaint(c.specification);
  CAPTURE(message);
  REQUIRE(message.find(c.says) != std::string::npos);
  REQUIRE(message.find('\n') == std::string::npos);
}

TEST_CASE("specification: the registry is complete and consistent", "[generators]")
{
  std::set<std::string> kinds;
  for (auto const& kind : generator_kinds()) {
    CAPTURE(kind.name);
    REQUIRE(kinds.insert(kind.name).second);
    REQUIRE_FALSE(kind.help.empty());
    REQUIRE(kind.published.starts_with(kind.name));
    std::set<std::string> keys;
    for (auto const& p : kind.parameters) {
      CAPTURE(p.name);
      REQUIRE(keys.insert(p.name).second);
      REQUIRE_FALSE(p.help.empty());
      REQUIRE(p.min <= p.value);
      REQUIRE(p.value <= p.max);
      if (p.type == GeneratorParameter::Type::integer) {
        REQUIRE(p.value == static_cast<double>(static_cast<std::int64_t>(p.value)));
        REQUIRE(p.min >= 0);
      }
    }
    REQUIRE(keys.contains("seed"));
  }
}

TEST_CASE("specification: the source of a scene is its specification", "[generators]")
{
  REQUIRE(generate("city,n=9,seed=3").source == "gen:city,n=9,seed=3");
}
