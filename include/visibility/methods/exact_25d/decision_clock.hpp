#pragma once

#include <ctime>

namespace visibility::exact_25d {

/// Adds the processor time of this thread during its life, in seconds, to a total; none if there is no total.
class DecisionClock {
public:
  explicit DecisionClock(double* total) : total_(total), start_(total != nullptr ? now() : 0) {}
  ~DecisionClock()
  {
    if (total_ != nullptr) *total_ += now() - start_;
  }
  DecisionClock(DecisionClock const&) = delete;
  DecisionClock& operator=(DecisionClock const&) = delete;

private:
  static double now()
  {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

  double* total_;
  double start_;
};

}  // namespace visibility::exact_25d
