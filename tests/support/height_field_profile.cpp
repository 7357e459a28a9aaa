#include "support/height_field_profile.hpp"

#include <algorithm>

namespace visibility::oracle::detail {
namespace {

using Q = RationalNumber;

Q rational(NT const& x) { return static_cast<Q>(x); }

}  // namespace

Point2q crossing(Plan const& plan, Vector const& line, int segment)
{
  Vector const x = cross(line, plan.segments[std::size_t(segment)].line);
  Q const w = rational(x.z);
  return {rational(x.x) / w, rational(x.y) / w};
}

Q height(Plan const& plan, int top, Point2q const& p)
{
  auto const& t = plan.tops[std::size_t(top)];
  return (rational(t.form.x) * p.x + rational(t.form.y) * p.y + rational(t.form.z)) / rational(t.scale);
}

Slice::Slice(Plan const& plan, Vector const& line, Polygons alive) : plan_(plan), line_(line)
{
  std::vector<Span> found;
  for (int i = 0; i < plan.polygon_count(); ++i) {
    if ((alive & polygon_bit(i)) == 0) continue;
    if (auto const p = passage(plan, line, i)) {
      found.push_back({i, 0, 0, *p});
      add(p->enter);
      if (!plan.is_fence(i)) add(p->leave);
    }
  }
  for (int s = plan.first_ridge; s < static_cast<int>(plan.segments.size()); ++s) {
    auto const& ridge = plan.segments[std::size_t(s)];
    if ((ridge.owners & alive) != ridge.owners) continue;
    int const a = sign(dot(line, ridge.a)), b = sign(dot(line, ridge.b));
    if (a * b < 0) add({s, a < 0});
  }
  for (auto const& [position, breaks] : breaks_) {
    for (auto const& s : breaks) rank_[s.segment] = static_cast<int>(stops_.size());
    stops_.push_back(breaks[0]);
    places_.push_back(crossing(plan_, line_, breaks[0].segment));
  }
  for (auto& s : found) {
    s.first = rank_.at(s.passage.enter.segment), s.last = rank_.at(s.passage.leave.segment);
    (s.polygon < plan.columns ? columns_ : others_).push_back(s);
  }
}

bool Slice::is_top(int polygon, int rank) const
{
  Point2q const m = middle(place(rank), place(rank + 1));
  Q const h = height_at(polygon, m);
  return std::ranges::none_of(
    columns_, [&](Span const& s) { return s.first <= rank && s.last > rank && height_at(s.polygon, m) > h; });
}

bool Slice::stands_out(int polygon, int rank) const
{
  Q const h = height_at(polygon, place(rank));
  return std::ranges::none_of(columns_, [&](Span const& s) {
    return s.first < rank && s.last >= rank && height_at(s.polygon, place(rank)) >= h;
  });
}

Slice::Span const* Slice::find(std::vector<Span> const& spans, int polygon)
{
  auto const s = std::ranges::find(spans, polygon, &Span::polygon);
  return s == spans.end() ? nullptr : &*s;
}

void Slice::add(Stop s)
{
  Point2q const p = crossing(plan_, line_, s.segment);
  breaks_[rational(line_.y) * p.x - rational(line_.x) * p.y].push_back(s);
}

}  // namespace visibility::oracle::detail
