// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The last seconds of pressing: depth over time, and everything that was felt when it was felt.

#include <deque>
#include <QWidget>
#include <vector>

#include "playback/playback.h"

namespace detent::editor {

/// A strip chart that runs while something happens and stands still otherwise. GUI thread.
class PressStrip : public QWidget {
  Q_OBJECT

 public:
  static constexpr double span_s = 3;  ///< drawn

  explicit PressStrip(QWidget* parent = nullptr);

  struct Moment {
    double time_s = 0;
    double depth = 0;  ///< share of the travel
    bool releasing = false, contact = false;
  };
  /// Times on one steady clock, never decreasing.
  void addMoment(const Moment& moment);
  /// The last event happened at `time_s`, the others as much earlier as their frames say.
  void addEvents(const std::vector<playback::EngineEvent>& events, double time_s, double sampleRate_Hz);
  void clear();

  std::size_t eventCount() const { return events_.size(); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Felt {
    double time_s;
    playback::EventKind kind;
    std::uint32_t count;
  };
  void forget();

  std::deque<Moment> moments_;
  std::deque<Felt> events_;
  double now_s_ = 0;
};

}  // namespace detent::editor
