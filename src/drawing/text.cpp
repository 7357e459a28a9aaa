#include "text.hpp"

#include <cstdint>

namespace visibility::detail::drawing {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

struct CodePoint {
  std::uint32_t value;
  std::size_t bytes;  ///< 0: not UTF-8
};

/// The code point at the start of the text. Requires: text not empty.
CodePoint first_code_point(std::string_view text)
{
  auto const byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  std::uint8_t const lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  std::size_t const n = lead >= 0xF0 && lead < 0xF8   ? 4
                        : lead >= 0xE0 && lead < 0xF0 ? 3
                        : lead >= 0xC2 && lead < 0xE0 ? 2
                                                      : 0;
  if (n == 0 || text.size() < n) return {0, 0};
  std::uint32_t value = lead & (0x7FU >> n);
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return {0, 0};
    value = value << 6U | (byte(i) & 0x3FU);
  }
  bool const overlong = (n == 3 && value < 0x800) || (n == 4 && value < 0x10000);
  bool const surrogate = value >= 0xD800 && value < 0xE000;
  return overlong || surrogate || value > 0x10FFFF ? CodePoint{0, 0} : CodePoint{value, n};
}

double width_of(std::uint32_t c)
{
  if (c >= 0x1100) return 1.05;  // Korean, Chinese, Japanese and symbols
  if (c >= 0x80) return 0.75;
  if (std::string_view("ijl.,:;'|!()[]-ftr ").find(static_cast<char>(c)) != std::string_view::npos) return 0.4;
  if (std::string_view("mwMW%@").find(static_cast<char>(c)) != std::string_view::npos) return 1;
  return c >= 'A' && c <= 'Z' ? 0.7 : 0.63;
}

}  // namespace

std::string clean_text(std::string_view text)
{
  std::string out;
  while (!text.empty()) {
    auto const [c, bytes] = first_code_point(text);
    bool const good = bytes > 0 && c >= 0x20 && !(c >= 0x7F && c < 0xA0) && c != 0xFFFE && c != 0xFFFF;
    out += good ? text.substr(0, bytes) : replacement;
    text.remove_prefix(bytes > 0 ? bytes : 1);
  }
  return out;
}

double text_width(std::string_view text)
{
  double sum = 0;
  while (!text.empty()) {
    auto const [c, bytes] = first_code_point(text);
    sum += width_of(c);
    text.remove_prefix(bytes);
  }
  return sum;
}

std::string shortened(std::string const& text, double ems)
{
  if (text_width(text) <= ems) return text;
  constexpr std::string_view dots = "...";
  std::string_view rest = text;
  double sum = text_width(dots);
  while (!rest.empty()) {
    auto const [c, bytes] = first_code_point(rest);
    sum += width_of(c);
    if (sum > ems) break;
    rest.remove_prefix(bytes);
  }
  return text.substr(0, text.size() - rest.size()) + std::string(dots);
}

std::string grouped(std::size_t n)
{
  std::string digits = std::to_string(n);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

}  // namespace visibility::detail::drawing
