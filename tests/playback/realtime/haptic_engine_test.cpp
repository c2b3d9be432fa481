// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/haptic_engine.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>

#include <catch2/catch.hpp>

#include "playback/realtime/grain_density.h"
#include "tests/playback/poisoned.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

struct Press {
  std::vector<EngineInput> inputs;
  std::int64_t frames = 0;
};

/// Presses of `duration_s` each, read at `sensor_Hz`.
Press presses(double rate, int count, double duration_s, double peak_N, double sensor_Hz = 425) {
  Press press;
  const double gap_s = 0.15, each_s = duration_s + gap_s;
  for (double t = 0; t < count * each_s; t += 1 / sensor_Hz) {
    const double phase = std::fmod(t, each_s) / duration_s;
    const double force = phase < 1 ? peak_N * 0.5 * (1 - std::cos(2 * M_PI * phase)) : 0;
    press.inputs.push_back({InputKind::force, t * rate, force});
  }
  press.frames = static_cast<std::int64_t>((count * each_s + 0.3) * rate);
  return press;
}

std::vector<float> renderIn(HapticEngine& engine, const Press& press,
                            const std::function<std::size_t()>& block,
                            std::vector<EngineEvent>* events = nullptr) {
  std::vector<float> out(static_cast<std::size_t>(press.frames));
  std::size_t done = 0, next = 0;
  while (done < out.size()) {
    const std::size_t n = std::min(block(), out.size() - done);
    while (next < press.inputs.size() && press.inputs[next].time_frames < static_cast<double>(done + n)) {
      REQUIRE(engine.push(press.inputs[next++]));
    }
    engine.render(out.data() + done, n);
    done += n;
    EngineEvent e;
    while (engine.nextEvent(e)) {
      if (events != nullptr) events->push_back(e);
    }
  }
  return out;
}

std::uint64_t grainPositions(const HapticProgram& p) {
  std::uint64_t n = 0;
  for (const StrokeTable* table : {&p.states[0].press, &p.states[0].release}) {
    for (std::size_t i = 0; i < table->slopeCount; ++i) {
      if (table->slopes[i].last >= table->slopes[i].first) {
        n += static_cast<std::uint64_t>(table->slopes[i].last - table->slopes[i].first + 1);
      }
    }
  }
  return n;
}

}  // namespace

TEST_CASE("engine: the result does not depend on the block, to the last bit") {
  for (double rate : {8000.0, 44100.0, 48000.0, 192000.0}) {
    const auto program = std::make_unique<HapticProgram>(programOf(twoLevelButton()));
    const Press press = presses(rate, 3, 0.12, 4);
    const auto whole = std::make_unique<HapticEngine>(rate);
    whole->use(program.get());
    const std::vector<float> expected = renderIn(*whole, press, [] { return std::size_t{8192}; });
    CHECK(*std::max_element(expected.begin(), expected.end()) > 0.2f);
    for (std::size_t block : {std::size_t{1}, std::size_t{7}, std::size_t{64}, std::size_t{1000}}) {
      const auto engine = std::make_unique<HapticEngine>(rate);
      engine->use(program.get());
      CHECK(renderIn(*engine, press, [&] { return block; }) == expected);
    }
    std::mt19937 random(7);
    const auto engine = std::make_unique<HapticEngine>(rate);
    engine->use(program.get());
    const auto any = renderIn(*engine, press, [&] { return std::size_t{1} + random() % 8192; });
    CHECK(std::memcmp(any.data(), expected.data(), any.size() * sizeof(float)) == 0);
  }
}

TEST_CASE("engine: a clear press is the same in every block, and its bottom-out waits for the jump") {
  PlaybackSettings settings;
  settings.feel = Feel::clear;
  const auto program = std::make_unique<HapticProgram>(programOf(twoLevelButton(), settings));
  const double rate = 48000;
  const Press press = presses(rate, 2, 0.12, 4);
  std::vector<EngineEvent> events;
  const auto whole = std::make_unique<HapticEngine>(rate), cut = std::make_unique<HapticEngine>(rate);
  whole->use(program.get());
  cut->use(program.get());
  const std::vector<float> expected = renderIn(
      *whole, press, [] { return std::size_t{8192}; }, &events);
  const std::vector<float> got = renderIn(*cut, press, [] { return std::size_t{17}; });
  CHECK(std::memcmp(expected.data(), got.data(), expected.size() * sizeof(float)) == 0);
  std::int64_t jumpEnds = 0;
  int bottomOuts = 0;
  for (const EngineEvent& e : events) {
    if (e.kind == EventKind::pressJump) {
      const Burst& burst = program->states[0].press.jumps[e.jump].burst;
      jumpEnds = e.frame + static_cast<std::int64_t>(std::floor(burst.duration_s * rate));
    }
    if (e.kind != EventKind::bottomOut) continue;
    ++bottomOuts;
    CHECK(e.frame >= jumpEnds);
  }
  CHECK(bottomOuts == 2);
}

namespace {

/// Energy of a stroke of 3.9 mm at a steady speed, and how long it takes, samples.
struct SteadyStroke {
  double energy = 0, frames = 0;
  double level_dB() const { return 10 * std::log10(energy / frames); }
};

SteadyStroke steadyStroke(const HapticProgram& program, double speed_mm_per_s) {
  const double rate = 48000;
  const auto engine = std::make_unique<HapticEngine>(rate);
  engine->use(&program);
  Press press;
  for (int i = 0; i * speed_mm_per_s / 1000 < 3.9; ++i)
    press.inputs.push_back({InputKind::displacement, i * rate / 1000, i * speed_mm_per_s / 1000});
  press.frames = static_cast<std::int64_t>(press.inputs.back().time_frames);
  SteadyStroke stroke{0, static_cast<double>(press.frames)};
  for (const float x : renderIn(*engine, press, [] { return std::size_t{512}; }))
    stroke.energy += static_cast<double>(x) * static_cast<double>(x);
  return stroke;
}

}  // namespace

TEST_CASE(
    "engine: a slope twice as steep is felt as louder by one step at least, at any speed and rate of force") {
  PlaybackSettings settings;
  settings.feel = Feel::clear;
  std::vector<double> slow_dB, fast_dB, rate_dB;
  for (const double slope_N_per_mm : {0.05, 0.1, 0.2, 0.4, 0.8}) {
    const Button button = buttonOf("slope", {stateOf("", {{0, 0.1}, {4, 0.1 + 4 * slope_N_per_mm}}, {})});
    const auto program = std::make_unique<HapticProgram>(programOf(button, settings));
    slow_dB.push_back(steadyStroke(*program, 5).level_dB());
    fast_dB.push_back(steadyStroke(*program, 200).level_dB());
    const double rate_N_per_s = 10;
    rate_dB.push_back(steadyStroke(*program, rate_N_per_s / slope_N_per_mm).level_dB());
  }
  for (const auto& levels_dB : {slow_dB, fast_dB, rate_dB})
    for (std::size_t i = 1; i < levels_dB.size(); ++i) CHECK(levels_dB[i] - levels_dB[i - 1] >= 1.5);
}

TEST_CASE("engine: twice as many grains are felt as louder by one step at least, from 5 to 200 mm/s") {
  PlaybackSettings settings;
  settings.feel = Feel::clear;
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton(), settings));
  std::vector<double> levels_dB, energies_dB;
  for (double speed_mm_per_s = 5; speed_mm_per_s <= 200; speed_mm_per_s *= 2) {
    const SteadyStroke stroke = steadyStroke(*program, speed_mm_per_s);
    levels_dB.push_back(stroke.level_dB());
    energies_dB.push_back(10 * std::log10(stroke.energy));
  }
  for (std::size_t i = 1; i < levels_dB.size(); ++i) CHECK(levels_dB[i] - levels_dB[i - 1] >= 1.5);
  const auto [least, most] = std::minmax_element(energies_dB.begin(), energies_dB.end());
  CHECK(*most - *least <= 6);
  CHECK(levelOfDensity(NAN, 4000, 50) == levelOfDensity(50, 4000, 50));
  CHECK(levelOfDensity(1e9, 4000, 50) == 1);
}

TEST_CASE("engine: a burst equals its closed form within 1e-6") {
  PlaybackSettings settings;
  settings.limiterCeiling = 1;
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton(), settings));
  for (double rate : {8000.0, 48000.0, 192000.0}) {
    for (Envelope envelope : {Envelope::falling, Envelope::rising}) {
      const auto engine = std::make_unique<HapticEngine>(rate);
      engine->use(program.get());
      engine->trigger(100, {390, 0.0203, 0.8, envelope});
      std::vector<float> out(static_cast<std::size_t>(rate * 0.05));
      engine->render(out.data(), out.size());
      double worst = 0;
      for (std::size_t i = 0; i < out.size(); ++i) {
        const double t = (static_cast<double>(i) - 100) / rate;
        const bool on = t >= 0 && t < 0.0203;
        const double ramp = envelope == Envelope::falling ? 1 - t / 0.0203 : t / 0.0203;
        const double expected = on ? 0.8 * ramp * std::sin(2 * M_PI * 390 * t) : 0;
        worst = std::max(worst, std::fabs(static_cast<double>(out[i]) - expected));
      }
      CHECK(worst < 1e-6);
    }
  }
}

TEST_CASE("engine: every grain and jump of a press is played, from 5 ms to 60 s") {
  for (const Button& button : {linearButton(), tactileButton(), twoLevelButton()}) {
    const auto program = std::make_unique<HapticProgram>(programOf(button));
    for (EventPlacement placement : {EventPlacement::atOnce, EventPlacement::timeStamped}) {
      program->placement = placement;
      for (double duration : {0.005, 0.06, 1.0, 60.0}) {
        const Press press = presses(8000, 1, duration, 30);
        const auto engine = std::make_unique<HapticEngine>(8000);
        engine->use(program.get());
        std::vector<EngineEvent> events;
        renderIn(
            *engine, press, [] { return std::size_t{64}; }, &events);
        INFO(button.name() << " in " << duration << " s");
        CHECK(engine->counts().grains == grainPositions(*program));
        CHECK(engine->counts().pressJumps == program->states[0].press.jumpCount);
        CHECK(engine->counts().releaseJumps == program->states[0].release.jumpCount);
        CHECK(engine->counts().bottomOuts == 1);
        CHECK(engine->counts().late == 0);
        CHECK(engine->counts().droppedInputs == 0);
        CHECK(engine->idle());
      }
    }
  }
}

TEST_CASE("engine: a press within one reading feels every jump once, in order and apart") {
  const auto program = std::make_unique<HapticProgram>(programOf(twoLevelButton()));
  REQUIRE(program->states[0].press.jumpCount == 2);
  for (EventPlacement placement : {EventPlacement::atOnce, EventPlacement::timeStamped}) {
    program->placement = placement;
    const auto engine = std::make_unique<HapticEngine>(48000);
    engine->use(program.get());
    engine->push({InputKind::force, 0, 0});
    engine->push({InputKind::force, 113, 10});
    std::vector<float> out(4800);
    engine->render(out.data(), out.size());
    std::vector<EngineEvent> bursts;
    for (EngineEvent e; engine->nextEvent(e);) {
      if (e.kind != EventKind::grain) bursts.push_back(e);
    }
    REQUIRE(bursts.size() == 3);
    CHECK(bursts[0].kind == EventKind::pressJump);
    CHECK(bursts[0].jump == 0);
    CHECK(bursts[1].kind == EventKind::pressJump);
    CHECK(bursts[1].jump == 1);
    CHECK(bursts[2].kind == EventKind::bottomOut);
    CHECK(bursts[1].frame - bursts[0].frame >= 240);
    CHECK(bursts[2].frame - bursts[1].frame >= 240);
  }
}

TEST_CASE("engine: time-stamped events keep their distances, at-once events fall on the readings") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  const double step = 48000.0 / 425;
  const auto gaps = [&](EventPlacement placement) {
    program->placement = placement;
    const auto engine = std::make_unique<HapticEngine>(48000);
    engine->use(program.get());
    Press ramp;
    for (int i = 0; i <= 100; ++i)
      ramp.inputs.push_back({InputKind::force, i * step, 0.1 + 0.006 * i * 0.999});
    ramp.frames = 20000;
    std::vector<EngineEvent> events;
    renderIn(
        *engine, ramp, [] { return std::size_t{64}; }, &events);
    double low = 1e9, high = 0;
    for (std::size_t i = 2; i < events.size(); ++i) {
      if (events[i].kind != EventKind::grain) continue;
      const auto gap = static_cast<double>(events[i].frame - events[i - 1].frame);
      low = std::min(low, gap);
      high = std::max(high, gap);
    }
    return high - low;
  };
  CHECK(gaps(EventPlacement::timeStamped) <= 2);
  CHECK(gaps(EventPlacement::atOnce) > step / 2);
}

TEST_CASE("engine: full scale is never exceeded and stealing does not click") {
  auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  program->gain = 8;
  const auto engine = std::make_unique<HapticEngine>(48000);
  engine->use(program.get());
  for (int i = 0; i < 300; ++i) engine->trigger(i * 13, {390, 0.2, 1, Envelope::falling});
  std::vector<float> out(48000);
  engine->render(out.data(), out.size());
  CHECK(engine->counts().stolenVoices > 200);
  for (float v : out) REQUIRE(std::fabs(v) <= 1.0f);

  // One long, quiet voice each: the step between samples never exceeds that of the sines themselves.
  program->gain = 1;
  const auto calm = std::make_unique<HapticEngine>(48000);
  calm->use(program.get());
  for (int i = 0; i < 40; ++i) calm->trigger(i * 97, {200, 0.9, 0.02, Envelope::falling});
  calm->render(out.data(), out.size());
  CHECK(calm->counts().stolenVoices > 20);
  const double steepest = 24 * 0.02 * (2 * M_PI * 200 / 48000 + 1.0 / 48);
  for (std::size_t i = 1; i < out.size(); ++i) REQUIRE(std::fabs(out[i] - out[i - 1]) < steepest);
}

TEST_CASE("engine: grain restarts do not click behind the low-pass") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  const auto engine = std::make_unique<HapticEngine>(48000);
  engine->use(program.get());
  for (int i = 0; i < 500; ++i) engine->triggerGrain(i * 37.0);
  std::vector<float> out(20000);
  engine->render(out.data(), out.size());
  float steepest = 0;
  for (std::size_t i = 1; i < out.size(); ++i) steepest = std::max(steepest, std::fabs(out[i] - out[i - 1]));
  CHECK(steepest < 0.02f);  // a raw restart steps by up to 0.25
}

TEST_CASE("engine: modes sound as they say") {
  const auto energy = [](FeedbackMode mode) {
    PlaybackSettings settings;
    settings.mode = mode;
    const auto program = std::make_unique<HapticProgram>(programOf(tactileButton(), settings));
    const auto engine = std::make_unique<HapticEngine>(48000);
    engine->use(program.get());
    renderIn(*engine, presses(48000, 1, 0.2, 1.2), [] { return std::size_t{256}; });
    const EngineCounts& c = engine->counts();
    return std::array<bool, 2>{c.grains > 0, c.pressJumps + c.releaseJumps + c.bottomOuts > 0};
  };
  CHECK(energy(FeedbackMode::full) == std::array<bool, 2>{true, true});
  CHECK(energy(FeedbackMode::clickOnly) == std::array<bool, 2>{false, true});
  CHECK(energy(FeedbackMode::slopeOnly) == std::array<bool, 2>{true, false});
  CHECK(energy(FeedbackMode::off) == std::array<bool, 2>{false, false});
}

TEST_CASE("engine: floods, not-a-numbers and lateness are counted and survived") {
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  const auto engine = std::make_unique<HapticEngine>(48000);
  engine->use(program.get());
  int refused = 0;
  for (int i = 0; i < 100000; ++i) {
    const double value = i % 97 == 0 ? std::nan("") : 0.4 + 0.4 * std::sin(i * 0.37);
    if (!engine->push({InputKind::force, i * 0.01, value})) ++refused;
  }
  CHECK(refused > 0);
  CHECK(engine->counts().droppedInputs == static_cast<std::uint64_t>(refused));
  std::vector<float> out(48000);
  engine->render(out.data(), out.size());
  for (float v : out) REQUIRE(std::fabs(v) <= 1.0f);
  CHECK(engine->idle());
}

TEST_CASE("engine: a program exchanged under a resting finger makes no sound of its own") {
  const auto a = std::make_unique<HapticProgram>(programOf(linearButton()));
  const auto b = std::make_unique<HapticProgram>(programOf(twoLevelButton()));
  const auto engine = std::make_unique<HapticEngine>(48000);
  engine->use(a.get());
  engine->push({InputKind::force, 0, 0.65});
  std::vector<float> out(24000);
  engine->render(out.data(), out.size());
  engine->use(b.get());
  const auto before = engine->counts();
  engine->push({InputKind::force, 24001, 0.65});
  engine->render(out.data(), out.size());
  CHECK(engine->counts().grains == before.grains);
  CHECK(*std::max_element(out.begin(), out.end()) == 0);
  CHECK(engine->position().displacement_mm > 0);
}

TEST_CASE("engine: gain changes in a ramp") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  const auto engine = std::make_unique<HapticEngine>(48000);
  engine->use(program.get());
  engine->trigger(0, {100, 1, 0.9, Envelope::falling});
  std::vector<float> out(2400), after(2400);
  engine->render(out.data(), out.size());
  engine->setGain(0);
  engine->render(after.data(), after.size());
  CHECK(std::fabs(after[0] - out.back()) < 0.02f);
  CHECK(after.back() == 0);
}

TEST_CASE("engine: 24 hours of presses neither drift nor grow") {
  const double rate = 8000;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  const auto engine = std::make_unique<HapticEngine>(rate);
  engine->use(program.get());
  const double day_s = 24 * 3600, every_s = 30;
  std::vector<float> out(8192);
  std::int64_t firstDelay = -1;
  std::uint64_t pressesDone = 0;
  double pressAt_s = 1;
  while (static_cast<double>(engine->frame()) < day_s * rate) {
    if (static_cast<double>(engine->frame()) / rate + 2 > pressAt_s) {
      for (int i = 0; i <= 60; ++i) {
        const double force = 1.2 * 0.5 * (1 - std::cos(2 * M_PI * i / 60));
        engine->push({InputKind::force, (pressAt_s + i / 425.0) * rate, force});
      }
      ++pressesDone;
      pressAt_s += every_s;
    }
    engine->render(out.data(), out.size());
    for (EngineEvent e; engine->nextEvent(e);) {
      if (e.kind != EventKind::pressJump) continue;
      const double began_s = pressAt_s - every_s;
      const auto delay = e.frame - static_cast<std::int64_t>(std::llround(began_s * rate));
      if (firstDelay < 0) firstDelay = delay;
      REQUIRE(std::llabs(delay - firstDelay) <= 1);
    }
  }
  CHECK(engine->counts().pressJumps >= pressesDone - 1);
  CHECK(engine->counts().grains + grainPositions(*program) >= pressesDone * grainPositions(*program));
  CHECK(engine->counts().late == 0);
  CHECK(engine->counts().droppedEvents == 0);
}

TEST_CASE("engine: fast strokes keep their vibration, and nothing constant") {
  PlaybackSettings settings;
  settings.mode = FeedbackMode::slopeOnly;
  const auto levelAt = [&](double speed_mm_per_s) {
    const auto program = std::make_unique<HapticProgram>(programOf(linearButton(), settings));
    const auto engine = std::make_unique<HapticEngine>(48000);
    engine->use(program.get());
    const double moves_s = 4 / speed_mm_per_s;
    for (double t = 0; t <= moves_s; t += 1e-3)
      engine->push({InputKind::displacement, t * 48000, t * speed_mm_per_s});
    std::vector<float> out(static_cast<std::size_t>((moves_s + 0.02) * 48000));
    engine->render(out.data(), out.size());
    double mean = 0, square = 0;
    for (float x : out) mean += static_cast<double>(x) / static_cast<double>(out.size());
    for (float x : out) square += static_cast<double>(x) * static_cast<double>(x);
    return std::pair{std::sqrt(square / static_cast<double>(out.size())), std::fabs(mean)};
  };
  const auto [slow, slowMean] = levelAt(5);
  for (double speed : {50.0, 100.0, 200.0}) {
    const auto [level, mean] = levelAt(speed);
    INFO(speed << " mm/s: " << level << " beside " << slow);
    CHECK(level > slow / 2);
    CHECK(level < slow * 2);
    CHECK(mean < 0.01);
  }
  settings.grainCarrier = GrainCarrier::retriggered;  // the former carrier, which lost level at 50 mm/s
  settings.highPass_Hz = 20;
  CHECK(levelAt(50).first < slow / 2);
}

TEST_CASE("engine: the bottom-out plays after more jumps than can wait") {
  std::vector<CurvePoint> press{{0, 0.1}};
  for (int i = 0; i < 30; ++i) {
    press.push_back({0.1 * i + 0.04, 0.9 + 0.02 * i});
    press.push_back({0.1 * i + 0.08, 0.4 + 0.02 * i});
  }
  press.push_back({3.0, 1.6});
  press.push_back({3.1, 6});
  const auto program = std::make_unique<HapticProgram>(programOf(buttonOf("many", {stateOf("", press, {})})));
  REQUIRE(program->states[0].hasBottomOut);
  const auto engine = std::make_unique<HapticEngine>(48000);
  engine->use(program.get());
  engine->push({InputKind::force, 0, 0});
  engine->push({InputKind::force, 113, 10});
  std::vector<float> out(48000);
  engine->render(out.data(), out.size());
  CHECK(engine->counts().bottomOuts == 1);
  CHECK(engine->counts().pressJumps + engine->counts().crowded == program->states[0].press.jumpCount);
}

TEST_CASE("engine: another program leaves no step in what sounds") {
  PlaybackSettings settings;
  DeviceProfile profile;
  profile.gain = 0.1;
  profile.equalizer = {{200, 2, 12}};
  const auto one = std::make_unique<HapticProgram>(programOf(linearButton(), settings));
  const auto other = std::make_unique<HapticProgram>(programOf(tactileButton(), settings, profile));
  const auto engine = std::make_unique<HapticEngine>(48000);
  engine->use(one.get());
  engine->trigger(0, {200, 0.1, 0.8, Envelope::falling});
  std::vector<float> out(4800);
  engine->render(out.data(), 1000);
  engine->use(other.get());
  engine->render(out.data() + 1000, out.size() - 1000);
  for (std::size_t i = 1; i < out.size(); ++i) CHECK(std::fabs(out[i] - out[i - 1]) < 0.03f);
}

TEST_CASE("engine: the limiter keeps the form of an attack") {
  // Distance of the output from the same sound at another level, share of its own.
  const auto misshapen = [](double gain, double before) {
    auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
    program->gain = gain;
    const auto render = [&](double ceiling) {
      program->limiterCeiling = ceiling;
      const auto engine = std::make_unique<HapticEngine>(48000);
      engine->use(program.get());
      if (before > 0) engine->trigger(0, {150, 0.06, before, Envelope::falling});
      engine->trigger(960, {390, 0.034, 0.9, Envelope::falling});
      std::vector<float> out(2400);
      engine->render(out.data(), out.size());
      return out;
    };
    const std::vector<float> limited = render(0.6);
    std::vector<double> free(limited.size(), 0);
    for (std::size_t i = 0; i < free.size(); ++i) {
      const auto burst = [&](double at, double frequency, double length, double amplitude) {
        const double t = (static_cast<double>(i) - at) / 48000;
        return t >= 0 && t < length ? amplitude * (1 - t / length) * std::sin(2 * M_PI * frequency * t) : 0;
      };
      free[i] = gain * (burst(960, 390, 0.034, 0.9) + (before > 0 ? burst(0, 150, 0.06, before) : 0));
    }
    double product = 0, own = 0, rest = 0;
    for (std::size_t i = 960; i < 1083; ++i) {  // first wave of the bottom-out
      product += free[i] * static_cast<double>(limited[i]);
      own += free[i] * free[i];
    }
    double energy = 0;
    for (std::size_t i = 960; i < 1083; ++i) {
      const double v = static_cast<double>(limited[i]);
      rest += (v - product / own * free[i]) * (v - product / own * free[i]);
      energy += v * v;
    }
    return std::sqrt(rest / energy);
  };
  // Without looking ahead: 0.10, 0.24, 0.15, 0.24.
  CHECK(misshapen(1, 0) < 0.03);
  CHECK(misshapen(4, 0) < 0.03);
  CHECK(misshapen(1, 0.4) < 0.05);
  CHECK(misshapen(4, 0.1) < 0.05);
}

TEST_CASE("engine: nothing is evaluated that a button does not have") {
  const double rate = 48000;
  const auto play = [&](const HapticProgram& program) {
    const auto engine = std::make_unique<HapticEngine>(rate);
    return meetsPoison([&] {
      engine->use(&program);
      renderIn(*engine, presses(rate, 2, 0.12, 1.5 * strongestForce_N(program)),
               [] { return std::size_t{64}; });
    });
  };
  PlaybackSettings noSlopes, noClicks;
  noSlopes.mode = FeedbackMode::clickOnly;
  noClicks.mode = FeedbackMode::slopeOnly;
  for (const Button& button : {linearButton(), tactileButton(), twoLevelButton(), lockingButton()}) {
    for (const PlaybackSettings& settings : {PlaybackSettings{}, noSlopes, noClicks}) {
      const auto program = std::make_unique<HapticProgram>(poisoned(programOf(button, settings)));
      INFO(button.name() << ", mode " << static_cast<int>(settings.mode));
      CHECK_FALSE(play(*program));
    }
  }
  // Properties that it does have are read: one poisoned jump is met.
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  REQUIRE(program->states[0].press.jumpCount == 1);
  poison(program->states[0].press.jumps[0]);
  CHECK(play(*program));
  CHECK(programOf(linearButton()).states[0].press.jumpCount == 0);
}
