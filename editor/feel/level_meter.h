// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Output level: a bar in decibels, the highest peak held, and whether the limiter works.

#include <QElapsedTimer>
#include <QWidget>

namespace detent::editor {

/// GUI thread.
class LevelMeter : public QWidget {
  Q_OBJECT

 public:
  static constexpr double lowest_dB = -60;
  static constexpr double hold_s = 1.5;  ///< duration for which a peak is shown
  /// speed with which the bar falls, and the peak after its hold
  static constexpr double fall_dB_per_s = 40;
  /// share of the ceiling from which the limiter counts as active
  static constexpr double limiting = 0.985;

  explicit LevelMeter(QWidget* parent = nullptr);

  /// Peak of the last moment as a share of full scale, at `time_s` on any steady clock. `ceiling` is the
  /// limiter's, a share of full scale.
  void setLevel(double level, double ceiling, double time_s);
  /// Shows that there is no stream: empty, without texts.
  void setIdle();

  double shown_dB() const { return shown_dB_; }
  double peak_dB() const { return peak_dB_; }
  bool limited() const { return limited_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void describe();

  double shown_dB_ = lowest_dB, peak_dB_ = lowest_dB, ceiling_dB_ = 0;
  double time_s_ = 0, peakAt_s_ = 0, limitedAt_s_ = 0;
  bool limited_ = false, idle_ = true;
};

}  // namespace detent::editor
