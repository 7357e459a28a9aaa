#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace visibility::detail {

/// Writes numbers as bytes: docs/result-format.md.
class ByteWriter {
public:
  void number(std::uint64_t value);  ///< 7 bits to a byte, the lowest first; the high bit says that more follow
  void real(double value);           ///< IEEE 754, eight bytes, the lowest first
  void text(std::string_view bytes) { out_ += bytes; }
  void checksum();  ///< CRC-32 of all that was written, four bytes, the lowest first
  std::string take() { return std::move(out_); }
  std::size_t size() const { return out_.size(); }

private:
  std::string out_;
};

/// Reads what a ByteWriter has written. Throws BadInput with the name of the file and the position where bytes are
/// missing or are no number.
class ByteReader {
public:
  ByteReader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  /// Takes the checksum off the end. Throws BadInput unless it is right.
  void verify_checksum();
  std::uint64_t number(char const* what);
  /// A number of things that follow, of at least so many bytes each: so no count asks for more memory than the file
  /// has.
  std::uint64_t count(char const* what, std::size_t bytes_each);
  double real(char const* what);  ///< finite
  std::string_view text(std::size_t length, char const* what);
  std::size_t left() const { return bytes_.size() - at_; }
  [[noreturn]] void fail(std::string const& what) const;

private:
  std::string_view bytes_;
  std::string name_;
  std::size_t at_ = 0;
};

}  // namespace visibility::detail
