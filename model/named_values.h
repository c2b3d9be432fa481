// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Values and the words that files, command lines and settings know them by.

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

/// Each value once, each word once; in the order people should read them.
template <class Value, std::size_t count>
struct NamedValues {
  std::array<NamedValue<Value>, count> all;

  /// Empty for a value that has no word.
  constexpr const char* word(Value value) const {
    for (const NamedValue<Value>& named : all)
      if (named.value == value) return named.word;
    return "";
  }
  /// Empty for a word that stands for nothing.
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
