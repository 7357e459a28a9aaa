#pragma once

#include "canvas.hpp"

#include <cairo.h>

#include <memory>

namespace visibility::detail::drawing {

/// An image in memory, through cairo.
class PngCanvas : public Canvas {
public:
  PngCanvas(int width, int height);
  void begin_group(std::string const& id, std::optional<std::size_t> objects,
                   std::optional<Rectangle> const& clip) override;
  void end_group() override;
  using Canvas::draw;
  void draw(Path const& path, Paint const& paint, std::string const& name) override;
  void write(Point2d const& at, std::string const& text, TextStyle const& style) override;
  /// The file's bytes. Throws BadInput if cairo failed anywhere.
  std::string finish();

private:
  struct Free {
    void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
    void operator()(cairo_t* c) const { cairo_destroy(c); }
  };
  void set_source(Fill const& fill);

  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> cairo_;
};

}  // namespace visibility::detail::drawing
