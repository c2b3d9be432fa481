// SPDX-License-Identifier: GPL-3.0-or-later
// The forecast against K&L's noisy group (Table 2), beside three measures of others; confusion_fit.py judges
// it. Figures: docs/reference/predicted-confusion.md

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "model/edits.h"
#include "model/file/button_file.h"
#include "playback/study/perception/confusion.h"
#include "playback/study/statistics/rank_correlation.h"
#include "tests/playback/study/perception/baselines.h"

using namespace detent;
using namespace detent::playback;

namespace {

const std::string names = "ABCDEF";
/// K&L, Table 2 (b): errors in 90 by A-B, A-C, B-C, A-D, ...
const std::vector<double> found{3, 2, 5, 1, 3, 10, 0, 4, 5, 5, 1, 4, 1, 0, 2};

Button sample(char name) {
  return *readButtonFile(std::string(DETENT_SOURCE_DIR) + "/samples/buttons/" + name + ".button.json");
}

/// Perception of the buttons with the settings of K&L's experiment.
std::vector<FeltButton> feelAll(PerceptionSettings settings) {
  settings.playback.feel = Feel::paper;
  std::vector<FeltButton> felt;
  for (const char name : names) felt.push_back(*feel(sample(name), settings));
  return felt;
}

std::vector<std::string> pairNames() {
  std::vector<std::string> pairs;
  for (std::size_t k = 1; k < names.size(); ++k)
    for (std::size_t i = 0; i < k; ++i) pairs.push_back({names[i], '-', names[k]});
  return pairs;
}

/// Larger where more errors are forecast: far-apart pairs differ in d' alone.
std::vector<double> confusable(const std::vector<PredictedPair>& pairs) {
  std::vector<double> order;
  for (const PredictedPair& pair : pairs) order.push_back(-pair.dPrime);
  return order;
}

void line(const char* what, const std::vector<double>& forecast) {
  const auto worst =
      static_cast<std::size_t>(std::max_element(forecast.begin(), forecast.end()) - forecast.begin());
  const auto rank =
      1 + std::count_if(forecast.begin(), forecast.end(), [&](double e) { return e > forecast[5]; });
  std::printf("%-44s Spearman %5.2f   most confused %s   C-D is number %ld\n", what,
              spearman(forecast, found), pairNames()[worst].c_str(), static_cast<long>(rank));
}

std::vector<double> baseline(const std::vector<FeltButton>& felt, VibrationDistance distance) {
  std::vector<double> likeness;
  for (std::size_t k = 1; k < felt.size(); ++k)
    for (std::size_t i = 0; i < k; ++i) likeness.push_back(-distanceBetween(felt[i], felt[k], distance));
  return likeness;
}

/// Prints errors forecast from a single figure of the buttons.
void printSimple(const std::vector<PredictedPair>& pairs) {
  std::vector<double> travel, strength, grains;
  for (std::size_t k = 1; k < names.size(); ++k)
    for (std::size_t i = 0; i < k; ++i)
      travel.push_back(-std::fabs(std::log(sample(names[i]).states()[0].graph.press().travel_mm() /
                                           sample(names[k]).states()[0].graph.press().travel_mm())));
  for (const PredictedPair& pair : pairs) {
    strength.push_back(-std::hypot(pair.press.strength, pair.release.strength));
    grains.push_back(-std::hypot(pair.press.travel, pair.release.travel));
  }
  line("travel alone (mm)", travel);
  line("strength alone", strength);
  line("number of grains alone", grains);
}

/// Change of d' between two buttons when the strongest force of one grows by 1 mN at a time.
void printSteps() {
  std::printf("largest step of d' by 1 mN, 60 in a row:");
  for (const char name : names) {
    const Button button = sample(name);
    const FeltButton was = *feel(button);
    const double strongest_N = button.states()[0].graph.press().forceRange_N().second;
    double before = 0, largest = 0;
    for (int step = 1; step <= 60; ++step) {
      const FeltButton now = *feel(*scaleForce(button, 1 + 0.001 * step / strongest_N));
      ConfusionSettings untuned;
      untuned.sensitivity = 1;
      const double dPrime = predictConfusion(was, now, untuned).dPrime;
      largest = std::max(largest, std::fabs(dPrime - before));
      before = dPrime;
    }
    std::printf("  %c %.3f", name, largest);
  }
  std::printf("\n");
}

}  // namespace

int main() {
  const std::vector<FeltButton> felt = feelAll({});
  const auto began = std::chrono::steady_clock::now();
  const std::vector<PredictedPair> pairs = predictAll(felt);
  const double each_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count() /
      static_cast<double>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PredictedPair& p = pairs[i];
    std::printf("%s  d' %5.2f  errors %5.1f  found %4.0f   press %.2f %.2f %.2f  release %.2f %.2f %.2f\n",
                pairNames()[i].c_str(), p.dPrime, p.errorsPer90(), found[i], p.press.strength, p.press.timing,
                p.press.travel, p.release.strength, p.release.timing, p.release.travel);
  }
  std::printf("%.2f ms per pair once both are felt\n\n", each_ms);
  line("forecast", confusable(pairs));
  line("1 - ST-SIM", baseline(felt, stSimDistance));
  line("1 - SPQI", baseline(felt, spqiDistance));
  line("spectral distance", baseline(felt, spectralDistance_dB));
  printSimple(pairs);
  PerceptionSettings flat;
  flat.device = {};
  line("forecast, flat device", confusable(predictAll(feelAll(flat))));
  for (const double gain_dB : {6.0, 18.0}) {
    PerceptionSettings other;
    for (Resonance& r : other.device.resonances) r.gain_dB = gain_dB;
    line(("forecast, resonances of " + std::to_string(static_cast<int>(gain_dB)) + " dB").c_str(),
         confusable(predictAll(feelAll(other))));
  }
  for (const double slope : {0.0, 0.5, 0.8}) {
    PerceptionSettings other;
    other.masking.slope = slope;
    line(("forecast, masking slope " + std::to_string(slope)).c_str(),
         confusable(predictAll(feelAll(other))));
  }
  for (int off = 0; off < 3; ++off) {
    ConfusionSettings without;
    constexpr double never = 1e9;
    if (off == 0) without.noticeable_dB = {never, never};
    if (off == 1) without.timingWeber = never;
    if (off == 2) without.travelWeber = never;
    line(off == 0   ? "forecast without strength"
         : off == 1 ? "forecast without timing"
                    : "forecast without travel",
         confusable(predictAll(felt, {}, without)));
  }
  for (const double weber : {0.1, 0.2, 0.25, 0.4, 1e9}) {
    ConfusionSettings other;
    other.forceWeber = weber;
    line(("forecast, Weber fraction of force " + std::to_string(weber)).c_str(),
         confusable(predictAll(felt, {}, other)));
  }
  for (const double least_N : {0.0, 1.0, 1.5, 2.0, 2.5, 3.0}) {
    PerceptionSettings other;
    other.hand.least_N.fill(least_N);
    line(("forecast, a hand of " + std::to_string(least_N) + " N at any speed").c_str(),
         confusable(predictAll(feelAll(other))));
  }
  printSteps();
  return 0;
}
