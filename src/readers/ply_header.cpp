#include "ply_header.hpp"

#include "readers.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace visibility::readers {

namespace {

struct NamedType {
  std::string_view name;
  PlyType type;
};
constexpr NamedType type_names[] = {
  {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
  {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
  {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
  {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
  {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
  {"float64", PlyType::float64}};

std::vector<std::string_view> words_of(std::string_view line)
{
  std::vector<std::string_view> words;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
    if (line.empty()) return words;
    words.push_back(line.substr(0, line.find_first_of(" \t\r")));
    line.remove_prefix(words.back().size());
  }
}

class HeaderParser {
public:
  HeaderParser(std::string_view bytes, std::string const& source) : bytes_(bytes), source_(source) {}

  PlyHeader parse()
  {
    if (take_line() != std::vector<std::string_view>{"ply"})
      bad("does not begin with the word 'ply'; is this a PLY file?");
    for (bool has_format = false;;) {
      auto const words = take_line();
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") {
        if (!has_format) bad("the header names no format; add 'format ascii 1.0' or the like");
        check_sizes();
        return std::move(header_);
      }
      if (words[0] == "format" && words.size() >= 2)
        has_format = true, format(words[1]);
      else if (words[0] == "element" && words.size() == 3)
        element(words[1], words[2]);
      else if (words[0] == "property" && words.size() >= 3 && !header_.elements.empty())
        property(words);
      else
        bad("cannot understand the header line '" + std::string(words[0]) + " ...'");
    }
  }

private:
  [[noreturn]] void bad(std::string const& what) const { fail(source_, "line " + std::to_string(header_.lines), what); }

  std::vector<std::string_view> take_line()
  {
    auto const rest = bytes_.substr(header_.length);
    auto const end = rest.find('\n');
    ++header_.lines;
    if (end == std::string_view::npos) bad("the header does not end; it needs an 'end_header' line");
    header_.length += end + 1;
    return words_of(rest.substr(0, end));
  }

  void format(std::string_view name)
  {
    if (name == "ascii")
      header_.encoding = PlyEncoding::ascii;
    else if (name == "binary_little_endian")
      header_.encoding = PlyEncoding::little_endian;
    else if (name == "binary_big_endian")
      header_.encoding = PlyEncoding::big_endian;
    else
      bad("unknown format '" + std::string(name) + "'; expected ascii, binary_little_endian or binary_big_endian");
  }

  void element(std::string_view name, std::string_view count)
  {
    PlyElement e{std::string(name), 0, {}};
    auto const r = std::from_chars(count.data(), count.data() + count.size(), e.count);
    if (r.ec != std::errc() || r.ptr != count.data() + count.size())
      bad("'" + std::string(count) + "' is not a number of " + e.name + " elements");
    header_.elements.push_back(std::move(e));
  }

  PlyType type(std::string_view name) const
  {
    auto const it = std::ranges::find(type_names, name, &NamedType::name);
    if (it == std::end(type_names)) bad("unknown property type '" + std::string(name) + "'");
    return it->type;
  }

  void property(std::vector<std::string_view> const& words)
  {
    auto& properties = header_.elements.back().properties;
    if (words[1] != "list") {
      if (words.size() != 3) bad("a property line needs a type and a name");
      properties.push_back({std::string(words[2]), type(words[1]), false, {}});
      return;
    }
    if (words.size() != 5) bad("a list property line needs two types and a name");
    PlyProperty p{std::string(words[4]), type(words[3]), true, type(words[2])};
    if (!is_integer(p.count_type)) bad("the length of list '" + p.name + "' must be of an integer type");
    properties.push_back(std::move(p));
  }

  void check_sizes() const
  {
    std::uint64_t const present = bytes_.size() - header_.length;
    std::uint64_t needed = 0;
    for (auto const& e : header_.elements) {
      std::uint64_t row = 0;
      for (auto const& p : e.properties)
        row += header_.encoding == PlyEncoding::ascii ? 1 : size_of(p.is_list ? p.count_type : p.type);
      if (row == 0) continue;
      if (e.count > (present - needed) / row)
        fail(source_, {},
             "the header claims " + std::to_string(e.count) + " " + e.name + " elements, but only " +
               std::to_string(present) + " bytes follow it; the file is truncated or its header wrong");
      needed += e.count * row;
    }
  }

  std::string_view bytes_;
  std::string const& source_;
  PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type)
{
  switch (type) {
  case PlyType::int8:
  case PlyType::uint8: return 1;
  case PlyType::int16:
  case PlyType::uint16: return 2;
  case PlyType::int32:
  case PlyType::uint32:
  case PlyType::float32: return 4;
  case PlyType::float64: return 8;
  }
  return 0;
}

std::size_t PlyElement::find(std::string_view property) const
{
  return static_cast<std::size_t>(std::ranges::find(properties, property, &PlyProperty::name) - properties.begin());
}

PlyHeader parse_ply_header(std::string_view bytes, std::string const& source)
{
  return HeaderParser(bytes, source).parse();
}

}  // namespace visibility::readers
