#pragma once

#include <ctime>

namespace visibility {

/// Processor seconds that the calling thread has used so far. POSIX; 0 where the clock is missing.
inline double thread_seconds()
{
  constexpr double nanosecond = 1e-9;
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + nanosecond * static_cast<double>(t.tv_nsec);
}

}  // namespace visibility
