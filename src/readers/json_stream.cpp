#include "json_value.hpp"
#include "numbers.hpp"
#include "readers.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace visibility::readers {

namespace {

/// Iterator over the bytes that reports how far the parser has come.
struct Cursor {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = char const*;
  using reference = char const&;

  char const* at;
  char const** progress;
  reference operator*() const { return *at; }
  Cursor& operator++()
  {
    *progress = ++at;
    return *this;
  }
  Cursor operator++(int)
  {
    Cursor const before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(Cursor const& a, Cursor const& b) { return a.at == b.at; }
};

/// Builds a JsonValue from the events of nlohmann's parser, which is iterative: depth costs it no stack. Ours is
/// limited, because destroying a tree is recursive and no scene is nested deeply.
class TreeBuilder {
public:
  JsonValue root;
  std::string error;

  bool null() { return put({}); }
  bool boolean(bool b) { return put(JsonValue(b)); }
  bool number_integer(std::int64_t i)
  {
    constexpr std::int64_t limit = std::int64_t{1} << 53;
    auto const d = static_cast<double>(i);
    return put(-limit <= i && i <= limit ? JsonValue(d) : JsonValue::decimal(std::to_string(i), d));
  }
  bool number_unsigned(std::uint64_t i)
  {
    constexpr std::uint64_t limit = std::uint64_t{1} << 53;
    auto const d = static_cast<double>(i);
    return put(i <= limit ? JsonValue(d) : JsonValue::decimal(std::to_string(i), d));
  }
  bool number_float(double d, std::string const& text)
  {
    // A normal double gives back any decimal of up to 15 digits that was rounded to it: shortest() is the same number.
    auto const digits = std::count_if(text.begin(), std::find_if(text.begin(), text.end(), is_exponent), is_digit);
    if (digits <= 15 && std::fabs(d) > 1e-290) return put(JsonValue(d));
    return put(JsonValue::decimal(text, d));
  }
  bool string(std::string& s) { return put(JsonValue(std::move(s))); }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(JsonValue::object()); }
  bool start_array(std::size_t) { return open(JsonValue::array()); }
  bool key(std::string& s)
  {
    key_ = std::move(s);
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, std::string const&, nlohmann::json::exception const& e)
  {
    std::string_view what = e.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: details"
    if (auto const colon = what.find(": "); colon != std::string_view::npos)
      what.remove_prefix(colon + 2);
    else if (auto const bracket = what.find("] "); bracket != std::string_view::npos)
      what.remove_prefix(bracket + 2);
    error = "not valid JSON: " + std::string(what);
    return false;
  }

private:
  static bool is_digit(char c) { return '0' <= c && c <= '9'; }
  static bool is_exponent(char c) { return c == 'e' || c == 'E'; }

  JsonValue* attach(JsonValue value)
  {
    if (open_.empty()) {
      root = std::move(value);
      return &root;
    }
    if (auto* array = open_.back()->as_array()) return &array->emplace_back(std::move(value));
    return &open_.back()->as_object()->emplace_back(std::move(key_), std::move(value)).second;
  }
  bool put(JsonValue value)
  {
    attach(std::move(value));
    return true;
  }
  bool open(JsonValue value)
  {
    if (open_.size() >= JsonStream::max_depth) {
      error = "JSON nested deeper than " + std::to_string(JsonStream::max_depth) + " levels";
      return false;
    }
    open_.push_back(attach(std::move(value)));
    return true;
  }
  bool close()
  {
    open_.pop_back();
    return true;
  }

  std::vector<JsonValue*> open_;  // stays valid: a container grows only while none of its children is open
  std::string key_;
};

constexpr std::string_view blank = " \t\r\n\x1e";

}  // namespace

JsonStream::JsonStream(std::string_view bytes, std::string source) : bytes_(bytes), source_(std::move(source))
{
  if (bytes_.starts_with("\xEF\xBB\xBF")) position_ = 3;
}

std::optional<JsonValue> JsonStream::next()
{
  position_ = std::min(bytes_.find_first_not_of(blank, position_), bytes_.size());
  auto const newlines = [&](std::size_t from, std::size_t to) {
    return static_cast<std::size_t>(std::count(bytes_.begin() + from, bytes_.begin() + to, '\n'));
  };
  line_ += newlines(counted_, position_);
  counted_ = position_;
  if (position_ == bytes_.size()) return std::nullopt;

  char const* reached = bytes_.data() + position_;
  char const* const end = bytes_.data() + bytes_.size();
  TreeBuilder tree;
  bool const ok = nlohmann::json::sax_parse(Cursor{reached, &reached}, Cursor{end, &reached}, &tree,
                                            nlohmann::json::input_format_t::json, /*strict=*/false);
  auto const position = static_cast<std::size_t>(reached - bytes_.data());
  if (!ok) fail(source_, "line " + std::to_string(line_ + newlines(position_, position)), tree.error);
  position_ = position;
  return std::move(tree.root);
}

}  // namespace visibility::readers
