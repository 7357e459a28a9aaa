#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace visibility::readers {

/// A JSON value that remembers numbers as they were written, which nlohmann::json does not: a CityJSON `transform` is
/// meant as decimals. 16 bytes, so that a million coordinates stay small.
class JsonValue {
public:
  using Array = std::vector<JsonValue>;
  using Object = std::vector<std::pair<std::string, JsonValue>>;

  JsonValue() = default;
  explicit JsonValue(bool b) : value_(b) {}
  explicit JsonValue(double d) : value_(d) {}
  explicit JsonValue(std::string s) : value_(std::make_unique<std::string>(std::move(s))) {}
  static JsonValue array() { return JsonValue(std::make_unique<Array>()); }
  static JsonValue object() { return JsonValue(std::make_unique<Object>()); }
  /// A number whose text is not to be had back from its double.
  static JsonValue decimal(std::string text, double value)
  {
    return JsonValue(std::make_unique<Decimal>(Decimal{std::move(text), value}));
  }

  bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
  Array const* as_array() const { return pointer<Array>(); }  ///< nullptr if it is something else; so below
  Object const* as_object() const { return pointer<Object>(); }
  std::string const* as_string() const { return pointer<std::string>(); }
  Array* as_array() { return const_cast<Array*>(pointer<Array>()); }
  Object* as_object() { return const_cast<Object*>(pointer<Object>()); }
  std::optional<double> as_number() const;  ///< the nearest double
  std::optional<bool> as_bool() const;
  std::string decimal_text() const;  ///< of a number: a decimal of exactly the value written

  /// The member of an object; nullptr if there is none or this is not an object. Of repeated keys the last counts.
  JsonValue const* find(std::string_view key) const;
  /// The member if it is a string, else empty.
  std::string_view text(std::string_view key) const;
  /// The member if it is an array, else an empty one.
  Array const& list(std::string_view key) const;

private:
  struct Decimal {
    std::string text;
    double value;
  };
  template <class T>
  explicit JsonValue(std::unique_ptr<T> p) : value_(std::move(p))
  {
  }
  template <class T>
  T const* pointer() const
  {
    auto const* p = std::get_if<std::unique_ptr<T>>(&value_);
    return p == nullptr ? nullptr : p->get();
  }

  std::variant<std::nullptr_t, bool, double, std::unique_ptr<Decimal>, std::unique_ptr<std::string>,
               std::unique_ptr<Array>, std::unique_ptr<Object>>
    value_;
};

/// A sequence of JSON documents: one, or several separated by white space or the RS character of RFC 8142.
class JsonStream {
public:
  /// Keeps a view of the bytes.
  JsonStream(std::string_view bytes, std::string source);

  /// The next document, if there is one. Throws BadInput (with the line) on a syntax error, a number beyond the range
  /// of double, or nesting deeper than `max_depth`.
  std::optional<JsonValue> next();
  std::size_t line() const { return line_; }  ///< where the latest document begins, from 1
  std::string const& source() const { return source_; }

  static constexpr std::size_t max_depth = 256;

private:
  std::string_view bytes_;
  std::string source_;
  std::size_t position_ = 0, counted_ = 0, line_ = 1;
};

}  // namespace visibility::readers
