#include "decimal.hpp"

#include "numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace visibility::readers {

using Integer = boost::multiprecision::cpp_int;

namespace {

Integer power_of_ten(long n) { return boost::multiprecision::pow(Integer(10), static_cast<unsigned>(n)); }

constexpr std::int64_t exact_limit = std::int64_t{1} << 53;  // integers up to here are doubles

}  // namespace

std::optional<Decimal> Decimal::parse(std::string_view text)
{
  constexpr std::size_t max_length = 400;
  constexpr long max_exponent = 400;
  if (text.empty() || text.size() > max_length) return std::nullopt;
  bool const negative = text[0] == '-';
  if (negative) text.remove_prefix(1);
  Decimal d;
  std::string digits;
  bool point = false;
  std::size_t i = 0;
  for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
    if (text[i] == '.' && !point) {
      point = true;
      continue;
    }
    if (text[i] < '0' || text[i] > '9') return std::nullopt;
    digits += text[i];
    d.exponent -= point;
  }
  if (digits.empty()) return std::nullopt;
  if (i < text.size()) {
    auto exponent = text.substr(i + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    long e = 0;
    auto const r = std::from_chars(exponent.data(), exponent.data() + exponent.size(), e);
    if (r.ec != std::errc() || r.ptr != exponent.data() + exponent.size() || std::labs(e) > max_exponent)
      return std::nullopt;
    d.exponent += e;
  }
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));  // "012" would be octal
  d.digits = Integer(digits);
  if (negative) d.digits = -d.digits;
  return d;
}

double Decimal::nearest() const
{
  // from_chars rounds correctly, whatever the number of digits.
  return *parse_double(digits.str() + "e" + std::to_string(exponent));
}

DecimalTransform::DecimalTransform(Decimal const& scale, Decimal const& translate)
  : exponent_(std::min({scale.exponent, translate.exponent, 0L}))
{
  scale_ = scale.digits * power_of_ten(scale.exponent - exponent_);
  translate_ = translate.digits * power_of_ten(translate.exponent - exponent_);
  constexpr long max_exact_power = 22;  // 10^22 is the last power of ten that is a double
  constexpr std::int64_t limit = INT64_MAX / 2;
  fits_ = -exponent_ <= max_exact_power && abs(scale_) <= limit && abs(translate_) <= limit;
  if (!fits_) return;
  small_scale_ = static_cast<std::int64_t>(scale_);
  small_translate_ = static_cast<std::int64_t>(translate_);
  for (long i = 0; i < -exponent_; ++i) power_ *= 10;  // exact at each step
}

double DecimalTransform::operator()(std::int64_t index) const
{
  std::int64_t sum = 0;
  if (fits_ && !__builtin_mul_overflow(index, small_scale_, &sum) &&
      !__builtin_add_overflow(sum, small_translate_, &sum) && -exact_limit <= sum && sum <= exact_limit)
    return static_cast<double>(sum) / power_;
  return Decimal{index * scale_ + translate_, exponent_}.nearest();
}

double DecimalTransform::operator()(Decimal const& index) const
{
  if (index.exponent == 0 && abs(index.digits) <= exact_limit) return (*this)(static_cast<std::int64_t>(index.digits));
  // index * scale + translate over the common exponent of product and translation
  long const exponent = std::min(index.exponent, 0L);
  Integer const digits = index.digits * power_of_ten(std::max(index.exponent, 0L));
  return Decimal{digits * scale_ + translate_ * power_of_ten(-exponent), exponent_ + exponent}.nearest();
}

}  // namespace visibility::readers
