#include "svg_canvas.hpp"

#include "text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace visibility::detail::drawing {

namespace {

/// A number of hundredths, without zeros at its end.
std::string hundredths(std::int64_t n)
{
  std::string const sign = n < 0 ? "-" : "";
  auto const value = static_cast<std::uint64_t>(n < 0 ? -n : n);
  std::uint64_t const part = value % 100;
  std::string text = sign + std::to_string(value / 100);
  if (part == 0) return text;
  text += part < 10 ? ".0" : ".";
  return text + std::to_string(part % 10 == 0 && part >= 10 ? part / 10 : part);
}

std::int64_t rounded(double x) { return std::llround(x * 100); }
std::string number(double x) { return hundredths(rounded(x)); }

std::string hex(Colour const& c)
{
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out = "#";
  for (unsigned const v : {c.red, c.green, c.blue}) out += {digits[v / 16], digits[v % 16]};
  return out;
}

std::string escaped(std::string const& text)
{
  std::string out;
  for (char const c : clean_text(text)) {
    switch (c) {
    case '&': out += "&amp;"; break;
    case '<': out += "&lt;"; break;
    case '>': out += "&gt;"; break;
    case '"': out += "&quot;"; break;
    default: out += c;
    }
  }
  return out;
}

/// Adds a step to path data in its shortest form; `command` is the one before.
void append_step(std::string& out, char& command, std::int64_t dx, std::int64_t dy)
{
  char const next = dy == 0 ? 'h' : dx == 0 ? 'v' : 'l';
  out += next == command ? ' ' : next;
  command = next;
  if (next != 'v') out += hundredths(dx);
  if (next == 'l') out += ' ';
  if (next != 'h') out += hundredths(dy);
}

/// Path data: absolute starts, relative steps between rounded points, so that no error adds up.
std::string path_data(Path const& path)
{
  std::string out;
  for (auto const& line : path.lines) {
    std::int64_t x = rounded(line.points.front().x), y = rounded(line.points.front().y);
    out += 'M' + hundredths(x) + ' ' + hundredths(y);
    char command = 'M';
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      std::int64_t const to_x = rounded(line.points[i].x), to_y = rounded(line.points[i].y);
      append_step(out, command, to_x - x, to_y - y);
      x = to_x, y = to_y;
    }
    if (line.closed) out += 'z';
  }
  for (auto const& d : path.discs) {
    std::string const r = number(d.radius), twice = hundredths(2 * rounded(d.radius));
    out += 'M' + number(d.centre.x - d.radius) + ' ' + number(d.centre.y) + 'a' + r + ' ' + r + " 0 1 0 " + twice +
           " 0a" + r + ' ' + r + " 0 1 0 -" + twice + " 0z";
  }
  return out;
}

std::string opacity(char const* attribute, double value)
{
  return value < 1 ? std::string(" ") + attribute + "=\"" + number(value) + '"' : "";
}

std::string stroke_attributes(Stroke const& s)
{
  std::string out = " stroke=\"" + hex(s.colour) + "\" stroke-width=\"" + number(s.width) + '"';
  if (s.dash > 0) out += " stroke-dasharray=\"" + number(s.dash) + '"';
  return out + opacity("stroke-opacity", s.opacity);
}

std::string hatch_lines(Fill const& f)
{
  std::string const colour = hex(f.hatch_colour);
  if (f.hatch == Hatch::dots)
    return "<circle cx=\"1.5\" cy=\"1.5\" r=\"0.8\" fill=\"" + colour +
           "\"/><circle cx=\"4.5\" cy=\"4.5\" r=\"0.8\" fill=\"" + colour + "\"/>";
  char const* const data = f.hatch == Hatch::rising ? "M-1 1l2-2M0 6l6-6M5 7l2-2" : "M-1 5l2 2M0 0l6 6M5-1l2 2";
  return std::string("<path d=\"") + data + "\" stroke=\"" + colour + "\" stroke-width=\"1.3\"/>";
}

}  // namespace

SvgCanvas::SvgCanvas(int width, int height, std::string const& title)
{
  std::string const w = std::to_string(width), h = std::to_string(height);
  out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w +
         "\" height=\"" + h + "\" viewBox=\"0 0 " + w + ' ' + h +
         "\" font-family=\"sans-serif\" stroke-linejoin=\"round\">\n<title>" + escaped(title) + "</title>\n";
}

void SvgCanvas::begin_group(std::string const& id, std::optional<std::size_t> objects,
                            std::optional<Rectangle> const& clip)
{
  std::string attributes = " id=\"" + id + '"';
  if (objects) attributes += " data-objects=\"" + std::to_string(*objects) + '"';
  if (clip) {
    std::string const clip_id = "clip" + std::to_string(++clips_);
    out_ += "<clipPath id=\"" + clip_id + "\"><rect x=\"" + number(clip->x) + "\" y=\"" + number(clip->y) +
            "\" width=\"" + number(clip->width) + "\" height=\"" + number(clip->height) + "\"/></clipPath>\n";
    attributes += " clip-path=\"url(#" + clip_id + ")\"";
  }
  out_ += "<g" + attributes + ">\n";
}

void SvgCanvas::end_group() { out_ += "</g>\n"; }

std::string SvgCanvas::fill_value(Fill const& fill)
{
  if (fill.hatch == Hatch::none) return hex(fill.colour);
  std::string const definition =
    "<rect width=\"6\" height=\"6\" fill=\"" + hex(fill.colour) + "\"/>" + hatch_lines(fill);
  auto const [at, is_new] = hatch_ids_.try_emplace(definition);
  if (is_new) at->second = "hatch" + std::to_string(hatch_ids_.size());
  return "url(#" + at->second + ')';
}

void SvgCanvas::draw(Path const& path, Paint const& paint, std::string const& name)
{
  if (path.empty()) return;
  std::string attributes = " fill=\"" + (paint.fill ? fill_value(*paint.fill) : "none") + '"';
  if (paint.fill) attributes += opacity("fill-opacity", paint.fill->opacity);
  if (paint.stroke) attributes += stroke_attributes(*paint.stroke);
  out_ += "<path" + attributes + " d=\"" + path_data(path) + '"';
  out_ += name.empty() ? "/>\n" : "><title>" + escaped(name) + "</title></path>\n";
}

void SvgCanvas::write(Point2d const& at, std::string const& text, TextStyle const& style)
{
  out_ += "<text x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\" font-size=\"" + number(style.size) + '"';
  if (style.bold) out_ += " font-weight=\"bold\"";
  if (style.centred) out_ += " text-anchor=\"middle\"";
  if (style.halo) out_ += " stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"";
  out_ += '>' + escaped(text) + "</text>\n";
}

std::string SvgCanvas::finish()
{
  out_ += "<defs>\n";
  for (auto const& [definition, id] : hatch_ids_)
    out_ += "<pattern id=\"" + id + "\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\">" + definition +
            "</pattern>\n";
  return std::move(out_ += "</defs>\n</svg>\n");
}

}  // namespace visibility::detail::drawing
