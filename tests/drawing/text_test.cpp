#include "drawing/text.hpp"
#include "support/catch.hpp"

using namespace visibility::detail::drawing;

TEST_CASE("picture text: whatever is not text becomes a replacement character", "[drawing]")
{
  std::string const bad = "\xEF\xBF\xBD";
  REQUIRE(clean_text("M\xC3\xBCnchen \xE4\xB8\xAD \xF0\x9F\x8F\xA0") == "M\xC3\xBCnchen \xE4\xB8\xAD \xF0\x9F\x8F\xA0");
  REQUIRE(clean_text("a\x01z\n") == "a" + bad + "z" + bad);
  REQUIRE(clean_text("\xFF") == bad);
  REQUIRE(clean_text("\xC3") == bad);                                // cut off
  REQUIRE(clean_text("\xC0\x80") == bad + bad);                      // overlong
  REQUIRE(clean_text("\xED\xA0\x80") == bad + bad + bad);            // surrogate
  REQUIRE(clean_text("\xEF\xBF\xBE") == bad);                        // no character of XML
  REQUIRE(clean_text("\xF4\x90\x80\x80").size() == 4 * bad.size());  // beyond Unicode
}

TEST_CASE("picture text: shortened to a width, numbers in groups", "[drawing]")
{
  std::string const text = "a rather long name of a building";
  REQUIRE(shortened(text, 100) == text);
  REQUIRE(shortened(text, 6).ends_with("..."));
  REQUIRE(text_width(shortened(text, 6)) <= 6);
  REQUIRE(grouped(0) == "0");
  REQUIRE(grouped(999) == "999");
  REQUIRE(grouped(1000) == "1,000");
  REQUIRE(grouped(1234567) == "1,234,567");
}
