#pragma once

#include "support/height_field_lines.hpp"

#include <optional>
#include <span>
#include <vector>

namespace visibility::oracle::detail {

/// Looks for a line along which one column is visible: depth first over cones of lines, each divided by events until
/// the column is proved hidden on it or the order of the slice is the same for all its lines.
class Search {
public:
  struct Result {
    std::optional<Witness> witness;
    bool decided = true;
  };

  Search(std::span<Column const> columns, Cell const& cell, Plan const& plan, Posts& posts)
    : columns_(columns), cell_(cell), plan_(plan), posts_(posts)
  {
  }
  Result operator()(int target);

  std::uint64_t cones = 0, leaves = 0;  ///< looked at so far

private:
  /// What is known of a polygon for all lines of a cone.
  struct Known {
    enum { mixed, fixed, irrelevant } state = mixed;
    Passage passage{};  ///< if fixed
  };
  using Events = std::vector<Event const*>;

  Known classify(int polygon, std::span<Vector const> rays) const;
  bool visit(Cone const& cone, std::vector<Known> known, Events const& pending);
  void drop_columns(std::span<Vector const> rays, std::vector<Known>& known) const;
  bool hidden(std::span<Vector const> rays, std::vector<Known> const& known);
  bool blocked(std::span<Vector const> rays, std::vector<Known> const& known, Post const& source, Post const& end);
  bool try_line(Vector const& line);
  bool leaf(Cone const& cone, Polygons alive);
  std::vector<Form const*> forms(Candidate const& candidate);
  bool accept(Vector const& line, Candidate const* candidate, Polygons alive);
  bool try_some_lines();
  Polygons all() const { return (polygon_bit(plan_.columns) << 1) - 1; }

  std::span<Column const> columns_;
  Cell const& cell_;
  Plan const& plan_;
  Posts& posts_;
  int target_ = 0;
  Result result_;
};

}  // namespace visibility::oracle::detail
