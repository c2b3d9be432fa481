// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measured curves over each other from first contact on, with a band for the scatter of all selected
// switches.

#include <optional>
#include <vector>

#include <qcustomplot.h>

#include "editor/document/display_units.h"
#include "importer/switch_library.h"

namespace detent::editor {

/// Mean and scatter of several presses at one displacement.
struct ScatterPoint {
  double displacement_mm = 0, mean_N = 0, sd_N = 0;  ///< sd of one record, n - 1
};

/// Mean and scatter over the common travel; empty for fewer than two.
std::vector<ScatterPoint> scatterOf(const std::vector<const importer::FeltShape*>& shapes);

/// Press solid, release dashed, one colour per switch. Beyond `mostCurves`, only the band represents the
/// switches. GUI thread.
class OverlayPlot : public QCustomPlot {
  Q_OBJECT

 public:
  static constexpr std::size_t mostCurves = 6;  ///< number of colours that can be distinguished

  explicit OverlayPlot(QWidget* parent = nullptr);

  /// A switch that is drawn.
  struct Entry {
    QString name;
    const importer::FeltShape* shape = nullptr;  ///< must outlive its display
  };
  /// The reference of the others (null: none) is drawn in the text's colour.
  void show(std::vector<Entry> entries, std::optional<importer::FeltShape> requested,
            const DisplayUnits& units);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void redraw();
  void layOutLegend();
  void drawShape(const importer::FeltShape& shape, const QPen& pen, const QString& name);
  void drawBand(const QColor& color);

  std::vector<Entry> entries_;
  std::optional<importer::FeltShape> requested_;
  DisplayUnits units_;
};

}  // namespace detent::editor
