#include "portal_families.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"
#include "visibility/line_space/portal_half_spaces.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

struct Mistakes {
  int sequences = 0, visible = 0;
  int hidden_though_visible = 0, visible_though_hidden = 0;
};

/// The same code in plain double, in the same small coordinates.
Mistakes mistakes(PortalFamily family, std::uint64_t seed, int n)
{
  PortalSource source(family, seed);
  Mistakes m;
  for (int i = 0; i < n; ++i) {
    auto const s = source.sequence(source.random().between(1, 4));
    bool const truth = has_sight_line(s), guess = has_sight_line<double>(s);
    ++m.sequences;
    m.visible += truth;
    m.hidden_though_visible += truth && !guess;
    m.visible_though_hidden += guess && !truth;
  }
  return m;
}

}  // namespace

TEST_CASE("has_sight_line: plain double is wrong where edges are nearly aligned", "[line_space][layer]")
{
  for (PortalFamily const family : all_portal_families) {
    auto const m = mistakes(family, 101, trials(1000));
    INFO(name(family) << ": of " << m.sequences << " sequences, " << m.visible << " visible, double hides "
                      << m.hidden_though_visible << " visible ones and shows " << m.visible_though_hidden
                      << " hidden ones");
    CHECK(m.sequences > 0);  // shows the counts with -s
    if (family == PortalFamily::nearly_aligned) CHECK(m.hidden_though_visible + m.visible_though_hidden > 0);
  }
}
