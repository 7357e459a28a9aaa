#include "paint_picture.hpp"

#include "labels.hpp"
#include "palette.hpp"
#include "pixel_path.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace visibility::detail::drawing {

namespace {

/// Objects of one role up to this many are drawn one by one, with names; more as a few paths.
constexpr std::size_t one_by_one = 2000;
constexpr double sight_line_end_radius = 2;

constexpr std::array<char const*, plan_roles> group_ids{"occluders", "hidden",     "visible",
                                                        "touching",  "only-first", "only-second"};

void paint_objects(Canvas& canvas, PlanPicture const& picture, PixelMap const& map, PlanRole role)
{
  bool const background = role == PlanRole::hidden || role == PlanRole::occluder;
  auto const is_of_role = [&](auto const& o) { return o.role == role; };
  auto const n = static_cast<std::size_t>(std::ranges::count_if(picture.objects, is_of_role));
  if (n == 0) return;
  Paint paint = palette::paint_of(role);
  canvas.begin_group(group_ids[static_cast<std::size_t>(role)], n, map.frame());
  if (n <= one_by_one) {
    for (auto const& o : picture.objects)
      if (is_of_role(o)) canvas.draw(pixel_path(o.outline, map, {0.02, background ? 1.0 : 2.5}), paint, o.name);
  } else {
    Crowd crowd(map, {0.3, 1});
    for (auto const& o : picture.objects)
      if (is_of_role(o)) crowd.add(o.outline);
    paint.stroke->width = background ? 0.2 : 0.4;
    for (auto const& path : crowd.paths()) canvas.draw(path, paint);
  }
  canvas.end_group();
}

void paint_shadows(Canvas& canvas, PlanPicture const& picture, PixelMap const& map)
{
  if (picture.shadows.empty()) return;
  canvas.begin_group("shadows", {}, map.frame());
  for (auto const& s : picture.shadows)
    canvas.draw(pixel_path(s, map), {palette::shadow_area, palette::shadow_outline});
  canvas.end_group();
}

void paint_funnels(Canvas& canvas, PlanPicture const& picture, PixelMap const& map)
{
  if (picture.funnels.empty()) return;
  canvas.begin_group("funnels", {}, map.frame());
  for (auto const& f : picture.funnels) {
    canvas.draw(pixel_path(f.area, map), {palette::funnel_area, {}});
    for (auto const& l : f.lines) canvas.draw(pixel_path(l, map), {{}, palette::funnel_line});
  }
  canvas.end_group();
}

/// All casings under all cores, so that chains of edges join.
void paint_edges(Canvas& canvas, PlanPicture const& picture, PixelMap const& map)
{
  if (picture.edge_parts.empty()) return;
  canvas.begin_group("edges", {}, map.frame());
  for (auto const& e : picture.edge_parts) canvas.draw(pixel_path(e.at, map), {{}, palette::edge_casing});
  for (auto const& e : picture.edge_parts)
    canvas.draw(pixel_path(e.at, map), {{}, e.sees_top ? palette::seen_top : palette::seen_wall});
  canvas.end_group();
}

void paint_sight_lines(Canvas& canvas, PlanPicture const& picture, PixelMap const& map)
{
  if (picture.sight_lines.empty()) return;
  canvas.begin_group("sight-lines", {}, map.frame());
  Path lines, ends;
  for (auto const& s : picture.sight_lines) {
    Path line = pixel_path(s, map);
    std::ranges::move(line.lines, std::back_inserter(lines.lines));
    auto const& f = map.frame();
    Point2d const end = map(s.to);
    if (end.x >= f.x && end.x <= f.x + f.width && end.y >= f.y && end.y <= f.y + f.height)
      ends.discs.push_back({end, sight_line_end_radius});
  }
  canvas.draw(lines, {{}, palette::sight_line});
  canvas.draw(ends, {palette::sight_line_end, palette::sight_line});
  canvas.end_group();
}

void paint_plan(Canvas& canvas, PlanPicture const& picture, PixelMap const& map, PictureStyle const& style)
{
  canvas.draw(map.frame(), {Fill{palette::white}, {}});
  for (auto const role : {PlanRole::hidden, PlanRole::occluder}) paint_objects(canvas, picture, map, role);
  paint_shadows(canvas, picture, map);
  paint_funnels(canvas, picture, map);
  auto const outline_of_cell = [&](char const* id, Paint const& paint) {
    canvas.begin_group(id, {}, map.frame());
    canvas.draw(pixel_path(PlanOutline{{picture.cell}, {}}, map, {0, 5}), paint, "view cell");
    canvas.end_group();
  };
  outline_of_cell("cell", {palette::cell_fill, {}});
  for (auto const role : {PlanRole::visible, PlanRole::touching, PlanRole::only_first, PlanRole::only_second})
    paint_objects(canvas, picture, map, role);
  paint_edges(canvas, picture, map);
  paint_sight_lines(canvas, picture, map);
  outline_of_cell("cell-outline", {{}, palette::cell_outline});
  if (auto const labels = place_labels(picture, map, style.labels); !labels.empty()) {
    canvas.begin_group("labels", {}, map.frame());
    for (auto const& l : labels) canvas.write(l.at, l.text, label_style);
    canvas.end_group();
  }
  canvas.draw(map.frame(), {{}, Stroke{palette::black, 1}});
}

void paint_sample(Canvas& canvas, LegendEntry const& e)
{
  double const y = e.at.y + sample_height / 2;
  Path const line{{{{{e.at.x, y}, {e.at.x + sample_width, y}}, false}}, {}};
  switch (e.sample) {
  case LegendEntry::Sample::area: canvas.draw(Rectangle{e.at.x, e.at.y, sample_width, sample_height}, e.paint); return;
  case LegendEntry::Sample::cased_line: canvas.draw(line, {{}, palette::edge_casing}); break;
  case LegendEntry::Sample::line:
  case LegendEntry::Sample::sight_line: break;
  }
  canvas.draw(line, e.paint);
  if (e.sample == LegendEntry::Sample::sight_line)
    canvas.draw({{}, {{{e.at.x + sample_width, y}, sight_line_end_radius}}},
                {palette::sight_line_end, palette::sight_line});
}

void paint_legend(Canvas& canvas, PictureLayout const& layout)
{
  canvas.begin_group("legend", {}, {});
  for (auto const& e : layout.legend) {
    paint_sample(canvas, e);
    canvas.write({e.at.x + sample_width + 7, e.at.y + sample_height - 1.5}, e.text, text_style);
  }
  auto const [x, y] = layout.scale_bar;
  double const end = x + layout.scale_pixels;
  canvas.draw(
    Path{{{{{x, y - 4}, {x, y + 4}}, false}, {{{x, y}, {end, y}}, false}, {{{end, y - 4}, {end, y + 4}}, false}}, {}},
    {{}, Stroke{palette::black, 1.5}});
  std::ostringstream metres;
  metres << layout.scale_metres << " m";
  canvas.write({end + 7, y + 4.5}, metres.str(), text_style);
  canvas.end_group();
}

}  // namespace

void paint(Canvas& canvas, PlanPicture const& picture, PictureLayout const& layout, PictureStyle const& style)
{
  canvas.draw(Rectangle{0, 0, static_cast<double>(layout.width), static_cast<double>(layout.height)},
              {Fill{palette::white}, {}});
  double const ems = layout.frame.width / title_style.size;
  canvas.write(layout.title, shortened(clean_text(picture.title), ems / 1.1), title_style);
  canvas.write(layout.subtitle, shortened(clean_text(picture.subtitle), layout.frame.width / text_style.size),
               text_style);
  paint_plan(canvas, picture, PixelMap(picture.region, layout.frame), style);
  paint_legend(canvas, layout);
}

}  // namespace visibility::detail::drawing
