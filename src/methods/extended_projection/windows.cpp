#include "windows.hpp"

#include <algorithm>
#include <cstring>

namespace visibility::extended_projection {

namespace {

/// Depths are never NaN and zero has one sign, so equal bits are equal depths.
bool are_equal(float const* a, float const* b, int n)
{
  return std::memcmp(a, b, static_cast<std::size_t>(n) * sizeof(float)) == 0;
}

void take_farther(float const* depths, int n, float* to)
{
  for (int x = 0; x < n; ++x) to[x] = to[x] < depths[x] ? depths[x] : to[x];
}

/// Maxima over windows of one row.
class RowWindows {
public:
  RowWindows(std::vector<Window> const& windows, int from_width)
    : n_(from_width), width_(static_cast<int>(windows.size())), running_(static_cast<std::size_t>(n_) + 1),
      next_(running_.size())
  {
    int largest = 0;
    reach_ = n_;
    for (auto const& w : windows) {
      if (w.is_empty()) continue;
      reach_ = std::min(reach_, w.size());
      largest = std::max(largest, w.size());
    }
    // Runs of `reach` pixels that make up each window; the sentinel behind the row makes up an empty one.
    runs_ = (largest + reach_ - 1) / reach_;
    for (int k = 0; k < runs_; ++k)
      for (auto const& w : windows)
        starts_.push_back(w.is_empty() ? n_ : std::min(w.first + k * reach_, w.last + 1 - reach_));
  }

  void operator()(float const* row, float* to)
  {
    if (runs_ == 0) return;
    // Double the runs, then lengthen them to `reach`: the run of r pixels at x and the one at x + way.
    std::copy_n(row, n_, running_.data());
    for (int r = 1; r < reach_;) {
      int const way = std::min(r, reach_ - r);
      lengthen(way, n_ - r - way + 1);
      r += way;
    }
    running_[static_cast<std::size_t>(n_)] = DepthMap<float>::empty;
    float const* const running = running_.data();
    int const* start = starts_.data();
    for (int x = 0; x < width_; ++x) to[x] = running[start[x]];
    for (int k = 1; k < runs_; ++k) {
      start += width_;
      for (int x = 0; x < width_; ++x) to[x] = std::max(to[x], running[start[x]]);
    }
  }

private:
  void lengthen(int way, int count)
  {
    float const* const from = running_.data();
    float* const to = next_.data();
    for (int x = 0; x < count; ++x) to[x] = from[x] < from[x + way] ? from[x + way] : from[x];
    running_.swap(next_);
  }

  int n_, width_, reach_, runs_;
  std::vector<int> starts_;  // of run k of the window of column x: at k * width + x
  std::vector<float> running_, next_;
};

}  // namespace

DepthMap<float> farthest_in_windows(DepthMap<float> const& from, std::vector<Window> const& columns,
                                    std::vector<Window> const& rows)
{
  int const n = from.width(), width = static_cast<int>(columns.size()), height = static_cast<int>(rows.size());
  std::vector<char> is_repeated(static_cast<std::size_t>(from.height()));
  for (int y = 1; y < from.height(); ++y)
    is_repeated[static_cast<std::size_t>(y)] = are_equal(from.row(y - 1), from.row(y), n);

  DepthMap<float> out(width, height);
  RowWindows in_row(columns, n);
  // The farthest of a window of rows, and that of the window before.
  std::vector<float> farthest(static_cast<std::size_t>(n)), before(farthest.size(), DepthMap<float>::empty);
  float const* done = nullptr;
  for (int y = 0; y < height; ++y) {
    auto const [first, last] = rows[static_cast<std::size_t>(y)];
    if (last < first) continue;
    std::copy_n(from.row(first), n, farthest.data());
    for (int k = first + 1; k <= last; ++k)
      if (!is_repeated[static_cast<std::size_t>(k)]) take_farther(from.row(k), n, farthest.data());
    float* const to = out.row(y);
    if (!are_equal(farthest.data(), before.data(), n)) {
      in_row(farthest.data(), to);
      done = to;
      farthest.swap(before);
    } else if (done != nullptr) {
      std::copy_n(done, width, to);
    }
  }
  return out;
}

}  // namespace visibility::extended_projection
