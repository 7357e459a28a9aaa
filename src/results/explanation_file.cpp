#include "visibility/methods/exact_25d/explanation_file.hpp"

#include "result_json.hpp"

#include <cmath>

namespace visibility::exact_25d {

namespace {

using visibility::detail::Json;
using visibility::detail::to_json;

Json to_json(Point2d const& p) { return {p.x, p.y}; }
Json to_json(PortalSequence::Edge const& e) { return {to_json(e.left), to_json(e.right)}; }

std::string fraction(RationalNumber const& x)
{
  std::ostringstream out;
  out << x;
  return out.str();
}

/// The same as a + b sqrt(d): ["a", "b", "d"], or ["a"] if it is rational.
Json exact_json(Position const& x)
{
  RationalNumber const a = x.p / x.r, b = x.q / x.r;
  if (b == 0 || x.d == 0) return {fraction(a)};
  return {fraction(a), fraction(b), fraction(x.d)};
}

Json edge_json(Scene const& scene, VisibleEdge const& e)
{
  Json parts = Json::array(), exact = Json::array();
  for (auto const& p : e.parts) {
    parts.push_back({approximate(p.low), approximate(p.high)});
    exact.push_back({exact_json(p.low), exact_json(p.high)});
  }
  return {{"object", scene.objects[e.object].name}, {"left", to_json(e.edge.left)}, {"right", to_json(e.edge.right)},
          {"sees", e.sees_top ? "top" : "wall"},    {"parts", std::move(parts)},    {"exact_parts", std::move(exact)}};
}

Json funnel_json(LineSpaceCell const& c)
{
  Json lines = Json::array(), occluders = Json::array();
  for (auto const& [p, q] : c.bounds) lines.push_back({to_json(p), to_json(q)});
  for (auto const& o : c.occluders) occluders.push_back(to_json(o));
  return {{"entry", to_json(c.entry)},
          {"exit", to_json(c.exit)},
          {"lines", std::move(lines)},
          {"occluders", std::move(occluders)}};
}

Json shadow_json(Shadow const& s)
{
  auto const plane = [](Point3d const& p, Point3d const& q, Point3d const& r) -> Json {
    return {to_json(p), to_json(q), to_json(r)};
  };
  auto const& [source, occluder] = s;
  return {{"source", to_json(source)},
          {"occluder", to_json(occluder)},
          {"planes",
           {plane(source.left, occluder.left, occluder.right), plane(source.right, occluder.left, occluder.right),
            plane(source.left, source.right, occluder.left), plane(source.left, source.right, occluder.right)}}};
}

Json explanation_json(Scene const& scene, ViewCell const& cell, Explanation const& e)
{
  Json outline = Json::array(), edges = Json::array(), funnels = Json::array(), shadows = Json::array();
  for (auto const& v : cell.vertices()) outline.push_back(to_json(v));
  for (auto const& v : e.edges) edges.push_back(edge_json(scene, v));
  for (auto const& c : e.cells) funnels.push_back(funnel_json(c));
  for (auto const& s : e.shadows) shadows.push_back(shadow_json(s));
  return {{"format", "visibility-lines/1"},
          {"scene", {{"source", scene.source}}},
          {"cell", {{"vertices", std::move(outline)}}},
          {"edges", std::move(edges)},
          {"funnels", std::move(funnels)},
          {"shadow_planes", std::move(shadows)}};
}

}  // namespace

std::string to_json(Scene const& scene, std::vector<ViewCell> const& cells,
                    std::vector<Explanation> const& explanations)
{
  if (explanations.size() == 1) return explanation_json(scene, cells[0], explanations[0]).dump() + '\n';
  Json all = Json::array();
  for (std::size_t i = 0; i < explanations.size(); ++i)
    all.push_back(explanation_json(scene, cells[i], explanations[i]));
  return all.dump() + '\n';
}

}  // namespace visibility::exact_25d
