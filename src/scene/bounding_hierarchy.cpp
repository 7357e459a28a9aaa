#include "visibility/scene/bounding_hierarchy.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>

namespace visibility {

namespace {

using Node = BoundingHierarchy::Node;

constexpr std::uint32_t leaf_size = 4;
constexpr int bins = 16;
/// Above this many items only the longest axis is binned: which one is best hardly matters there, and the top levels
/// read every item once a level.
constexpr std::uint32_t one_axis_above = 512;
/// From this depth on nodes are split at the median, so that no input makes the tree deep.
constexpr int median_depth = 48;

/// An item while the tree is built; kept together, so that each pass over a node reads memory in order.
struct Reference {
  Box box;
  std::uint32_t item;
};

double component(Point3d const& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
double centre(Box const& b, int axis) { return 0.5 * component(b.min, axis) + 0.5 * component(b.max, axis); }
Point3d centre(Box const& b) { return {centre(b, 0), centre(b, 1), centre(b, 2)}; }

double half_area(Box const& b)
{
  if (b.is_empty()) return 0;
  double const x = b.max.x - b.min.x, y = b.max.y - b.min.y, z = b.max.z - b.min.z;
  return x * y + y * z + z * x;
}

struct Split {
  int axis = -1;
  double origin = 0, scale = 0;
  int bin = 0;
  double cost = HUGE_VAL;
  int bin_of(Box const& b) const
  {
    return std::clamp(static_cast<int>((centre(b, axis) - origin) * scale), 0, bins - 1);
  }
};

class Builder {
public:
  Builder(std::vector<Reference>& references, std::vector<Node>& nodes) : references_(references), nodes_(nodes) {}

  /// Makes `node` hold the references [first, last) and splits it as often as it takes.
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last, int depth)
  {
    Box bounds, centres;
    for (auto const& r : range(first, last)) {
      bounds.extend(r.box);
      centres.extend(centre(r.box));
    }
    nodes_[node] = {bounds, first, last - first};
    if (last - first <= leaf_size) return;
    std::uint32_t middle = first;
    if (depth < median_depth)
      if (Split const s = best_split(first, last, centres); s.axis >= 0) middle = partition(first, last, s);
    if (middle == first || middle == last) middle = median(first, last, centres);
    auto const left = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = left;
    nodes_[node].count = 0;
    build(left, first, middle, depth + 1);
    build(left + 1, middle, last, depth + 1);
  }

private:
  std::span<Reference> range(std::uint32_t first, std::uint32_t last)
  {
    return std::span(references_).subspan(first, last - first);
  }

  std::uint32_t partition(std::uint32_t first, std::uint32_t last, Split const& s)
  {
    auto const items = range(first, last);
    auto const right =
      std::partition(items.begin(), items.end(), [&](Reference const& r) { return s.bin_of(r.box) < s.bin; });
    return first + static_cast<std::uint32_t>(right - items.begin());
  }

  Split best_split(std::uint32_t first, std::uint32_t last, Box const& centres)
  {
    if (last - first > one_axis_above) return best_split(first, last, centres, longest_axis(centres));
    Split best;
    for (int axis = 0; axis < 3; ++axis)
      if (Split const s = best_split(first, last, centres, axis); s.cost < best.cost) best = s;
    return best;
  }

  Split best_split(std::uint32_t first, std::uint32_t last, Box const& centres, int axis)
  {
    double const lo = component(centres.min, axis), extent = component(centres.max, axis) - lo;
    if (!(extent > 0) || !std::isfinite(bins / extent)) return {};
    Split s{axis, lo, bins / extent, 0, HUGE_VAL};
    std::array<Box, bins> box;
    std::array<std::uint32_t, bins> count{};
    for (auto const& r : range(first, last)) {
      auto const b = static_cast<std::size_t>(s.bin_of(r.box));
      box[b].extend(r.box);
      ++count[b];
    }
    std::array<double, bins> right_cost{};
    Box right;
    std::uint32_t n = 0;
    for (std::size_t b = bins - 1; b > 0; --b) {
      right.extend(box[b]);
      n += count[b];
      right_cost[b] = half_area(right) * n;
    }
    Box left;
    n = 0;
    for (std::size_t b = 1; b < bins; ++b) {
      left.extend(box[b - 1]);
      n += count[b - 1];
      double const cost = half_area(left) * n + right_cost[b];
      if (n == 0 || n == last - first || !(cost < s.cost)) continue;
      s.cost = cost;
      s.bin = static_cast<int>(b);
    }
    return s.bin > 0 ? s : Split{};
  }

  static int longest_axis(Box const& centres)
  {
    double const x = centres.max.x - centres.min.x, y = centres.max.y - centres.min.y,
                 z = centres.max.z - centres.min.z;
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }

  std::uint32_t median(std::uint32_t first, std::uint32_t last, Box const& centres)
  {
    int const axis = longest_axis(centres);
    auto const items = range(first, last);
    auto const middle = items.begin() + (last - first) / 2;
    std::nth_element(items.begin(), middle, items.end(), [&](Reference const& a, Reference const& b) {
      return std::pair(centre(a.box, axis), a.item) < std::pair(centre(b.box, axis), b.item);
    });
    return first + static_cast<std::uint32_t>(middle - items.begin());
  }

  std::vector<Reference>& references_;
  std::vector<Node>& nodes_;
};

void unpack(std::vector<Reference> const& references, std::vector<std::uint32_t>& items, std::vector<Box>& bounds)
{
  items.reserve(references.size());
  bounds.reserve(references.size());
  for (auto const& r : references) {
    items.push_back(r.item);
    bounds.push_back(r.box);
  }
}

}  // namespace

BoundingHierarchy::BoundingHierarchy(std::span<Box const> boxes)
{
  if (boxes.empty()) return;
  std::vector<Reference> references;
  references.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) references.push_back({boxes[i], i});
  nodes_.reserve(boxes.size());
  nodes_.resize(1);
  Builder(references, nodes_).build(0, 0, static_cast<std::uint32_t>(boxes.size()), 0);
  unpack(references, items_, item_bounds_);
}

BoundingHierarchy::BoundingHierarchy(BoundingHierarchy const& groups, std::span<std::uint32_t const> first_of_group,
                                     std::span<Box const> boxes)
  : nodes_(groups.nodes_)
{
  if (boxes.empty()) return;
  std::vector<Reference> references;
  references.reserve(boxes.size());
  Builder builder(references, nodes_);
  // Only the leaves of `groups` change: each gets the items of its groups, and nodes below it if these are many.
  auto const expand = [&](auto const& self, std::uint32_t index, int depth) -> void {
    Node const node = nodes_[index];
    if (!node.is_leaf()) {
      self(self, node.first, depth + 1);
      self(self, node.first + 1, depth + 1);
      return;
    }
    auto const first = static_cast<std::uint32_t>(references.size());
    for (auto const g : groups.items().subspan(node.first, node.count))
      for (auto i = first_of_group[g]; i < first_of_group[g + 1]; ++i) references.push_back({boxes[i], i});
    builder.build(index, first, static_cast<std::uint32_t>(references.size()), depth);
  };
  expand(expand, 0, 0);
  unpack(references, items_, item_bounds_);
}

void BoundingHierarchy::validate(std::span<Box const> boxes) const
{
  auto const require = [](bool ok, char const* what) {
    if (!ok) throw std::logic_error(std::string("BoundingHierarchy: ") + what);
  };
  auto const inside = [](Box const& inner, Box const& outer) {
    return contains(outer, inner.min) && contains(outer, inner.max);
  };
  require(items_.size() == boxes.size() && item_bounds_.size() == boxes.size(), "not one entry per item");
  for (std::size_t i = 0; i < items_.size(); ++i)
    require(item_bounds_[i] == boxes[items_[i]], "bounds of another item");
  std::vector<bool> seen(boxes.size(), false);
  for (auto const i : items_) {
    require(i < boxes.size() && !seen[i], "an item is missing or doubled");
    seen[i] = true;
  }
  std::size_t covered = 0;
  for (auto const& n : nodes_) {
    if (!n.is_leaf()) {
      require(n.first + 1 < nodes_.size(), "a child out of range");
      require(inside(nodes_[n.first].bounds, n.bounds) && inside(nodes_[n.first + 1].bounds, n.bounds),
              "a child outside its parent");
      continue;
    }
    covered += n.count;
    for (auto i = n.first; i < n.first + n.count; ++i)
      require(inside(boxes[items_[i]], n.bounds), "an item outside its leaf");
  }
  require(covered == boxes.size(), "leaves do not tile the items");
}

}  // namespace visibility
