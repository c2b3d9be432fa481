// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Signals of other programs, read off the GUI thread: the latest file wins.

#include <cstdint>
#include <memory>
#include <QObject>
#include <string>
#include <vector>

#include "editor/document/latest_request.h"
#include "editor/feel/drawn_signal.h"

namespace detent::editor {

/// An AHAP, .haptic, HJIF or sound file beside a button's own signal.
struct ReferenceDrawing : DrawnSignal {
  std::vector<Message> notes;  ///< what of the file is not played, or played differently
};

/// Reads and draws `file`. Some 100 ms; any thread.
ReferenceDrawing referenceDrawingOf(const std::string& file);

/// One worker thread, begun with the first request. GUI thread, except where said.
class ReferenceSource : public QObject {
  Q_OBJECT

 public:
  explicit ReferenceSource(QObject* parent = nullptr);

  /// A later request overtakes one that waits.
  void request(const std::string& file);
  /// What is asked for or under way is not told any more.
  void forget() { ++requested_; }

 signals:
  /// Of the last request.
  void ready(std::shared_ptr<const detent::editor::ReferenceDrawing> drawing);

 private:
  struct Waiting {
    std::uint64_t revision;
    std::string file;
  };
  void read(const Waiting& next);  // worker thread

  std::uint64_t requested_ = 0;
  LatestRequest<Waiting> requests_;
};

}  // namespace detent::editor
