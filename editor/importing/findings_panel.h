// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What was found and what was given, step by step, with fields to correct it.

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

/// How sure the import is, and a box for each thing that can be corrected: every change is a labelled step of the
/// current graph, each given value has a button that goes back to what was found. GUI thread.
class FindingsPanel : public QScrollArea {
  Q_OBJECT

 public:
  /// Both must outlive it.
  FindingsPanel(ImportState& state, ViewSettings& settings, QWidget* parent = nullptr);

  /// Puts the keyboard on the field that does it.
  void focusField(GraphAxis axis);
  void focusUnit(GraphAxis axis);
  void focusDpi();
  void focusSwitches();
  /// Whether all that is typed can be read. Where not, puts the keyboard on the first such field, which says why.
  bool acceptable();

 signals:
  void toolRequested(PageToolKind kind);
  /// What is said now needs more room than before to be seen without scrolling sideways.
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
  int wanted_px_ = 0;  ///< widthWanted() last said
  QTimer soon_;
};

}  // namespace detent::editor
