#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace visibility::readers {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);
inline bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string name;
  PlyType type;
  bool is_list = false;
  PlyType count_type{};  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Position of a property; properties.size() if there is none of that name.
  std::size_t find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t length = 0;  ///< bytes, with the line end after `end_header`
  std::size_t lines = 0;
};

/// Throws BadInput with the line. An element that claims more rows than the bytes behind the header can hold is bad.
PlyHeader parse_ply_header(std::string_view bytes, std::string const& source);

}  // namespace visibility::readers
