#pragma once

#include <ctime>

namespace visibility {

namespace detail {

inline double seconds_on(clockid_t clock)
{
  constexpr double nanosecond = 1e-9;
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + nanosecond * static_cast<double>(t.tv_nsec);
}

}  // namespace detail

/// Processor seconds that the calling thread has used so far. POSIX; 0 where the clock is missing.
inline double thread_seconds() { return detail::seconds_on(CLOCK_THREAD_CPUTIME_ID); }

/// The same of all threads of the process together.
inline double process_seconds() { return detail::seconds_on(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace visibility
