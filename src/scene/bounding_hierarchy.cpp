#include "visibility/scene/bounding_hierarchy.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>

namespace visibility {

namespace {

constexpr std::uint32_t leaf_size = 4;
constexpr int bins = 16;

double component(Point3d const& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

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
  int bin_of(double c) const { return std::clamp(static_cast<int>((c - origin) * scale), 0, bins - 1); }
};

class Builder {
public:
  Builder(std::span<Box const> boxes, std::vector<BoundingHierarchy::Node>& nodes, std::vector<std::uint32_t>& items,
          int max_depth)
    : boxes_(boxes), nodes_(nodes), items_(items), median_depth_(max_depth / 2)
  {
    centres_.reserve(boxes.size());
    for (auto const& b : boxes)
      centres_.push_back({0.5 * b.min.x + 0.5 * b.max.x, 0.5 * b.min.y + 0.5 * b.max.y, 0.5 * b.min.z + 0.5 * b.max.z});
  }

  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last, int depth)
  {
    Box bounds, centres;
    for (auto i = first; i < last; ++i) {
      bounds.extend(boxes_[items_[i]]);
      centres.extend(centres_[items_[i]]);
    }
    nodes_[node] = {bounds, first, last - first};
    if (last - first <= leaf_size) return;
    std::uint32_t middle = first;
    if (depth < median_depth_)
      if (Split const s = best_split(first, last, centres); s.axis >= 0)
        middle = static_cast<std::uint32_t>(
          std::partition(items_.begin() + first, items_.begin() + last,
                         [&](auto i) { return s.bin_of(component(centres_[i], s.axis)) < s.bin; }) -
          items_.begin());
    if (middle == first || middle == last) middle = median(first, last, centres);
    auto const left = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = left;
    nodes_[node].count = 0;
    build(left, first, middle, depth + 1);
    build(left + 1, middle, last, depth + 1);
  }

private:
  Split best_split(std::uint32_t first, std::uint32_t last, Box const& centres) const
  {
    Split best;
    double best_cost = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
      double const lo = component(centres.min, axis), extent = component(centres.max, axis) - lo;
      if (!(extent > 0) || !std::isfinite(bins / extent)) continue;
      Split s{axis, lo, bins / extent, 0};
      std::array<Box, bins> box;
      std::array<std::uint32_t, bins> count{};
      for (auto i = first; i < last; ++i) {
        auto const b = static_cast<std::size_t>(s.bin_of(component(centres_[items_[i]], axis)));
        box[b].extend(boxes_[items_[i]]);
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
        if (n == 0 || n == last - first || !(cost < best_cost)) continue;
        best_cost = cost;
        best = s;
        best.bin = static_cast<int>(b);
      }
    }
    return best;
  }

  std::uint32_t median(std::uint32_t first, std::uint32_t last, Box const& centres)
  {
    double const x = centres.max.x - centres.min.x, y = centres.max.y - centres.min.y,
                 z = centres.max.z - centres.min.z;
    int const axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    auto const middle = first + (last - first) / 2;
    std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last, [&](auto a, auto b) {
      return std::pair(component(centres_[a], axis), a) < std::pair(component(centres_[b], axis), b);
    });
    return middle;
  }

  std::span<Box const> boxes_;
  std::vector<BoundingHierarchy::Node>& nodes_;
  std::vector<std::uint32_t>& items_;
  std::vector<Point3d> centres_;
  int median_depth_;
};

}  // namespace

BoundingHierarchy::BoundingHierarchy(std::span<Box const> boxes)
{
  if (boxes.empty()) return;
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0U);
  nodes_.reserve(boxes.size());
  nodes_.resize(1);
  Builder(boxes, nodes_, items_, max_depth).build(0, 0, static_cast<std::uint32_t>(boxes.size()), 0);
}

void BoundingHierarchy::validate(std::span<Box const> boxes) const
{
  auto const require = [](bool ok, char const* what) {
    if (!ok) throw std::logic_error(std::string("BoundingHierarchy: ") + what);
  };
  auto const inside = [](Box const& inner, Box const& outer) {
    return contains(outer, inner.min) && contains(outer, inner.max);
  };
  require(items_.size() == boxes.size(), "not one entry per item");
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
