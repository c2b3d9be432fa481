// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_source.h"

#include <algorithm>
#include <utility>

#include "editor/document/message_words.h"

namespace detent::editor {

namespace {

constexpr std::size_t mostKept = 128;  // felt buttons, about 200 kB each

/// Index pairs of this many buttons, in the order of a forecast.
std::vector<std::pair<std::size_t, std::size_t>> pairsIn(std::size_t buttons, ForecastPairs pairs) {
  if (pairs == ForecastPairs::all) return playback::pairsOf(buttons);
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t other = 1; other < buttons; ++other) found.emplace_back(0, other);
  return found;
}

}  // namespace

ForecastSource::ForecastSource(QObject* parent)
    : QObject(parent), answers_(this, [this](const Query& query) {
        std::optional<Forecast> computed = compute(query);
        if (!computed) return;
        const auto forecast = std::make_shared<const Forecast>(*std::move(computed));
        query.tell([this, forecast] { emit ready(forecast); });
      }) {}

std::optional<Forecast> ForecastSource::compute(const Query& query) {
  const std::vector<Button>& buttons = query.request.buttons;
  const auto pairs = pairsIn(buttons.size(), query.request.pairs);
  const std::size_t all = buttons.size() + pairs.size();
  FeltList felt;
  for (const Button& button : buttons) {
    Result<std::shared_ptr<const Felt>> made = feltOf(button, query);
    if (query.overtaken()) return {};
    if (!made) return Forecast{query.revision, {}, sentenceOf(made.failure())};
    felt.push_back(*std::move(made));
    tellProgress(query, felt.size(), all);
  }
  Forecast forecast{query.revision, {}, {}};
  for (const auto& [first, second] : pairs) {
    if (query.overtaken()) return {};
    forecast.pairs.push_back(pairOf(*felt[first], *felt[second]));
    tellProgress(query, felt.size() + forecast.pairs.size(), all);
  }
  forgetOld(felt);
  return forecast;
}

Result<std::shared_ptr<const ForecastSource::Felt>> ForecastSource::feltOf(const Button& button,
                                                                           const Query& query) {
  const auto known =
      std::find_if(kept_.begin(), kept_.end(), [&](const auto& f) { return f->button == button; });
  if (known != kept_.end()) return *known;
  Result<playback::FeltButton> made = playback::feel(button, {}, [&query] { return query.overtaken(); });
  if (!made) return made.failure();
  kept_.push_back(std::make_shared<const Felt>(Felt{nextId_++, button, *std::move(made)}));
  return kept_.back();
}

playback::PredictedPair ForecastSource::pairOf(const Felt& a, const Felt& b) {
  const std::pair key(a.id, b.id);
  const auto known = keptPairs_.find(key);
  if (known != keptPairs_.end()) return known->second;
  return keptPairs_.emplace(key, playback::predictConfusion(a.felt, b.felt)).first->second;
}

/// Every edit creates another button, so only those of the last request are kept.
void ForecastSource::forgetOld(const FeltList& used) {
  if (kept_.size() <= mostKept) return;
  kept_ = used;
  const auto gone = [&](std::uint64_t id) {
    return std::none_of(used.begin(), used.end(), [&](const auto& f) { return f->id == id; });
  };
  std::erase_if(keptPairs_,
                [&](const auto& pair) { return gone(pair.first.first) || gone(pair.first.second); });
}

void ForecastSource::tellProgress(const Query& query, std::size_t done, std::size_t all) {
  query.tell(
      [this, done = static_cast<int>(done), all = static_cast<int>(all)] { emit progress(done, all); });
}

}  // namespace detent::editor
