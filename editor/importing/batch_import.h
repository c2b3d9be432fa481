// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Imports every graph of many files in the background, in threads of the editor.

#include <atomic>
#include <memory>
#include <optional>
#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <vector>

#include "editor/document/display_units.h"
#include "editor/importing/import_queries.h"
#include "model/button.h"

namespace detent::editor {

/// Result of one graph, in words; of a file that cannot be read, of the file.
struct BatchResult {
  GraphId graph;                 ///< page 0: the whole file
  std::optional<Button> button;  ///< none: the graph was refused
  double confidence = 0;         ///< 0..1, with a button
  QString question;              ///< would settle a refusal; with its choices
  QString reason;                ///< of a refusal, or why a button is not more certain
};

/// One batch at a time. Files are imported beside each other, on all cores but one. GUI thread.
class BatchImport : public QObject {
  Q_OBJECT

 public:
  explicit BatchImport(QObject* parent = nullptr);
  /// Waits for the running imports, which end soon.
  ~BatchImport() override;

  /// `units`: of the reasons. What still runs is cancelled.
  void start(const QStringList& paths, const DisplayUnits& units);
  /// Files that are not finished give no result any more.
  void cancel();
  bool isRunning() const { return left_ > 0; }

 signals:
  void started(int file);                                            ///< its place in the list of paths
  void finished(int file, const std::vector<BatchResult>& results);  ///< at least one result
  /// All files are finished, or the batch was cancelled.
  void ended();

 private:
  void take(int batch, int file, const std::vector<BatchResult>& results);

  QThreadPool workers_;
  std::shared_ptr<std::atomic<bool>> cancelled_;  ///< of the batch that runs
  int batch_ = 0, left_ = 0;
};

}  // namespace detent::editor
