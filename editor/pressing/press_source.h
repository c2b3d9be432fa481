// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecasts of a press off the GUI thread: the latest request wins, what it overtook is given up.

#include <cstdint>
#include <memory>
#include <optional>
#include <QObject>
#include <utility>
#include <vector>

#include "editor/document/latest_request.h"
#include "playback/pressing.h"

namespace detent::editor {

/// In the order of the requested buttons.
struct PressAnswer {
  std::uint64_t revision = 0;
  std::vector<std::shared_ptr<const playback::PressForecast>> forecasts;
};

/// One worker thread, begun with the first request. A forecast takes seconds: those of the last requests are
/// kept, so that an edit of one of six costs one. Its end gives up what runs, and waits some milliseconds.
/// GUI thread, except where said.
class PressSource : public QObject {
  Q_OBJECT

 public:
  explicit PressSource(QObject* parent = nullptr);

  /// `operateAt_mm`: where the contact of all closes instead. Gives the revision of the answer, unless a
  /// later request overtakes it.
  std::uint64_t request(std::vector<Button> buttons, std::optional<double> operateAt_mm) {
    return answers_.ask({std::move(buttons), operateAt_mm});
  }
  void cancel() { answers_.cancel(); }  ///< no answer comes for earlier requests

 signals:
  void progress(int done, int all);  ///< buttons
  void ready(std::shared_ptr<const detent::editor::PressAnswer> answer);

 private:
  struct Wanted {
    std::vector<Button> buttons;
    std::optional<double> operateAt_mm;
  };
  using Asked = LatestAnswer<Wanted>::Asked;
  struct Kept {
    Button button;
    std::optional<double> operateAt_mm;
    std::shared_ptr<const playback::PressForecast> forecast;
  };
  void answer(const Asked& asked);  // worker thread
  /// Worker thread; null when overtaken.
  std::shared_ptr<const playback::PressForecast> forecastOf(const Button& button, const Asked& asked);

  std::vector<Kept> kept_;        // of the worker thread; the oldest first
  LatestAnswer<Wanted> answers_;  // last: its thread uses the others
};

}  // namespace detent::editor
