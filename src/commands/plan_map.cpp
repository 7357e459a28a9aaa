#include "plan_map.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace visibility::commands {

namespace {

/// A grid of characters over a horizontal rectangle.
class Canvas {
public:
  Canvas(Box const& bounds, int columns)
    : bounds_(bounds), columns_(columns), step_((bounds.max.x - bounds.min.x) / columns)
  {
    constexpr int most_rows = 200;
    rows_ = 1 + index(bounds.max.y - bounds.min.y, 2 * step_, most_rows);  // characters are twice as high as wide
    lines_.assign(static_cast<std::size_t>(rows_), std::string(static_cast<std::size_t>(columns), ' '));
  }

  void fill(Box const& b, char c)
  {
    int const x0 = index(b.min.x - bounds_.min.x, step_, columns_),
              x1 = index(b.max.x - bounds_.min.x, step_, columns_);
    int const y0 = index(bounds_.max.y - b.max.y, 2 * step_, rows_),
              y1 = index(bounds_.max.y - b.min.y, 2 * step_, rows_);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) lines_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = c;
  }

  std::string text() const
  {
    std::string out;
    for (auto const& line : lines_) out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    return out;
  }

private:
  /// offset / step within 0 .. n-1; 0 where the quotient of huge coordinates is no number.
  static int index(double offset, double step, int n)
  {
    double const x = offset / step;
    return x > 0 ? static_cast<int>(std::min(x, n - 1.0)) : 0;
  }

  Box bounds_;
  int columns_, rows_ = 1;
  double step_;
  std::vector<std::string> lines_;
};

}  // namespace

std::string plan_map(Scene const& scene, ViewCell const& cell, PotentiallyVisibleSet const& set, int columns)
{
  Box bounds = cell.bounds();
  bounds.extend(bounding_box(scene));
  Canvas canvas(bounds, columns);
  for (auto const& o : scene.objects) canvas.fill(bounding_box(scene, o), '.');
  for (auto const i : set.visible) canvas.fill(bounding_box(scene, scene.objects[i]), '#');
  canvas.fill(cell.bounds(), 'C');
  return canvas.text();
}

}  // namespace visibility::commands
