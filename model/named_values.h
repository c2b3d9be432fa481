// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Enum values and their names in files, command lines and settings.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace detent {

template <class Value>
struct NamedValue {
  const char* word;
  Value value;
};

/// A table of values and names; each value and each name occurs once, in display order.
template <class Value, std::size_t count>
struct NamedValues {
  std::array<NamedValue<Value>, count> all;

  /// Returns "" for a value without a name.
  constexpr const char* word(Value value) const {
    for (const NamedValue<Value>& named : all)
      if (named.value == value) return named.word;
    return "";
  }
  /// Returns nullopt for an unknown name.
  constexpr std::optional<Value> value(std::string_view word) const {
    for (const NamedValue<Value>& named : all)
      if (named.word == word) return named.value;
    return {};
  }
};

/// named<Colour>({{"red", Colour::red}, {"green", Colour::green}})
template <class Value, std::size_t count>
constexpr NamedValues<Value, count> named(const NamedValue<Value> (&list)[count]) {
  return {std::to_array(list)};
}

}  // namespace detent
