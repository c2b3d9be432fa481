// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measures how long the GUI thread kept the event loop waiting.

#include <algorithm>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <time.h>

namespace detent::editor {

/// Processor time of the calling thread.
inline double threadTime_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// A timer that should fire every `period_ms`; what it comes late is a stall. On a busy machine a stall is
/// mostly other programs' time: `longestOwn_ms` counts only what the GUI thread itself computed in between.
/// GUI thread, while an event loop runs.
class StallProbe : public QObject {
 public:
  explicit StallProbe(QObject* parent = nullptr) : QObject(parent) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(period_ms);
    connect(&timer_, &QTimer::timeout, this, [this] {
      longest_ms_ = std::max(longest_ms_, since_.elapsed() - period_ms);
      since_.restart();
      const double own_ms = threadTime_ms();
      longestOwn_ms_ = std::max(longestOwn_ms_, own_ms - ownBefore_ms_);
      ownBefore_ms_ = own_ms;
    });
    restart();
  }
  void restart() {
    longest_ms_ = 0, longestOwn_ms_ = 0;
    ownBefore_ms_ = threadTime_ms();
    since_.start();
    timer_.start();
  }
  qint64 longest_ms() const { return std::max(longest_ms_, since_.elapsed() - period_ms); }
  double longestOwn_ms() const { return std::max(longestOwn_ms_, threadTime_ms() - ownBefore_ms_); }

 private:
  static constexpr int period_ms = 2;
  QTimer timer_;
  QElapsedTimer since_;
  qint64 longest_ms_ = 0;
  double longestOwn_ms_ = 0, ownBefore_ms_ = 0;
};

}  // namespace detent::editor
