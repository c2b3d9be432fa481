// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Computes press signals off the GUI thread. Only the latest request is answered; older ones are dropped.

#include <cstdint>
#include <memory>
#include <QObject>
#include <utility>

#include "editor/document/latest_request.h"
#include "editor/feel/press_signal.h"

namespace detent::editor {

/// One worker thread, started by the first request. At most one request waits while one is computed, so an
/// answer is never older than two computations. The destructor waits some milliseconds for the running
/// computation. GUI thread, except where stated.
class PressSignalSource : public QObject {
  Q_OBJECT

 public:
  explicit PressSignalSource(QObject* parent = nullptr);

  /// Returns the revision of this request, which its answer repeats. There is no answer if a later request
  /// replaces this one before its computation starts.
  std::uint64_t request(PressSignalRequest request) { return answers_.ask(std::move(request)); }
  std::uint64_t lastRequested() const { return answers_.latest(); }

 signals:
  void ready(std::shared_ptr<const detent::editor::PressSignal> signal);

 private:
  LatestAnswer<PressSignalRequest> answers_;
};

}  // namespace detent::editor
