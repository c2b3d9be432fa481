// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_source.h"

#include <algorithm>
#include <utility>

namespace detent::editor {

namespace {

constexpr std::size_t mostKept = 128;  // felt buttons, about 200 kB each

}  // namespace

ForecastSource::ForecastSource(QObject* parent) : QObject(parent) {}

ForecastSource::~ForecastSource() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    ++latest_;
  }
  wake_.notify_one();
  if (worker_.joinable()) worker_.join();
}

std::uint64_t ForecastSource::request(std::vector<Button> buttons) {
  const std::uint64_t revision = ++latest_;
  {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(Waiting{revision, std::move(buttons)});
  }
  if (!worker_.joinable()) worker_ = std::thread([this] { run(); });
  wake_.notify_one();
  return revision;
}

void ForecastSource::cancel() { ++latest_; }

void ForecastSource::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return stopping_ || waiting_.has_value(); });
    if (stopping_) return;
    const Waiting next = *std::exchange(waiting_, std::nullopt);
    lock.unlock();
    if (std::optional<Forecast> computed = compute(next)) {
      auto forecast = std::make_shared<const Forecast>(*std::move(computed));
      // Queued events for an object that is gone are dropped by Qt; the destructor waits for this thread.
      QMetaObject::invokeMethod(
          this,
          [this, forecast] {
            if (!overtaken(forecast->revision)) emit ready(forecast);
          },
          Qt::QueuedConnection);
    }
    lock.lock();
  }
}

std::optional<Forecast> ForecastSource::compute(const Waiting& asked) {
  const auto gone = [this, revision = asked.revision] { return overtaken(revision); };
  const int all = static_cast<int>(asked.buttons.size());
  std::vector<playback::FeltButton> felt;
  for (const Button& button : asked.buttons) {
    auto known = std::find_if(kept_.begin(), kept_.end(), [&](const Felt& f) { return f.button == button; });
    if (known == kept_.end()) {
      Result<playback::FeltButton> made = playback::feel(button, {}, gone);
      if (gone()) return {};
      if (!made) return Forecast{asked.revision, {}, QString::fromStdString(made.failure().sentence())};
      if (kept_.size() >= mostKept) kept_.erase(kept_.begin());
      kept_.push_back({button, *std::move(made)});
      known = std::prev(kept_.end());
    }
    felt.push_back(known->felt);
    QMetaObject::invokeMethod(
        this,
        [this, revision = asked.revision, done = static_cast<int>(felt.size()), all] {
          if (!overtaken(revision)) emit progress(revision, done, all);
        },
        Qt::QueuedConnection);
  }
  std::vector<playback::PredictedPair> pairs =
      playback::predictAll(felt, [&](std::size_t, std::size_t) { return !gone(); });
  if (gone()) return {};
  return Forecast{asked.revision, std::move(pairs), {}};
}

}  // namespace detent::editor
