// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecasts of confusion off the GUI thread: the latest request wins, what it overtook is given up.

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <QObject>
#include <thread>
#include <vector>

#include "playback/playback.h"

namespace detent::editor {

/// All pairs of the buttons asked for, by playback::pairsOf: (0,1), (0,2), (1,2), ...
struct Forecast {
  std::uint64_t revision = 0;
  std::vector<playback::PredictedPair> pairs;
  QString trouble;  ///< why there are none; empty otherwise
};

/// One worker thread, begun with the first request. What a button feels like is kept, so that an edit of one
/// of fifty costs one. GUI thread, except where said.
class ForecastSource : public QObject {
  Q_OBJECT

 public:
  explicit ForecastSource(QObject* parent = nullptr);
  ~ForecastSource() override;  ///< gives up what runs, waits some milliseconds

  /// Gives the revision of the answer, unless a later request overtakes it.
  std::uint64_t request(std::vector<Button> buttons);
  void cancel();  ///< no answer comes for what was asked so far

 signals:
  void progress(std::uint64_t revision, int done, int all);
  void ready(std::shared_ptr<const detent::editor::Forecast> forecast);

 private:
  struct Waiting {
    std::uint64_t revision = 0;
    std::vector<Button> buttons;
  };
  struct Felt {
    Button button;
    playback::FeltButton felt;
  };
  void run();                                       // worker thread
  std::optional<Forecast> compute(const Waiting&);  // worker thread; nothing when overtaken
  bool overtaken(std::uint64_t revision) const { return latest_ != revision; }

  std::atomic<std::uint64_t> latest_{0};
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Waiting> waiting_;
  bool stopping_ = false;
  std::vector<Felt> kept_;  // worker thread
  std::thread worker_;
};

}  // namespace detent::editor
