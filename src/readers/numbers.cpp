#include "numbers.hpp"

#include <charconv>
#include <cmath>
#include <limits>

namespace visibility::readers {

namespace {

/// std::from_chars reports overflow and underflow alike. The number has `digits` before its point, or leading zeros
/// after it; that decides, since a double spans only 10^-324 to 10^308.
bool is_huge(std::string_view number)
{
  auto const e = number.find_first_of("eE");
  if (e != std::string_view::npos && e + 1 < number.size()) {
    auto const exponent = number.substr(e + 1);
    // No file holds enough digits to make up for an exponent of the other sign by more than its own length.
    long value = 0;
    auto const digits = exponent.substr(exponent.front() == '+' ? 1 : 0);
    auto const r = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (r.ec == std::errc::result_out_of_range) return exponent.front() != '-';
    auto const mantissa = number.substr(0, e);
    auto const point = std::min(mantissa.find('.'), mantissa.size());
    auto const first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return false;
    auto const magnitude = first < point ? static_cast<long>(point - first) : -static_cast<long>(first - point - 1);
    return magnitude > -value;
  }
  auto const point = std::min(number.find('.'), number.size());
  auto const first = number.find_first_of("123456789");
  return first < point;
}

}  // namespace

std::optional<double> take_double(std::string_view& text)
{
  auto number = text;
  bool const plus = !number.empty() && number.front() == '+';
  if (plus) number.remove_prefix(1);
  if (plus && !number.empty() && number.front() == '-') return std::nullopt;
  double value = 0;
  auto const r = std::from_chars(number.data(), number.data() + number.size(), value);
  if (r.ec == std::errc::invalid_argument) return std::nullopt;
  auto const length = static_cast<std::size_t>(r.ptr - number.data());
  if (r.ec == std::errc::result_out_of_range) {
    value = is_huge(number.substr(0, length)) ? std::numeric_limits<double>::infinity() : 0.0;
    if (number.front() == '-') value = -value;
  }
  text = number.substr(length);
  return value;
}

std::optional<double> parse_double(std::string_view text)
{
  auto const value = take_double(text);
  return text.empty() ? value : std::nullopt;
}

std::string shortest(double value)
{
  if (value == 0) return std::signbit(value) ? "-0.0" : "0";
  char buffer[32];
  auto const r = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, r.ptr};
}

}  // namespace visibility::readers
