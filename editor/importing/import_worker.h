// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The object on the import thread that answers queries.

#include <atomic>
#include <memory>
#include <QElapsedTimer>
#include <QObject>

#include "editor/importing/import_queries.h"

namespace detent::editor {

/// Lives on the import thread and owns the open document. Each call of `ask` is answered by one `answered`.
/// `stop` may be set from any thread and ends the work soon, with a Failure.
class ImportWorker : public QObject {
  Q_OBJECT

 public:
  using StopFlag = std::shared_ptr<std::atomic<bool>>;
  void answer(quint64 ticket, const Query& query, const StopFlag& stop);

 signals:
  void answered(quint64 ticket, std::shared_ptr<const Answer> answer);
  /// Emitted at most 40 times a second.
  void progressed(quint64 ticket, double fraction, importer::ImportStep step);

 private:
  ImportAnswers answers_;
  QElapsedTimer sinceReport_;
};

}  // namespace detent::editor
