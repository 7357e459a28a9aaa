#pragma once

#include "canvas.hpp"

#include <map>

namespace visibility::detail::drawing {

/// SVG 1.1 as text, coordinates in hundredths of a pixel.
class SvgCanvas : public Canvas {
public:
  SvgCanvas(int width, int height, std::string const& title);
  void begin_group(std::string const& id, std::optional<std::size_t> objects,
                   std::optional<Rectangle> const& clip) override;
  void end_group() override;
  using Canvas::draw;
  void draw(Path const& path, Paint const& paint, std::string const& name) override;
  void write(Point2d const& at, std::string const& text, TextStyle const& style) override;
  /// The whole document. Call once, at the end.
  std::string finish();

private:
  std::string fill_value(Fill const& fill);

  std::string out_;
  int clips_ = 0;
  std::map<std::string, std::string> hatch_ids_;  ///< by their definition
};

}  // namespace visibility::detail::drawing
