#pragma once

#include "scenes.hpp"
#include "support/catch.hpp"

namespace visibility::test {

/// Whether the edge is seen at t; if it is, by a good witness.
inline bool sees(std::vector<Column> const& columns, std::size_t column, std::size_t side, oracle::Crossing crossing,
                 RationalNumber const& t, Cell const& cell = unit_cell)
{
  auto const w = oracle::sight_line_to_edge(columns, column, side, crossing, t, cell);
  if (w) CHECK((w->object == columns[column].object && oracle::confirms(columns, cell, *w)));
  oracle::Verdict const v = oracle::sees_edge_at(columns, column, side, crossing, t, cell);
  CHECK(v == (w ? oracle::Verdict::visible : oracle::Verdict::hidden));
  return w.has_value();
}

}  // namespace visibility::test
