// SPDX-License-Identifier: GPL-3.0-or-later
// detent_offers_bench: what *make distinguishable* offers, against every whole per cent of each lever.
// Figures: docs/reference/predicted-confusion.md

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "model/edits.h"
#include "model/file/button_file.h"
#include "playback/study/perception/design_help.h"
#include "playback/study/statistics/shuffle.h"

using namespace detent;
using namespace detent::playback;

namespace {

const DesignHelpSettings settings;

Result<Button> changedBy(const Button& button, Lever lever, double factor) {
  if (lever == Lever::snap) return scaleSnapRatios(button, factor);
  return lever == Lever::travel ? scaleTravel(button, factor) : scaleForce(button, factor);
}

bool apart(const Button& a, const FeltButton& b) {
  const Result<FeltButton> felt = feel(a, settings.perception);
  return felt && predictConfusion(*felt, b, settings.confusion).distinguished();
}

/// The first whole per cent on the way from 100 that makes the two distinguishable.
std::optional<int> byGrid(const Button& button, const FeltButton& other, Lever lever, int step) {
  const int last = step > 0 ? static_cast<int>(100 * settings.largestFactor)
                            : static_cast<int>(std::lround(100 / settings.largestFactor));
  for (int percent = 100 + step; step > 0 ? percent <= last : percent >= last; percent += step) {
    const Result<Button> changed = changedBy(button, lever, percent / 100.0);
    if (!changed) return {};
    if (!(*changed == button) && apart(*changed, other)) return percent;
  }
  return {};
}

/// Buttons of the samples, and such as differ a little from them.
std::vector<Button> pool() {
  std::vector<Button> buttons;
  StudyRandom random = randomSeededBy("offers");
  for (const std::string name : {"A", "B", "C", "D", "E", "F"}) {
    const Button button =
        *readButtonFile(std::string(DETENT_SOURCE_DIR) + "/samples/buttons/" + name + ".button.json");
    buttons.push_back(button);
    const auto near = [&] { return 0.8 + 0.45 * drawShare(random); };
    buttons.push_back(*rename(*scaleForce(*scaleTravel(button, near()), near()), name + "'"));
  }
  return buttons;
}

struct Tally {
  std::size_t offers = 0, reached = 0, within = 0, missed = 0;
  double worst = 0;  ///< how much further than need be, as a ratio less 1
};

void check(const Button& button, const Button& other, Tally& tally) {
  const FeltButton felt = *feel(other, settings.perception);
  const std::vector<Suggestion> offered = *makeDistinguishable(button, other, settings);
  for (const Lever lever : {Lever::snap, Lever::travel, Lever::force}) {
    for (const int step : {1, -1}) {
      const std::optional<int> least = byGrid(button, felt, lever, step);
      const auto at = std::find_if(offered.begin(), offered.end(), [&](const Suggestion& s) {
        return s.lever == lever && (s.factor > 1) == (step > 0);
      });
      if (at == offered.end()) {
        tally.missed += least ? 1 : 0;
        continue;
      }
      ++tally.offers;
      const Result<Button> again = changedBy(button, lever, at->factor);
      tally.reached += again && apart(*again, felt) ? 1 : 0;
      const double further = least ? std::fabs(std::log(at->factor / (*least / 100.0))) : 1;
      tally.within += further <= std::log(1.02) ? 1 : 0;
      tally.worst = std::max(tally.worst, std::expm1(further));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t wanted = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 30;
  const std::vector<Button> buttons = pool();
  std::vector<FeltButton> felt;
  for (const Button& button : buttons) felt.push_back(*feel(button, settings.perception));
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < buttons.size(); ++i)
    for (std::size_t k = 0; k < buttons.size(); ++k)
      if (i != k && !predictConfusion(felt[i], felt[k], settings.confusion).distinguished())
        pairs.emplace_back(i, k);
  StudyRandom random = randomSeededBy("pairs");
  shuffle(pairs, random);
  Tally tally;
  std::size_t checked = 0;
  for (; checked < std::min(wanted, pairs.size()); ++checked)
    check(buttons[pairs[checked].first], buttons[pairs[checked].second], tally);
  std::printf(
      "| pairs not told apart | offers | reach the bar when computed anew | within 2 %% of the least by the "
      "grid | furthest from it | ways "
      "the grid found and no offer did |\n|---|---|---|---|---|---|\n| %zu | %zu | %zu | %zu | %.1f %% | %zu "
      "|\n",
      checked, tally.offers, tally.reached, tally.within, 100 * tally.worst, tally.missed);
  return 0;
}
