#include "support/height_field_search.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <stdexcept>

namespace visibility::oracle::detail {
namespace {

constexpr int lines_tried = 16;  // before the search

/// Whether every line of the cone meets stop a before or with stop b; `apart`: and its inner lines strictly before.
enum class Order { unknown, together, apart };
Order order(Plan const& plan, Stop a, Stop b, std::span<Vector const> rays)
{
  Signs const s = signs(Posts::order(plan, a, b), rays);
  return s.negative ? Order::unknown : s.positive ? Order::apart : Order::together;
}

}  // namespace

Search::Result Search::operator()(int target, std::uint32_t object)
{
  target_ = target;
  object_ = object;
  result_ = {};
  if (try_some_lines()) return result_;
  Events pending;
  // The corners of the cell and of the target divide first.
  Polygons const ends = polygon_bit(plan_.cell()) | polygon_bit(target);
  for (auto const& e : plan_.events) pending.push_back(&e);
  std::ranges::stable_partition(pending, [&](Event const* e) { return (e->owners & ~ends) == 0; });
  for (auto const& cone : all_lines())
    if (visit(cone, std::vector<Known>(std::size_t(plan_.polygon_count())), pending)) break;
  return result_;
}

Search::Known Search::classify(int polygon, std::span<Vector const> rays) const
{
  auto const& corners = plan_.polygons[std::size_t(polygon)];
  bool some_negative = false, some_positive = false, fixed = true;
  for (auto const& c : corners) {
    Signs const s = signs(c, rays);
    some_negative = some_negative || s.negative;
    some_positive = some_positive || s.positive;
    fixed = fixed && !s.both();
  }
  if (!some_negative || !some_positive) return {Known::irrelevant, {}};
  if (!fixed) return {};
  auto const p = passage(plan_, inner_line(rays), polygon);
  return {Known::fixed, p.value()};
}

/// Columns that no line of the cone meets between cell and target play no part.
void Search::drop_columns(std::span<Vector const> rays, std::vector<Known>& known) const
{
  auto const &cell = known[std::size_t(plan_.cell())].passage, &own = known[std::size_t(target_)].passage;
  for (int i = 0; i < plan_.columns; ++i) {
    Known& k = known[std::size_t(i)];
    if (i == target_ || k.state != Known::fixed) continue;
    if (order(plan_, own.leave, k.passage.enter, rays) != Order::unknown ||
        order(plan_, k.passage.leave, cell.enter, rays) != Order::unknown)
      k.state = Known::irrelevant;
  }
}

/// Looks at the cone; whether a witness was found.
bool Search::visit(Cone const& cone, std::vector<Known> known, Events const& pending)
{
  ++cones;
  for (int i = 0; i < plan_.polygon_count(); ++i)
    if (known[std::size_t(i)].state == Known::mixed) known[std::size_t(i)] = classify(i, cone.rays);
  auto const &cell = known[std::size_t(plan_.cell())], &own = known[std::size_t(target_)];
  if (cell.state == Known::irrelevant || own.state == Known::irrelevant) return false;

  if (cell.state == Known::fixed && own.state == Known::fixed) {
    if (order(plan_, own.passage.leave, cell.passage.enter, cone.rays) != Order::unknown) return false;
    drop_columns(cone.rays, known);
    if (hidden(cone.rays, known)) return false;
  }
  Polygons alive = 0;
  for (int i = 0; i < plan_.polygon_count(); ++i)
    if (known[std::size_t(i)].state != Known::irrelevant) alive |= polygon_bit(i);

  Events rest;
  Event const* at = nullptr;
  for (auto const* e : pending) {
    if ((e->owners & alive) != e->owners || !signs(e->point, cone.rays).both()) continue;
    if (at == nullptr)
      at = e;
    else
      rest.push_back(e);
  }
  if (at == nullptr) return leaf(cone, alive);
  auto const [right, left] = split(cone, at->point);
  return visit(right, known, rest) || visit(left, known, rest);
}

/// Whether the columns whose passage is fixed hide the target on the whole cone. Requires: those of cell and target
/// are. The near end of a polygon takes the place of a column's wall, with more conditions than are tried here; a fence
/// is a wall alone.
bool Search::hidden(std::span<Vector const> rays, std::vector<Known> const& known)
{
  auto const &cell = known[std::size_t(plan_.cell())].passage, &own = known[std::size_t(target_)].passage;
  if (order(plan_, cell.leave, own.enter, rays) != Order::apart) return false;  // perhaps seen from right above
  bool const face = plan_.segments[std::size_t(own.enter.segment)].face;
  for (Stop const s : {cell.leave, cell.enter}) {
    Post const source{s, plan_.cell()}, eave{own.enter, target_}, far_end{own.leave, target_};
    if (face && !blocked(rays, known, source, eave)) return false;
    if (plan_.is_fence(target_)) continue;
    if (nowhere_positive(posts_.above(source, eave, far_end), rays)) continue;  // the top faces away
    if (!blocked(rays, known, source, far_end)) return false;
  }
  return true;
}

/// Whether one column before the target blocks the segment from source to end on the whole cone.
bool Search::blocked(std::span<Vector const> rays, std::vector<Known> const& known, Post const& source, Post const& end)
{
  Stop const enter = known[std::size_t(target_)].passage.enter;
  for (int i = 0; i < plan_.columns; ++i) {
    auto const& k = known[std::size_t(i)];
    if (i == target_ || k.state != Known::fixed) continue;
    for (Stop const s : {k.passage.leave, k.passage.enter}) {
      if (order(plan_, source.stop, s, rays) == Order::unknown) continue;
      Order const before = order(plan_, s, enter, rays);
      if (before == Order::unknown || (before == Order::together && s.segment == k.passage.enter.segment)) continue;
      if (nowhere_positive(posts_.above(source, {s, i}, end), rays)) return true;
    }
  }
  return false;
}

std::vector<Form const*> Search::forms(Candidate const& candidate)
{
  std::vector<Form const*> out;
  for (auto const& q : candidate.occluders) {
    auto const* f = &posts_.above(candidate.source, q, candidate.target);
    if (std::ranges::find(out, f) == out.end()) out.push_back(f);
  }
  return out;
}

/// Every line of the cone meets the same stops in the same order.
bool Search::leaf(Cone const& cone, Polygons alive)
{
  ++leaves;
  Vector const line = inner_line(cone.rays);
  View const view = view_along(plan_, line, target_, alive, RationalNumber(1) / 4);
  if (view.from_above) return accept(line, nullptr, alive);
  for (auto const& candidate : view.candidates) {
    Decision const d = all_positive(forms(candidate), cone.rays);
    if (d.line) return accept(*d.line, &candidate, alive);
    result_.decided = result_.decided && d.decided;
  }
  return false;
}

/// Keeps a sight line near the limit that the candidate describes (none: seen from above).
bool Search::accept(Vector const& line, Candidate const* candidate, Polygons alive)
{
  RationalNumber shrink = RationalNumber(1) / 4;
  for (int tries = 0; tries < 12; ++tries, shrink = shrink * shrink) {
    std::optional<Witness> w = candidate != nullptr ? sight_line(plan_, line, *candidate, shrink)
                                                    : view_along(plan_, line, target_, alive, shrink).from_above;
    if (!w) break;
    w->object = object_;
    if (!confirm_(*w)) continue;
    result_ = {std::move(w), true};
    return true;
  }
  throw std::logic_error("height field oracle: what is visible has no sight line");
}

bool Search::try_line(Vector const& line)
{
  for (auto const& e : plan_.events)
    if (dot(line, e.point) == 0) return false;
  View const view = view_along(plan_, line, target_, all(), RationalNumber(1) / 4);
  if (view.from_above) return accept(line, nullptr, all());
  for (auto const& candidate : view.candidates) {
    auto const conditions = forms(candidate);
    if (std::ranges::all_of(conditions, [&](Form const* f) { return value(*f, line) > 0; }))
      return accept(line, &candidate, all());
  }
  return false;
}

/// Lines through a point of the cell and a point of the target, to be done soon with what is easily seen.
bool Search::try_some_lines()
{
  test::Random random(1);
  auto const in = [&](int polygon) {
    Vector sum{NT(0), NT(0), NT(0)};
    for (auto const& c : plan_.polygons[std::size_t(polygon)]) sum = sum + (NT(random.between(1, 64)) * c);
    return sum;
  };
  for (int i = 0; i < lines_tried; ++i) {
    Vector const p = in(plan_.cell()), q = in(target_);
    if (try_line(cross(p, q))) return true;
  }
  return false;
}

}  // namespace visibility::oracle::detail
