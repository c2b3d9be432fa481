// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Shows the present state of a force device: force, energy between finger and button, punctuality of the
// loop.

#include <QWidget>

#include "editor/document/view_settings.h"
#include "editor/feel/force_session.h"

namespace detent::editor {

/// Three bars with their numbers. GUI thread.
class ForceMeter : public QWidget {
  Q_OBJECT

 public:
  explicit ForceMeter(ViewSettings& settings, QWidget* parent = nullptr);

  /// `limit_N` > 0: the device's largest force.
  void show(const playback::ForceStatus& status, const ForceEnergy& energy, double limit_N);
  /// Shows that nothing runs.
  void setIdle();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Bar {
    QString name, text;
    double share = 0;  ///< 0..1
    bool bad = false;
  };
  void paintBar(QPainter& painter, const QRectF& row, const Bar& bar) const;

  ViewSettings& settings_;
  Bar bars_[3];
};

}  // namespace detent::editor
