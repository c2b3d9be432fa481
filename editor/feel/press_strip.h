// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The last seconds of pressing: depth over time, and the felt events at their times.

#include <deque>
#include <QWidget>
#include <vector>

#include "playback/playback.h"

namespace detent::editor {

/// A strip chart that moves while something happens and stops otherwise. GUI thread.
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
  /// Adds events. The last one happened at `time_s`; the times of the others follow from their frames.
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
