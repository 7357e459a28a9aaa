#include "mesh_outline.hpp"

#include "visibility/predicates/orient2d.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace visibility::detail {

namespace {

using Index = std::uint32_t;

/// A set of directed edges as a chain: an edge and its reverse cancel.
class Chain {
public:
  void add(Index from, Index to)
  {
    if (from < to)
      edges_.push_back({from, to, 1});
    else if (to < from)
      edges_.push_back({to, from, -1});
  }

  /// What is left after cancelling: edges in their direction, as often as they occur, ascending.
  std::vector<std::array<Index, 2>> sum()
  {
    std::ranges::sort(edges_, {}, [](Edge const& e) { return std::tie(e.low, e.high); });
    std::vector<std::array<Index, 2>> out;
    for (std::size_t i = 0; i < edges_.size();) {
      auto const [low, high, first] = edges_[i];
      int times = 0;
      for (; i < edges_.size() && edges_[i].low == low && edges_[i].high == high; ++i) times += edges_[i].times;
      for (int k = 0; k < std::abs(times); ++k)
        out.push_back(times > 0 ? std::array{low, high} : std::array{high, low});
    }
    std::ranges::sort(out);
    return out;
  }

private:
  struct Edge {
    Index low, high;
    int times;
  };
  std::vector<Edge> edges_;
};

/// Walks along directed edges of which as many leave each point as arrive: every walk comes back to its start.
std::vector<std::vector<Index>> closed_walks(std::vector<std::array<Index, 2>> const& edges, std::size_t points)
{
  std::vector<std::size_t> next(points + 1, 0);
  for (auto const& e : edges) ++next[e[0] + 1];
  for (std::size_t i = 0; i < points; ++i) next[i + 1] += next[i];
  std::vector<std::vector<Index>> walks;
  std::vector<std::size_t> const end(next.begin() + 1, next.end());
  for (Index start = 0; start < points; ++start)
    while (next[start] < end[start]) {
      auto& walk = walks.emplace_back();
      Index at = start;
      do {
        walk.push_back(at);
        at = edges[next[at]++][1];
      } while (at != start);
    }
  return walks;
}

/// Positions of values in the sorted list of distinct ones.
template <class Point>
std::vector<Index> ranks(std::vector<Point> const& points, std::vector<Point>& distinct)
{
  distinct = points;
  std::ranges::sort(distinct);
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  std::vector<Index> out;
  for (auto const& p : points)
    out.push_back(static_cast<Index>(std::ranges::lower_bound(distinct, p) - distinct.begin()));
  return out;
}

}  // namespace

std::vector<std::vector<Point2d>> mesh_outline(Scene const& scene, IndexRange triangles)
{
  std::vector<std::array<double, 3>> corners, distinct;
  std::vector<std::array<double, 2>> plan, distinct_plan;
  for (Index i = triangles.first; i < triangles.last; ++i)
    for (auto const v : scene.triangles[i]) {
      auto const& p = scene.vertices[v];
      corners.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});  // no negative zeros
      plan.push_back({p.x + 0.0, p.y + 0.0});
    }
  auto const in_space = ranks(corners, distinct), in_plan = ranks(plan, distinct_plan);

  // Of a closed surface as many triangles over a point look up as down: those that look up cover all.
  Chain surface;
  for (std::size_t t = 0; t < corners.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) surface.add(in_space[t + k], in_space[t + (k + 1) % 3]);
  bool const closed = surface.sum().empty();

  // Counterclockwise triangles: how often they wind around a point is how many cover it, and cancelling keeps that.
  Chain covered;
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    auto const point = [&](std::size_t k) { return Point2d{plan[t + k][0], plan[t + k][1]}; };
    Sign const turn = orient2d<Filtered>(point(0), point(1), point(2));
    if (is_zero(turn) || (closed && is_negative(turn))) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      Index const a = in_plan[t + k], b = in_plan[t + (k + 1) % 3];
      is_positive(turn) ? covered.add(a, b) : covered.add(b, a);
    }
  }
  std::vector<std::vector<Point2d>> rings;
  for (auto const& walk : closed_walks(covered.sum(), distinct_plan.size())) {
    auto& ring = rings.emplace_back();
    for (auto const i : walk) ring.push_back({distinct_plan[i][0], distinct_plan[i][1]});
  }
  return rings;
}

}  // namespace visibility::detail
