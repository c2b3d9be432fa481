// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Misses against effort: one dot per button, with the band over the fingers both ways.

#include <memory>
#include <vector>

#include <qcustomplot.h>

#include "editor/document/display_units.h"
#include "playback/pressing.h"

namespace detent::editor {

/// Effort is the peak force of the fingertip. Colours are those of the comparison; a button without a
/// forecast has no dot. GUI thread.
class EffortPlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit EffortPlot(QWidget* parent = nullptr);

  /// `names` as long as `forecasts`.
  void setForecasts(const std::vector<std::shared_ptr<const playback::PressForecast>>& forecasts,
                    const std::vector<QString>& names, const DisplayUnits& units);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void redraw();

  std::vector<std::shared_ptr<const playback::PressForecast>> forecasts_;
  std::vector<QString> names_;
  DisplayUnits units_;
};

}  // namespace detent::editor
