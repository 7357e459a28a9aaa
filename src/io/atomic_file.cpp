#include "atomic_file.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <array>
#include <atomic>
#include <unistd.h>

namespace visibility::io {

namespace {

// Names of open temporary files, for the signal handler: no lock, no allocation.
constexpr int slots = 64;
std::array<std::atomic<char const*>, slots> open_names{};
std::atomic<unsigned> counter{0};

int take_slot(char const* name)
{
  for (int i = 0; i < slots; ++i) {
    char const* expected = nullptr;
    if (open_names[static_cast<std::size_t>(i)].compare_exchange_strong(expected, name)) return i;
  }
  return -1;  // more files than slots: cleaned by the destructor only
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path))
{
  temporary_ = path_.string() + ".part-" + std::to_string(getpid()) + "-" + std::to_string(counter++);
  slot_ = take_slot(temporary_.c_str());
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (stream_) return;
  if (slot_ >= 0) open_names[static_cast<std::size_t>(slot_)] = nullptr;
  throw BadInput(path_.string() + ": cannot be written; check that the folder exists and may be written to");
}

AtomicFile::~AtomicFile()
{
  if (temporary_.empty()) return;
  stream_.close();
  unlink(temporary_.c_str());
  if (slot_ >= 0) open_names[static_cast<std::size_t>(slot_)] = nullptr;
}

void AtomicFile::commit()
{
  stream_.close();
  if (!stream_) throw BadInput(path_.string() + ": could not be written completely; is the disk full?");
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) throw BadInput(path_.string() + ": cannot be replaced (" + error.message() + ")");
  if (slot_ >= 0) open_names[static_cast<std::size_t>(slot_)] = nullptr;
  temporary_.clear();
}

void AtomicFile::remove_all() noexcept
{
  for (auto& name : open_names)
    if (char const* n = name.load()) unlink(n);
}

}  // namespace visibility::io
