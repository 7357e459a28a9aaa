#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace visibility {

/// Two sets of object names side by side; names as a set, doubles count once.
struct Comparison {
  std::size_t size_a = 0, size_b = 0, common = 0;
  std::vector<std::string> only_a, only_b;  ///< sorted

  bool equal() const { return only_a.empty() && only_b.empty(); }
  /// |A| / |B|: the overestimation of a conservative A against an exact B. 1 if both are empty, infinite if only B is.
  double overestimation() const;
  /// |A and B| / |B|: the recall of an aggressive A against an exact B. 1 if B is empty.
  double recall() const;
};

Comparison compare(std::span<std::string const> a, std::span<std::string const> b);

}  // namespace visibility
