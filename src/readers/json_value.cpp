#include "json_value.hpp"

#include "numbers.hpp"

#include <algorithm>

namespace visibility::readers {

std::optional<double> JsonValue::as_number() const
{
  if (auto const* d = std::get_if<double>(&value_)) return *d;
  if (auto const* d = pointer<Decimal>()) return d->value;
  return std::nullopt;
}

std::optional<bool> JsonValue::as_bool() const
{
  if (auto const* b = std::get_if<bool>(&value_)) return *b;
  return std::nullopt;
}

std::string JsonValue::decimal_text() const
{
  if (auto const* d = pointer<Decimal>()) return d->text;
  if (auto const* d = std::get_if<double>(&value_)) return shortest(*d);
  return {};
}

JsonValue const* JsonValue::find(std::string_view key) const
{
  auto const* members = as_object();
  if (members == nullptr) return nullptr;
  auto const it = std::find_if(members->rbegin(), members->rend(), [&](auto const& m) { return m.first == key; });
  return it == members->rend() ? nullptr : &it->second;
}

std::string_view JsonValue::text(std::string_view key) const
{
  auto const* member = find(key);
  auto const* s = member == nullptr ? nullptr : member->as_string();
  return s == nullptr ? std::string_view() : *s;
}

JsonValue::Array const& JsonValue::list(std::string_view key) const
{
  static Array const none;
  auto const* member = find(key);
  auto const* a = member == nullptr ? nullptr : member->as_array();
  return a == nullptr ? none : *a;
}

}  // namespace visibility::readers
