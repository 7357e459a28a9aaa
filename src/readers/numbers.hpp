#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace visibility::readers {

/// The double nearest to the decimal number at the front of `text`, which loses that front. Underflow gives a zero,
/// overflow an infinity; "nan" and "inf" are read as such, so that callers can say what is wrong with them.
/// Empty, and `text` untouched, if there is no number.
std::optional<double> take_double(std::string_view& text);

/// The same for a text that is a number from end to end.
std::optional<double> parse_double(std::string_view text);

/// The shortest decimal that reads back as the same double; "-0.0" keeps its sign. Requires: finite.
std::string shortest(double value);

}  // namespace visibility::readers
