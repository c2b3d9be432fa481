// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/nearest_forecasts.h"

namespace detent::editor {

NearestForecasts::NearestForecasts(QObject* parent) : QObject(parent) {
  reader_.setMaxThreadCount(1);
  connect(&source_, &ForecastSource::ready, this, [this](const std::shared_ptr<const Forecast>& forecast) {
    for (std::size_t i = 0; i < std::min(requested_.size(), forecast->pairs.size()); ++i)
      emit foretold(requested_[i], forecast->pairs[i]);
  });
}

NearestForecasts::~NearestForecasts() {
  ++question_;
  reader_.clear();
  reader_.waitForDone();
}

void NearestForecasts::cancel() {
  ++question_;
  source_.cancel();
}

void NearestForecasts::ask(const Button& reference,
                           std::vector<std::pair<SwitchIndex, importer::LibrarySwitch>> nearest) {
  cancel();
  reader_.start([this, question = question_.load(), reference, nearest = std::move(nearest)] {
    std::vector<SwitchIndex> read;
    std::vector<Button> buttons;
    for (const auto& [index, entry] : nearest) {
      if (question != question_) return;
      if (auto button = importer::buttonOf(entry, importer::Quality::draft)) {
        read.push_back(index);
        buttons.push_back(*std::move(button));
      }
    }
    QMetaObject::invokeMethod(
        this, [this, question, reference, read, buttons] { request(question, reference, read, buttons); },
        Qt::QueuedConnection);
  });
}

void NearestForecasts::request(quint64 question, const Button& reference,
                               const std::vector<SwitchIndex>& read, const std::vector<Button>& buttons) {
  if (question != question_ || buttons.empty()) return;
  requested_ = read;
  std::vector<Button> all{reference};
  all.insert(all.end(), buttons.begin(), buttons.end());
  source_.request(std::move(all), ForecastPairs::ofFirst);
}

}  // namespace detent::editor
