#include "visibility/scene/grounded.hpp"

#include "polygon_sides.hpp"
#include "upper_boundary.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <charconv>

namespace visibility {

namespace {

using height_field::same_in_plan;

std::string shortest(double x)
{
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// Carries primitives down to the ground, one object after another.
class Grounding {
public:
  explicit Grounding(Scene const& scene) : scene_(scene), builder_(scene.source), ground_(bounding_box(scene).min.z) {}

  Scene run()
  {
    for (auto const& n : scene_.notes) builder_.note(n);
    for (auto const& o : scene_.objects) {
      if (!o.occludes) throw BadInput("object '" + o.name + "' hides nothing: ground the scene before it comes in");
      builder_.begin_object(o.name);
      for (auto i = o.boxes.first; i < o.boxes.last; ++i) add(scene_.boxes[i]);
      for (auto i = o.balls.first; i < o.balls.last; ++i) builder_.add(scene_.balls[i]);
      for (auto i = o.prisms.first; i < o.prisms.last; ++i) add(scene_.prisms[i]);
      for (auto i = o.polyhedra.first; i < o.polyhedra.last; ++i) add(scene_.polyhedra[i]);
      for (auto i = o.triangles.first; i < o.triangles.last; ++i) add(scene_.triangle(i));
    }
    builder_.note("grounded: everything below an upper surface is solid down to height " + shortest(ground_));
    if (!scene_.balls.empty()) builder_.note("grounded: balls stay as they are");
    if (invalid_ > 0)
      builder_.note("grounded: " + std::to_string(invalid_) + " prisms with an invalid footprint became their walls");
    return builder_.finish();
  }

private:
  Point3d foot(Point3d const& p) const { return {p.x, p.y, ground_}; }

  void add(Box box)
  {
    box.min.z = ground_;
    builder_.add(box);
  }

  void add(Prism prism)
  {
    if (convex_partition(prism).empty()) {
      ++invalid_;
      for (auto const& ring : prism.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
          auto const &p = ring[i], &q = ring[(i + 1) % ring.size()];
          add_curtain({p.x, p.y, prism.top}, {q.x, q.y, prism.top});
        }
      return;
    }
    prism.bottom = ground_;
    builder_.add(std::move(prism));
  }

  /// What lies below the upper surface of a convex solid is the hull of its vertices and of their feet.
  void add(ConvexPolyhedron const& polyhedron)
  {
    auto points = polyhedron.vertices;
    for (auto const& p : polyhedron.vertices)
      if (p.z != ground_) points.push_back(foot(p));
    builder_.add(ConvexPolyhedron::hull(points));
  }

  void add(Triangle const& t)
  {
    auto const& [a, b, c] = t.vertices;
    bool const on_ground = a.z == ground_ && b.z == ground_ && c.z == ground_;
    Sign const turn = orient2d<Filtered>(horizontal(a), horizontal(b), horizontal(c));
    if (on_ground)
      add_triangle(a, b, c);
    else if (is_zero(turn))
      add_vertical(t.vertices);
    else
      builder_.add(is_positive(turn) ? column({a, b, c}) : column({a, c, b}));
  }

  /// The solid between a triangle, counterclockwise in plan, and the ground, which its corners may touch.
  ConvexPolyhedron column(std::array<Point3d, 3> const& top) const
  {
    using Index = ConvexPolyhedron::Index;
    std::vector<Point3d> vertices(top.begin(), top.end());
    std::array<Index, 3> below;
    for (Index i = 0; i < 3; ++i) {
      below[i] = top[i].z == ground_ ? i : static_cast<Index>(vertices.size());
      if (below[i] != i) vertices.push_back(foot(top[i]));
    }
    std::vector<std::array<Index, 3>> facets{{0, 1, 2}, {below[2], below[1], below[0]}};
    for (Index i = 0; i < 3; ++i) {
      Index const j = (i + 1) % 3;
      if (below[j] != j) facets.push_back({i, below[j], j});
      if (below[i] != i) facets.push_back({i, below[i], below[j]});
    }
    return ConvexPolyhedron::from_facets(std::move(vertices), facets);
  }

  void add_vertical(std::array<Point3d, 3> const& p)
  {
    auto const boundary = upper_boundary(p);
    if (boundary.empty()) return add_triangle(p[0], p[1], p[2]);
    for (std::size_t i = 1; i < boundary.size(); ++i) add_curtain(boundary[i - 1], boundary[i]);
  }

  void add_curtain(Point3d const& a, Point3d const& b)
  {
    if (same_in_plan(a, b)) return;
    if (a.z != ground_) add_triangle(a, foot(a), foot(b));
    if (b.z != ground_) add_triangle(a, foot(b), b);
    if (a.z == ground_ && b.z == ground_) add_triangle(a, b, b);
  }

  void add_triangle(Point3d const& a, Point3d const& b, Point3d const& c)
  {
    auto const first = builder_.add_vertex(a);
    builder_.add_vertex(b);
    builder_.add_vertex(c);
    builder_.add_triangle(first, first + 1, first + 2);
  }

  Scene const& scene_;
  SceneBuilder builder_;
  double ground_;
  std::size_t invalid_ = 0;
};

}  // namespace

Scene grounded(Scene const& scene) { return Grounding(scene).run(); }

}  // namespace visibility
