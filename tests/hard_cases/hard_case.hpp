#pragma once

#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/scene_builder.hpp"
#include "visibility/scene/view_cell.hpp"

#include <string>
#include <vector>

/// Scenes that break implementations of visibility, each with its truth, derived by hand. docs/hard-cases.md lists them
/// with what every method says.
namespace visibility::hard_cases {

/// A free sight line, found by hand.
struct SightLine {
  std::string object;
  Point3q from, to;
};

struct HardCase {
  std::string kind, name;
  std::string why;  ///< what is true, and the argument
  Scene scene;
  ViewCell cell;
  std::vector<std::string> visible;         ///< the truth: names of all visible objects
  std::vector<SightLine> sight_lines = {};  ///< where the argument is a line
  bool is_height_field = true;              ///< whether nobody looks below an upper surface
};

/// Builds the scene of a case, an object at a time.
class Stage {
public:
  Stage& box(std::string const& name, Box const& b);
  /// A box on the ground, z = 0.
  Stage& box(std::string const& name, Point2d const& low, Point2d const& high, double top);
  /// A prism on the ground.
  Stage& prism(std::string const& name, std::vector<Point2d> ring, double top);
  /// A vertical quadrilateral of two triangles below the segment pq, down to `bottom`.
  Stage& curtain(std::string const& name, Point3d const& p, Point3d const& q, double bottom = 0);
  Stage& triangle(std::string const& name, Point3d const& p, Point3d const& q, Point3d const& r);
  Stage& ball(std::string const& name, Ball const& b);
  Scene scene() { return builder_.finish(); }

private:
  void begin(std::string const& name);  // stays with the object that was begun last under this name

  SceneBuilder builder_{"hard case"};
  std::string last_;
};

inline double above(double x) { return std::nextafter(x, HUGE_VAL); }
inline double below(double x) { return std::nextafter(x, -HUGE_VAL); }
/// The exact middle of two numbers, for which there may be no double.
inline RationalNumber middle(double a, double b) { return (RationalNumber(a) + RationalNumber(b)) / 2; }

using Cases = std::vector<HardCase>;

Cases grazing();      ///< sight lines that only touch
Cases abutting();     ///< occluders that share boundaries
Cases collinear();    ///< corners on one line
Cases coincident();   ///< faces and bodies that coincide, nest, lie in one plane
Cases slits();        ///< openings one unit in the last place wide
Cases cyclic();       ///< occluders without an order
Cases far_offsets();  ///< small detail at coordinates of 10^6 to 10^8
Cases extreme();      ///< subnormal and huge coordinates
Cases slivers();      ///< bodies without thickness, or next to none
Cases heights();      ///< equal heights
Cases cells();        ///< view cells that touch, overlook, are thin or pointed
Cases slanting();     ///< events that three slanting edges decide
Cases reguli();       ///< whole families of lines that touch all edges
Cases small();        ///< next to nothing in the scene

/// All of them.
Cases all();

}  // namespace visibility::hard_cases
