// SPDX-License-Identifier: GPL-3.0-or-later
// detent_playback_coverage: how often the truth lies within the errors that playback and studies print.
// `coverage.py playback` writes its tables into docs/measurements/coverage.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "playback/identification/identify.h"
#include "playback/measurement/calibrate.h"
#include "playback/measurement/latency_statistics.h"
#include "playback/measurement/sweep.h"
#include "playback/realtime/biquad.h"
#include "playback/study/statistics/binomial.h"
#include "playback/study/statistics/resampling.h"
#include "tests/bench/coverage_count.h"
#include "tests/playback/identification/pressed_record.h"

namespace {

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

void printHead(const char* what, const char* columns) {
  std::printf("\n### %s\n\n| %s | N | within 68.3 %% | within 95.0 %% |\n|---|---|---|---|\n", what, columns);
}

void printRow(const std::string& name, const CoverageCount& count) {
  std::printf("| %s | %zu | %s |\n", name.c_str(), count.count(), count.text().c_str());
  std::fflush(stdout);
}

void identification() {
  constexpr unsigned records = 1000;
  printHead("`identify`: sigma of k, b, mass and offset", "record, estimate");
  for (const double press_s : {0.06, 0.2, 0.5}) {
    PressedRecord press;
    press.presses_s = {press_s};
    CoverageCount k, b, c;
    for (unsigned seed = 0; seed < records; ++seed) {
      const auto found = identify(recordOf(press, 5000 + seed));
      if (!found) continue;
      k.add(found->k_N_per_mm[0].value, found->k_N_per_mm[0].sigma, 0.3);
      c.add(found->offset_N.value, found->offset_N.sigma, press.offset_N);
      if (!found->b_Ns_per_mm.empty()) b.add(found->b_Ns_per_mm[0].value, found->b_Ns_per_mm[0].sigma, 0.003);
    }
    const std::string name = std::to_string(std::lround(1000 * press_s)) + " ms, one k and b: ";
    printRow(name + "k", k);
    printRow(name + "b", b);
    printRow(name + "offset", c);
  }
  PressedRecord heavy;
  heavy.presses_s = {0.08, 0.15};
  heavy.mass_kg = 0.05;
  CoverageCount mass;
  for (unsigned seed = 0; seed < records; ++seed) {
    const auto found = identify(recordOf(heavy, 5000 + seed));
    if (found && found->mass_kg) mass.add(found->mass_kg->value, found->mass_kg->sigma, heavy.mass_kg);
  }
  printRow("80 and 150 ms, 50 g: mass", mass);
  PressedRecord four;
  four.presses_s = {0.06, 0.1, 0.2, 0.5};
  four.k = [](double x) { return 0.25 + 0.03 * (x - 2) * (x - 2); };
  four.b = [](double x) { return 0.004 - 0.0005 * (x - 2) * (x - 2); };
  IdentifySettings settings;
  settings.knots = 8;
  std::array<CoverageCount, 8> k, b;
  for (unsigned seed = 0; seed < records; ++seed) {
    const auto found = identify(recordOf(four, 5000 + seed), settings);
    if (!found) continue;
    for (std::size_t i = 0; i < k.size(); ++i) {
      k[i].add(found->k_N_per_mm[i].value, found->k_N_per_mm[i].sigma, four.k(found->knots_mm[i]));
      if (!found->b_Ns_per_mm.empty())
        b[i].add(found->b_Ns_per_mm[i].value, found->b_Ns_per_mm[i].sigma, four.b(found->knots_mm[i]));
    }
  }
  for (std::size_t i = 0; i < k.size(); ++i) {
    printRow("60 to 500 ms, knot " + std::to_string(i + 1) + " of 8: k", k[i]);
    printRow("60 to 500 ms, knot " + std::to_string(i + 1) + " of 8: b", b[i]);
  }
}

/// Weights on a sensor whose curve is a polynomial of a divider's reading; each reading errs as the settings
/// say.
std::vector<KnownWeight> weighed(const SensorCalibration& truth, std::size_t readings, std::mt19937& random) {
  std::normal_distribution<> unit(0, 1);
  const CalibrationSettings settings;
  std::vector<KnownWeight> weights;
  for (std::size_t i = 0; i < readings; ++i) {
    KnownWeight w;
    w.force_N = 0.2 + 4.8 * static_cast<double>(i) / static_cast<double>(readings - 1);
    const double felt_N =
        w.force_N + std::hypot(settings.absoluteError_N, settings.relativeError * w.force_N) * unit(random);
    double low = 0, high = truth.fullScale_counts - 1e-9;
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      (truth.force_N(middle) < felt_N ? low : high) = middle;
    }
    w.raw = low;
    weights.push_back(w);
  }
  return weights;
}

void calibration() {
  constexpr unsigned calibrations = 2000;
  printHead("`calibrate`: standard errors of the coefficients", "curve, readings, coefficient");
  std::mt19937 random(31);
  for (const std::size_t degree : {1U, 2U}) {
    SensorCalibration truth;
    truth.circuit = SensorCircuit::divider;
    truth.coefficientCount = degree + 1;
    truth.coefficients = {0.02, 2.0, degree == 2 ? 0.4 : 0.0, 0};
    for (const std::size_t readings : {8U, 12U, 24U}) {
      std::array<CoverageCount, 3> counts;
      unsigned found = 0, right = 0;
      for (unsigned i = 0; i < calibrations; ++i) {
        const auto calibrated = calibrate(weighed(truth, readings, random), {});
        if (!calibrated) continue;
        ++found;
        if (calibrated->coefficientCount != truth.coefficientCount) continue;
        ++right;
        for (std::size_t c = 0; c <= degree; ++c)
          counts[c].add(calibrated->coefficients[c], calibrated->standardErrors[c], truth.coefficients[c]);
      }
      for (std::size_t c = 0; c <= degree; ++c) {
        char name[100];
        std::snprintf(name, sizeof name, "degree %zu (chosen in %.0f %%), %zu readings: c%zu", degree,
                      100.0 * right / std::max(1U, found), readings, c);
        printRow(name, counts[c]);
      }
    }
  }
}

std::size_t drawErrors(std::size_t trials, double rate, std::mt19937& random) {
  return std::binomial_distribution<std::size_t>(trials, rate)(random);
}

/// Participants are not alike: their rates come from a beta distribution of that mean and concentration.
std::vector<Count> answersOf(std::size_t participants, std::size_t trials, double rate, double concentration,
                             std::mt19937& random) {
  std::gamma_distribution<> a(rate * concentration, 1), b((1 - rate) * concentration, 1);
  std::vector<Count> counts;
  for (std::size_t i = 0; i < participants; ++i) {
    const double x = a(random), y = b(random);
    counts.push_back({drawErrors(trials, x + y > 0 ? x / (x + y) : rate, random), trials});
  }
  return counts;
}

bool holds(const Interval& interval, double rate) { return interval.low <= rate && rate <= interval.high; }

/// Studies print 95 % intervals only.
class StudyTable {
 public:
  StudyTable(const char* what, const char* columns) {
    std::printf("\n### %s\n\n| %s | N | within 95.0 %% | no interval |\n|---|---|---|---|\n", what, columns);
  }
  void add(const std::string& name, const CoverageCount& count, unsigned none) {
    std::printf("| %s | %zu | %s | %u |\n", name.c_str(), count.count(), count.text95().c_str(), none);
    std::fflush(stdout);
  }
};

void studies() {
  constexpr unsigned studyCount = 4000;
  std::mt19937 random(77);
  StudyTable ofTrials("Studies: intervals of an error rate over independent trials",
                      "trials, rate, interval");
  for (const std::size_t trials : {90U, 1350U}) {
    for (const double rate : {0.01, 0.05, 0.11, 0.3}) {
      CoverageCount byWilson, byClopperPearson;
      for (unsigned i = 0; i < studyCount; ++i) {
        const Count count{drawErrors(trials, rate, random), trials};
        byWilson.add(false, holds(wilson(count), rate));
        byClopperPearson.add(false, holds(clopperPearson(count), rate));
      }
      char name[80];
      std::snprintf(name, sizeof name, "%zu, %.0f %%: ", trials, 100 * rate);
      ofTrials.add(std::string(name) + "Wilson", byWilson, 0);
      ofTrials.add(std::string(name) + "Clopper-Pearson", byClopperPearson, 0);
    }
  }
  constexpr unsigned groupCount = 1000;
  StudyTable ofPeople("Studies: interval of a group's error rate by resampling participants",
                      "participants of 150 trials, rate, concentration");
  for (const std::size_t participants : {6U, 9U, 18U}) {
    for (const auto& [rate, concentration] : {std::pair{0.034, 70.0}, {0.1, 70.0}, {0.1, 10.0}}) {
      CoverageCount counts;
      unsigned none = 0;
      for (unsigned i = 0; i < groupCount; ++i) {
        const std::vector<Count> answers = answersOf(participants, 150, rate, concentration, random);
        ResamplingSettings settings;
        settings.resamples = 1000;
        const auto interval = participantBootstrap(answers, settings);
        none += interval ? 0 : 1;
        if (interval) counts.add(false, holds(*interval, rate));
      }
      char name[80];
      std::snprintf(name, sizeof name, "%zu, %.1f %%, %.0f", participants, 100 * rate, concentration);
      ofPeople.add(name, counts, none);
    }
  }
}

/// A device of resonances at least an octave apart, and the part of them that a recording of the sweep
/// holds.
struct SimulatedDevice {
  std::vector<Resonance> resonances;  // rising
  std::vector<float> recorded;
};

SimulatedDevice deviceOf(std::size_t count, const std::vector<float>& played, const SweepSettings& settings,
                         double noise, std::mt19937& random) {
  std::uniform_real_distribution<> share(0, 1);
  SimulatedDevice device;
  std::vector<double> samples(played.begin(), played.end());
  double frequency_Hz = 80 * std::exp2(share(random));
  for (std::size_t i = 0; i < count; ++i, frequency_Hz *= std::exp2(1 + 0.4 * share(random))) {
    device.resonances.push_back({frequency_Hz, 4 + 10 * share(random), 8 + 8 * share(random)});
    const Resonance& r = device.resonances.back();
    Biquad section;
    section.setCoefficients(peaking(settings.sampleRate_Hz, r.frequency_Hz, r.q, r.gain_dB));
    section.process(samples.data(), samples.size());
  }
  std::normal_distribution<> hiss(0, noise * settings.level);
  for (const double sample : samples)
    device.recorded.push_back(static_cast<float>(0.1 * (sample + hiss(random))));
  return device;
}

void sweeps() {
  constexpr unsigned deviceCount = 300;
  printHead("`sweep`: sigma of frequency, Q and gain of a device's resonances",
            "resonances, noise of the sweep's level: estimate, its error (rms)");
  std::mt19937 random(5);
  SweepSettings settings;
  settings.duration_s = 4;
  settings.sampleRate_Hz = 8000;
  const std::vector<float> played = sweepSignal(settings);
  for (const std::size_t resonances : {1U, 3U}) {
    for (const double noise : {0.01, 0.1}) {
      std::array<CoverageCount, 3> counts;
      std::array<double, 3> squares{};
      unsigned lost = 0;
      for (unsigned i = 0; i < deviceCount; ++i) {
        const SimulatedDevice device = deviceOf(resonances, played, settings, noise, random);
        const auto response = analyseSweep(played, device.recorded, settings);
        if (!response || response->errors.size() != resonances) {
          ++lost;
          continue;
        }
        for (const Resonance& truth : device.resonances) {
          const auto nearest = std::ranges::min_element(response->resonances, {}, [&](const Resonance& r) {
            return std::abs(std::log(r.frequency_Hz / truth.frequency_Hz));
          });
          const ResonanceErrors& sigma =
              response->errors[static_cast<std::size_t>(nearest - response->resonances.begin())];
          counts[0].add(nearest->frequency_Hz, sigma.frequency_Hz, truth.frequency_Hz);
          counts[1].add(nearest->q, sigma.q, truth.q);
          counts[2].add(nearest->gain_dB, sigma.gain_dB, truth.gain_dB);
          squares[0] += std::pow(nearest->frequency_Hz / truth.frequency_Hz - 1, 2);
          squares[1] += std::pow(nearest->q / truth.q - 1, 2);
          squares[2] += std::pow(nearest->gain_dB - truth.gain_dB, 2);
        }
      }
      const auto rms = [&](std::size_t i) {
        return std::sqrt(squares[i] / static_cast<double>(std::max<std::size_t>(1, counts[i].count())));
      };
      char name[120];
      std::snprintf(name, sizeof name, "%zu, %.2f: frequency, %.3f %%", resonances, noise, 100 * rms(0));
      printRow(name, counts[0]);
      std::snprintf(name, sizeof name, "%zu, %.2f: Q, %.2f %%", resonances, noise, 100 * rms(1));
      printRow(name, counts[1]);
      std::snprintf(name, sizeof name, "%zu, %.2f: gain, %.3f dB", resonances, noise, rms(2));
      printRow(name, counts[2]);
      if (lost > 0)
        std::printf("| %zu, %.2f: without errors, or not all found | %u | | |\n", resonances, noise, lost);
    }
  }
}

// `latency` prints mean and SD of the measured delays, as the paper does: a spread, no error of the mean. SD
// / sqrt(N) must be one.
void latencies() {
  printHead("`latency`: mean against SD / sqrt(N)", "delays");
  std::mt19937 random(9);
  for (const std::size_t n : {20U, 50U, 200U}) {
    CoverageCount counts;
    for (unsigned i = 0; i < 4000; ++i) {
      std::vector<double> delays_s;
      std::uniform_real_distribution<> waiting_s(0, 0.0027);  // for the next block or reading
      std::normal_distribution<> jitter_s(0.005, 0.0003);
      for (std::size_t k = 0; k < n; ++k) delays_s.push_back(jitter_s(random) + waiting_s(random));
      const LatencyStatistics s = statisticsOf(std::move(delays_s), 0);
      counts.add(s.mean_s, s.sd_s / std::sqrt(static_cast<double>(n)), 0.005 + 0.00135);
    }
    printRow(std::to_string(n), counts);
  }
}

}  // namespace

int main() {
  identification();
  calibration();
  studies();
  latencies();
  sweeps();
  return 0;
}
