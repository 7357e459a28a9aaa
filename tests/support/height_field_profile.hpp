#pragma once

#include "support/height_field_slice.hpp"

#include <map>
#include <vector>

/// What a slice is made of, in rationals.
namespace visibility::oracle::detail {

Point2q crossing(Plan const& plan, Vector const& line, int segment);
/// Of a polygon's top plane over the point.
RationalNumber height(Plan const& plan, int top, Point2q const& p);
/// The point at p + f (q - p).
inline Point2q towards(Point2q const& p, Point2q const& q, RationalNumber const& f)
{
  return {p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)};
}
inline Point2q middle(Point2q const& p, Point2q const& q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }

/// The breaks of a slice in order: equal positions share a rank.
class Slice {
public:
  struct Span {
    int polygon, first, last;  ///< ranks
    Passage passage;
  };

  Slice(Plan const& plan, Vector const& line, Polygons alive);

  std::vector<Span> const& columns() const { return columns_; }
  Span const* column(int i) const { return find(columns_, i); }
  Span const* cell() const { return find(others_, plan_.cell()); }
  Span const* target() const { return find(others_, plan_.target()); }  ///< that is no column

  Stop stop(int rank) const { return stops_[std::size_t(rank)]; }
  Point2q const& place(int rank) const { return places_[std::size_t(rank)]; }
  RationalNumber height_at(int top, Point2q const& p) const { return height(plan_, top, p); }

  /// Whether no column is higher than this polygon between the rank and the next. Requires: the polygon spans them.
  bool is_top(int polygon, int rank) const;
  /// Whether the wall at the rank, under the polygon's top, stands out above all columns just before it.
  bool stands_out(int polygon, int rank) const;

private:
  static Span const* find(std::vector<Span> const& spans, int polygon);
  void add(Stop s);

  Plan const& plan_;
  Vector line_;
  std::map<RationalNumber, std::vector<Stop>> breaks_;
  std::map<int, int> rank_;
  std::vector<Stop> stops_;
  std::vector<Point2q> places_;
  std::vector<Span> columns_, others_;
};

/// What a segment from the source's rank must pass over to reach what is just before rank `end` (the top of a wall) or
/// just behind (`behind`: columns that begin there count).
std::vector<Post> occluders_up_to(Slice const& slice, int source, int end, bool behind);

/// The same to reach the far end of a piece of a top that no other column covers; from rank `begin` on all columns are
/// at most as high as the target. `own` is the target's span.
std::vector<Post> occluders_of_top(Slice const& slice, int source, int begin, Slice::Span const& own);

/// What a line shows of a target that is no column.
View view_of_target(Plan const& plan, Slice const& slice, RationalNumber const& shrink);

}  // namespace visibility::oracle::detail
