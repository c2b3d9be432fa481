// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The middle of the window: a tab per open button, or the welcome page.

#include <QStackedWidget>
#include <QTabWidget>
#include <vector>

#include "editor/window/document_tab.h"
#include "editor/window/welcome_page.h"

namespace detent::editor {

/// Owns the tabs. GUI thread.
class TabArea : public QStackedWidget {
  Q_OBJECT

 public:
  /// Takes ownership of `welcome`.
  TabArea(WelcomePage* welcome, ViewSettings& settings, QWidget* parent = nullptr);
  ~TabArea() override;

  /// Adds a tab for the document, shows it and returns it.
  DocumentTab& add(std::unique_ptr<ButtonDocument> document);
  /// Closes a tab without a question. Listeners to tabClosing() must release it.
  void remove(DocumentTab& tab);

  DocumentTab* current() const;
  void show(ButtonDocument& document);
  void showNext(int step);
  /// All tabs, in their order.
  std::vector<DocumentTab*> all() const;
  std::vector<ButtonDocument*> documents() const;
  /// The tab with this file, if it is open.
  DocumentTab* withPath(const QString& path) const;
  DocumentTab* tabOf(const ButtonDocument* document) const;

 signals:
  /// Another tab is shown, or none (null).
  void currentTabChanged(detent::editor::DocumentTab* tab);
  void tabAdded(detent::editor::DocumentTab* tab);
  void tabClosing(detent::editor::DocumentTab* tab);
  /// The cross of a tab was pressed.
  void closeRequested(detent::editor::DocumentTab* tab);
  /// Tabs came, went or moved.
  void documentsChanged();

 private:
  void updateTitles();
  DocumentTab* at(int index) const;
  ViewSettings& settings_;
  QTabWidget* tabs_;
};

}  // namespace detent::editor
