#include "visibility/viewspace/delta_sets.hpp"

#include "visibility/viewspace/neighbours.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace visibility {

namespace {

using Objects = DeltaSets::Objects;

Objects difference(Objects const& a, Objects const& b)
{
  Objects out;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(out));
  return out;
}

/// Disjoint sets, by size.
class Components {
public:
  explicit Components(std::size_t n) : parent_(n), size_(n, 1)
  {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  bool join(std::uint32_t a, std::uint32_t b)
  {
    a = root(a), b = root(b);
    if (a == b) return false;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
    return true;
  }

private:
  std::uint32_t root(std::uint32_t a)
  {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  std::vector<std::uint32_t> parent_, size_;
};

/// For each cell the one that its set is derived from, or Entry::key. A minimum spanning tree [Kruskal 1956] of the
/// cells and of an empty set next to all of them.
std::vector<std::uint32_t> choose_origins(std::span<ViewCell const> cells, std::span<Objects const> sets)
{
  auto const n = static_cast<std::uint32_t>(cells.size());
  std::uint32_t const nothing = n;
  std::vector<std::tuple<std::size_t, std::uint32_t, std::uint32_t>> edges;
  for (std::uint32_t i = 0; i < n; ++i) edges.emplace_back(encoded_size(sets[i]), i, nothing);
  for (auto const& [a, b] : neighbours(cells)) edges.emplace_back(encoded_size(difference(sets[a], sets[b])), a, b);
  std::ranges::sort(edges);
  Components components(std::size_t{n} + 1);
  std::vector<std::vector<std::uint32_t>> tree(std::size_t{n} + 1);
  for (auto const& [bytes, a, b] : edges)
    if (components.join(a, b)) tree[a].push_back(b), tree[b].push_back(a);

  std::vector<std::uint32_t> origin(n, DeltaSets::Entry::key), stack{nothing};
  while (!stack.empty()) {
    auto const at = stack.back();
    stack.pop_back();
    for (auto const next : tree[at]) {
      if (at != nothing && (next == nothing || next == origin[at])) continue;
      if (at != nothing) origin[next] = at;
      stack.push_back(next);
    }
  }
  return origin;
}

bool is_ascending(Objects const& objects)
{
  return std::ranges::adjacent_find(objects, std::ranges::greater_equal()) == objects.end();
}

BoundingHierarchy hierarchy_over(std::span<ViewCell const> cells)
{
  std::vector<Box> bounds;
  for (auto const& c : cells) bounds.push_back(c.bounds());
  return BoundingHierarchy(bounds);
}

}  // namespace

std::size_t encoded_size(std::uint64_t number)
{
  std::size_t bytes = 1;
  while (number >= 0x80) number >>= 7, ++bytes;
  return bytes;
}

std::size_t encoded_size(std::span<std::uint32_t const> ascending)
{
  std::size_t bytes = encoded_size(ascending.size());
  for (std::size_t i = 0; i < ascending.size(); ++i)
    bytes += encoded_size(std::uint64_t{i == 0 ? ascending[0] : ascending[i] - ascending[i - 1] - 1});
  return bytes;
}

DeltaSets::DeltaSets(std::vector<ViewCell> cells, std::span<Objects const> sets, std::uint32_t objects)
  : cells_(std::move(cells)), objects_(objects), hierarchy_(hierarchy_over(cells_))
{
  if (sets.size() != cells_.size()) throw std::invalid_argument("there is not one set for each cell");
  // Before differences are formed, which need ascending sets.
  if (!std::ranges::all_of(sets, is_ascending)) throw std::invalid_argument("a set is not ascending");
  auto const origins = choose_origins(cells_, sets);
  for (std::size_t i = 0; i < sets.size(); ++i)
    entries_.push_back({origins[i], origins[i] == Entry::key ? sets[i] : difference(sets[i], sets[origins[i]])});
  validate();
}

DeltaSets::DeltaSets(std::vector<ViewCell> cells, std::vector<Entry> entries, std::uint32_t objects)
  : cells_(std::move(cells)), entries_(std::move(entries)), objects_(objects), hierarchy_(hierarchy_over(cells_))
{
  if (entries_.size() != cells_.size()) throw std::invalid_argument("there is not one set for each cell");
  validate();
}

void DeltaSets::validate() const
{
  for (auto const& e : entries_) {
    if (!is_ascending(e.changed)) throw std::invalid_argument("a set is not ascending");
    if (!e.changed.empty() && e.changed.back() >= objects_)
      throw std::invalid_argument("a set names object " + std::to_string(e.changed.back()) + " of " +
                                  std::to_string(objects_));
    if (e.from != Entry::key && e.from >= size())
      throw std::invalid_argument("a set is derived from that of cell " + std::to_string(e.from) + " of " +
                                  std::to_string(size()));
  }
  std::vector<std::uint8_t> leads_to_key(size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    std::vector<std::uint32_t> path;
    auto at = i;
    for (; at != Entry::key && leads_to_key[at] == 0; at = entries_[at].from) {
      if (path.size() > size()) throw std::invalid_argument("sets are derived from each other in a circle");
      path.push_back(at);
    }
    for (auto const p : path) leads_to_key[p] = 1;
  }
}

std::size_t DeltaSets::key_count() const
{
  return static_cast<std::size_t>(std::ranges::count(entries_, Entry::key, &Entry::from));
}

auto DeltaSets::set(std::size_t cell) const -> Objects
{
  // An object is in the set iff it changes an odd number of times on the way to the key.
  Objects changes;
  for (auto at = static_cast<std::uint32_t>(cell); at != Entry::key; at = entries_[at].from)
    changes.insert(changes.end(), entries_[at].changed.begin(), entries_[at].changed.end());
  std::ranges::sort(changes);
  Objects out;
  for (std::size_t i = 0; i < changes.size();) {
    std::size_t next = i;
    while (next < changes.size() && changes[next] == changes[i]) ++next;
    if ((next - i) % 2 != 0) out.push_back(changes[i]);
    i = next;
  }
  return out;
}

auto DeltaSets::all() const -> std::vector<Objects>
{
  std::vector<Objects> out(size());
  std::vector<std::uint8_t> known(size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    std::vector<std::uint32_t> path;
    for (auto at = i; at != Entry::key && known[at] == 0; at = entries_[at].from) path.push_back(at);
    for (; !path.empty(); path.pop_back()) {
      auto const& e = entries_[path.back()];
      out[path.back()] = e.from == Entry::key ? e.changed : difference(out[e.from], e.changed);
      known[path.back()] = 1;
    }
  }
  return out;
}

std::optional<std::size_t> DeltaSets::cell_at(Point3d const& point) const
{
  std::optional<std::size_t> first;
  hierarchy_.any_item_meeting({point, point}, [&](std::uint32_t i) {
    if ((!first || i < *first) && contains(cells_[i], point)) first = i;
    return false;
  });
  return first;
}

}  // namespace visibility
