// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What was found and what was given, step by step, with fields to correct it.

#include <functional>
#include <memory>
#include <QScrollArea>
#include <QTimer>

#include "editor/document/view_settings.h"
#include "editor/importing/import_state.h"
#include "editor/importing/page_view.h"

namespace detent::editor {

/// Fields change the current graph's corrections as labelled steps; each given value has a button that goes
/// back to what was found.
class FindingsPanel : public QScrollArea {
  Q_OBJECT

 public:
  /// Both must outlive it.
  FindingsPanel(ImportState& state, ViewSettings& settings, QWidget* parent = nullptr);
  ~FindingsPanel() override;

  /// Puts the keyboard on the field that does it.
  void focusField(GraphAxis axis);
  void focusUnit(GraphAxis axis);
  void focusDpi();

 signals:
  void toolAsked(ToolKind kind);

 private:
  struct Fields;
  void build();
  void refresh();
  void settleLayout();
  void showAxis(GraphAxis axis);
  void showCurves();
  void showResult();
  void showChecks(const importer::ImportReport* report);
  void takeEnd(GraphAxis axis, bool isMax);
  void change(const QString& label, const std::function<void(Corrections&)>& edit);

  ImportState& state_;
  ViewSettings& settings_;
  std::unique_ptr<Fields> fields_;
  QTimer soon_;
};

}  // namespace detent::editor
