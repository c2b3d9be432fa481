// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The link between a handle and a computer: encoder steps, and the delay of messages in each direction.

#include <cmath>
#include <deque>
#include <optional>
#include <random>

namespace detent::test {

inline double quantised_mm(double position_mm, double step_mm) {
  return step_mm > 0 ? std::floor(position_mm / step_mm + 0.5) * step_mm : position_mm;
}

/// Uniform numbers that are the same on every machine (std::uniform_real_distribution promises none of that).
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(between(0, static_cast<double>(count)));
  }
  bool once(double probability) { return between(0, 1) < probability; }

 private:
  std::mt19937_64 engine_;
};

struct TransportSettings {
  double delay_s = 0;   ///< delay of every message
  double jitter_s = 0;  ///< random addition, 0 to this, drawn for each message
  double lost = 0;      ///< share that never arrives
};

/// Messages in order; one that is late holds up those behind it, as a serial line does.
template <class Message>
class Transport {
 public:
  Transport(const TransportSettings& settings, std::uint64_t seed) : settings_(settings), chance_(seed) {}

  void send(double now_s, const Message& message) {
    const double due_s = now_s + settings_.delay_s + chance_.between(0, settings_.jitter_s);
    if (chance_.once(settings_.lost)) return;
    waiting_.push_back({waiting_.empty() ? due_s : std::max(due_s, waiting_.back().due_s), message});
  }
  /// The newest message that has arrived since the last call; older ones are overtaken.
  std::optional<Message> newest(double now_s) {
    std::optional<Message> newest;
    while (!waiting_.empty() && waiting_.front().due_s <= now_s + 1e-9) {
      newest = waiting_.front().message;
      waiting_.pop_front();
    }
    return newest;
  }

 private:
  struct Waiting {
    double due_s;
    Message message;
  };
  TransportSettings settings_;
  Chance chance_;
  std::deque<Waiting> waiting_;
};

}  // namespace detent::test
