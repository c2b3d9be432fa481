// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The pad for pressing: converts mouse, keys, pen and touch to a finger, and shows the button's position.

#include <optional>
#include <QElapsedTimer>
#include <QPointingDevice>
#include <QString>
#include <QWidget>
#include <vector>

#include "editor/document/view_settings.h"
#include "model/sections.h"

class QTouchEvent;

namespace detent::editor {

/// Meaning of a mouse drag or a touch without pressure. Keys always press by time, pens by pressure.
enum class Drive {
  time,   ///< a human-like press as long as the button is held
  depth,  ///< dragging down presses deeper
  force   ///< dragging down presses harder
};

/// Properties of a button that the pad draws. Plain value.
struct PadButton {
  QString name, stateName;
  double start_mm = 0, end_mm = 0;  ///< end_mm > start_mm, unless the button has no travel
  double full_N = 1;                ///< force of a full press; > 0
  std::vector<TactilePoint> pressPoints, releasePoints;
  std::optional<double> operating_mm, reset_mm;
};

/// Position of the pad. Plain value.
struct PadMotion {
  double displacement_mm = 0, force_N = 0;
  bool pressed = false, releasing = false, contact = false;
};

/// The pad. GUI thread.
class PressPad : public QWidget {
  Q_OBJECT

 public:
  explicit PressPad(ViewSettings& settings, QWidget* parent = nullptr);

  /// Sets the button that is drawn. Null: nothing can be pressed, and `why` is shown instead.
  void setButton(std::optional<PadButton> button, const QString& why = {});
  void setMotion(const PadMotion& motion);
  /// Lights the mark of an event for a quarter of a second.
  enum class Lamp { pressJump, releaseJump, bottomOut };
  void flash(Lamp lamp);
  void setDrive(Drive drive) { drive_ = drive; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void timedDown();
  void timedUp();
  void forceMoved(double share);  ///< of a full press, 0..1
  void depthMoved(double share);  ///< of the travel, 0..1
  void lifted();                  ///< ends forceMoved and depthMoved

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void timerEvent(QTimerEvent* event) override;

 private:
  enum class Source { mouse, key, pen, touch };

  bool begin(Source source, double y_px, bool byPressure);
  void move(Source source, double y_px, double pressure);
  void end(Source source);
  bool touch(QTouchEvent& event);
  double dragShare(double y_px) const;
  QRectF scaleArea() const;
  QRectF capArea() const;
  QRectF forceArea() const;
  void paintDepth(QPainter& painter) const;
  void paintCap(QPainter& painter) const;
  void paintForce(QPainter& painter) const;
  void paintReadout(QPainter& painter) const;
  double depthShare(double displacement_mm) const;
  double lampGlow(Lamp lamp) const;
  bool isAtEnd() const;

  ViewSettings& settings_;
  std::optional<PadButton> button_;
  QString why_;
  PadMotion motion_;
  Drive drive_ = Drive::time;
  std::optional<Source> held_;
  int heldKey_ = 0;
  bool timed_ = false, byForce_ = false;
  double heldFrom_px_ = 0;
  QElapsedTimer clock_;
  qint64 flashed_ms_[3] = {-10000, -10000, -10000};
  int fadeTimer_ = 0;
};

}  // namespace detent::editor
