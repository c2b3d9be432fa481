// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One tab: a document, its workspace, and the notices about it.

#include <memory>
#include <QPointer>
#include <QWidget>

#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/panels/graph_workspace.h"
#include "editor/window/magnetic_dialog.h"
#include "editor/window/notice_bar.h"
#include "model/validation.h"

namespace detent::editor {

/// Owns its document. Its side panels are made when they are first needed and go with it. GUI thread.
class DocumentTab : public QWidget {
  Q_OBJECT

 public:
  DocumentTab(std::unique_ptr<ButtonDocument> document, ViewSettings& settings, QWidget* parent = nullptr);
  ~DocumentTab() override;

  ButtonDocument& document() { return *document_; }
  GraphWorkspace& workspace() { return *workspace_; }
  NoticeBar& notices() { return *notices_; }
  /// The last choice of an export for a magnetic keyboard; not kept in the file.
  MagneticChoice& magneticChoice() { return magneticChoice_; }
  QWidget* valuesPanel();
  QWidget* inspector();
  QWidget* historyPanel();
  QWidget* checksPanel();
  QWidget* annotationsPanel();

 signals:
  /// The user wants to type numbers in the inspector.
  void inspectorWanted();
  /// An earlier version is to be opened as a button of its own.
  void versionOpened(const detent::Button& version);

 private:
  std::unique_ptr<ButtonDocument> document_;  // outlives everything that shows it
  ViewSettings& settings_;
  NoticeBar* notices_;
  GraphWorkspace* workspace_;
  MagneticChoice magneticChoice_;
  void showPlace(const WarningPlace& place);

  QPointer<QWidget> values_, inspector_, history_, checks_, annotations_;
};

}  // namespace detent::editor
