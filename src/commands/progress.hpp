#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace visibility::commands {

/// A bar on standard error while long work runs; nothing at all where standard error is not a terminal.
/// `advance` may be called from any thread.
class Progress {
public:
  Progress(std::string what, std::size_t total);
  ~Progress();
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;

  void advance(std::size_t steps = 1);

private:
  void draw();

  std::string what_;
  std::size_t total_, done_ = 0;
  bool shown_;
  std::chrono::steady_clock::time_point last_{};
  std::mutex mutex_;
};

}  // namespace visibility::commands
