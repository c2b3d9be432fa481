// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Draws the feel of a press, or a signal of another program: vibration and its spectrogram over one time
// axis.

#include <memory>
#include <optional>
#include <QImage>
#include <QWidget>

#include "editor/document/graph_colors.h"
#include "editor/feel/press_signal.h"
#include "editor/feel/reference_drawing.h"

namespace detent::editor {

/// GUI thread.
class SignalView : public QWidget {
  Q_OBJECT

 public:
  explicit SignalView(QWidget* parent = nullptr);

  /// Sets the signal; null: nothing to show.
  void setSignal(std::shared_ptr<const PressSignal> signal);
  const std::shared_ptr<const PressSignal>& pressSignal() const { return press_; }
  /// Shows the signal of another program, with the name `name`.
  void setReference(std::shared_ptr<const ReferenceDrawing> reference, const QString& name);
  /// Sets the smallest duration (s) and level (share of full scale) of the axes, so that two views can be
  /// compared; 0: those of the signal.
  void setLeast(double duration_s, double peak);
  /// Time span of the axis.
  double drawnDuration_s() const { return layoutOf().duration_s; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// The signal of this revision has been drawn.
  void shown(quint64 revision);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Layout {
    QRectF wave, marks, spectrum;
    double toX(double time_s) const { return wave.left() + time_s / duration_s * wave.width(); }
    double duration_s = 1;
  };
  Layout layoutOf() const;
  void setDrawn(std::shared_ptr<const DrawnSignal> signal, const QString& heading, const QString& details);
  void paintWave(QPainter& painter, const Layout& layout, const GraphColors& colors) const;
  void paintMarks(QPainter& painter, const Layout& layout, const GraphColors& colors) const;
  void paintSpectrum(QPainter& painter, const Layout& layout, const GraphColors& colors);
  void paintTime(QPainter& painter, const Layout& layout, const GraphColors& colors) const;
  void paintCursor(QPainter& painter, const Layout& layout, const GraphColors& colors) const;
  QString readout(const Layout& layout) const;

  std::shared_ptr<const DrawnSignal> signal_;
  std::shared_ptr<const PressSignal> press_;  ///< `signal_` if it is a press signal; otherwise null
  QString heading_;
  double leastDuration_s_ = 0, leastPeak_ = 0;
  /// picture of the spectrogram, one pixel per column and row; made when it is first drawn
  QImage picture_;
  std::optional<QPointF> cursor_;
};

/// A level as a colour: dark violet to yellow, evenly brighter, so that it reads in grey and with any colour
/// vision (after matplotlib's viridis). From `floor_dB` up to 0.
QRgb levelColor(double level_dB, double floor_dB);
/// Below this the spectrogram is as dark as silence.
inline constexpr double spectrogramFloor_dB = -60;

}  // namespace detent::editor
