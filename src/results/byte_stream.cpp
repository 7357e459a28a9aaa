#include "byte_stream.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <zlib.h>

#include <bit>
#include <cmath>

namespace visibility::detail {

namespace {

constexpr std::size_t checksum_bytes = 4;

std::uint32_t crc(std::string_view bytes)
{
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<Bytef const*>(bytes.data()), bytes.size()));
}

}  // namespace

void ByteWriter::number(std::uint64_t value)
{
  for (; value >= 0x80; value >>= 7) out_ += static_cast<char>((value & 0x7f) | 0x80);
  out_ += static_cast<char>(value);
}

void ByteWriter::real(double value)
{
  auto const bits = std::bit_cast<std::uint64_t>(value);
  for (int i = 0; i < 64; i += 8) out_ += static_cast<char>(bits >> i & 0xff);
}

void ByteWriter::checksum()
{
  auto const value = crc(out_);
  for (int i = 0; i < 32; i += 8) out_ += static_cast<char>(value >> i & 0xff);
}

void ByteReader::verify_checksum()
{
  if (bytes_.size() < checksum_bytes) fail("the file ends too early");
  auto const last = bytes_.substr(bytes_.size() - checksum_bytes);
  bytes_.remove_suffix(checksum_bytes);
  std::uint32_t stored = 0;
  for (std::size_t i = 0; i < checksum_bytes; ++i)
    stored |= std::uint32_t{static_cast<unsigned char>(last[i])} << (8 * i);
  if (stored != crc(bytes_)) fail("the file is damaged or incomplete (its checksum is wrong): write it again");
}

std::uint64_t ByteReader::number(char const* what)
{
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    if (at_ == bytes_.size()) fail(std::string("the file ends within ") + what);
    auto const byte = static_cast<unsigned char>(bytes_[at_++]);
    auto const bits = std::uint64_t{byte} & 0x7f;
    if (shift == 63 && bits > 1) break;
    value |= bits << shift;
    if (byte < 0x80) return value;
  }
  fail(std::string(what) + ": a number of more than 64 bits");
}

std::uint64_t ByteReader::count(char const* what, std::size_t bytes_each)
{
  auto const n = number(what);
  if (n > left() / bytes_each) fail(std::string(what) + ": there are fewer in the file than it says");
  return n;
}

double ByteReader::real(char const* what)
{
  auto const eight = text(8, what);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < 8; ++i) bits |= std::uint64_t{static_cast<unsigned char>(eight[i])} << (8 * i);
  auto const value = std::bit_cast<double>(bits);
  if (!std::isfinite(value)) fail(std::string(what) + ": a coordinate is not finite");
  return value;
}

std::string_view ByteReader::text(std::size_t length, char const* what)
{
  if (length > left()) fail(std::string("the file ends within ") + what);
  auto const out = bytes_.substr(at_, length);
  at_ += length;
  return out;
}

void ByteReader::fail(std::string const& what) const
{
  throw BadInput(name_ + ", byte " + std::to_string(at_) + ": " + what);
}

}  // namespace visibility::detail
