// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/message.h"

#include <cmath>
#include <cstdio>

namespace detent {
namespace {

std::string numberText(double value, const char* unit) {
  char text[48];
  const bool large = std::abs(value) >= 1e6 && std::abs(value) < 1e9;  // "11000000 N", not "1.1e+07 N"
  std::snprintf(text, sizeof text, large ? "%.0f%s" : "%.6g%s", value, unit);
  return text;
}

std::string english(const MessageValue& value) {
  switch (value.measure) {
    case Measure::text:
      return value.text;
    case Measure::number:
      return numberText(value.number, "");
    case Measure::share: {
      char text[16];
      std::snprintf(text, sizeof text, "%.0f %%", 100 * value.number);
      return text;
    }
    case Measure::displacement_mm:
      return numberText(value.number, " mm");
    case Measure::force_N:
      return numberText(value.number, " N");
    case Measure::messages:
      return english(value.messages);
  }
  return {};
}

}  // namespace

MessageValue::MessageValue(std::string words) : text(std::move(words)) {}
MessageValue::MessageValue(std::string_view words) : text(words) {}
MessageValue::MessageValue(const char* words) : text(words) {}
MessageValue::MessageValue(double value, Measure itsMeasure) : measure(itsMeasure), number(value) {}
MessageValue::MessageValue(Message message) : measure(Measure::messages) {
  messages.push_back(std::move(message));
}
MessageValue::MessageValue(std::vector<Message> list)
    : measure(Measure::messages), messages(std::move(list)) {}

Message Message::of(const char* words, std::vector<MessageValue> values) {
  Message message;
  message.words_ = words;
  message.values_ = std::move(values);
  return message;
}

std::string filled(std::string_view pattern, const std::vector<std::string>& values) {
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool place =
        pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' && pattern[i + 1] <= '9';
    const auto index = place ? static_cast<std::size_t>(pattern[i + 1] - '1') : values.size();
    if (index < values.size()) {
      text += values[index];
      ++i;
    } else {
      text += pattern[i];
    }
  }
  return text;
}

std::string english(const Message& message) {
  std::vector<std::string> values;
  for (const MessageValue& value : message.values()) values.push_back(english(value));
  return filled(message.words(), values);
}

std::string english(const std::vector<Message>& messages) {
  std::string text;
  for (const Message& message : messages) text += (text.empty() ? "" : "; ") + english(message);
  return text;
}

}  // namespace detent
