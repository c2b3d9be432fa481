// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/import_worker.h"

namespace detent::editor {

void ImportWorker::answer(quint64 ticket, const Query& query, const StopFlag& stop) {
  constexpr qint64 reportEvery_ms = 25;
  sinceReport_.invalidate();
  importer::Progress progress;
  progress.cancelled = [stop] { return stop->load(std::memory_order_relaxed); };
  progress.report = [this, ticket](double fraction, importer::ImportStep step) {
    if (sinceReport_.isValid() && sinceReport_.elapsed() < reportEvery_ms) return;
    sinceReport_.start();
    emit progressed(ticket, fraction, step);
  };
  emit answered(ticket, std::make_shared<const Answer>(answers_.answer(query, progress)));
}

}  // namespace detent::editor
