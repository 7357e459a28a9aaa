// The extreme rays of cones of portal sequences are those of cddlib (Fukuda's double description in GMP rationals).
#include "portal_families.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"
#include "visibility/line_space/portal_half_spaces.hpp"

#include <gmp.h>

#define GMPRATIONAL
extern "C" {
#include <setoper.h>

#include <cdd.h>
}

#include <algorithm>
#include <set>

using namespace visibility;
using namespace visibility::test;

namespace {

using Line = PluckerLine<RationalNumber>;
using Lines = std::vector<Line>;

struct Generators {
  std::size_t lineality = 0;
  Lines rays;
};

Generators by_cddlib(Lines const& half_spaces)
{
  [[maybe_unused]] static bool const ready = (dd_set_global_constants(), true);
  auto const rows = static_cast<dd_rowrange>(half_spaces.size());
  dd_MatrixPtr const matrix = dd_CreateMatrix(rows, 7);
  matrix->representation = dd_Inequality;
  matrix->numbtype = dd_Rational;
  for (std::size_t i = 0; i < half_spaces.size(); ++i)
    for (std::size_t j = 0; j < 6; ++j)  // b(l, h): the direction of l meets the moment of h
      mpq_set(matrix->matrix[i][j + 1], half_spaces[i][(j + 3) % 6].mpq());
  dd_ErrorType error = dd_NoError;
  dd_PolyhedraPtr const polyhedron = dd_DDMatrix2Poly(matrix, &error);
  REQUIRE(error == dd_NoError);
  dd_MatrixPtr const found = dd_CopyGenerators(polyhedron);
  Generators generators;
  for (dd_rowrange i = 0; i < found->rowsize; ++i) {
    if (mpq_sgn(found->matrix[i][0]) != 0) continue;  // the apex
    Line l;
    for (std::size_t j = 0; j < 6; ++j) l[j] = RationalNumber(found->matrix[i][j + 1]);
    if (set_member(i + 1, found->linset)) {
      ++generators.lineality;
    } else {
      generators.rays.push_back(primitive(l));
    }
  }
  dd_FreeMatrix(found);
  dd_FreePolyhedra(polyhedron);
  dd_FreeMatrix(matrix);
  return generators;
}

template <class NT>
Generators by_cone(std::vector<PluckerLine<NT>> const& half_spaces)
{
  PluckerCone<NT> const cone{std::span<PluckerLine<NT> const>(half_spaces)};
  Generators generators{cone.lineality().size(), {}};
  for (auto const& r : cone.rays()) generators.rays.push_back(primitive(rational(r.line)));
  return generators;
}

/// Rays by their coordinates, or, where there is a lineality space, by what they touch.
std::set<std::vector<RationalNumber>> names(Generators const& g, Lines const& half_spaces)
{
  std::set<std::vector<RationalNumber>> result;
  for (Line const& r : g.rays) {
    std::vector<RationalNumber> row;
    if (g.lineality == 0)
      for (std::size_t i = 0; i < 6; ++i) row.push_back(r[i]);
    else
      for (Line const& h : half_spaces) row.emplace_back(plucker_product(r, h) == 0 ? 1 : 0);
    result.insert(row);
  }
  return result;
}

}  // namespace

TEST_CASE("PluckerCone: its rays are those of cddlib on ten thousand portal sequences", "[line_space][oracle]")
{
  int sequences = 0, with_lines = 0, without_interior = 0;
  for (PortalFamily const family : all_portal_families) {
    PortalSource source(family, 111);
    for (int i = 0; i < trials(2500); ++i) {
      CAPTURE(name(family), i);
      auto const s = source.sequence(source.random().below(3) == 0 ? 2 : 1);
      auto const frame = integer_frame(s);
      auto const exact = portal_half_spaces<ExactNumber>(s, frame);
      auto const half_spaces = portal_half_spaces<RationalNumber>(s, frame);
      auto const ours = by_cone(exact), theirs = by_cddlib(half_spaces);
      REQUIRE(ours.lineality == theirs.lineality);
      REQUIRE(ours.rays.size() == theirs.rays.size());
      REQUIRE(names(ours, half_spaces) == names(theirs, half_spaces));
      ++sequences;
      with_lines += ours.lineality > 0;
      without_interior += !cone_with_interior(std::span<PluckerLine<ExactNumber> const>(exact));
    }
  }
  CHECK(sequences == 4 * trials(2500));
  CHECK(with_lines > 0);
  CHECK(without_interior > 0);
}
