// SPDX-License-Identifier: GPL-3.0-or-later
// Counts, rates, intervals and measured figures at their edges: none, one, all, and very many.

#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "playback/measurement/calibrate.h"
#include "playback/measurement/exact_number.h"
#include "playback/measurement/fourier.h"
#include "playback/measurement/latency_statistics.h"
#include "playback/measurement/normal.h"
#include "playback/measurement/profile_file.h"
#include "playback/measurement/root.h"
#include "playback/measurement/spectrogram.h"
#include "playback/measurement/sweep.h"
#include "playback/study/statistics/abx_sensitivity.h"
#include "playback/study/statistics/binomial.h"
#include "playback/study/statistics/rank_correlation.h"
#include "playback/study/statistics/resampling.h"
#include "playback/study/statistics/shuffle.h"
#include "tests/extremes/extreme_values.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::tests;

namespace {

Count anyCount(double most = 1e6) {
  const auto trials = static_cast<std::size_t>(oneIn(4) ? count(0, 3) : magnitude(1, most));
  return {static_cast<std::size_t>(static_cast<double>(trials) * (oneIn(4)   ? 0
                                                                  : oneIn(3) ? 1
                                                                             : share())),
          trials};
}

AbxStrategy anyStrategy() {
  return oneIn(2) ? AbxStrategy::differencing : AbxStrategy::independentObservations;
}

ResamplingSettings few() {
  ResamplingSettings settings;
  settings.resamples = 100;
  settings.seed = static_cast<std::uint64_t>(count(0, 1000000));
  return settings;
}

bool isInterval(const Interval& i) { return i.low >= 0 && i.high <= 1 && i.low <= i.high; }

}  // namespace

TEST_CASE("rates and their intervals", "[finite]") {
  holdsAlways("wilson: within 0 and 1, around the rate", [] {
    const Count c = anyCount();
    const Interval i = wilson(c, within(0.5, 0.9999));
    RC_ASSERT(isInterval(i));
    if (c.trials > 0) RC_ASSERT(i.low <= rateOf(c) + 1e-12 && i.high >= rateOf(c) - 1e-12);
  });
  holdsAlways("clopperPearson: within 0 and 1, around the rate, with the requested tails", [] {
    const Count c = anyCount(1e4);
    const double confidence = within(0.5, 0.999);
    const Interval i = clopperPearson(c, confidence);
    RC_ASSERT(isInterval(i));
    if (c.trials == 0) return;
    RC_ASSERT(i.low <= rateOf(c) + 1e-12 && i.high >= rateOf(c) - 1e-12);
    if (c.errors < c.trials) RC_ASSERT(std::abs(atMost(c, i.high) - (1 - confidence) / 2) < 1e-6);
  });
  holdsAlways("atMost: a probability that rises with the errors and falls with the rate", [] {
    const Count c = anyCount(1e4);
    const double rate = share(), p = atMost(c, rate);
    RC_ASSERT(p >= 0 && p <= 1 + 1e-12);
    RC_ASSERT(atMost(c, std::min(1.0, rate + 0.1)) <= p + 1e-9);
    if (c.errors < c.trials) RC_ASSERT(atMost({c.errors + 1, c.trials}, rate) >= p - 1e-9);
  });
  holdsAlways("rateOf: 0 without trials", [] { RC_ASSERT(rateOf({0, 0}) == 0 && rateOf(anyCount()) <= 1); });
  holdsAlways("holm: never below the p it adjusts, never above 1, in the same order", [] {
    std::vector<double> p;
    for (int i = count(0, 20); i > 0; --i) p.push_back(oneIn(5) ? 0 : magnitude(1e-300, 1));
    const auto adjusted = holm(p);
    RC_ASSERT(adjusted.size() == p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      RC_ASSERT(adjusted[i] >= p[i] && adjusted[i] <= 1);
      for (std::size_t k = 0; k < p.size(); ++k)
        if (p[i] < p[k]) RC_ASSERT(adjusted[i] <= adjusted[k]);
    }
  });
}

TEST_CASE("the normal distribution and d'", "[finite]") {
  holdsAlways("normalQuantile and normalCdf undo each other", [] {
    const double p = oneIn(2) ? magnitude(1e-300, 0.5) : within(0.5, 1 - 1e-9);
    RC_ASSERT(alike(normalCdf(normalQuantile(p)), p, 1e-6));
  });
  holdsAlways("normalCdf rises from 0 to 1", [] {
    const double z = within(-1, 1) * magnitude(1e-3, 1e300), p = normalCdf(z);
    RC_ASSERT(p >= 0 && p <= 1 && normalCdf(z + std::abs(z) * 0.1) >= p);
  });
  holdsAlways("dPrimeOf and shareCorrect undo each other", [] {
    const AbxStrategy strategy = anyStrategy();
    const double d = within(0.05, 5);
    RC_ASSERT(alike(dPrimeOf(shareCorrect(d, strategy), strategy), d, 1e-4));
  });
  holdsAlways("shareCorrect: from a half to 1, never falling", [] {
    const AbxStrategy strategy = anyStrategy();
    const double d = magnitude(1e-9, 1e9), right = shareCorrect(d, strategy);
    RC_ASSERT(right >= 0.5 - 1e-12 && right <= 1 && shareCorrect(d * 1.1, strategy) >= right - 1e-12);
  });
  holdsAlways("dPrimeOf: 0 up to a half, finite below 1", [] {
    const AbxStrategy strategy = anyStrategy();
    RC_ASSERT(dPrimeOf(within(0, 0.5), strategy) == 0);
    const double d = dPrimeOf(1 - magnitude(1e-12, 0.5), strategy);
    RC_ASSERT(std::isfinite(d) && d >= 0);
  });
}

TEST_CASE("people resampled and ranks", "[finite]") {
  holdsAlways("participantBootstrap: an interval within 0 and 1, the same for the same seed", [] {
    std::vector<Count> people;
    for (int i = count(0, 12); i > 0; --i) people.push_back(anyCount(1000));
    const ResamplingSettings settings = few();
    const auto one = participantBootstrap(people, settings), other = participantBootstrap(people, settings);
    RC_ASSERT(one.has_value() == other.has_value());
    if (!one) return;
    RC_ASSERT(isInterval(*one) && one->low == other->low && one->high == other->high);
  });
  holdsAlways("groupDifferenceP: within 0 and 1, whichever group is first", [] {
    std::vector<Count> a, b;
    for (int i = count(0, 8); i > 0; --i) a.push_back(anyCount(100));
    for (int i = count(0, 8); i > 0; --i) b.push_back(anyCount(100));
    const double p = groupDifferenceP(a, b, few());
    RC_ASSERT(p > 0 && p <= 1);
    if (a.empty() || b.empty()) RC_ASSERT(p == 1);
  });
  holdsAlways("spearman: within -1 and 1, unchanged by anything that keeps the order", [] {
    std::vector<double> x, y, stretched;
    for (int i = count(0, 30); i > 0; --i) {
      x.push_back(within(-1, 1) * magnitude(1e-3, 1e3)), y.push_back(within(-1, 1));
      stretched.push_back(std::ldexp(x.back(), 100));
    }
    const double r = spearman(x, y);
    RC_ASSERT(r >= -1 - 1e-12 && r <= 1 + 1e-12);
    RC_ASSERT(spearman(stretched, y) == r && spearman(y, x) == r);
  });
  holdsAlways("drawBelow, drawShare, shuffle", [] {
    StudyRandom random = randomSeededBy(std::to_string(count(0, 1000000)));
    const auto bound = static_cast<std::uint64_t>(magnitude(1, 1e18));
    RC_ASSERT(drawBelow(random, bound) < bound);
    const double drawn = drawShare(random);
    RC_ASSERT(drawn >= 0 && drawn < 1);
    std::vector<int> items(static_cast<std::size_t>(count(0, 50)));
    std::iota(items.begin(), items.end(), 0);
    auto shuffled = items;
    shuffle(shuffled, random);
    std::sort(shuffled.begin(), shuffled.end());
    RC_ASSERT(shuffled == items);
  });
  holdsAlways("whereRisingPasses: to the last bit", [] {
    const double root = within(-1, 1) * magnitude(1e-9, 1e9);
    const double found = whereRisingPasses(0.0, -2e9, 2e9, [&](double x) { return x - root; });
    RC_ASSERT(alike(found, root, 1e-12, 1e-12));
  });
}

TEST_CASE("measured figures", "[finite]") {
  holdsAlways("statisticsOf: in order, in any unit", [] {
    std::vector<double> delays;
    const double unit = magnitude(1e-12, 1e12);
    for (int i = count(1, 60); i > 0; --i) delays.push_back(unit * share());
    const LatencyStatistics s = statisticsOf(delays, 0);
    RC_ASSERT(s.min_s <= s.p5_s && s.p5_s <= s.median_s && s.median_s <= s.p95_s && s.p95_s <= s.p99_s &&
              s.p99_s <= s.max_s);
    RC_ASSERT(s.mean_s >= s.min_s * (1 - 1e-12) && s.mean_s <= s.max_s * (1 + 1e-12) && s.sd_s >= 0);
    RC_ASSERT(!histogram(s, count(1, 20)).empty());
  });
  holdsAlways("Fourier: there and back, and the energy stays", [] {
    const std::size_t length = std::size_t{1} << count(0, 10);
    const double unit = magnitude(1e-100, 1e100);
    std::vector<std::complex<double>> data(length);
    double energy = 0;
    for (auto& value : data) value = {unit * within(-1, 1), unit * within(-1, 1)}, energy += std::norm(value);
    auto turned = data;
    transform(turned, Transform::forward);
    double turnedEnergy = 0;
    for (const auto& value : turned) turnedEnergy += std::norm(value);
    RC_ASSERT(alike(turnedEnergy / static_cast<double>(length), energy, 1e-12));
    transform(turned, Transform::inverse);
    for (std::size_t i = 0; i < length; ++i)
      RC_ASSERT(std::abs(turned[i] - data[i]) <= 1e-13 * unit * static_cast<double>(length));
  });
  holdsAlways("powerOfTwo", [] {
    const auto n = static_cast<std::size_t>(magnitude(1, 1e15)), p = powerOfTwo(n);
    RC_ASSERT(p >= n && (p & (p - 1)) == 0 && p / 2 < n);
  });
  holdsAlways("spectrogramOf: finite levels at every rate and length", [] {
    std::vector<float> samples(static_cast<std::size_t>(count(0, 4000)));
    for (float& s : samples) s = static_cast<float>(within(-1, 1) * (oneIn(3) ? 0 : 1));
    const Spectrogram s = spectrogramOf(samples, magnitude(8000, 192000));
    RC_ASSERT(s.level_dB.size() == s.columns * s.rows);
    for (const float level : s.level_dB)
      RC_ASSERT(std::isfinite(level) && level >= lowestLevel_dB && level <= 1.0f);
  });
  holdsAlways("exact reads back as the same double", [] {
    const double value = anyFinite();
    RC_ASSERT(std::strtod(exact(value).c_str(), nullptr) == value);
  });
}

TEST_CASE("sensors and profiles of any kind") {
  holdsAlways("calibrate, any weights", [] {
    std::vector<KnownWeight> weights;
    for (int i = count(0, 8); i > 0; --i)
      weights.push_back(oneIn(4) ? KnownWeight{anyDouble(), anyDouble()}
                                 : KnownWeight{within(0, 12), within(1, 1000)});
    CalibrationSettings settings;
    settings.circuit = static_cast<SensorCircuit>(count(0, 2));
    settings.highestDegree = static_cast<unsigned>(count(1, 3));
    const auto calibration = calibrate(weights, settings);
    if (!calibration) return assertNamed(calibration.failure());
    for (std::size_t i = 0; i < calibration->coefficientCount; ++i)
      RC_ASSERT(std::isfinite(calibration->coefficients[i]) && std::isfinite(calibration->standardErrors[i]));
    RC_ASSERT(std::isfinite(calibration->residual_N) && calibration->residual_N >= 0);
  });
  holdsAlways("calibrate: exact weights of a straight sensor give it back", [] {
    const double offset = within(-1, 1), slope = magnitude(0.1, 100);
    std::vector<KnownWeight> weights;
    for (int i = 0; i < 6; ++i) {
      const double raw = 100 + 150 * i;
      weights.push_back({offset + slope * raw / 1023, raw});
    }
    CalibrationSettings settings;
    settings.circuit = SensorCircuit::linear;
    settings.highestDegree = 1;
    const auto calibration = calibrate(weights, settings);
    if (!calibration) RC_FAIL(calibration.failure().sentence());
    RC_ASSERT(alike(calibration->force_N(500), offset + slope * 500 / 1023, 1e-9, 1));
  });
  holdsAlways("parseWeights, any text", [] {
    std::string text = oneIn(2) ? "mass_g,raw\n" : "force_N,raw\n";
    for (int i = count(0, 40); i > 0; --i)
      text += "0123456789.,-e\nnai "[static_cast<std::size_t>(count(0, 18))];
    const auto weights = parseWeights(text, "any");
    if (!weights) assertNamed(weights.failure());
  });
  holdsAlways("a profile survives its file bit for bit", [] {
    DeviceProfile profile;
    profile.name = "any";
    profile.gain = magnitude(1e-3, 10);
    for (int i = count(0, 4); i > 0; --i)
      profile.resonances.push_back({magnitude(10, 1000), magnitude(0.1, 100), within(0, 30)});
    for (int i = count(0, 4); i > 0; --i)
      profile.equalizer.push_back({magnitude(10, 1000), magnitude(0.1, 100), within(-12, 0)});
    const auto again = parseDeviceProfile(toText(profile), "profile");
    if (!again) RC_FAIL(again.failure().sentence());
    RC_ASSERT(again->gain == profile.gain && again->resonances.size() == profile.resonances.size());
    for (std::size_t i = 0; i < profile.equalizer.size(); ++i)
      RC_ASSERT(again->equalizer[i].frequency_Hz == profile.equalizer[i].frequency_Hz &&
                again->equalizer[i].q == profile.equalizer[i].q);
  });
  holdsAlways("parseDeviceProfile, damaged", [] {
    DeviceProfile profile;
    profile.name = "any";
    profile.resonances = {{390, 8, 12}};
    profile.equalizer = {{390, 8, -12}};
    std::string text = toText(profile);
    for (int i = count(1, 8); i > 0; --i)
      text[anyOf<std::size_t>(0, text.size() - 1)] =
          "0123456789=.-e na\n"[static_cast<std::size_t>(count(0, 17))];
    const auto again = parseDeviceProfile(text, "profile");
    if (!again) assertNamed(again.failure());
  });
  holdsAlways("sweepSignal: within its level at every rate", [] {
    SweepSettings settings;
    settings.sampleRate_Hz = magnitude(8000, 192000);
    settings.duration_s = 0.6;
    settings.level = within(0.001, 1);
    for (const float y : sweepSignal(settings))
      RC_ASSERT(std::isfinite(y) && std::abs(y) <= static_cast<float>(settings.level) * 1.0001f);
  });
}
