// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/signal_message.h"

#include <array>
#include <charconv>
#include <cmath>

namespace detent::playback {

namespace {

constexpr std::size_t mostMessageArguments = 3;

struct Name {
  std::string_view fudi;
  SignalKind kind;
};
constexpr std::array<Name, 8> names{{{"jump", SignalKind::jump},
                                     {"bottom", SignalKind::bottomOut},
                                     {"grain", SignalKind::grain},
                                     {"force", SignalKind::force},
                                     {"displacement", SignalKind::displacement},
                                     {"gain", SignalKind::gain},
                                     {"stop", SignalKind::stop},
                                     {"hold", SignalKind::hold}}};

bool isBurst(SignalKind kind) {
  return kind == SignalKind::jump || kind == SignalKind::bottomOut || kind == SignalKind::grain;
}

bool build(SignalKind kind, const double* arguments, std::size_t count, SignalMessage& message) {
  message = SignalMessage{};
  message.kind = kind;
  if (kind == SignalKind::stop) return true;
  // Keys of controllers always send one number: 0 when they are released.
  if (count == 1 && (kind == SignalKind::grain || kind == SignalKind::hold)) {
    if (arguments[0] == 0) message.kind = SignalKind::none;
    count = 0;
  }
  if (message.kind == SignalKind::none || kind == SignalKind::hold) return true;
  if (!isBurst(kind)) {
    if (count != 1) return false;
    message.value = arguments[0];
    return acceptable(message);
  }
  if (count == 0 && kind == SignalKind::grain) {
    message.bare = true;
    return true;
  }
  if (count != mostMessageArguments) return false;
  message.burst = {arguments[0], arguments[1] * 1e-3, arguments[2],
                   kind == SignalKind::bottomOut ? Envelope::rising : Envelope::falling};
  return acceptable(message);
}

bool separates(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ','; }

bool parseMessage(std::string_view text, SignalMessage& message) {
  std::array<double, mostMessageArguments> arguments{};
  std::size_t count = 0;
  std::string_view name;
  while (!text.empty()) {
    while (!text.empty() && separates(text.front())) text.remove_prefix(1);
    std::size_t length = 0;
    while (length < text.size() && !separates(text[length])) ++length;
    if (length == 0) break;
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(length);
    if (name.empty()) {
      name = word;
      continue;
    }
    if (count == arguments.size()) return false;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), arguments[count]);
    if (error != std::errc() || end != word.data() + word.size()) return false;
    ++count;
  }
  for (const Name& n : names) {
    if (n.fudi == name) return build(n.kind, arguments.data(), count, message);
  }
  return false;
}

bool blank(std::string_view text) {
  for (char c : text) {
    if (!separates(c)) return false;
  }
  return true;
}

void append(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text += ' ';
  if (error == std::errc()) text.append(digits.data(), end);
}

}  // namespace

bool acceptable(const SignalMessage& m) {
  if (isBurst(m.kind)) {
    if (m.bare) return m.kind == SignalKind::grain;
    const Burst& b = m.burst;
    return b.frequency_Hz > 0 && b.frequency_Hz <= 2000 && b.duration_s > 0 && b.duration_s <= 1 &&
           b.amplitude >= 0 && b.amplitude <= 1;
  }
  if (!std::isfinite(m.value)) return false;
  return m.kind != SignalKind::gain || (m.value >= 0 && m.value <= 1);
}

void parseFudi(std::string_view packet, SignalCounts& counts,
               const std::function<void(const SignalMessage&)>& onMessage) {
  ++counts.packets;
  while (!packet.empty()) {
    const std::size_t end = packet.find(';');
    const std::string_view text = packet.substr(0, end);
    packet = end == std::string_view::npos ? std::string_view{} : packet.substr(end + 1);
    if (blank(text)) continue;
    SignalMessage message;
    if (parseMessage(text, message)) {
      ++counts.messages;
      if (message.kind != SignalKind::none) onMessage(message);
    } else {
      ++counts.malformed;
    }
  }
}

std::string toFudi(const SignalMessage& message) {
  std::string text;
  for (const Name& n : names) {
    if (n.kind == message.kind) text = n.fudi;
  }
  if (message.kind == SignalKind::stop || message.kind == SignalKind::hold) return text + ";\n";
  if (!isBurst(message.kind)) {
    append(text, message.value);
  } else if (!message.bare) {
    append(text, message.burst.frequency_Hz);
    append(text, message.burst.duration_s * 1e3);
    append(text, message.burst.amplitude);
  }
  return text + ";\n";
}

bool fromOsc(std::string_view address, const double* arguments, std::size_t count, SignalMessage& message) {
  constexpr std::string_view prefix = "/detent/";
  if (address.substr(0, prefix.size()) != prefix) return false;
  for (const Name& n : names) {
    if (address.substr(prefix.size()) == n.fudi) return build(n.kind, arguments, count, message);
  }
  return false;
}

}  // namespace detent::playback
