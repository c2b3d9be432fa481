// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Press signals off the GUI thread: the latest request wins, what it overtook is never computed.

#include <cstdint>
#include <memory>
#include <QObject>

#include "editor/document/latest_request.h"
#include "editor/feel/press_signal.h"

namespace detent::editor {

/// One worker thread, begun with the first request. At most one request waits while one is computed, so an
/// answer is never older than two computations. Its end waits for the running computation, some milliseconds. GUI
/// thread, except where said.
class PressSignalSource : public QObject {
  Q_OBJECT

 public:
  explicit PressSignalSource(QObject* parent = nullptr);

  /// Gives the revision that the answer will carry, unless a later request overtakes it.
  std::uint64_t request(PressSignalRequest request);
  std::uint64_t lastRequested() const { return requested_; }

 signals:
  void ready(std::shared_ptr<const detent::editor::PressSignal> signal);

 private:
  struct Waiting {
    std::uint64_t revision;
    PressSignalRequest request;
  };
  void compute(const Waiting& next);  // worker thread

  std::uint64_t requested_ = 0;
  LatestRequest<Waiting> requests_;
};

}  // namespace detent::editor
