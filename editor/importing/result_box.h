// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Result of an import, in the units shown: travel, strokes, printed values, remarks, times.

#include <QGroupBox>
#include <QLabel>

#include "editor/document/view_settings.h"
#include "editor/importing/import_state.h"

namespace detent::editor {

/// Hidden while there is no result. GUI thread.
class ResultBox : public QGroupBox {
  Q_OBJECT

 public:
  /// `settings` must outlive it.
  explicit ResultBox(ViewSettings& settings, QWidget* parent = nullptr);

  /// Shows a report; null: no result.
  void follow(const importer::ImportReport* report, const std::vector<Failure>& refusedMarks);

 private:
  void showChecks(const importer::ImportReport& report, const std::vector<Failure>& refusedMarks);
  QString strokeText(const QString& name, const importer::StrokeReport& stroke) const;
  QString textOf(const importer::ImportReport& report) const;

  ViewSettings& settings_;
  QLabel *result_, *checks_, *warnings_, *seconds_;
};

}  // namespace detent::editor
