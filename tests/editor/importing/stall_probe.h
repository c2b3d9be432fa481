#pragma once
// How long the GUI thread kept the event loop waiting.

#include <algorithm>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace detent::editor {

/// A timer that should fire every `period_ms`; what it comes late is a stall. GUI thread, while an event loop
/// runs.
class StallProbe : public QObject {
 public:
  explicit StallProbe(QObject* parent = nullptr) : QObject(parent) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(period_ms);
    connect(&timer_, &QTimer::timeout, this, [this] {
      longest_ms_ = std::max(longest_ms_, since_.elapsed() - period_ms);
      since_.restart();
    });
    restart();
  }
  void restart() {
    longest_ms_ = 0;
    since_.start();
    timer_.start();
  }
  qint64 longest_ms() const { return std::max(longest_ms_, since_.elapsed() - period_ms); }

 private:
  static constexpr int period_ms = 2;
  QTimer timer_;
  QElapsedTimer since_;
  qint64 longest_ms_ = 0;
};

}  // namespace detent::editor
