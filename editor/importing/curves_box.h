// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Colours of press and release, masks, and the resolution of the drawn page.

#include <QCheckBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <vector>

#include "editor/document/view_settings.h"
#include "editor/importing/origin_mark.h"
#include "editor/importing/page_view.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {

/// Fields correct the current graph. GUI thread.
class CurvesBox : public QGroupBox {
  Q_OBJECT

 public:
  /// Both must outlive it.
  CurvesBox(ImportState& state, ViewSettings& settings, QWidget* parent = nullptr);

  /// Shows the current graph's curves; for a force meter's log only the exchange of strokes.
  void follow(bool ofLog);
  QuantityField* resolutionField() { return dpi_; }

 signals:
  void toolRequested(PageToolKind kind);

 private:
  QHBoxLayout* strokeRow(Stroke stroke);
  QHBoxLayout* maskRow();
  QHBoxLayout* resolutionRow();

  ImportState& state_;
  ViewSettings& settings_;
  QPushButton *press_ = nullptr, *release_ = nullptr;
  OriginMark *pressOrigin_ = nullptr, *releaseOrigin_ = nullptr, *dpiOrigin_ = nullptr;
  QCheckBox* swap_;
  QLabel *strokes_, *masks_ = nullptr;
  QToolButton* noMasks_ = nullptr;
  QuantityField* dpi_ = nullptr;
  std::vector<QWidget*> ofPage_;
};

}  // namespace detent::editor
