#include "visibility/evidence/compare.hpp"

#include <algorithm>
#include <limits>

namespace visibility {

double Comparison::overestimation() const
{
  if (size_b == 0) return size_a == 0 ? 1 : std::numeric_limits<double>::infinity();
  return static_cast<double>(size_a) / static_cast<double>(size_b);
}

double Comparison::recall() const
{
  return size_b == 0 ? 1 : static_cast<double>(common) / static_cast<double>(size_b);
}

Comparison compare(std::span<std::string const> a, std::span<std::string const> b)
{
  auto const as_set = [](std::span<std::string const> names) {
    std::vector<std::string> set(names.begin(), names.end());
    std::ranges::sort(set);
    set.erase(std::unique(set.begin(), set.end()), set.end());
    return set;
  };
  auto const left = as_set(a), right = as_set(b);
  Comparison out;
  out.size_a = left.size();
  out.size_b = right.size();
  std::ranges::set_difference(left, right, std::back_inserter(out.only_a));
  std::ranges::set_difference(right, left, std::back_inserter(out.only_b));
  out.common = left.size() - out.only_a.size();
  return out;
}

}  // namespace visibility
