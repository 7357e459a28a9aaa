#pragma once

#include "hard_case.hpp"

namespace visibility::hard_cases {

/// What a method says of a case.
struct Verdict {
  std::string method, arithmetic;
  Guarantee guarantee;                      ///< what its result claims
  std::vector<std::string> missing, extra;  ///< against the truth: false hidden, and overestimated; sorted
  bool is_right() const { return missing.empty() && extra.empty(); }
};

/// What every method that takes the scene says, with every arithmetic that it knows.
std::vector<Verdict> verdicts(HardCase const&);

}  // namespace visibility::hard_cases
