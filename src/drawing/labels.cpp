#include "labels.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>

namespace visibility::detail::drawing {

namespace {

constexpr std::size_t few = 40;
constexpr double widest = 16;  ///< ems

struct Candidate {
  bool hidden;
  double width, height;  ///< of the bounds, pixels
  Point2d middle;
  std::string const* name;
};

Candidate candidate(PlanPicture::DrawnObject const& o, PixelMap const& map)
{
  double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;
  auto const extend = [&](Point2d const& p, double by) {
    x0 = std::min(x0, p.x - by), x1 = std::max(x1, p.x + by), y0 = std::min(y0, p.y - by), y1 = std::max(y1, p.y + by);
  };
  for (auto const& ring : o.outline.rings)
    for (auto const& p : ring) extend(map(p), 0);
  for (auto const& d : o.outline.discs) extend(map(d.centre), d.radius * map.scale());
  auto const& f = map.frame();  // the middle of the part that is shown
  x0 = std::max(x0, f.x), x1 = std::min(x1, f.x + f.width), y0 = std::max(y0, f.y), y1 = std::min(y1, f.y + f.height);
  bool const hidden = o.role == PlanRole::hidden || o.role == PlanRole::occluder;
  return {hidden, x1 - x0, y1 - y0, {(x0 + x1) / 2, (y0 + y1) / 2}, &o.name};
}

bool overlap(Rectangle const& a, Rectangle const& b)
{
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool inside(Rectangle const& a, Rectangle const& b)
{
  return a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;
}

}  // namespace

std::vector<Label> place_labels(PlanPicture const& picture, PixelMap const& map, PictureLabels wanted)
{
  if (wanted == PictureLabels::off || (wanted == PictureLabels::automatic && picture.objects.size() > few)) return {};
  std::vector<Candidate> candidates;
  for (auto const& o : picture.objects) candidates.push_back(candidate(o, map));
  std::ranges::stable_sort(candidates, [](Candidate const& a, Candidate const& b) {
    return a.hidden != b.hidden ? b.hidden : std::max(a.width, a.height) > std::max(b.width, b.height);
  });
  std::vector<Label> out;
  std::vector<Rectangle> taken;
  for (auto const& c : candidates) {
    std::string const text = shortened(clean_text(*c.name), widest);
    double const width = text_width(text) * label_style.size;
    bool const above = c.width < width && c.height < 2 * label_style.size;  // it would cover the object
    Point2d const at{c.middle.x, above ? c.middle.y - c.height / 2 - 5 : c.middle.y + label_style.size * 0.36};
    Rectangle const box{at.x - width / 2, at.y - label_style.size, width, label_style.size * 1.3};
    if (!inside(box, map.frame()) || std::ranges::any_of(taken, [&](auto const& t) { return overlap(t, box); }))
      continue;
    taken.push_back(box);
    out.push_back({at, text});
  }
  return out;
}

}  // namespace visibility::detail::drawing
