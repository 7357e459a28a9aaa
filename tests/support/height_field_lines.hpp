#pragma once

#include "support/height_field_slice.hpp"

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

/// Convex sets of directed lines of the plane, and signs of quadratic forms on them.
namespace visibility::oracle::detail {

/// The cone over a convex polygon of the space of lines: rays in cyclic order, facets[i] holds rays i and i + 1.
struct Cone {
  std::vector<Vector> rays, facets;
};

/// The eight cones into which the signs of the coordinates divide all lines.
std::vector<Cone> all_lines();
/// The parts of the cone on which dot(point, line) <= 0 and >= 0. Requires: both signs occur.
std::pair<Cone, Cone> split(Cone const& cone, Vector const& point);
/// A line of the cone's interior, about the middle.
Vector inner_line(std::span<Vector const> rays);

/// The signs that a linear form takes on the rays of a cone.
struct Signs {
  bool negative = false, positive = false;
  bool both() const { return negative && positive; }
};
Signs signs(Vector const& linear, std::span<Vector const> rays);

/// A symmetric matrix.
struct Form {
  NT xx, xy, xz, yy, yz, zz;
};
NT value(Form const& form, Vector const& line);

/// What posts are as functions of the line, and the forms made of them, each computed once.
class Posts {
public:
  explicit Posts(Plan const& plan) : plan_(plan) {}

  /// Linear in the line, positive iff it meets stop `a` before stop `b`.
  static Vector order(Plan const& plan, Stop a, Stop b);
  /// Positive iff the segment from post p to post s passes above post q. Requires: the line meets p, q, s in this order
  /// (p = q or q = s allowed), as their stops say.
  Form const& above(Post const& p, Post const& q, Post const& s);

private:
  struct Functions {
    Vector crossing, height;  ///< the plan point is cross(line, crossing), its height dot(line, height) / z of that
  };
  Functions functions(Post const& post) const;

  Plan const& plan_;
  std::unordered_map<std::uint64_t, Form> forms_;
};

/// Whether all forms are positive at one line of the cone over the rays: such a line, in the interior; or proof that
/// there is none; or neither, where the positive sets are thinner than the subdivision.
struct Decision {
  std::optional<Vector> line;
  bool decided = true;
};
Decision all_positive(std::vector<Form const*> const& forms, std::vector<Vector> const& rays);

/// Whether some form is nowhere positive on the cone, by its coefficients in the rays.
bool nowhere_positive(Form const& form, std::span<Vector const> rays);

}  // namespace visibility::oracle::detail
