#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <boost/multiprecision/cpp_int.hpp>

namespace visibility::readers {

/// An exact decimal number: digits * 10^exponent.
struct Decimal {
  boost::multiprecision::cpp_int digits;
  long exponent = 0;

  /// Empty unless the text is a JSON number with an exponent and length that a coordinate may have (some hundreds).
  static std::optional<Decimal> parse(std::string_view text);
  double nearest() const;  ///< correctly rounded; infinity on overflow
};

/// index * scale + translate, computed exactly and then rounded once to the nearest double: the coordinate that
/// a CityJSON file means.
class DecimalTransform {
public:
  DecimalTransform(Decimal const& scale, Decimal const& translate);
  double operator()(Decimal const& index) const;
  double operator()(std::int64_t index) const;

private:
  boost::multiprecision::cpp_int scale_, translate_;  // both times 10^exponent_
  long exponent_;
  // The same where everything fits into 64 bits and the power of ten is a double: then one division rounds correctly
  // [Clinger 1990], since numerator and denominator are exact.
  bool fits_ = false;
  std::int64_t small_scale_ = 0, small_translate_ = 0;
  double power_ = 1;
};

}  // namespace visibility::readers
