// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Many sheets imported in the background: a list of results, from which each leads to the import dialogue.

#include <functional>
#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>

#include "editor/document/view_settings.h"
#include "editor/importing/batch_import.h"

namespace detent::editor {

/// Questions to the user, and actions of the main window.
struct BatchActions {
  std::function<QStringList(QWidget* parent)> files;
  std::function<QString(QWidget*parent)> folder, folderToSave;      ///< empty: cancelled
  std::function<void(const QString& path, GraphId graph)> correct;  ///< in the import dialogue
  std::function<void(const QString& path, const Button& button)> open;
};

/// Stays beside the window; closing it cancels the batch. GUI thread.
class BatchDialog : public QDialog {
  Q_OBJECT

 public:
  /// `view` must outlive it.
  BatchDialog(const ViewSettings& view, BatchActions actions, QWidget* parent = nullptr);

  /// Imports these files in place of the listed ones.
  void start(const QStringList& paths);
  /// Shows the result of a listed graph that a person has imported in the import dialogue.
  void takeChecked(const QString& path, const importer::ImportReport& report);
  void done(int result) override;

 private:
  struct Row {
    QString path;
    BatchResult result;
  };
  QLayout* chooserRow();
  QLayout* actionRow();
  void take(int file, const std::vector<BatchResult>& results);
  void fill(QTreeWidgetItem& item, const QString& name, const QString& path, const BatchResult& result);
  /// The row of a list's item; null for a file that has items of its own, or no result yet.
  const Row* rowOf(const QTreeWidgetItem& item) const;
  void showResult(QTreeWidgetItem& item);
  void showProgress();
  void follow();
  std::vector<const Row*> chosen() const;
  void correct(const QTreeWidgetItem& item);
  void save();
  void ended();

  const ViewSettings& view_;
  BatchActions at_;
  BatchImport batch_{this};
  std::vector<Row> rows_;  ///< index: the number stored in the list's item
  QStringList paths_;
  int finished_ = 0;
  QTreeWidget* list_;
  QProgressBar* progress_;
  QLabel* summary_;
  QPushButton *files_ = nullptr, *folder_ = nullptr, *stop_ = nullptr, *correct_ = nullptr, *open_ = nullptr,
              *save_ = nullptr;
};

}  // namespace detent::editor
