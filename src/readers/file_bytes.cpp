#include "file_bytes.hpp"

#include "readers.hpp"

#include <zlib.h>

#include <memory>

namespace visibility::readers {

std::string file_bytes(std::filesystem::path const& path)
{
  std::string const name = path.string();
  std::error_code error;
  if (!std::filesystem::exists(path, error)) fail(name, {}, "no such file; check the path");
  if (std::filesystem::is_directory(path, error)) fail(name, {}, "is a folder; name a scene file in it");

  // zlib reads plain files as they are.
  gzFile const file = gzopen(name.c_str(), "rb");
  if (file == nullptr) fail(name, {}, "cannot be opened; check that it may be read");
  auto const close = [](gzFile f) { gzclose_r(f); };
  std::unique_ptr<gzFile_s, decltype(close)> const guard(file, close);
  gzbuffer(file, 1 << 17);

  std::string bytes;
  if (auto const size = std::filesystem::file_size(path, error); !error) bytes.reserve(size + 1);
  constexpr unsigned chunk = 1 << 20;
  for (;;) {
    std::size_t const had = bytes.size();
    if (had + chunk > bytes.capacity()) bytes.reserve(std::max(had + chunk, 2 * bytes.capacity()));
    bytes.resize(had + chunk);
    int const got = gzread(file, bytes.data() + had, chunk);
    bytes.resize(had + static_cast<std::size_t>(std::max(got, 0)));
    if (got > 0) continue;
    int code = Z_OK;
    char const* const what = gzerror(file, &code);
    if (got < 0 || (code != Z_OK && code != Z_STREAM_END))
      fail(name, {}, "cannot be read or unpacked (" + printable(what) + "); get a complete copy of the file");
    return bytes;
  }
}

}  // namespace visibility::readers
