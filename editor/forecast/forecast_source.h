// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecasts of confusion off the GUI thread: the latest request wins, what it overtook is given up.

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <QObject>
#include <QString>
#include <utility>
#include <vector>

#include "editor/document/latest_request.h"
#include "playback/study.h"

namespace detent::editor {

enum class ForecastPairs : std::uint8_t {
  all,     ///< (0,1), (0,2), (1,2), (0,3), ...: as playback::pairsOf
  ofFirst  ///< (0,1), (0,2), (0,3), ...
};

/// The pairs that were asked for, in their order.
struct Forecast {
  std::uint64_t revision = 0;
  std::vector<playback::PredictedPair> pairs;
  QString trouble;  ///< why there are none; empty otherwise
};

/// One worker thread, begun with the first request. What a button feels like and what was said of a pair is kept, so
/// that an edit of one of fifty costs one button and its pairs. GUI thread, except where said.
class ForecastSource : public QObject {
  Q_OBJECT

 public:
  explicit ForecastSource(QObject* parent = nullptr);
  ~ForecastSource() override;  ///< gives up what runs, waits some milliseconds

  /// Gives the revision of the answer, unless a later request overtakes it.
  std::uint64_t request(std::vector<Button> buttons, ForecastPairs pairs = ForecastPairs::all);
  void cancel();  ///< no answer comes for what was asked so far

 signals:
  /// Buttons and pairs.
  void progress(int done, int all);
  void ready(std::shared_ptr<const detent::editor::Forecast> forecast);

 private:
  struct Waiting {
    std::uint64_t revision = 0;
    std::vector<Button> buttons;
    ForecastPairs pairs = ForecastPairs::all;
  };
  struct Felt {
    std::uint64_t id = 0;
    Button button;
    playback::FeltButton felt;
  };
  using FeltList = std::vector<std::shared_ptr<const Felt>>;
  void answer(const Waiting& next);                 // worker thread
  std::optional<Forecast> compute(const Waiting&);  // worker thread; nothing when overtaken
  Result<std::shared_ptr<const Felt>> feltOf(const Button& button, std::uint64_t revision);
  playback::PredictedPair pairOf(const Felt& a, const Felt& b);
  void forgetOld(const FeltList& used);
  void tellProgress(std::uint64_t revision, std::size_t done, std::size_t all);
  bool overtaken(std::uint64_t revision) const { return latest_ != revision; }

  std::atomic<std::uint64_t> latest_{0};
  // Of the worker thread.
  FeltList kept_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, playback::PredictedPair> keptPairs_;
  std::uint64_t nextId_ = 0;
  LatestRequest<Waiting> requests_;  // last: its thread uses the others
};

}  // namespace detent::editor
