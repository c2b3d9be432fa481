// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/prepare_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <catch2/catch.hpp>

#include "playback/prepare/felt_level.h"
#include "playback/prepare/stroke_table.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

TEST_CASE("prepare: jumps follow the paper's rules") {
  PlaybackSettings settings;
  settings.jumpAmplitudePerArea_per_mJ = 1.5;
  const Button button = twoLevelButton();
  const auto program = std::make_unique<HapticProgram>(programOf(button, settings));
  const StrokeCurve& press = button.states()[0].graph.press();
  std::size_t i = 0;
  for (const Section& s : sectionsOf(press, Stroke::press)) {
    if (s.kind != SectionKind::jump) continue;
    const JumpEntry& jump = program->states[0].press.jumps[i++];
    CHECK(jump.from_mm == s.from_mm);
    CHECK(jump.burst.frequency_Hz == 390);
    CHECK(jump.burst.duration_s == Approx(0.020 * (s.to_mm - s.from_mm)));
    CHECK(jump.burst.amplitude == Approx(1.5 * jumpArea_mJ(press, s)));
    CHECK(jump.burst.envelope == Envelope::falling);
  }
  CHECK(i == 2);
  CHECK(program->states[0].press.jumpCount == 2);
  CHECK(program->states[0].release.jumps[0].burst.frequency_Hz == 410);
  CHECK(program->bottomOut.frequency_Hz == 200);
  CHECK(program->bottomOut.duration_s == Approx(0.030));
  CHECK(program->bottomOut.envelope == Envelope::rising);
  CHECK(program->grain.frequency_Hz == 150);
  CHECK(program->grainsPerMm == 20);
}

TEST_CASE(
    "prepare: the paper's feel leaves every level as it is, the clear one lets the weakest jump through") {
  PlaybackSettings settings;
  const auto plain = std::make_unique<HapticProgram>(programOf(twoLevelButton(), settings));
  CHECK(plain->loudestDensity_per_s == 0);
  CHECK(plain->slopeUnderJump == 1);
  CHECK(plain->longestBottomOutWait_s == 0);
  CHECK(plain->states[0].bottomOutLevel == 1);
  CHECK(plain->states[0].press.slopeLevel == 1);
  CHECK_FALSE(plain->states[0].press.jumps[0].burst.quietensSlope);

  settings.feel = Feel::clear;
  const auto clear = std::make_unique<HapticProgram>(programOf(twoLevelButton(), settings));
  Burst bottomOut = clear->bottomOut;
  bottomOut.amplitude *= clear->states[0].bottomOutLevel;
  double weakest_dB = 1000, last_dB = 0;
  const StrokeTable &press = clear->states[0].press, &before = plain->states[0].press;
  for (std::size_t i = 0; i < press.jumpCount; ++i) {
    CHECK(press.jumps[i].burst.amplitude == Approx(std::sqrt(before.jumps[i].burst.amplitude)));
    CHECK(press.jumps[i].burst.quietensSlope);
    last_dB = feltLevel_dB(press.jumps[i].burst, {}, *clear);
    weakest_dB = std::min(weakest_dB, last_dB);
  }
  CHECK(feltLevel_dB(bottomOut, {}, *clear) == Approx(last_dB - settings.clear.jumpAbove_dB));
  for (std::size_t i = 0; i < press.slopeCount; ++i) {
    CHECK(feltSlopeLevel_dB({}, *clear) + 20 * std::log10(press.slopeLevel * press.slopes[i].level) <=
          weakest_dB - settings.clear.jumpAbove_dB + 1e-9);
  }

  const auto linear = std::make_unique<HapticProgram>(programOf(linearButton(), settings));
  CHECK(linear->states[0].bottomOutLevel == 1);
  CHECK(linear->states[0].press.slopeLevel == 1);
}

TEST_CASE(
    "prepare: levels above threshold: 45 dB at 250 Hz, 12 dB per octave far from it, and what the device "
    "adds") {
  CHECK(pacinianWeight_dB(250) == 0);
  CHECK(pacinianWeight_dB(4000) - pacinianWeight_dB(8000) == Approx(12).margin(0.2));
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  DeviceProfile device;
  device.resonances = {{250, 8, 12}};
  const Burst burst{250, 1, 1, Envelope::falling};
  CHECK(feltLevel_dB(burst, {}, *program) == Approx(45).margin(0.1));
  CHECK(feltLevel_dB(burst, device, *program) == Approx(57).margin(0.1));
}

TEST_CASE("prepare: twice as steep is felt 4.1 dB stronger, up to full scale; the paper knows no steepness") {
  const auto levelsOf = [](double slope_N_per_mm, Feel feel) {
    PlaybackSettings settings;
    settings.feel = feel;
    const Button button = buttonOf("slope", {stateOf("", {{0, 0.1}, {4, 0.1 + 4 * slope_N_per_mm}}, {})});
    const auto program = std::make_unique<HapticProgram>(programOf(button, settings));
    const StrokeTable& press = program->states[0].press;
    REQUIRE(press.slopeCount == 1);
    return 20 * std::log10(press.slopes[0].level * press.slopeLevel);
  };
  for (double slope_N_per_mm : {0.05, 0.1, 0.2, 0.4}) {
    CHECK(levelsOf(2 * slope_N_per_mm, Feel::clear) - levelsOf(slope_N_per_mm, Feel::clear) ==
          Approx(4.14).margin(0.51));
    CHECK(levelsOf(slope_N_per_mm, Feel::paper) == 0);
  }
  CHECK(levelsOf(0.8, Feel::clear) - levelsOf(0.05, Feel::clear) == Approx(16.6).margin(0.51));
  CHECK(levelsOf(5, Feel::clear) <= 6.03);  // a grain has half of full scale
}

TEST_CASE("prepare: a slope that changes is felt piece by piece, every grain once") {
  PlaybackSettings settings;
  settings.feel = Feel::clear;
  const Button button = buttonOf("two rates", {stateOf("", {{0, 0.1}, {2, 0.2}, {4, 1.2}}, {})});
  const auto clear = std::make_unique<HapticProgram>(programOf(button, settings));
  const StrokeTable& press = clear->states[0].press;
  REQUIRE(press.slopeCount > 1);
  CHECK(press.slopes[0].level < 0.5 * press.slopes[press.slopeCount - 1].level);
  for (std::size_t i = 1; i < press.slopeCount; ++i)
    CHECK(press.slopes[i].first == press.slopes[i - 1].last + 1);
  settings.feel = Feel::paper;
  const auto paper = std::make_unique<HapticProgram>(programOf(button, settings));
  CHECK(press.slopes[0].first == paper->states[0].press.slopes[0].first);
  CHECK(press.slopes[press.slopeCount - 1].last == paper->states[0].press.slopes[0].last);
}

TEST_CASE("prepare: the bottom-out behind a slope makes none of its grains louder") {
  PlaybackSettings settings;
  settings.feel = Feel::clear;
  for (const bool withBottomOut : {false, true}) {
    std::vector<CurvePoint> points{{0, 0.1}, {4, 0.9}};
    if (withBottomOut) points.push_back({4, 3});
    const auto program =
        std::make_unique<HapticProgram>(programOf(buttonOf("wall", {stateOf("", points, {})}), settings));
    const StrokeTable& press = program->states[0].press;
    INFO(withBottomOut);
    REQUIRE(press.slopeCount == 1);
    CHECK(20 * std::log10(press.slopes[0].level) == Approx(-2.8).margin(0.26));  // 0.2 N/mm, as drawn
  }
}

TEST_CASE("prepare: only what the button has") {
  const auto linear = std::make_unique<HapticProgram>(programOf(linearButton()));
  CHECK(linear->stateCount == 1);
  CHECK(linear->states[0].press.jumpCount == 0);
  CHECK(linear->equalizerBandCount == 0);
  CHECK(linear->states[0].press.pointCount < 10);
  PlaybackSettings off;
  off.mode = FeedbackMode::off;
  const auto silent = std::make_unique<HapticProgram>(programOf(tactileButton(), off));
  CHECK(silent->grainsPerMm == 0);
  CHECK(silent->states[0].press.jumpCount == 0);
  CHECK_FALSE(silent->states[0].hasBottomOut);
}

TEST_CASE("prepare: without grains a button has no slopes, and keeps its jumps") {
  for (const Feel feel : {Feel::clear, Feel::paper}) {
    PlaybackSettings settings;
    settings.feel = feel;
    settings.grainsPerMm = 0;
    const auto program = std::make_unique<HapticProgram>(programOf(tactileButton(), settings));
    CHECK(program->grainsPerMm == 0);
    CHECK(program->states[0].press.slopeCount == 0);
    CHECK(program->states[0].press.jumpCount > 0);
  }
}

TEST_CASE("prepare: the device's resonance and equalizer are used when requested") {
  DeviceProfile profile;
  profile.resonances = {{780, 10, 20}, {260, 5, 9}, {370, 8, 12}};
  profile.equalizer = {{370, 8, -12}};
  PlaybackSettings settings;
  settings.jumpFrequencySource = JumpFrequencySource::profile;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton(), settings, profile));
  CHECK(program->states[0].press.jumps[0].burst.frequency_Hz == 370);
  CHECK(program->states[0].release.jumps[0].burst.frequency_Hz == Approx(410.0 * 370 / 390));
  // The band at the jumps' own frequency is spared unless requested.
  CHECK(program->equalizerBandCount == 0);
  settings.equalizer = EqualizerUse::full;
  CHECK(programOf(tactileButton(), settings, profile).equalizerBandCount == 1);
  settings.equalizer = EqualizerUse::sparingJumps;
  profile.equalizer.push_back({780, 10, -12});
  CHECK(programOf(tactileButton(), settings, profile).equalizerBandCount == 1);
  profile.equalizer.pop_back();
  settings.equalizer = EqualizerUse::off;
  CHECK(programOf(tactileButton(), settings, profile).equalizerBandCount == 0);
  const Result<PreparedProgram> without = prepareProgram(tactileButton(), {}, settings);
  REQUIRE(without);
  REQUIRE(!without->summary.warnings.empty());
  CHECK(without->summary.warnings[0].code == PrepareWarningCode::noResonance);
}

TEST_CASE("prepare: settings outside their range are refused by name") {
  const double nan = std::nan("");
  const auto refused = [](const PlaybackSettings& s, const char* name) {
    const Result<PreparedProgram> r = prepareProgram(linearButton(), {}, s);
    REQUIRE_FALSE(r);
    CHECK(r.failure().exitCode() == 2);
    CHECK(r.failure().sentence().find(name) != std::string::npos);
  };
  PlaybackSettings s;
  s.grainsPerMm = -1;
  refused(s, "grainsPerMm");
  s = {};
  s.grainFrequency_Hz = nan;
  refused(s, "grainFrequency_Hz");
  s = {};
  s.hysteresis_N = -0.001;
  refused(s, "hysteresis_N");
  s = {};
  s.limiterCeiling = 1.5;
  refused(s, "limiterCeiling");
  s = {};
  s.shortestJump_s = 0.5;
  refused(s, "shortestJump_s");
  DeviceProfile profile;
  profile.equalizer.resize(17, {390, 1, 0});
  CHECK_FALSE(prepareProgram(linearButton(), profile, {}));
}

TEST_CASE("table: as close to the curve as its vertices allow, vertical rises kept") {
  const Button button = tactileButton();
  const StrokeCurve& curve = button.states()[0].graph.press();
  const TableFit fit = fitTable(curve, curve.start_mm(), curve.end_mm(), -1e9, {1.2});
  CHECK(fit.points.size() <= maxTablePoints);
  std::size_t k = 0;
  for (int i = 0; i <= 10000; ++i) {
    const double x = 4.0 * i / 10000;
    while (k + 2 < fit.points.size() && fit.points[k + 1].displacement_mm <= x) ++k;
    const TablePoint &a = fit.points[k], &b = fit.points[k + 1];
    const double f = a.force_N + (b.force_N - a.force_N) * (x - a.displacement_mm) /
                                     (b.displacement_mm - a.displacement_mm);
    REQUIRE(std::fabs(f - curve.force_N(x)) <= fit.error_N + 1e-6);
  }
  const Result<StrokeCurve> withBottomOut =
      StrokeCurve::fromKnots({{0, 0, 0, 0.1}, {2, 0.2, 0.1, 0}, {2, 5, 0, 0.1}, {3, 5.1, 0.1, 0}});
  REQUIRE(withBottomOut);
  const TableFit steep = fitTable(*withBottomOut, 0, 3, -1e9, {});
  int atBottomOut = 0;
  for (const TablePoint& p : steep.points) atBottomOut += p.displacement_mm == 2 ? 1 : 0;
  CHECK(atBottomOut == 2);
  CHECK(steep.error_N < 1e-9);
}

TEST_CASE("prepare: many jumps and long names are cut with a warning, never out of bounds") {
  std::vector<CurvePoint> wavy;
  for (int i = 0; i <= 200; ++i)
    wavy.push_back({i * 0.05, 1 + i * 0.02 + (i % 2 == 0 ? 0 : 0.9 + 0.001 * i)});
  const Button button = buttonOf(std::string(200, 'n'), {stateOf("", wavy, {})});
  const Result<PreparedProgram> prepared = prepareProgram(button, {}, {});
  REQUIRE(prepared);
  CHECK(prepared->program.states[0].press.jumpCount <= maxJumps);
  CHECK(std::string(prepared->program.name.data()).size() == maxProgramName - 1);
}

TEST_CASE("prepare: of more equal jumps than a program holds the first are kept, and the rest is reported") {
  std::vector<CurvePoint> press{{0, 0.1}};
  constexpr int jumps = 40;
  for (int i = 0; i < jumps; ++i) {
    press.push_back({0.1 * i + 0.04, 0.9 + 0.02 * i});
    press.push_back({0.1 * i + 0.08, 0.4 + 0.02 * i});
  }
  press.push_back({4.2, 3});
  const Result<PreparedProgram> prepared = prepareProgram(buttonOf("many", {stateOf("", press, {})}), {}, {});
  REQUIRE(prepared);
  CHECK(prepared->program.states[0].press.jumpCount == maxJumps);
  CHECK(prepared->program.states[0].press.jumps[0].from_mm <
        prepared->program.states[0].press.jumps[1].from_mm);
  const auto& warnings = prepared->summary.warnings;
  CHECK(std::any_of(warnings.begin(), warnings.end(),
                    [](const PrepareWarning& w) { return w.code == PrepareWarningCode::jumpsLeftOut; }));
}

TEST_CASE("prepare: a profile with what no device measures is refused by name") {
  const double absurd = GENERATE(1e300, -1e300);
  const auto refused = [](const DeviceProfile& profile, const std::string& name) {
    const Result<PreparedProgram> prepared = prepareProgram(tactileButton(), profile, {});
    REQUIRE_FALSE(prepared);
    CHECK(prepared.failure().sentence().find(name) != std::string::npos);
  };
  const auto with = [](auto change) {
    DeviceProfile profile;
    change(profile);
    return profile;
  };
  CHECK(prepareProgram(tactileButton(), with([](auto& p) { p.resonances = {{780, 12, 20}}; }), {}));
  refused(with([](auto& p) { p.gain = 1e-300; }), "gain");
  refused(with([&](auto& p) { p.resonances = {{780, absurd, 20}}; }), "resonance q");
  refused(with([&](auto& p) { p.resonances = {{780, 12, absurd}}; }), "resonance gain_dB");
  refused(with([&](auto& p) { p.sensor.coefficients[1] = absurd; }), "sensor.coefficients");
  refused(with([&](auto& p) { p.sensor.noise_N = absurd; }), "sensor.noise_N");
  refused(with([&](auto& p) { p.sensor.residual_N = absurd; }), "sensor.residual_N");
  refused(with([&](auto& p) { p.latency = {50, absurd, 0, 0}; }), "latency mean_s");
}

TEST_CASE("prepare: a transducer's power bounds the ceiling, its sensor's noise the hysteresis") {
  DeviceProfile profile;
  profile.transducer = {1, 4, 8};  // 2 V of 8
  profile.sensor.noise_N = 0.01;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton(), {}, profile));
  CHECK(program->limiterCeiling == Approx(0.25));
  CHECK(program->hysteresis_N == Approx(0.04));
  profile.sensor.weights = 3;
  profile.sensor.coefficients = {0, -1, 0, 0};
  CHECK_FALSE(prepareProgram(tactileButton(), profile, {}));
}

namespace {

/// A press with two jumps, of which the second falls by more.
Button twoClicks(double firstFall_N, double secondFall_N) {
  return buttonOf("two clicks", {stateOf("",
                                         {{0, 0.2},
                                          {0.8, 1.2},
                                          {1.1, 1.2 - firstFall_N},
                                          {1.6, 1.6},
                                          {2.0, 2.6},
                                          {2.4, 2.6 - secondFall_N},
                                          {3.0, 3.2},
                                          {3.0, 4.0}},
                                         {})});
}

}  // namespace

TEST_CASE("prepare: the bottom-out stays felt beside a strong click, however weak the one before") {
  for (const double weak_N : {0.12, 0.3, 0.6}) {
    PlaybackSettings settings;
    settings.feel = Feel::clear;
    const auto program = std::make_unique<HapticProgram>(programOf(twoClicks(weak_N, 1.5), settings));
    const StateProgram& state = program->states[0];
    REQUIRE(state.press.jumpCount == 2);
    REQUIRE(state.hasBottomOut);
    Burst bottomOut = program->bottomOut;
    bottomOut.amplitude *= state.bottomOutLevel;
    const double strong_dB = feltLevel_dB(state.press.jumps[1].burst, {}, *program);
    INFO("first fall " << weak_N << " N, " << feltLevel_dB(state.press.jumps[0].burst, {}, *program)
                       << " and " << strong_dB << " dB");
    CHECK(feltLevel_dB(bottomOut, {}, *program) >= strong_dB - 12);
    CHECK(feltLevel_dB(bottomOut, {}, *program) <= strong_dB - settings.clear.jumpAbove_dB + 1e-9);
  }
}

TEST_CASE("prepare: the clear feel keeps the order of the jumps over the paper's areas") {
  for (const Feel feel : {Feel::paper, Feel::clear}) {
    PlaybackSettings settings;
    settings.feel = feel;
    double before = 0;
    for (double fall_N = 0.2; fall_N < 1.2; fall_N += 0.1) {
      const auto program = std::make_unique<HapticProgram>(programOf(twoClicks(0.1, fall_N), settings));
      const double amplitude = program->states[0].press.jumps[1].burst.amplitude;
      INFO(feels.word(feel) << ", falls by " << fall_N);
      if (amplitude < 1) CHECK(amplitude > before);
      before = amplitude;
    }
    CHECK(before > 0.5);
  }
}

TEST_CASE("prepare: a click that the paper's levels drown is reported, with its place") {
  const auto remarksOf = [](const Button& button, const PlaybackSettings& settings,
                            const DeviceProfile& profile) {
    const Result<PreparedProgram> prepared = prepareProgram(button, profile, settings);
    REQUIRE(prepared);
    for (const PrepareWarning& w : prepared->summary.warnings)
      if (w.code == PrepareWarningCode::clickDrowned) return english(w.message);
    return std::string();
  };
  PlaybackSettings paper;
  const Button weakFirst = twoClicks(0.12, 1.5);
  CHECK(remarksOf(weakFirst, paper, {}).find("0.8 mm") != std::string::npos);
  CHECK(remarksOf(weakFirst, paper, {}).find("--feel clear") != std::string::npos);
  CHECK(remarksOf(weakFirst, paper, {}).find("2 mm") == std::string::npos);
  PlaybackSettings clear;
  clear.feel = Feel::clear;
  CHECK(remarksOf(weakFirst, clear, {}).empty());
  PlaybackSettings slopes;
  slopes.mode = FeedbackMode::slopeOnly;
  CHECK(remarksOf(weakFirst, slopes, {}).empty());
  CHECK(remarksOf(linearButton(), paper, {}).empty());
  // A device that resonates at the jumps' frequency lifts them.
  DeviceProfile resonant;
  resonant.resonances = {{390, 10, 24}};
  CHECK(remarksOf(weakFirst, paper, resonant).empty());
}
