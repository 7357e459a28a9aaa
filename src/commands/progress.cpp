#include "progress.hpp"

#include <cstdio>
#include <unistd.h>

namespace visibility::commands {

Progress::Progress(std::string what, std::size_t total)
  : what_(std::move(what)), total_(total), shown_(total > 1 && isatty(STDERR_FILENO) == 1)
{
}

Progress::~Progress()
{
  if (shown_ && last_ != std::chrono::steady_clock::time_point{}) std::fputs("\r\033[K", stderr);
}

void Progress::advance(std::size_t steps)
{
  std::lock_guard const lock(mutex_);
  done_ += steps;
  auto const now = std::chrono::steady_clock::now();
  if (!shown_ || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  draw();
}

void Progress::draw()
{
  constexpr std::size_t width = 40;
  std::size_t const filled = width * (done_ < total_ ? done_ : total_) / total_;
  std::string const bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %zu/%zu", what_.c_str(), bar.c_str(), done_, total_);
  std::fflush(stderr);
}

}  // namespace visibility::commands
