// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecasts of the difference of the nearest switches from the reference button.

#include <atomic>
#include <QObject>
#include <QThreadPool>

#include "editor/forecast/forecast_source.h"
#include "editor/measured/measured_table.h"

namespace detent::editor {

/// Reads the switches' logs again, because a forecast needs the whole button; a new request replaces the
/// running one. GUI thread.
class NearestForecasts : public QObject {
  Q_OBJECT

 public:
  explicit NearestForecasts(QObject* parent = nullptr);
  ~NearestForecasts() override;

  /// Requests forecasts. `foretold` follows once for each switch that could be read, unless a newer request
  /// replaces this one.
  void ask(const Button& reference, std::vector<std::pair<SwitchIndex, importer::LibrarySwitch>> nearest);
  void cancel();

 signals:
  void foretold(detent::editor::SwitchIndex of, const detent::playback::PredictedPair& pair);

 private:
  void request(quint64 question, const Button& reference, const std::vector<SwitchIndex>& read,
               const std::vector<Button>& buttons);

  std::atomic<quint64> question_{0};
  std::vector<SwitchIndex> requested_;  // switches of the running request
  ForecastSource source_;
  QThreadPool reader_;  // last member, because its thread uses the others
};

}  // namespace detent::editor
