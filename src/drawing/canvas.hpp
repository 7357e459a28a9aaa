#pragma once

#include "visibility/kernel/point.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What pictures are painted with; lengths in pixels, x to the right, y down. One painter serves every format.
namespace visibility::detail::drawing {

struct Colour {
  std::uint8_t red, green, blue;
  friend bool operator==(Colour const&, Colour const&) = default;
};

/// Lines over a fill, so that areas differ without colour too.
enum class Hatch : std::uint8_t { none, rising, falling, dots };

struct Fill {
  Colour colour;
  Hatch hatch = Hatch::none;
  Colour hatch_colour{255, 255, 255};
  double opacity = 1;
};

struct Stroke {
  Colour colour;
  double width;
  double dash = 0;  ///< length of dashes and gaps; 0: none
  double opacity = 1;
};

struct Paint {
  std::optional<Fill> fill;
  std::optional<Stroke> stroke;
};

struct Rectangle {
  double x, y, width, height;
};

/// Filled by the nonzero rule.
struct Path {
  struct Line {
    std::vector<Point2d> points;
    bool closed = true;
  };
  struct Disc {
    Point2d centre;
    double radius;
  };
  std::vector<Line> lines;
  std::vector<Disc> discs;
  bool empty() const { return lines.empty() && discs.empty(); }
};

struct TextStyle {
  double size = 13;  ///< of an em
  bool bold = false;
  bool centred = false;
  bool halo = false;  ///< a white rim, for text over a drawing
};

class Canvas {
public:
  virtual ~Canvas() = default;
  /// Everything until `end_group` belongs to one thing, and is cut off outside `clip` if that is given.
  /// `objects`: how many objects the group shows; for readers of the file.
  virtual void begin_group(std::string const& id, std::optional<std::size_t> objects,
                           std::optional<Rectangle> const& clip) = 0;
  virtual void end_group() = 0;
  /// `name`: of what the path stands for; may be empty.
  virtual void draw(Path const& path, Paint const& paint, std::string const& name) = 0;
  /// `at`: the start, or middle, of the baseline.
  virtual void write(Point2d const& at, std::string const& text, TextStyle const& style) = 0;

  void draw(Path const& path, Paint const& paint) { draw(path, paint, {}); }
  void draw(Rectangle const& r, Paint const& paint)
  {
    draw(Path{{{{{r.x, r.y}, {r.x + r.width, r.y}, {r.x + r.width, r.y + r.height}, {r.x, r.y + r.height}}}}, {}},
         paint, {});
  }
};

}  // namespace visibility::detail::drawing
