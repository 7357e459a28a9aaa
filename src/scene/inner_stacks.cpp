#include "inner_stacks.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"

#include <algorithm>

namespace visibility::detail {

namespace {

/// More prisms than these are not stacked: every pair is looked at.
constexpr std::size_t most_prisms = 1'000;

struct Storey {
  InnerBody const* body;
  ConvexPrism const* prism;
  Box bounds;
};

/// Whether the closed footprint of `outer` contains that of `inner`. Exact.
bool covers(Storey const& outer, Storey const& inner)
{
  if (inner.bounds.min.x < outer.bounds.min.x || inner.bounds.max.x > outer.bounds.max.x ||
      inner.bounds.min.y < outer.bounds.min.y || inner.bounds.max.y > outer.bounds.max.y)
    return false;
  auto const &out = outer.prism->footprint, &in = inner.prism->footprint;
  for (std::size_t i = 0, n = out.size(); i < n; ++i)
    if (std::ranges::any_of(
          in, [&](Point2d const& p) { return is_negative(orient2d<Filtered>(out[i], out[(i + 1) % n], p)); }))
      return false;
  return true;
}

}  // namespace

std::vector<InnerBody> stacks(std::span<InnerBody const> bodies)
{
  std::vector<Storey> storeys;
  for (auto const& k : bodies)
    if (auto const* prism = std::get_if<ConvexPrism>(&k.shape)) storeys.push_back({&k, prism, bounding_box(*prism)});
  std::vector<InnerBody> out;
  if (storeys.size() < 2 || storeys.size() > most_prisms) return out;
  std::ranges::stable_sort(storeys, {}, [](Storey const& s) { return s.prism->bottom; });
  std::vector<Storey const*> column;
  for (auto const& s : storeys) {
    auto const contains_storey = [&](InnerBody const& k) {
      auto const& prism = std::get<ConvexPrism>(k.shape);
      return prism.footprint == s.prism->footprint && prism.bottom <= s.prism->bottom && s.prism->top <= prism.top &&
             k.floor <= s.body->floor && k.needs_outside <= s.body->needs_outside;
    };
    if (std::ranges::any_of(out, contains_storey)) continue;
    column.clear();
    for (auto const& t : storeys)
      if (t.body->floor <= s.body->floor && t.body->needs_outside <= s.body->needs_outside && covers(t, s))
        column.push_back(&t);
    ConvexPrism joined = *s.prism;
    for (auto const* t : column)  // by growing bottom
      if (t->prism->bottom <= joined.top && t->prism->top >= joined.bottom)
        joined.top = std::max(joined.top, t->prism->top);
    std::ranges::stable_sort(column, std::greater<>{}, [](Storey const* t) { return t->prism->top; });
    for (auto const* t : column)
      if (t->prism->top >= joined.bottom) joined.bottom = std::min(joined.bottom, t->prism->bottom);
    if (joined.bottom < s.prism->bottom || joined.top > s.prism->top)
      out.push_back({std::move(joined), s.body->floor, s.body->needs_outside});
  }
  return out;
}

}  // namespace visibility::detail
