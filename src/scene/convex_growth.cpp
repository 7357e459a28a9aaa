#include "convex_growth.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"

#include <algorithm>
#include <limits>

namespace visibility::detail {

namespace {

using plan::Polygon;

struct Edge {
  Point2d a, b;
};

std::vector<Edge> edges_of(std::span<Polygon const> rings)
{
  std::vector<Edge> out;
  for (auto const& ring : rings)
    for (std::size_t i = 0, n = ring.size(); i < n; ++i)
      if (ring[i] != ring[(i + 1) % n]) out.push_back({ring[i], ring[(i + 1) % n]});
  return out;
}

/// Lines beyond this number are not tried for every edge.
constexpr std::size_t most_lines = 64;

class Growth {
public:
  Growth(std::span<Polygon const> rings, Polygon const& seed) : seed_(seed), edges_(edges_of(rings))
  {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Point2d low{inf, inf}, high{-inf, -inf};
    for (auto const& e : edges_) {
      low = {std::min(low.x, e.a.x), std::min(low.y, e.a.y)};
      high = {std::max(high.x, e.a.x), std::max(high.y, e.a.y)};
    }
    slack_ = 1e-9 * (high.x - low.x + high.y - low.y);
    region_ = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (std::size_t i = 0, n = seed.size(); i < n; ++i) lines_.push_back({seed[i], seed[(i + 1) % n]});
    for (auto const& e : edges_)
      if (lines_.size() < most_lines) {
        if (keeps_seed(e))
          lines_.push_back(e);
        else if (keeps_seed({e.b, e.a}))
          lines_.push_back({e.b, e.a});
      }
  }

  Polygon run()
  {
    Point2d const centre = plan::mean(seed_);
    auto const distance = [&](Edge const& e) {
      Point2d const middle{(e.a.x + e.b.x) / 2, (e.a.y + e.b.y) / 2};
      return std::min({plan::distance(e.a, centre), plan::distance(e.b, centre), plan::distance(middle, centre)});
    };
    // What runs along the seed leaves no choice; then the nearest edges first.
    for (auto const& e : edges_)
      if (runs_along_seed(e)) avoid(e);
    std::ranges::sort(edges_, {}, distance);
    for (auto const& e : edges_) avoid(e);
    return region_;
  }

private:
  bool keeps_seed(Edge const& line) const
  {
    return std::ranges::all_of(seed_, [&](Point2d const& p) { return plan::left_of(line.a, line.b, p) >= -slack_; });
  }
  bool runs_along_seed(Edge const& e) const
  {
    std::size_t const n = seed_.size();
    for (std::size_t i = 0; i < n; ++i) {
      Point2d const &a = seed_[i], &b = seed_[(i + 1) % n];
      if ((a == e.a && b == e.b) || (a == e.b && b == e.a)) return true;
    }
    return false;
  }
  void avoid(Edge const& e)
  {
    if (!plan::enters(region_, e.a, e.b, slack_)) return;
    Polygon best;
    double best_area = 0;
    auto const attempt = [&](Edge const& line) {
      if (plan::left_of(line.a, line.b, e.a) > slack_ || plan::left_of(line.a, line.b, e.b) > slack_) return;
      Polygon rest = plan::clip(region_, line.a, line.b);
      if (double const area = plan::area(rest); area > best_area) best = std::move(rest), best_area = area;
    };
    for (auto const& line : lines_) attempt(line);
    for (Edge const& line : {e, Edge{e.b, e.a}})
      if (keeps_seed(line)) attempt(line);
    region_ = std::move(best);  // a line of the seed or the edge's own always separates the two
  }

  Polygon const& seed_;
  std::vector<Edge> edges_, lines_;
  Polygon region_;
  double slack_ = 0;
};

/// Whether the closed segment meets the open interior of the convex polygon. Exact, by separating lines.
bool meets_interior(Edge const& e, Polygon const& convex)
{
  bool left = false, right = false;
  for (std::size_t i = 0, n = convex.size(); i < n; ++i) {
    Point2d const &a = convex[i], &b = convex[(i + 1) % n];
    if (!is_positive(orient2d<Filtered>(a, b, e.a)) && !is_positive(orient2d<Filtered>(a, b, e.b))) return false;
    Sign const s = orient2d<Filtered>(e.a, e.b, a);
    left |= is_positive(s);
    right |= is_negative(s);
  }
  return left && right;
}

}  // namespace

plan::Polygon grow(std::span<Polygon const> rings, Polygon const& seed) { return Growth(rings, seed).run(); }

bool lies_inside(std::span<Polygon const> rings, Polygon const& convex)
{
  Point2d const p = plan::mean(convex);
  for (std::size_t i = 0, n = convex.size(); i < n; ++i)
    if (!is_positive(orient2d<Filtered>(convex[i], convex[(i + 1) % n], p))) return false;
  bool odd = false;  // crossings of a ray towards +x from a point infinitesimally right of p and above
  for (auto const& e : edges_of(rings)) {
    if (meets_interior(e, convex)) return false;
    if ((e.a.y > p.y) == (e.b.y > p.y)) continue;
    odd ^= is_positive(e.a.y < e.b.y ? orient2d<Filtered>(e.a, e.b, p) : orient2d<Filtered>(e.b, e.a, p));
  }
  return odd;
}

}  // namespace visibility::detail
