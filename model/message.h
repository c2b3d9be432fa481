// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A message as an English pattern with values. Each edge words it: command line and JSON in English, the
// editor in the user's language, number style and units.

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace detent {

class Message;

/// Quantity of a message value, so that an edge can show it in its own units.
enum class Measure {
  text,             ///< shown unchanged: a name, a symbol, text of the page
  number,           ///< without a unit
  share,            ///< 0..1, shown in per cent
  displacement_mm,  ///< a displacement
  force_N,
  messages  ///< nested messages, joined by semicolons
};

/// One value of a message.
struct MessageValue {
  MessageValue(std::string words);
  MessageValue(std::string_view words);
  MessageValue(const char* words);
  MessageValue(std::integral auto count);
  MessageValue(double value, Measure itsMeasure = Measure::number);
  MessageValue(Message message);
  MessageValue(std::vector<Message> list);

  Measure measure = Measure::text;
  double number = 0;
  std::string text;
  std::vector<Message> messages;
};

/// A message. Plain value, any thread.
class Message {
 public:
  Message() = default;
  /// `words` is a literal; %1 to %9 are replaced by the values.
  template <std::size_t n, class... Values>
  Message(const char (&words)[n], Values&&... values)
      : words_(words), values_{MessageValue(std::forward<Values>(values))...} {}
  /// Text made at run time, such as a system error or the contents of a file; shown unchanged.
  Message(std::string text) : words_(text.empty() ? "" : "%1") {
    if (!text.empty()) values_.emplace_back(std::move(text));
  }
  template <std::size_t n>
  Message(char (&buffer)[n]) : Message(std::string(buffer)) {}
  Message(std::same_as<const char*> auto text) : Message(std::string(text)) {}
  /// Like the first constructor, for patterns in a table; `words` must have static lifetime.
  static Message of(const char* words, std::vector<MessageValue> values);

  bool empty() const { return *words_ == '\0'; }
  const char* words() const { return words_; }
  const std::vector<MessageValue>& values() const { return values_; }

 private:
  const char* words_ = "";
  std::vector<MessageValue> values_;
};

// Defined after Message, which it contains.
MessageValue::MessageValue(std::integral auto count)
    : MessageValue(static_cast<double>(count), Measure::number) {}

inline MessageValue millimetres(double value_mm) { return {value_mm, Measure::displacement_mm}; }
inline MessageValue newtons(double value_N) { return {value_N, Measure::force_N}; }

/// `pattern` with %1, %2 ... replaced by `values`.
std::string filled(std::string_view pattern, const std::vector<std::string>& values);

/// Returns the wording of the command line: English, mm and N.
std::string english(const Message& message);
/// Joins several messages by semicolons.
std::string english(const std::vector<Message>& messages);

}  // namespace detent
