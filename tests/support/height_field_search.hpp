#pragma once

#include "support/height_field_lines.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace visibility::oracle::detail {

/// Looks for a line along which one polygon of the plan is visible, a column or the plan's own target: depth first over
/// cones of lines, each divided by events until it is proved hidden on it or the order of the slice is the same for all
/// its lines.
class Search {
public:
  struct Result {
    std::optional<Witness> witness;
    bool decided = true;
  };

  /// Whether the sight line of a witness is free and ends on what its object number says.
  using Confirm = std::function<bool(Witness const&)>;

  Search(Plan const& plan, Posts& posts, Confirm confirm) : plan_(plan), posts_(posts), confirm_(std::move(confirm)) {}
  /// `object`: what witnesses are to name.
  Result operator()(int target, std::uint32_t object);

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
  Polygons all() const { return polygon_bit(plan_.polygon_count()) - 1; }

  Plan const& plan_;
  Posts& posts_;
  Confirm confirm_;
  int target_ = 0;
  std::uint32_t object_ = 0;
  Result result_;
};

}  // namespace visibility::oracle::detail
