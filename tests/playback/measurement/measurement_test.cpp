// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include <catch2/catch.hpp>

#include "playback/measurement/calibrate.h"
#include "playback/measurement/fourier.h"
#include "playback/measurement/latency_statistics.h"
#include "playback/measurement/profile_file.h"
#include "playback/measurement/sweep.h"
#include "playback/realtime/biquad.h"

using namespace detent;
using namespace detent::playback;

TEST_CASE("fourier: inverse of forward, and a line spectrum") {
  std::vector<std::complex<double>> data(256);
  for (std::size_t i = 0; i < data.size(); ++i)
    data[i] = std::cos(2 * M_PI * 17 * static_cast<double>(i) / 256);
  const auto before = data;
  transform(data, Transform::forward);
  CHECK(std::abs(data[17]) == Approx(128));
  CHECK(std::abs(data[18]) < 1e-9);
  transform(data, Transform::inverse);
  for (std::size_t i = 0; i < data.size(); ++i) CHECK(std::abs(data[i] - before[i]) < 1e-12);
}

TEST_CASE("sweep: resonances, gain and delay of a known device are found, with noise and distortion") {
  SweepSettings settings;
  settings.duration_s = 4;
  const std::vector<float> played = sweepSignal(settings);
  std::vector<double> x(played.begin(), played.end());
  const struct { double f, q, g; } truth[] = {{260, 6, 10}, {390, 10, 14}, {780, 12, 18}};
  for (const auto& t : truth) {
    Biquad section;
    section.setCoefficients(peaking(settings.sampleRate_Hz, t.f, t.q, t.g));
    section.process(x.data(), x.size());
  }
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.002);
  std::vector<float> recorded(played.size(), 0);
  const std::size_t delay = 1234;
  for (std::size_t i = delay; i < recorded.size(); ++i) {
    const double v = 0.1 * x[i - delay];
    recorded[i] = static_cast<float>(v + 0.05 * v * v + noise(random));
  }
  const Result<FrequencyResponse> response = analyseSweep(played, recorded, settings);
  REQUIRE(response);
  CHECK(response->delay_s == Approx(delay / settings.sampleRate_Hz).margin(2e-4));
  REQUIRE(response->resonances.size() == 3);
  for (const auto& t : truth) {
    const auto near =
        std::find_if(response->resonances.begin(), response->resonances.end(),
                     [&](const Resonance& r) { return std::fabs(r.frequency_Hz / t.f - 1) < 0.02; });
    REQUIRE(near != response->resonances.end());
    CHECK(near->gain_dB == Approx(t.g).margin(2));
    CHECK(near->q == Approx(t.q).epsilon(0.2));
  }
  const double flat = response->gain_dB[static_cast<std::size_t>(24 * std::log2(50.0 / 10))];
  CHECK(flat == Approx(-20).margin(1));
  DeviceProfile profile;
  applyResponse(*response, settings, profile);
  CHECK(profile.equalizer.size() == 3);
  CHECK(profile.equalizer[0].gain_dB == Approx(-12));
  CHECK(responseCsv(*response).find("frequency_Hz,gain_dB\n") == 0);
}

TEST_CASE("sweep: neighbouring sections are found together, within their stated errors") {
  SweepSettings settings;
  settings.duration_s = 4;
  const std::vector<float> played = sweepSignal(settings);
  const std::vector<Resonance> truths[] = {{{260, 6, 10}, {390, 10, 14}, {780, 12, 18}},
                                           {{150, 4, 8}, {330, 15, 12}, {520, 8, 9}},
                                           {{90, 20, 16}, {410, 5, 11}}};
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.002);
  int within = 0, within2 = 0, all = 0;
  for (const std::vector<Resonance>& truth : truths) {
    std::vector<double> x(played.begin(), played.end());
    for (const Resonance& t : truth) {
      Biquad section;
      section.setCoefficients(peaking(settings.sampleRate_Hz, t.frequency_Hz, t.q, t.gain_dB));
      section.process(x.data(), x.size());
    }
    std::vector<float> recorded(played.size(), 0);
    for (std::size_t i = 700; i < recorded.size(); ++i)
      recorded[i] = static_cast<float>(0.1 * x[i - 700] + noise(random));
    const auto response = analyseSweep(played, recorded, settings);
    REQUIRE(response);
    REQUIRE(response->errors.size() == truth.size());
    for (const Resonance& t : truth) {
      const auto near = std::min_element(response->resonances.begin(), response->resonances.end(),
                                         [&](const Resonance& a, const Resonance& b) {
                                           return std::fabs(a.frequency_Hz - t.frequency_Hz) <
                                                  std::fabs(b.frequency_Hz - t.frequency_Hz);
                                         });
      const ResonanceErrors& error =
          response->errors[static_cast<std::size_t>(near - response->resonances.begin())];
      INFO(t.frequency_Hz << " Hz: Q " << near->q << " for " << t.q << " +- " << error.q << ", "
                          << near->gain_dB << " dB for " << t.gain_dB << " +- " << error.gain_dB);
      CHECK(near->q == Approx(t.q).epsilon(0.01));
      CHECK(near->gain_dB == Approx(t.gain_dB).margin(0.1));
      const double z[] = {(near->frequency_Hz - t.frequency_Hz) / error.frequency_Hz,
                          (near->q - t.q) / error.q, (near->gain_dB - t.gain_dB) / error.gain_dB};
      for (const double each : z) within += std::fabs(each) < 1, within2 += std::fabs(each) < 2, ++all;
    }
  }
  INFO(within << " and " << within2 << " of " << all);
  CHECK(within >= 0.4 * all);
  CHECK(within2 >= 0.8 * all);
}

TEST_CASE("sweep: of a recorder whose full scale is known, the device's level above threshold") {
  SweepSettings settings;
  settings.duration_s = 4;
  const std::vector<float> played = sweepSignal(settings);
  std::vector<double> x(played.begin(), played.end());
  for (const Resonance& t : {Resonance{260, 6, 10}, Resonance{390, 10, 14}}) {
    Biquad section;
    section.setCoefficients(peaking(settings.sampleRate_Hz, t.frequency_Hz, t.q, t.gain_dB));
    section.process(x.data(), x.size());
  }
  std::vector<float> recorded(played.size(), 0);
  for (std::size_t i = 700; i < recorded.size(); ++i) recorded[i] = static_cast<float>(0.1 * x[i - 700]);
  const auto response = analyseSweep(played, recorded, settings);
  REQUIRE(response);
  // Full scale of the device is 0.1 of the recorder's 250 m/s2: a hundred times the threshold of touch.
  CHECK(fullScaleLevel_dB(*response, settings, 250) == Approx(40).margin(0.3));
}

TEST_CASE("sweep: what is no sum of sections keeps its peaks, without errors") {
  std::vector<double> frequency_Hz, gain_dB;
  for (int i = 10; i < 1000; ++i) {
    frequency_Hz.push_back(i);
    gain_dB.push_back(i / 50 % 2 ? 20 : 0);  // a comb
  }
  CHECK_FALSE(fitSectionsTogether(frequency_Hz, gain_dB, {{75, 3, 10}}, 48000));
  CHECK_FALSE(fitSectionsTogether(frequency_Hz, gain_dB, {}, 48000));
  CHECK_FALSE(fitSectionsTogether({100, 200}, {1, 2}, {{150, 3, 10}}, 48000));
}

TEST_CASE("sweep: lost sound is seen, noise, distortion and rattling resonances are not taken for it") {
  SweepSettings settings;
  settings.duration_s = 4;
  const std::vector<float> played = sweepSignal(settings);
  const auto recordedWith = [&](double lostAt_s, std::size_t lost, bool shifts) {
    Biquad resonance;
    resonance.setCoefficients(peaking(settings.sampleRate_Hz, 390, 10, 14));
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0, 0.001);
    std::vector<float> recorded(played.size(), 0);
    const std::size_t delay = 800;
    const auto gap = static_cast<std::size_t>(lostAt_s * settings.sampleRate_Hz);
    for (std::size_t i = delay; i < recorded.size(); ++i) {
      const std::size_t from = i - delay + (shifts && i > gap ? lost : 0);
      double v = 0.1 * static_cast<double>(from < played.size() ? played[from] : 0);
      resonance.process(&v, 1);
      const bool silent = !shifts && i >= gap && i < gap + lost;
      recorded[i] = static_cast<float>((silent ? 0 : v + 0.5 * v * v) + noise(random));
    }
    return recorded;
  };
  const auto clean = analyseSweep(played, recordedWith(0, 0, false), settings);
  REQUIRE(clean);
  CHECK(clean->dropouts_s.empty());
  for (const double at_s : {1.5, 2.5, 3.5}) {
    for (const std::size_t lost : {std::size_t{256}, std::size_t{1024}}) {
      for (const bool shifts : {false, true}) {
        const auto response = analyseSweep(played, recordedWith(at_s, lost, shifts), settings);
        INFO(at_s << " s, " << lost << " samples, " << (shifts ? "cut out" : "silent"));
        REQUIRE(response);
        // A gap late in a sweep only delays the rest, and is harmless where it is not noticed.
        CHECK((!response->dropouts_s.empty() || (shifts && agree(*response, *clean))));
        if (!shifts) CHECK(response->dropouts_s.front() == Approx(at_s).margin(0.02));
      }
    }
  }
}

TEST_CASE("sweep: an input without the sweep is said to be one") {
  SweepSettings settings;
  settings.duration_s = 1;
  const std::vector<float> played = sweepSignal(settings);
  std::vector<float> nothing(played.size(), 0);
  CHECK(analyseSweep(played, nothing, settings).failure().exitCode() == 5);
  std::mt19937 random(2);
  for (float& v : nothing) v = static_cast<float>(random() % 1000) * 1e-5f;
  CHECK_FALSE(analyseSweep(played, nothing, settings));
  nothing[7] = std::nanf("");
  CHECK_FALSE(analyseSweep(played, nothing, settings));
}

TEST_CASE("calibrate: truth within the error bars, degree only as high as supported") {
  CalibrationSettings settings;
  std::mt19937 random(11);
  std::normal_distribution<double> unit(0, 1);
  int inside = 0, trials = 200, tooHigh = 0;
  for (int trial = 0; trial < trials; ++trial) {
    // A divider whose conductance rises linearly with force: u = F / 5.
    std::vector<KnownWeight> weights;
    for (double force : {0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0, 12.0}) {
      const double read = force * (1 + 0.02 * unit(random));
      const double u = read / 5;
      weights.push_back({force, 1023 * u / (1 + u)});
    }
    const Result<SensorCalibration> c = calibrate(weights, settings);
    REQUIRE(c);
    if (c->coefficientCount > 2) {
      ++tooHigh;
      continue;
    }
    if (std::fabs(c->coefficients[1] - 5) < 2 * c->standardErrors[1]) ++inside;
    CHECK(c->force_N(1023 * 0.6 / 1.6) == Approx(3).epsilon(0.05));
  }
  CHECK(tooHigh < trials / 4);
  CHECK(inside > 0.8 * (trials - tooHigh));
  // A sensor that is really curved gets its curvature.
  std::vector<KnownWeight> bent;
  for (double u = 0.05; u < 2; u += 0.1) bent.push_back({2 * u + 1.5 * u * u, 1023 * u / (1 + u)});
  const Result<SensorCalibration> c = calibrate(bent, settings);
  REQUIRE(c);
  CHECK(c->coefficientCount >= 3);
  CHECK(c->residual_N < 1e-6);
}

TEST_CASE("calibrate: three or four readings are reported as too few, whatever they say") {
  for (std::size_t count : {3U, 4U}) {
    std::vector<KnownWeight> weights;
    for (std::size_t i = 0; i < count; ++i)
      weights.push_back({0.5 * static_cast<double>(i), 100 + 50 * static_cast<double>(i)});
    CalibrationSettings linear;
    linear.circuit = SensorCircuit::linear;
    const Result<SensorCalibration> c = calibrate(weights, linear);
    REQUIRE_FALSE(c);
    CHECK(c.failure().sentence().find(std::to_string(count) + " readings") != std::string::npos);
  }
}

TEST_CASE("calibrate: unusable weights are refused") {
  CHECK_FALSE(calibrate({}, {}));
  CHECK_FALSE(calibrate({{1, 100}, {1, 101}, {1, 99}, {1, 100}, {1, 100}}, {}));
  CHECK_FALSE(calibrate({{1, 100}, {2, 1023}, {3, 300}, {4, 500}, {5, 600}}, {}));
  CHECK_FALSE(calibrate({{5, 100}, {4, 200}, {3, 300}, {2, 400}, {1, 500}, {0.5, 550}}, {}));
  const auto weights = parseWeights("mass_g,raw\n100,200\n# x\n200.5,300\r\n", "w.csv");
  REQUIRE(weights);
  CHECK((*weights)[0].force_N == Approx(0.980665));
  for (const char* bad : {"100,200\n", "mass_g,raw\n100\n", "mass_g,raw\n100,x\n", "mass_g,raw\nx,1\n"}) {
    CHECK(parseWeights(bad, "w.csv").failure().sentence().find("line") != std::string::npos);
  }
}

TEST_CASE("profile: survives a round trip bit for bit; typing errors do not pass") {
  DeviceProfile p;
  p.name = "Mockup 1";
  p.gain = 0.1 + 0.2;
  p.fullScale_dB = 41.0 + 1.0 / 3;
  p.resonances = {{390.123456789, 1.0 / 3, 14}, {260, 5, 3}};
  p.equalizer = {{390.1, 3, -12}};
  p.sensor.circuit = SensorCircuit::divider;
  p.sensor.coefficientCount = 3;
  p.sensor.coefficients = {0.01, 5.0000000001, -1e-17, 0};
  p.sensor.standardErrors = {1e-3, 2e-3, 3e-3, 0};
  p.sensor.weights = 12;
  p.latency = MeasuredLatency{50, 0.05112, 0.00165, 0.054};
  const Result<DeviceProfile> back = parseDeviceProfile(toText(p), "p");
  REQUIRE(back);
  CHECK(toText(*back) == toText(p));
  CHECK(back->gain == p.gain);
  CHECK(back->fullScale_dB == p.fullScale_dB);
  CHECK(back->sensor.coefficients == p.sensor.coefficients);
  CHECK(back->resonances[0].q == p.resonances[0].q);
  CHECK(back->latency->mean_s == 0.05112);
  for (const char* bad : {"", "gain = 1\n", "detent-device 2\n", "detent-device 1\ngian = 1\n",
                          "detent-device 1\ngain = x\n", "detent-device 1\ngain = 1\ngain = 1\n",
                          "detent-device 1\nfull_scale_dB = 1e300\n", "detent-device 1\ngain = -1\n",
                          "detent-device 1\nresonance = 1 2\n", "detent-device 1\nsensor.circuit = bridge\n",
                          "detent-device 1\ngain 1\n", "detent-device 1\ngain = nan\n"}) {
    const Result<DeviceProfile> refused = parseDeviceProfile(bad, "bad.device");
    INFO(bad);
    REQUIRE_FALSE(refused);
    CHECK(refused.failure().exitCode() == 3);
  }
}

TEST_CASE("latency statistics: mean, SD, percentiles, histogram") {
  std::vector<double> delays;
  for (int i = 1; i <= 100; ++i) delays.push_back(i * 1e-3);
  const LatencyStatistics s = statisticsOf(delays, 2);
  CHECK(s.n == 100);
  CHECK(s.lost == 2);
  CHECK(s.mean_s == Approx(0.0505));
  CHECK(s.sd_s == Approx(0.0290115));
  CHECK(s.median_s == Approx(0.0505));
  CHECK(s.p95_s == Approx(0.09505));
  const std::string rows = histogram(s, 10);
  CHECK(std::count(rows.begin(), rows.end(), '\n') == 10);
  CHECK(statisticsOf({}, 3).n == 0);
  CHECK(statisticsOf({0.001}, 0).sd_s == 0);
}
