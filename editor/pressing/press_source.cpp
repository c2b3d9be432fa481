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
    : QObject(parent), requests_([this](const Waiting& next) { answer(next); }) {}

PressSource::~PressSource() { cancel(); }

std::uint64_t PressSource::request(std::vector<Button> buttons, std::optional<double> operateAt_mm) {
  const std::uint64_t revision = ++latest_;
  requests_.put({revision, std::move(buttons), operateAt_mm});
  return revision;
}

void PressSource::cancel() { ++latest_; }

void PressSource::answer(const Waiting& next) {
  const auto made = std::make_shared<PressAnswer>(PressAnswer{next.revision, {}});
  for (const Button& button : next.buttons) {
    if (overtaken(next.revision)) return;
    auto forecast = forecastOf(button, next);
    if (!forecast) return;
    made->forecasts.push_back(std::move(forecast));
    const int done = static_cast<int>(made->forecasts.size()), all = static_cast<int>(next.buttons.size());
    QMetaObject::invokeMethod(
        this,
        [this, revision = next.revision, done, all] {
          if (!overtaken(revision)) emit progress(done, all);
        },
        Qt::QueuedConnection);
  }
  // Queued events for an object that is gone are dropped by Qt; the destructor waits for this thread.
  QMetaObject::invokeMethod(
      this,
      [this, made] {
        if (!overtaken(made->revision)) emit ready(made);
      },
      Qt::QueuedConnection);
}

std::shared_ptr<const playback::PressForecast> PressSource::forecastOf(const Button& button,
                                                                       const Waiting& asked) {
  const auto known = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) {
    return each.operateAt_mm == asked.operateAt_mm && each.button == button;
  });
  if (known != kept_.end()) return known->forecast;
  const playback::ForecastSettings settings{asked.operateAt_mm, {}, threadsBesideTheWindow()};
  auto forecast =
      playback::forecastPress(button, settings, [this, &asked] { return overtaken(asked.revision); });
  if (!forecast) return {};
  if (kept_.size() == mostKept) kept_.erase(kept_.begin());
  kept_.push_back(
      {button, asked.operateAt_mm, std::make_shared<const playback::PressForecast>(*std::move(forecast))});
  return kept_.back().forecast;
}

}  // namespace detent::editor
