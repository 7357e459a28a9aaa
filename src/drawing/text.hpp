#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace visibility::detail::drawing {

/// Valid UTF-8 without control characters: what is not becomes U+FFFD. Safe in XML and in fonts.
std::string clean_text(std::string_view text);

/// Width of a text, in ems: an estimate on the wide side for sans-serif fonts, the same for every format, so that the
/// layout does not depend on installed fonts. Requires: clean text.
double text_width(std::string_view text);

/// The longest beginning, with dots if something is left out, that is at most so many ems wide. Requires: clean text.
std::string shortened(std::string const& text, double ems);

/// 1234567 as 1,234,567.
std::string grouped(std::size_t n);

}  // namespace visibility::detail::drawing
