#pragma once

#include "visibility/scene/scene.hpp"

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace visibility {

/// Input that cannot be used; `what()` is one line: what, where (file, line, object), what to do.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Builds a scene object by object and checks each primitive as it arrives.
/// Every `add_*` throws BadInput naming the current object if a coordinate is not finite or a shape is not one
/// (box with min > max, radius < 0, bottom >= top); primitives go to the object begun last.
class SceneBuilder {
public:
  explicit SceneBuilder(std::string source);

  /// Starts an object. A name already taken gets "#2", "#3", ... appended; bytes that are not UTF-8 and control
  /// characters become '?'. Objects that receive no primitive are dropped by `finish` and counted in a note.
  void begin_object(std::string_view name);
  /// The same for an object that is only looked for: it hides nothing.
  void begin_occludee(std::string_view name);

  void add(Box const& box);
  void add(Ball const& ball);
  void add(Prism prism);
  void add(ConvexPolyhedron polyhedron);
  /// Index of a vertex for `add_triangle`; vertices may be shared by triangles of any object.
  std::uint32_t add_vertex(Point3d const& p);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void note(std::string text);

  /// The scene; the builder is empty afterwards. Throws BadInput if no object has a primitive.
  Scene finish();

private:
  [[noreturn]] void fail(std::string const& what) const;
  Object& current();

  Scene scene_;
};

}  // namespace visibility
