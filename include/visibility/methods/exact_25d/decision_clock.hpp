#pragma once

#include "visibility/kernel/processor_seconds.hpp"

namespace visibility::exact_25d {

/// Adds the processor time of this thread during its life, in seconds, to a total; none if there is no total.
class DecisionClock {
public:
  explicit DecisionClock(double* total) : total_(total), start_(total != nullptr ? thread_seconds() : 0) {}
  ~DecisionClock()
  {
    if (total_ != nullptr) *total_ += thread_seconds() - start_;
  }
  DecisionClock(DecisionClock const&) = delete;
  DecisionClock& operator=(DecisionClock const&) = delete;

private:
  double* total_;
  double start_;
};

}  // namespace visibility::exact_25d
