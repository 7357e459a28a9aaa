#include "visibility/drawing/explained_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace visibility {

namespace {

using Edge = PortalSequence::Edge;

Point2d operator+(Point2d const& a, Point2d const& b) { return {a.x + b.x, a.y + b.y}; }
Point2d operator-(Point2d const& a, Point2d const& b) { return {a.x - b.x, a.y - b.y}; }
Point2d operator*(double t, Point2d const& a) { return {t * a.x, t * a.y}; }
double cross(Point2d const& a, Point2d const& b) { return a.x * b.y - a.y * b.x; }
double dot(Point2d const& a, Point2d const& b) { return a.x * b.x + a.y * b.y; }
double length(Point2d const& a) { return std::hypot(a.x, a.y); }
Point2d middle(PlanPicture::Segment const& s) { return 0.5 * (s.from + s.to); }

bool reaches_into(PlanPicture::Segment const& s, PlanRegion const& r)
{
  return std::min(s.from.x, s.to.x) <= r.max.x && r.min.x <= std::max(s.from.x, s.to.x) &&
         std::min(s.from.y, s.to.y) <= r.max.y && r.min.y <= std::max(s.from.y, s.to.y);
}

double diagonal(PlanRegion const& r) { return length(r.max - r.min); }

/// Longer than the way from anything shown to beyond the region.
double reach(PlanPicture const& p) { return 2 * diagonal(p.region); }

/// Where the line through a and b crosses the line through c and d; a if they are parallel.
Point2d crossing(Point2d const& a, Point2d const& b, Point2d const& c, Point2d const& d)
{
  double const turn = cross(b - a, d - c);
  return turn == 0 ? a : a + (cross(c - a, d - c) / turn) * (b - a);
}

PlanPicture::Funnel drawn(PlanPicture const& picture, exact_25d::LineSpaceCell const& cell)
{
  PlanPicture::Funnel out;
  double const far = reach(picture);
  Point2d const left = horizontal(cell.exit.left), right = horizontal(cell.exit.right);
  Point2d forward{0, 0};
  struct Ray {
    Point2d at, towards;
  };
  std::vector<Ray> rays;
  for (auto const& [a, b] : cell.bounds) {
    Point2d const d = b - a;
    if (length(d) == 0) continue;
    rays.push_back({crossing(a, b, left, right), (1 / length(d)) * d});
    forward = forward + rays.back().towards;
    Point2d const entry = crossing(a, b, horizontal(cell.entry.left), horizontal(cell.entry.right));
    out.lines.push_back({entry, rays.back().at + far * rays.back().towards});
  }
  if (rays.empty() || length(forward) == 0) return out;
  forward = (1 / length(forward)) * forward;
  constexpr double steepest = 0.1;  // cosine: lines across the funnel's direction bound no simple shape
  if (std::ranges::any_of(rays, [&](Ray const& r) { return dot(r.towards, forward) < steepest; })) return out;

  // At a distance along `forward` the lines through the funnel reach from the least to the greatest offset of its
  // bounds.
  Point2d const aside{-forward.y, forward.x}, start = 0.5 * (left + right);
  auto const offset = [&](Ray const& r, double distance) {
    double const t = (distance - dot(r.at - start, forward)) / dot(r.towards, forward);
    return dot(r.at + t * r.towards - start, aside);
  };
  double first = 0;
  for (auto const& r : rays) first = std::max(first, dot(r.at - start, forward));
  auto const [rightmost, leftmost] =
    std::ranges::minmax(rays, {}, [&](Ray const& r) { return dot(r.at - start, aside); });
  std::vector<Point2d> low{rightmost.at}, high{leftmost.at};
  constexpr int steps = 64;  // geometric: most happens near the cell
  for (int i = 0; i <= steps; ++i) {
    double const distance = first + far * (std::pow(2, 10.0 * i / steps) - 1) / 1023;
    auto const [least, most] = std::ranges::minmax(rays, {}, [&](Ray const& r) { return offset(r, distance); });
    low.push_back(start + distance * forward + offset(least, distance) * aside);
    high.push_back(start + distance * forward + offset(most, distance) * aside);
  }
  out.area = low;
  out.area.insert(out.area.end(), high.rbegin(), high.rend());
  return out;
}

/// What the curtain below the edge hides of the ground from a point.
std::vector<Point2d> shadow(Point3d const& from, Edge const& edge, double ground, double far)
{
  // Beyond `far` a shadow has no end in the picture; so is that of an edge at least as high as the eye.
  auto const thrown = [&](Point3d const& top) {
    Point2d const way = horizontal(top) - horizontal(from);
    double const fall = from.z - top.z, beyond = (top.z - ground) / fall;
    double const most = length(way) > 0 ? far / length(way) : 0;
    return horizontal(top) + (fall > 0 && beyond < most ? beyond : most) * way;
  };
  return {horizontal(edge.left), horizontal(edge.right), thrown(edge.right), thrown(edge.left)};
}

/// Positions of the n elements with the least keys, in order of the keys; equal keys in order of position.
template <class Key>
std::vector<std::size_t> first_by(std::size_t size, std::size_t n, Key&& key)
{
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, key);
  order.resize(std::min(n, size));
  return order;
}

}  // namespace

void add_explanation(PlanPicture& picture, exact_25d::Explanation const& explanation, ExplanationShown const& shown)
{
  for (auto const& e : explanation.edges) {
    Point2d const left = horizontal(e.edge.left), way = horizontal(e.edge.right) - left;
    for (auto const& part : e.parts) {
      PlanPicture::Segment const at{left + approximate(part.low) * way, left + approximate(part.high) * way};
      if (reaches_into(at, picture.region)) picture.edge_parts.push_back({at, e.sees_top});
    }
  }
  for (auto const i : first_by(explanation.cells.size(), shown.funnels, [&](std::size_t k) {
         return -static_cast<double>(explanation.cells[k].occluders.size());
       }))
    picture.funnels.push_back(drawn(picture, explanation.cells[i]));

  auto const gap = [&](std::size_t k) {
    auto const& [source, occluder] = explanation.shadows[k];
    return length(middle({horizontal(source.left), horizontal(source.right)}) -
                  middle({horizontal(occluder.left), horizontal(occluder.right)}));
  };
  for (auto const i : first_by(explanation.shadows.size(), shown.shadows, gap))
    for (auto const& end : {explanation.shadows[i].source.left, explanation.shadows[i].source.right})
      picture.shadows.push_back(shadow(end, explanation.shadows[i].occluder, shown.ground, reach(picture)));
}

}  // namespace visibility
