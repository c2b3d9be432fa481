// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What there is to say, before anybody says it: an English pattern and the values that go into it. Each edge makes
// its own words of it: the command line and JSON in English, the editor in the person's language, number style and
// units.

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace detent {

class Message;

/// What a value of a message measures, so that an edge can show it in the units it uses.
enum class Measure {
  text,             ///< as it is: a name, a symbol, what stands on the page
  number,           ///< without a unit
  share,            ///< 0..1, shown in percent
  displacement_mm,  ///< a length of the travel
  force_N,
  messages  ///< said in their turn, joined by semicolons
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

/// Something to say. Plain value, any thread.
class Message {
 public:
  Message() = default;
  /// `words` is a literal; %1 to %9 stand for the values.
  template <std::size_t n, class... Values>
  Message(const char (&words)[n], Values&&... values)
      : words_(words), values_{MessageValue(std::forward<Values>(values))...} {}
  /// Words that were made while running: an error text of the system, what stands in a file. Kept as they are.
  Message(std::string text) : words_(text.empty() ? "" : "%1") {
    if (!text.empty()) values_.emplace_back(std::move(text));
  }
  template <std::size_t n>
  Message(char (&buffer)[n]) : Message(std::string(buffer)) {}
  Message(std::same_as<const char*> auto text) : Message(std::string(text)) {}
  /// As the first constructor, for patterns in a table; `words` must live for ever.
  static Message of(const char* words, std::vector<MessageValue> values);

  bool empty() const { return *words_ == '\0'; }
  const char* words() const { return words_; }
  const std::vector<MessageValue>& values() const { return values_; }

 private:
  const char* words_ = "";
  std::vector<MessageValue> values_;
};

// Below Message, which it holds: a constructor's body asks for the destructor of what it builds.
MessageValue::MessageValue(std::integral auto count)
    : MessageValue(static_cast<double>(count), Measure::number) {}

inline MessageValue millimetres(double value_mm) { return {value_mm, Measure::displacement_mm}; }
inline MessageValue newtons(double value_N) { return {value_N, Measure::force_N}; }

/// `pattern` with %1, %2 ... replaced by `values`.
std::string filled(std::string_view pattern, const std::vector<std::string>& values);

/// As the command line says it: English, mm and N.
std::string english(const Message& message);
/// Several, joined by semicolons.
std::string english(const std::vector<Message>& messages);

}  // namespace detent
