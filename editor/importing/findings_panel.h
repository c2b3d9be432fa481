// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Shows found and given values, step by step, with fields to correct them.

#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include "editor/document/view_settings.h"
#include "editor/importing/axis_box.h"
#include "editor/importing/curves_box.h"
#include "editor/importing/result_box.h"
#include "editor/importing/switches_box.h"

namespace detent::editor {

/// The import's confidence, and a box for each value that can be corrected. Every change can be undone, and
/// each given value has a button that restores the found one. GUI thread.
class FindingsPanel : public QScrollArea {
  Q_OBJECT

 public:
  /// Both must outlive it.
  FindingsPanel(ImportState& state, ViewSettings& settings, QWidget* parent = nullptr);

  /// Moves the keyboard focus to the field for an axis' values.
  void focusField(GraphAxis axis);
  void focusUnit(GraphAxis axis);
  void focusDpi();
  void focusSwitches();
  /// Returns true if all typed values can be read. If not, focuses the first field with an error.
  bool acceptable();

 signals:
  void toolRequested(PageToolKind kind);
  /// The content needs this width to be visible without horizontal scrolling.
  void widthWanted(int width_px);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void build();
  void addConfidence(QVBoxLayout& column);
  QGroupBox* frameBox();
  void connectState();
  void refresh();
  void showConfidence(const ImportGraph& graph);
  void showSteps(const std::shared_ptr<const importer::GraphEvidence>& evidence);
  void showFrame(const ImportGraph& graph, const std::shared_ptr<const importer::GraphEvidence>& evidence);
  void settleLayout();
  AxisBox& axis(GraphAxis which) { return which == GraphAxis::x ? *x_ : *y_; }

  ImportState& state_;
  ViewSettings& settings_;
  QLabel *confidence_, *cause_, *steps_;
  QProgressBar* sure_;
  QCheckBox* confirmed_;
  QGroupBox* frameBox_ = nullptr;
  OriginMark* frameOrigin_ = nullptr;
  QLabel* frameDetails_ = nullptr;
  SwitchesBox* switches_;
  AxisBox *x_, *y_;
  CurvesBox* curves_;
  ResultBox* result_;
  int wanted_px_ = 0;  ///< last width emitted by widthWanted()
  QTimer soon_;
};

}  // namespace detent::editor
