#include "png_canvas.hpp"

#include "text.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <numbers>

namespace visibility::detail::drawing {

namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

void set_colour(cairo_t* c, Colour const& colour, double opacity = 1)
{
  cairo_set_source_rgba(c, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, opacity);
}

void trace(cairo_t* c, Path const& path)
{
  cairo_new_path(c);
  for (auto const& line : path.lines) {
    cairo_new_sub_path(c);
    for (auto const& p : line.points) cairo_line_to(c, p.x, p.y);
    if (line.closed) cairo_close_path(c);
  }
  for (auto const& d : path.discs) {
    cairo_new_sub_path(c);
    cairo_arc_negative(c, d.centre.x, d.centre.y, d.radius, 0, -whole_turn);  // the way of counterclockwise rings
    cairo_close_path(c);
  }
}

/// One tile, 6 by 6 pixels, of a hatched fill.
cairo_surface_t* tile(Fill const& fill)
{
  auto* const surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, 6, 6);
  auto* const c = cairo_create(surface);
  set_colour(c, fill.colour);
  cairo_paint(c);
  set_colour(c, fill.hatch_colour);
  cairo_set_line_width(c, 1.3);
  if (fill.hatch == Hatch::dots) {
    for (double const at : {1.5, 4.5}) {
      cairo_arc(c, at, at, 0.8, 0, whole_turn);
      cairo_fill(c);
    }
  } else {
    for (double const shift : {-6.0, 0.0, 6.0}) {
      bool const rising = fill.hatch == Hatch::rising;
      cairo_move_to(c, shift - 1, rising ? 7 : -1);
      cairo_line_to(c, shift + 7, rising ? -1 : 7);
      cairo_stroke(c);
    }
  }
  cairo_destroy(c);
  return surface;
}

cairo_status_t append(void* text, unsigned char const* data, unsigned length)
{
  static_cast<std::string*>(text)->append(reinterpret_cast<char const*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void require(cairo_status_t status)
{
  if (status != CAIRO_STATUS_SUCCESS)
    throw BadInput(std::string("the picture could not be painted: ") + cairo_status_to_string(status));
}

}  // namespace

PngCanvas::PngCanvas(int width, int height)
  : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)), cairo_(cairo_create(surface_.get()))
{
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
}

void PngCanvas::begin_group(std::string const&, std::optional<std::size_t>, std::optional<Rectangle> const& clip)
{
  cairo_save(cairo_.get());
  if (!clip) return;
  cairo_rectangle(cairo_.get(), clip->x, clip->y, clip->width, clip->height);
  cairo_clip(cairo_.get());
}

void PngCanvas::end_group() { cairo_restore(cairo_.get()); }

void PngCanvas::set_source(Fill const& fill)
{
  if (fill.hatch == Hatch::none) return set_colour(cairo_.get(), fill.colour, fill.opacity);
  auto* const surface = tile(fill);
  cairo_set_source_surface(cairo_.get(), surface, 0, 0);
  cairo_pattern_set_extend(cairo_get_source(cairo_.get()), CAIRO_EXTEND_REPEAT);
  cairo_surface_destroy(surface);  // the pattern keeps it
}

void PngCanvas::draw(Path const& path, Paint const& paint, std::string const&)
{
  if (path.empty()) return;
  trace(cairo_.get(), path);
  if (paint.fill) {
    set_source(*paint.fill);
    cairo_fill_preserve(cairo_.get());
  }
  if (paint.stroke) {
    auto const& s = *paint.stroke;
    set_colour(cairo_.get(), s.colour, s.opacity);
    cairo_set_line_width(cairo_.get(), s.width);
    cairo_set_dash(cairo_.get(), &s.dash, s.dash > 0 ? 1 : 0, 0);
    cairo_stroke_preserve(cairo_.get());
  }
  cairo_new_path(cairo_.get());
}

void PngCanvas::write(Point2d const& at, std::string const& text, TextStyle const& style)
{
  auto* const c = cairo_.get();
  std::string const clean = clean_text(text);
  cairo_select_font_face(c, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(c, style.size);
  cairo_text_extents_t extents{};
  if (style.centred) cairo_text_extents(c, clean.c_str(), &extents);
  cairo_new_path(c);
  cairo_move_to(c, at.x - extents.x_advance / 2, at.y);
  cairo_text_path(c, clean.c_str());
  if (style.halo) {
    set_colour(c, {255, 255, 255});
    cairo_set_line_width(c, 3);
    cairo_set_dash(c, nullptr, 0, 0);
    cairo_stroke_preserve(c);
  }
  set_colour(c, {0, 0, 0});
  cairo_fill(c);
}

std::string PngCanvas::finish()
{
  require(cairo_status(cairo_.get()));
  std::string out;
  require(cairo_surface_write_to_png_stream(surface_.get(), append, &out));
  return out;
}

}  // namespace visibility::detail::drawing
