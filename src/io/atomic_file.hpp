#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace visibility::io {

/// A file that appears whole or not at all: written under a temporary name in the same folder, renamed by `commit`.
/// Without `commit` the destructor removes it.
class AtomicFile {
public:
  /// Throws BadInput if the folder cannot be written to.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(AtomicFile const&) = delete;
  AtomicFile& operator=(AtomicFile const&) = delete;

  std::ostream& stream() { return stream_; }
  /// Throws BadInput if anything could not be written.
  void commit();

  /// Removes the temporary files of all that are open; safe in a signal handler (Ctrl-C), good for leaving only.
  static void remove_all() noexcept;

private:
  std::filesystem::path path_;
  std::string temporary_;
  std::ofstream stream_;
  int slot_ = -1;
};

}  // namespace visibility::io
