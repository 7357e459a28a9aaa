#include "picture_layout.hpp"

#include "palette.hpp"
#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace visibility::detail::drawing {

namespace {

constexpr double margin = 14, line_height = 20, gap = 7;
constexpr double widest_bar = 0.25;  ///< of the frame

using Sample = LegendEntry::Sample;

std::vector<LegendEntry> legend(PlanPicture const& p)
{
  bool const two_sets =
    p.objects_of[std::size_t(PlanRole::only_first)] + p.objects_of[std::size_t(PlanRole::only_second)] > 0;
  std::array<char const*, plan_roles> const names{"occluders",
                                                  two_sets ? "hidden in both" : "hidden",
                                                  two_sets ? "visible in both" : "visible",
                                                  "visible: in or at the cell",
                                                  "only in A",
                                                  "only in B"};
  std::vector<LegendEntry> out;
  out.push_back({Sample::area, {palette::cell_fill, palette::cell_outline}, "view cell"});
  for (auto const role : {PlanRole::touching, PlanRole::visible, PlanRole::only_first, PlanRole::only_second,
                          PlanRole::hidden, PlanRole::occluder}) {
    std::size_t const n = p.objects_of[static_cast<std::size_t>(role)];
    if (n > 0)
      out.push_back({Sample::area, palette::paint_of(role), std::string(names[std::size_t(role)]) + ": " + grouped(n)});
  }
  auto const line = [&](Sample sample, Stroke const& stroke, std::string const& text) {
    out.push_back({sample, {{}, stroke}, text});
  };
  if (!p.sight_lines.empty())
    line(Sample::sight_line, palette::sight_line, "sight lines: " + grouped(p.sight_lines.size()));
  auto const tops = static_cast<std::size_t>(std::ranges::count(p.edge_parts, true, &PlanPicture::EdgePart::sees_top));
  if (tops < p.edge_parts.size())
    line(Sample::cased_line, palette::seen_wall, "edges seen, with their wall: " + grouped(p.edge_parts.size() - tops));
  if (tops > 0) line(Sample::cased_line, palette::seen_top, "edges seen, with their top: " + grouped(tops));
  if (!p.funnels.empty())
    out.push_back(
      {Sample::area, {palette::funnel_area, palette::funnel_line}, "funnels: " + grouped(p.funnels.size())});
  if (!p.shadows.empty())
    out.push_back({Sample::area,
                   {palette::shadow_area, palette::shadow_outline},
                   "shadows from ends of the cell's sides: " + grouped(p.shadows.size())});
  return out;
}

/// Places the entries in as many columns as fit; returns the height used.
double place(std::vector<LegendEntry>& entries, double x, double y, double width)
{
  double widest = 0;
  for (auto& e : entries) {
    e.text = shortened(e.text, (width - sample_width - gap) / text_style.size);
    widest = std::max(widest, text_width(e.text));
  }
  double const column = sample_width + gap + widest * text_style.size + 2 * gap;
  auto const columns = std::max<std::size_t>(1, static_cast<std::size_t>((width + 2 * gap) / column));
  for (std::size_t i = 0; i < entries.size(); ++i)
    entries[i].at = {x + static_cast<double>(i % columns) * column, y + static_cast<double>(i / columns) * line_height};
  return static_cast<double>((entries.size() + columns - 1) / columns) * line_height;
}

/// The largest of 1, 2, 5 times a power of ten that is no longer.
double round_length(double longest)
{
  double const power = std::pow(10, std::floor(std::log10(longest)));
  for (double const factor : {5.0, 2.0})
    if (factor * power <= longest) return factor * power;
  return power;
}

}  // namespace

PictureLayout picture_layout(PlanPicture const& picture, PictureStyle const& style)
{
  if (style.size < 200 || style.size > 20000)
    throw std::invalid_argument("a picture's size is 200 to 20000 pixels, not " + std::to_string(style.size));
  PictureLayout out{};
  out.width = style.size;
  double const inner = style.size - 2 * margin;
  double y = margin;
  out.title = {margin, y += title_style.size};
  out.subtitle = {margin, y += line_height};
  y += margin - 2;
  auto const& r = picture.region;
  out.frame = {margin, y, inner, std::round(inner * ((r.max.y - r.min.y) / (r.max.x - r.min.x)))};
  y += out.frame.height + margin;

  double const pixels_per_metre = inner / (r.max.x - r.min.x);
  out.scale_metres = round_length(widest_bar * (r.max.x - r.min.x));
  out.scale_pixels = out.scale_metres * pixels_per_metre;
  out.scale_bar = {margin, y + 6};
  y += line_height;

  out.legend = legend(picture);
  y += place(out.legend, margin, y, inner);
  out.height = static_cast<int>(std::ceil(y + margin / 2));
  return out;
}

}  // namespace visibility::detail::drawing
