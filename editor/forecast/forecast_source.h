// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecasts of confusion off the GUI thread. Only the latest request is answered; older ones are cancelled.

#include <cstdint>
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

/// The requested pairs, in their order.
struct Forecast {
  std::uint64_t revision = 0;
  std::vector<playback::PredictedPair> pairs;
  QString trouble;  ///< why there is no forecast; empty otherwise
};

/// One worker thread, started by the first request. Signals of buttons and forecasts of pairs are kept, so
/// that an edit of one of fifty buttons costs one button and its pairs. The destructor cancels the running
/// request, which takes some milliseconds. GUI thread, except where stated.
class ForecastSource : public QObject {
  Q_OBJECT

 public:
  explicit ForecastSource(QObject* parent = nullptr);

  /// Returns the revision of this request, which its answer repeats. A later request replaces this one, which
  /// then has no answer.
  std::uint64_t request(std::vector<Button> buttons, ForecastPairs pairs = ForecastPairs::all) {
    return answers_.ask({std::move(buttons), pairs});
  }
  void cancel() { answers_.cancel(); }  ///< suppresses the answers to earlier requests

 signals:
  /// Number of finished buttons and pairs, and of all.
  void progress(int done, int all);
  void ready(std::shared_ptr<const detent::editor::Forecast> forecast);

 private:
  struct Wanted {
    std::vector<Button> buttons;
    ForecastPairs pairs = ForecastPairs::all;
  };
  using Query = LatestAnswer<Wanted>::Query;
  struct Felt {
    std::uint64_t id = 0;
    Button button;
    playback::FeltButton felt;
  };
  using FeltList = std::vector<std::shared_ptr<const Felt>>;
  // Worker thread; empty if a newer request exists.
  std::optional<Forecast> compute(const Query& query);
  Result<std::shared_ptr<const Felt>> feltOf(const Button& button, const Query& query);
  playback::PredictedPair pairOf(const Felt& a, const Felt& b);
  void forgetOld(const FeltList& used);
  void tellProgress(const Query& query, std::size_t done, std::size_t all);

  // Used by the worker thread only.
  FeltList kept_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, playback::PredictedPair> keptPairs_;
  std::uint64_t nextId_ = 0;
  LatestAnswer<Wanted> answers_;  // last member, because its thread uses the others
};

}  // namespace detent::editor
