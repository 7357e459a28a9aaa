#include "visibility/raster/depth_map.hpp"

#include "visibility/raster/grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace visibility {

template <class T>
T round_up(double v)
{
  auto const rounded = static_cast<T>(v);
  return rounded < v ? std::nextafter(rounded, std::numeric_limits<T>::infinity()) : rounded;
}

namespace {

/// v moved up so far that rounding it to the nearest float cannot bring it below v - 2^-149, without a comparison (this
/// loop is the hot one): at most two units in the last place too far.
template <class T>
double before_rounding(double v)
{
  if constexpr (std::is_same_v<T, float>) return v + std::fabs(v) * 0x1.00001p-24;
  return v;
}

template <class T>
void write_constant(T* row, int begin, int end, T depth)
{
  for (int x = begin; x < end; ++x) row[x] = depth < row[x] ? depth : row[x];
}

template <class T>
void write_affine(T* row, int begin, int end, double base, double slope)
{
  for (int x = begin; x < end; ++x) {
    auto const depth = static_cast<T>(before_rounding<T>(base + slope * x));
    row[x] = depth < row[x] ? depth : row[x];
  }
}

struct Line {
  double base, slope;
  double operator()(int x) const { return base + slope * x; }
};

std::size_t highest(std::span<Line const> lines, int x)
{
  std::size_t best = 0;
  for (std::size_t k = 1; k < lines.size(); ++k)
    if (lines[k](x) > lines[best](x)) best = k;
  return best;
}

/// The upper envelope of the lines over [begin, end). A line that is highest at both ends is so in between, up to
/// roundings that the margin of the lines covers (proofs/raster.md), so most pixels see one line only.
template <class T>
void write_envelope(T* row, int begin, int end, std::span<Line const> lines, std::size_t at_begin, std::size_t at_last)
{
  if (at_begin == at_last) return write_affine(row, begin, end, lines[at_begin].base, lines[at_begin].slope);
  if (end - begin <= 8) {
    for (int x = begin; x < end; ++x) write_affine(row, x, x + 1, lines[highest(lines, x)](x), 0.0);
    return;
  }
  int const middle = begin + (end - begin) / 2;
  write_envelope(row, begin, middle, lines, at_begin, highest(lines, middle - 1));
  write_envelope(row, middle, end, lines, highest(lines, middle), at_last);
}

}  // namespace

template <class T>
DepthMap<T>::DepthMap(int width, int height) : width_(width), height_(height)
{
  if (width < 1 || height < 1 || width > Grid::max_size || height > Grid::max_size)
    throw std::invalid_argument("DepthMap: width and height must be 1 to 4096 pixels");
  depths_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), empty);
}

template <class T>
void DepthMap<T>::clear()
{
  std::fill(depths_.begin(), depths_.end(), empty);
}

template <class T>
void DepthMap<T>::write(Spans const& spans, PixelDepth const& depth)
{
  if (depth.is_constant()) {
    auto const rounded = round_up<T>(depth.row(0));
    for (auto const& s : spans) write_constant(row(s.row), s.begin, s.end, rounded);
    return;
  }
  for (auto const& s : spans) write_affine(row(s.row), s.begin, s.end, depth.row(s.row), depth.slope());
}

template <class T>
void DepthMap<T>::write(Spans const& spans, std::span<PixelDepth const> depths)
{
  if (depths.empty()) return;
  if (depths.size() == 1) return write(spans, depths[0]);
  double magnitude = 0;
  for (auto const& d : depths) magnitude = std::max(magnitude, d.magnitude());
  std::vector<PixelDepth> raised;
  for (auto const& d : depths) raised.push_back(d.farther(16 * 0x1p-53 * magnitude + 0x1p-149));
  std::vector<Line> lines(depths.size());
  for (auto const& s : spans) {
    for (std::size_t k = 0; k < lines.size(); ++k) lines[k] = {raised[k].row(s.row), raised[k].slope()};
    write_envelope<T>(row(s.row), s.begin, s.end, lines, highest(lines, s.begin), highest(lines, s.end - 1));
  }
}

template float round_up<float>(double);
template double round_up<double>(double);
template class DepthMap<float>;
template class DepthMap<double>;

}  // namespace visibility
