// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/pressing/press_source.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace detent::editor {

namespace {

constexpr std::size_t mostKept = 64;

/// One core is left to the window.
unsigned threadsBesideTheWindow() { return std::max(2U, std::thread::hardware_concurrency()) - 1; }

}  // namespace

PressSource::PressSource(QObject* parent)
    : QObject(parent), answers_(this, [this](const Asked& asked) { answer(asked); }) {}

void PressSource::answer(const Asked& asked) {
  const std::vector<Button>& buttons = asked.request.buttons;
  const auto made = std::make_shared<PressAnswer>(PressAnswer{asked.revision, {}});
  for (const Button& button : buttons) {
    if (asked.overtaken()) return;
    auto forecast = forecastOf(button, asked);
    if (!forecast) return;
    made->forecasts.push_back(std::move(forecast));
    asked.tell([this, done = static_cast<int>(made->forecasts.size()),
                all = static_cast<int>(buttons.size())] { emit progress(done, all); });
  }
  asked.tell([this, made] { emit ready(made); });
}

std::shared_ptr<const playback::PressForecast> PressSource::forecastOf(const Button& button,
                                                                       const Asked& asked) {
  const std::optional<double> operateAt_mm = asked.request.operateAt_mm;
  const auto known = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) {
    return each.operateAt_mm == operateAt_mm && each.button == button;
  });
  if (known != kept_.end()) return known->forecast;
  const playback::ForecastSettings settings{operateAt_mm, {}, threadsBesideTheWindow()};
  auto forecast = playback::forecastPress(button, settings, [&asked] { return asked.overtaken(); });
  if (!forecast) return {};
  if (kept_.size() == mostKept) kept_.erase(kept_.begin());
  kept_.push_back(
      {button, operateAt_mm, std::make_shared<const playback::PressForecast>(*std::move(forecast))});
  return kept_.back().forecast;
}

}  // namespace detent::editor
