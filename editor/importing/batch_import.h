// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Imports every graph of many files in the background, each file in its own process, as detent-import
// --batch: a crash costs that file only.

#include <optional>
#include <QList>
#include <QObject>
#include <QProcess>
#include <QStringList>
#include <vector>

#include "editor/document/display_units.h"
#include "editor/importing/import_queries.h"
#include "model/button.h"

namespace detent::editor {

/// Result of one graph, or of one of its switches; for a file that cannot be read, of the whole file.
struct BatchResult {
  GraphId graph;                 ///< page 0: the whole file
  std::optional<Button> button;  ///< none: the graph was refused
  double confidence = 0;         ///< 0..1, with a button
  QString question;              ///< question that would settle a refusal, with its choices
  QString reason;                ///< reason for a refusal, or for a low confidence
  bool checked = false;          ///< imported by a person, in the import dialogue
  int curve = 0;                 ///< number of the switch in a plot with several, from 1
  QString curveName = {};        ///< as the plot names it; may be empty
};
BatchResult resultOf(GraphId graph, const importer::ImportReport& report, const DisplayUnits& units);

/// First word of the command line of a process that imports one file of a batch; the program must then
/// return importForBatch(the other words).
inline constexpr char batchWorkerOption[] = "--batch-worker";
/// Imports the file that the words name and writes its results to the standard output.
int importForBatch(const QStringList& words);

/// One batch at a time. Several files are imported in parallel, on all cores but one. GUI thread.
class BatchImport : public QObject {
  Q_OBJECT

 public:
  explicit BatchImport(QObject* parent = nullptr) : QObject(parent) {}
  ~BatchImport() override;

  /// `units`: for the reasons. Cancels imports that are still running.
  void start(const QStringList& paths, const DisplayUnits& units);
  /// Cancels the batch; unfinished files give no result.
  void cancel();
  bool isRunning() const { return left_ > 0; }

 signals:
  void started(int file);                                            ///< its place in the list of paths
  void finished(int file, const std::vector<BatchResult>& results);  ///< at least one result
  /// All files are finished, or the batch was cancelled.
  void ended();

 private:
  void startNext();
  void take(QProcess& process, int file);

  QStringList paths_;
  DisplayUnits units_;
  QList<QProcess*> running_;
  int next_ = 0, left_ = 0;
};

}  // namespace detent::editor
