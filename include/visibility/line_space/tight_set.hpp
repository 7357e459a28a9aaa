#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace visibility {

/// A set of positions of half-spaces, those that a ray touches: one word, and more only when there are more than 64.
class TightSet {
public:
  void insert(std::size_t i)
  {
    if (i < 64) {
      low_ |= std::uint64_t{1} << i;
      return;
    }
    std::size_t const w = i / 64 - 1;
    if (w >= high_.size()) high_.resize(w + 1);
    high_[w] |= std::uint64_t{1} << (i % 64);
  }

  bool contains(std::size_t i) const { return (word(i / 64) >> (i % 64) & 1) != 0; }

  bool contains(TightSet const& other) const
  {
    if ((other.low_ & ~low_) != 0) return false;
    for (std::size_t w = 0; w < other.high_.size(); ++w)
      if ((other.high_[w] & ~word(w + 1)) != 0) return false;
    return true;
  }

  int size() const
  {
    int n = std::popcount(low_);
    for (auto const w : high_) n += std::popcount(w);
    return n;
  }
  bool empty() const { return size() == 0; }

  /// {0, ..., n - 1}.
  static TightSet first(std::size_t n)
  {
    TightSet s;
    for (std::size_t i = 0; i < n; ++i) s.insert(i);
    return s;
  }

  friend TightSet operator&(TightSet const& a, TightSet const& b)
  {
    TightSet s;
    s.low_ = a.low_ & b.low_;
    s.high_.resize(std::min(a.high_.size(), b.high_.size()));
    for (std::size_t w = 0; w < s.high_.size(); ++w) s.high_[w] = a.high_[w] & b.high_[w];
    return s;
  }

private:
  std::uint64_t word(std::size_t w) const { return w == 0 ? low_ : w - 1 < high_.size() ? high_[w - 1] : 0; }

  std::uint64_t low_ = 0;
  std::vector<std::uint64_t> high_;
};

}  // namespace visibility
