#include "support.hpp"

using namespace visibility;

// Hidden: run with `test_generators "[large]"`, and with `/usr/bin/time -v` before it for the memory.
TEST_CASE("large: the scenes of the papers at their size", "[.][large]")
{
  struct Case {
    char const* kind;
    std::size_t primitives;  // as the paper says
  };
  auto const c = GENERATE(values<Case>({{"city", 3324},
                                        {"spheres", 26'999},
                                        {"slanted", 42'801},
                                        {"urban", 26'800'000},
                                        {"box-field", 20'700'000},
                                        {"forest", 7'750'000},
                                        {"district", 1'800'000}}));
  auto const kind = std::ranges::find(generator_kinds(), c.kind, &GeneratorKind::name);
  CAPTURE(kind->published);
  auto const scene = generate(kind->published);
  auto const made = static_cast<double>(scene.primitive_count()), wanted = static_cast<double>(c.primitives);
  REQUIRE(std::abs(made - wanted) <= 0.02 * wanted);
  scene.validate();
}

TEST_CASE("large: a city of a million boxes", "[.][large]")
{
  auto const scene = generate("city,n=751000");
  REQUIRE(scene.boxes.size() >= 1'000'000);
  scene.validate();
}
