// SPDX-License-Identifier: GPL-3.0-or-later
// What runs in the callback, on any readings, at any rate, cut in any way, and after any time.

#include <cmath>
#include <cstring>
#include <memory>

#include <catch2/catch.hpp>

#include "playback/offline/render_press.h"
#include "playback/realtime/force_engine.h"
#include "playback/realtime/haptic_engine.h"
#include "playback/realtime/live_session.h"
#include "playback/realtime/rain_noise.h"
#include "playback/realtime/sensor_calibration.h"
#include "playback/realtime/sine.h"
#include "playback/realtime/stream_clock.h"
#include "tests/extremes/extreme_values.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::tests;

namespace {

constexpr double pi = 3.14159265358979323846;

double anyRate() {
  return oneIn(2)
             ? magnitude(8000, 192000)
             : std::vector<double>{8000, 44100, 48000, 96000, 192000}[static_cast<std::size_t>(count(0, 4))];
}

const HapticProgram& programOf(int button) {
  static const std::vector<HapticProgram> programs{
      test::programOf(test::linearButton()), test::programOf(test::tactileButton()),
      test::programOf(test::twoLevelButton()), test::programOf(test::lockingButton())};
  return programs[static_cast<std::size_t>(button)];
}
const HapticProgram& anyProgram() { return programOf(count(0, 3)); }

std::unique_ptr<HapticProgram> extremeProgram() {
  Result<PreparedProgram> prepared = prepareProgram(extremeButton(), {}, {});
  if (!prepared) return nullptr;
  return std::make_unique<HapticProgram>(prepared->program);
}

/// There and back, by forces.
PressTrace pressOf(const HapticProgram& program, double strength, double seconds, double rate_Hz) {
  PressTrace trace;
  const double strongest = strongestForce_N(program) * strength;
  const auto readings = std::max(3, static_cast<int>(seconds * rate_Hz));
  for (int i = 0; i <= readings; ++i) {
    const double s = static_cast<double>(i) / readings;
    trace.readings.push_back({seconds * s, strongest * std::pow(std::sin(pi * s), 2)});
  }
  return trace;
}

std::vector<float> rendered(const HapticProgram& program, const std::vector<EngineInput>& inputs,
                            double rate_Hz, int samples, const std::vector<int>& blocks) {
  const auto engine = std::make_unique<HapticEngine>(rate_Hz);
  engine->use(&program);
  for (const EngineInput& input : inputs) engine->push(input);
  std::vector<float> out(static_cast<std::size_t>(samples));
  std::size_t at = 0;
  for (std::size_t b = 0; at < out.size(); ++b) {
    const std::size_t n = std::min(out.size() - at, static_cast<std::size_t>(blocks[b % blocks.size()]));
    engine->render(out.data() + at, n);
    at += n;
  }
  return out;
}

struct Counts {
  std::uint64_t grains, press, release, bottoms;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts countsOf(const HapticProgram& program, const PressTrace& trace, double rate_Hz) {
  RenderSettings settings;
  settings.sampleRate_Hz = rate_Hz;
  const auto summary = renderPress(program, trace, settings, [](const float*, std::size_t) { return true; });
  if (!summary) RC_FAIL(summary.failure().sentence());
  const EngineCounts& c = summary->counts;
  return {c.grains, c.pressJumps, c.releaseJumps, c.bottomOuts};
}

}  // namespace

TEST_CASE("the engine's samples lie within full scale whatever comes in") {
  holdsAlways("any readings at any times", [] {
    const HapticProgram& program = anyProgram();
    const auto engine = std::make_unique<HapticEngine>(anyRate());
    engine->use(&program);
    std::vector<float> out(512);
    for (int i = count(1, 20); i > 0; --i) {
      EngineInput input;
      input.kind = oneIn(3) ? InputKind::displacement : oneIn(5) ? InputKind::resync : InputKind::force;
      input.time_frames = oneIn(3) ? anyDouble() : static_cast<double>(engine->frame()) + within(0, 600);
      input.value = oneIn(3) ? anyDouble() : within(-1, 4);
      engine->push(input);
      if (oneIn(4))
        engine->trigger(anyDouble(), {within(1, 2000), within(0, 0.1), within(0, 1), Envelope::falling});
      if (oneIn(8)) engine->setGain(oneIn(2) ? anyFinite() : within(0, 10));
      engine->render(out.data(), static_cast<std::size_t>(count(0, 512)));
      for (const float y : out) RC_ASSERT(std::isfinite(y) && std::abs(y) <= 1.0f);
    }
  });
  holdsAlways("buttons of any size", [] {
    const auto program = extremeProgram();
    RC_PRE(program != nullptr);
    const PressTrace trace = pressOf(*program, within(0.5, 1.5), 0.05, 1000);
    RenderSettings settings;
    settings.sampleRate_Hz = anyRate();
    settings.tail_s = 0.05;
    const auto out = renderPress(*program, trace, settings);
    if (!out) return assertNamed(out.failure());
    for (const float y : out->samples) RC_ASSERT(std::isfinite(y) && std::abs(y) <= 1.0f);
  });
  holdsAlways("sample rates outside the limits are moved to them", [] {
    const HapticEngine* engine = nullptr;
    const auto held = std::make_unique<HapticEngine>(anyDouble());
    engine = held.get();
    RC_ASSERT(engine->sampleRate_Hz() >= HapticEngine::lowestSampleRate_Hz);
    RC_ASSERT(engine->sampleRate_Hz() <= HapticEngine::highestSampleRate_Hz);
  });
}

TEST_CASE("how a sound is cut into blocks does not matter", "[finite]") {
  holdsAlways("render: the same bits in any blocks", [] {
    const HapticProgram& program = anyProgram();
    const double rate = anyRate();
    std::vector<EngineInput> inputs;
    double time = 0;
    for (int i = count(2, 40); i > 0; --i)
      inputs.push_back(
          {InputKind::force, time += within(0, 0.004) * rate, strongestForce_N(program) * within(-0.1, 1.3)});
    std::vector<int> blocks;
    for (int i = count(1, 5); i > 0; --i) blocks.push_back(count(1, 700));
    const auto whole = rendered(program, inputs, rate, 4000, {4000}),
               cut = rendered(program, inputs, rate, 4000, blocks);
    RC_ASSERT(std::memcmp(whole.data(), cut.data(), whole.size() * sizeof(float)) == 0);
  });
  holdsAlways("renderPress: the same bits for any block", [] {
    const HapticProgram& program = anyProgram();
    const PressTrace trace = pressOf(program, within(0.2, 1.4), 0.05, 425);
    RenderSettings one, other;
    one.tail_s = other.tail_s = 0.05;
    other.block = static_cast<std::size_t>(count(1, 8192));
    const auto a = renderPress(program, trace, one), b = renderPress(program, trace, other);
    RC_ASSERT(a.ok() && b.ok());
    RC_ASSERT(a->samples == b->samples);
  });
}

TEST_CASE("a press is the same press at any rate", "[finite]") {
  holdsAlways("events do not depend on the sample rate", [] {
    const HapticProgram& program = anyProgram();
    const PressTrace trace = pressOf(program, within(0.2, 1.4), 0.1, 425);
    RC_ASSERT(countsOf(program, trace, 48000) == countsOf(program, trace, anyRate()));
  });
  holdsAlways("nor on the sensor's, where the press reaches the same force", [] {
    const HapticProgram& program = anyProgram();
    const double strength = within(0.2, 1.4);
    // Even numbers of readings have one at the strongest force.
    const int coarse = 2 * count(20, 100), fine = 2 * count(100, 1000);
    const Counts a = countsOf(program, pressOf(program, strength, 0.2, coarse / 0.2), 48000);
    const Counts b = countsOf(program, pressOf(program, strength, 0.2, fine / 0.2), 48000);
    RC_ASSERT(a.press == b.press && a.release == b.release && a.bottoms == b.bottoms);
    RC_ASSERT(a.grains == b.grains);
  });
  holdsAlways("an event's time moves by less than two readings when the sensor's rate changes", [] {
    const HapticProgram& program = programOf(1);
    const double seconds = within(0.1, 0.4), strength = within(1, 1.3);
    const int coarse = 2 * count(20, 60), fine = 2 * count(100, 400);
    const auto jumpAt = [&](int readings) {
      RenderSettings settings;
      const auto summary = renderPress(program, pressOf(program, strength, seconds, readings / seconds),
                                       settings, [](const float*, std::size_t) { return true; });
      RC_ASSERT(summary.ok());
      for (const EngineEvent& e : summary->events)
        if (e.kind == EventKind::pressJump) return static_cast<double>(e.frame) / settings.sampleRate_Hz;
      RC_FAIL("no jump");
      return 0.0;
    };
    RC_ASSERT(std::abs(jumpAt(coarse) - jumpAt(fine)) <= 2 * seconds / coarse + 1.0 / 48000);
  });
  holdsAlways("tracker: a way in many steps crosses what it crosses in one", [] {
    const HapticProgram& program = anyProgram();
    StrokeTracker one, many;
    one.use(&program);
    many.use(&program);
    const double to = strongestForce_N(program) * within(0.05, 1.3);
    const auto sumOf = [](const Crossings& c) {
      std::uint64_t grains = 0, others = 0;
      for (std::size_t i = 0; i < c.count; ++i)
        (c.items[i].kind == CrossingKind::grain ? grains : others) += c.items[i].count;
      return std::pair{grains, others};
    };
    const auto whole = sumOf(one.updateForce(to));
    std::pair<std::uint64_t, std::uint64_t> parts{0, 0};
    const int steps = count(1, 200);
    for (int i = 1; i <= steps; ++i) {
      const auto part = sumOf(many.updateForce(i == steps ? to : to * i / steps));
      parts.first += part.first, parts.second += part.second;
    }
    RC_ASSERT(whole == parts);
    RC_ASSERT(alike(one.position().displacement_mm, many.position().displacement_mm, 1e-12, 4));
  });
  holdsAlways("tracker: there and back it is where it was", [] {
    const auto program = extremeProgram();
    RC_PRE(program != nullptr);
    StrokeTracker tracker;
    tracker.use(program.get());
    const double to = strongestForce_N(*program) * within(0, 1.3);
    tracker.updateForce(to);
    RC_ASSERT(std::isfinite(tracker.position().displacement_mm));
    tracker.updateForce(-1);
    const StateProgram& state = program->states[tracker.position().state];
    RC_ASSERT(tracker.position().displacement_mm >= state.low_mm &&
              tracker.position().displacement_mm <= state.end_mm);
  });
  holdsAlways("tracker: any finite readings leave it on its table", [] {
    const HapticProgram& program = anyProgram();
    StrokeTracker tracker;
    tracker.use(&program);
    for (int i = count(1, 30); i > 0; --i) {
      const double value = oneIn(3) ? anyFinite() : within(-1, 4);
      const Crossings& met = oneIn(2) ? tracker.updateForce(value) : tracker.updateDisplacement(value);
      double before = 0;
      for (std::size_t k = 0; k < met.count; ++k) {
        RC_ASSERT(met.items[k].fraction >= before && met.items[k].fraction <= 1);
        before = met.items[k].fraction;
      }
      const StateProgram& state = program.states[tracker.position().state];
      RC_ASSERT(tracker.position().displacement_mm >= state.low_mm - 1e-12 &&
                tracker.position().displacement_mm <= state.end_mm + 1e-12);
    }
  });
}

TEST_CASE("filters are stable and silent after silence at every rate", "[finite]") {
  holdsAlways("lowPass: -3 dB at its cutoff, poles inside", [] {
    const double rate = anyRate(), cutoff = magnitude(1, 0.44 * rate);
    const BiquadCoefficients c = lowPass(rate, cutoff, static_cast<unsigned>(count(1, 2)));
    RC_ASSERT(alike(magnitude(c, rate, cutoff), std::sqrt(0.5), 1e-6));
    RC_ASSERT(std::abs(c.a2) < 1 && std::abs(c.a1) < 1 + c.a2);
  });
  holdsAlways("highPass: -3 dB at its cutoff, nothing constant", [] {
    const double rate = anyRate(), cutoff = magnitude(1, 0.44 * rate);
    const BiquadCoefficients c = highPass(rate, cutoff);
    RC_ASSERT(alike(playback::magnitude(c, rate, cutoff), std::sqrt(0.5), 1e-6));
    RC_ASSERT(playback::magnitude(c, rate, 0) < 1e-9);
  });
  holdsAlways("peaking: its gain at its frequency", [] {
    const double rate = anyRate(), frequency = tests::magnitude(10, 0.44 * rate), gain = within(-24, 24);
    const BiquadCoefficients c = peaking(rate, frequency, tests::magnitude(0.1, 100), gain);
    RC_ASSERT(std::abs(20 * std::log10(playback::magnitude(c, rate, frequency)) - gain) < 1e-3);
    RC_ASSERT(std::abs(c.a2) < 1 && std::abs(c.a1) < 1 + c.a2);
  });
  holdsAlways("coefficients out of band are the identity", [] {
    const double rate = anyRate(), beyond = rate * within(0.46, 4);
    for (const BiquadCoefficients& c : {lowPass(rate, beyond, 2), peaking(rate, beyond, 1, 6)})
      RC_ASSERT(c.b0 == 1 && c.b1 == 0 && c.b2 == 0 && c.a1 == 0 && c.a2 == 0);
  });
  holdsAlways("Biquad: exactly silent after silence, no denormal", [] {
    Biquad filter;
    const double rate = anyRate();
    filter.setCoefficients(lowPass(rate, tests::magnitude(20, 0.4 * rate), 2));
    std::vector<double> samples{within(-1, 1) * tests::magnitude(1e-300, 1)};
    filter.process(samples.data(), 1);
    std::vector<double> silence(static_cast<std::size_t>(rate), 0.0);
    filter.process(silence.data(), silence.size());
    RC_ASSERT(filter.silent());
    for (const double y : silence) RC_ASSERT(y == 0 || std::abs(y) >= std::numeric_limits<double>::min());
  });
  holdsAlways("sineOfCycles: error below 1e-12", [] {
    const double phase = share();
    RC_ASSERT(std::abs(static_cast<double>(sineOfCycles(phase) -
                                           std::sin(2 * 3.14159265358979323846264338327950288L *
                                                    static_cast<long double>(phase)))) < 1e-12);
  });
}

TEST_CASE("the limiter holds its ceiling") {
  holdsAlways("any samples", [] {
    Limiter limiter;
    const double ceiling = within(0.01, 1);
    limiter.configure(ceiling, oneIn(2) ? anyDouble() : tests::magnitude(1, 1e5));
    std::vector<double> in;
    for (int i = count(1, 100); i > 0; --i) in.push_back(oneIn(2) ? anyDouble() : within(-2, 2));
    std::vector<float> out(in.size());
    limiter.process(in.data(), out.data(), in.size());
    for (const float y : out)
      RC_ASSERT(std::isfinite(y) && std::abs(static_cast<double>(y)) <= ceiling * (1 + 1e-7));
  });
  holdsAlways("below the ceiling bit for bit", [] {
    Limiter limiter;
    limiter.configure(1, 100);
    std::vector<double> in;
    for (int i = count(1, 100); i > 0; --i) in.push_back(within(-1, 1) * tests::magnitude(1e-300, 1));
    std::vector<float> out(in.size());
    limiter.process(in.data(), out.data(), in.size());
    for (std::size_t i = 0; i < in.size(); ++i) RC_ASSERT(out[i] == static_cast<float>(in[i]));
  });
}

TEST_CASE("voices follow their closed form", "[finite]") {
  holdsAlways("Voice: amplitude, length, and nothing after", [] {
    const double rate = anyRate();
    const Burst burst{within(1, 2000), within(0, 0.05), share(),
                      oneIn(2) ? Envelope::rising : Envelope::falling};
    Voice voice;
    voice.start(burst, rate);
    std::vector<double> bus(static_cast<std::size_t>(burst.duration_s * rate) + 100, 0.0);
    voice.addTo(bus.data(), bus.size());
    RC_ASSERT(!voice.active());
    for (std::size_t i = 0; i < bus.size(); ++i) {
      RC_ASSERT(std::abs(bus[i]) <= burst.amplitude * (1 + 1e-12));
      const double t = static_cast<double>(i) / rate;
      if (t >= burst.duration_s) {
        RC_ASSERT(bus[i] == 0 || t < burst.duration_s + 1 / rate);
        continue;
      }
      const double ramp = t / burst.duration_s;
      const double level = burst.amplitude * (burst.envelope == Envelope::falling ? 1 - ramp : ramp);
      RC_ASSERT(std::abs(bus[i] - level * std::sin(2 * pi * burst.frequency_Hz * t)) < 1e-9);
    }
  });
  holdsAlways("Voice: a stolen one is silent when its fade is over", [] {
    Voice voice;
    voice.start({200, 0.1, 1, Envelope::falling}, 48000);
    std::vector<double> bus(4000, 0.0);
    const auto played = static_cast<std::size_t>(count(1, 2000)),
               fade = static_cast<std::size_t>(count(1, 1000));
    voice.addTo(bus.data(), played);
    voice.fadeOut(static_cast<std::int64_t>(fade));
    std::fill(bus.begin(), bus.end(), 0.0);
    voice.addTo(bus.data(), bus.size());
    for (std::size_t i = fade; i < bus.size(); ++i) RC_ASSERT(bus[i] == 0);
  });
  holdsAlways("GrainVoice: within its amplitude, however grains follow", [] {
    GrainVoice voice;
    const double rate = anyRate();
    const Burst grain{within(1, 2000), within(0.001, 0.05), share(), Envelope::falling};
    for (int i = count(1, 12); i > 0; --i) {
      voice.start(grain, oneIn(2) ? GrainCarrier::running : GrainCarrier::retriggered, rate);
      std::vector<double> bus(static_cast<std::size_t>(count(1, 800)), 0.0);
      voice.addTo(bus.data(), bus.size());
      for (const double y : bus) RC_ASSERT(std::abs(y) <= grain.amplitude * (1 + 1e-12));
    }
  });
  holdsAlways("RainNoise: within full scale at every rate", [] {
    RainNoise rain(within(0, 0.3));
    rain.setSampleRate(anyRate());
    std::vector<float> out(2000);
    for (int i = 0; i < 5; ++i) {
      rain.render(out.data(), out.size());
      for (const float y : out) RC_ASSERT(std::isfinite(y) && std::abs(y) <= 1.0f);
    }
  });
}

TEST_CASE("readings of any kind are judged, none passes that is none") {
  holdsAlways("ForceConditioner: what it lets through is finite and within its limits", [] {
    ConditionerSettings settings;
    ForceConditioner conditioner(settings);
    double time = 0;
    for (int i = count(1, 200); i > 0; --i) {
      time += oneIn(20) ? anyDouble() : 0.0023;
      const double value = oneIn(4) ? anyDouble() : within(-0.1, 5);
      if (conditioner.judge(time, value) == ConditionerVerdict::reject) continue;
      RC_ASSERT(std::isfinite(conditioner.value()));
      RC_ASSERT(conditioner.value() >= settings.lowest && conditioner.value() <= settings.highest);
    }
    const ConditionerCounts& c = conditioner.counts();
    RC_ASSERT(c.accepted + c.rejected() <= 200u + c.wrongTimes);
  });
  holdsAlways("ForceSteadier: without noise every reading passes bit for bit", [] {
    ForceSteadier steadier;
    double time_s = 0;
    steadier.configure(0, 0);
    for (int i = count(1, 100); i > 0; --i) {
      const double reading = within(-1, 1) * tests::magnitude(1e-12, 1e6);
      RC_ASSERT(steadier.next(time_s += 0.001, reading) == reading);
    }
  });
  holdsAlways("NoiseEstimate: has the unit of its readings", [] {
    NoiseEstimate one, other;
    const double factor = std::ldexp(1.0, count(-200, 200));
    for (int i = 0; i < 300; ++i) {
      const double reading = within(-1, 1);
      one.add(reading);
      other.add(reading * factor);
    }
    RC_ASSERT(one.sd() > 0 && other.sd() == one.sd() * factor);
  });
  holdsAlways("SensorCalibration: finite for finite readings, or not a number", [] {
    SensorCalibration calibration;
    calibration.circuit = static_cast<SensorCircuit>(count(0, 2));
    calibration.coefficients = {within(-1, 1), within(0, 10), within(-1, 1), 0};
    calibration.coefficientCount = static_cast<std::size_t>(count(1, 4));
    const double force = calibration.force_N(within(-100, 1200));
    RC_ASSERT(std::isfinite(force) || calibration.circuit == SensorCircuit::divider);
  });
}

TEST_CASE("time does not wear out", "[finite]") {
  holdsAlways("StreamClock: to the sample after a day, a year, and beyond 2^53 samples", [] {
    const double rate = anyRate();
    StreamClock clock(rate);
    const auto start = static_cast<std::int64_t>(tests::magnitude(1, 0x1p55));
    const int block = count(16, 1024);
    const double begin_s = within(0, 1e5);
    for (int i = 0; i < 200; ++i) clock.onCallback(begin_s + i * block / rate, start + i * block, block);
    const double now_s = begin_s + 199.5 * block / rate;
    const double expected = static_cast<double>(start) + 199.5 * block;
    RC_ASSERT(std::abs(clock.frameAt(now_s) - expected) <=
              1e-5 * rate + 4 * (std::nextafter(expected, 1e300) - expected));
  });
  holdsAlways("StreamClock: 24 hours of callbacks do not drift", [] {
    const double rate = 48000;
    StreamClock clock(rate);
    const double drift = 1 + within(-1e-4, 1e-4);  // the device's clock against the computer's
    std::int64_t frame = 0;
    constexpr int callbacks = 2000;
    const auto block = static_cast<std::int64_t>(24 * 3600 * rate / callbacks / 1000) * 10;
    double time_s = 1e4;
    for (int i = 0; i < callbacks; ++i) {
      clock.onCallback(time_s, frame, block);
      RC_ASSERT(std::abs(clock.frameAt(time_s) - static_cast<double>(frame)) <= static_cast<double>(block));
      frame += block;
      time_s += static_cast<double>(block) / rate * drift;
    }
  });
}

TEST_CASE("a press of 200,000 readings is felt when one of 400 is") {
  const HapticProgram& program = programOf(1);
  const auto jumpsOf = [&](double rate_Hz) {
    const auto summary = renderPress(program, pressOf(program, 1.2, 0.2, rate_Hz), {},
                                     [](const float*, std::size_t) { return true; });
    REQUIRE(summary);
    std::vector<double> times_s;
    for (const EngineEvent& e : summary->events)
      if (e.kind != EventKind::grain) times_s.push_back(static_cast<double>(e.frame) / 48000);
    return times_s;
  };
  const std::vector<double> few = jumpsOf(2000), many = jumpsOf(1e6);
  REQUIRE(few.size() == many.size());
  REQUIRE(few.size() >= 2);
  for (std::size_t i = 0; i < few.size(); ++i) CHECK(many[i] == Approx(few[i]).margin(0.001));
}

TEST_CASE("24 simulated hours: the last press is the first press") {
  const HapticProgram& program = programOf(1);
  const PressTrace press = pressOf(program, 1.2, 0.2, 425);
  const double rate = 8000;
  const auto engine = std::make_unique<HapticEngine>(rate);
  engine->use(&program);
  const auto soundOf = [&](double begin_s) {
    ConditionerCounts counts;
    std::vector<EngineInput> inputs = conditionedInputs(press, program, rate, 0, counts);
    const auto begin = static_cast<std::int64_t>(begin_s * rate);
    std::vector<float> silence(8192), out(4000);
    while (engine->frame() < begin)
      engine->render(silence.data(),
                     static_cast<std::size_t>(std::min<std::int64_t>(8192, begin - engine->frame())));
    for (EngineInput input : inputs) {
      input.time_frames += static_cast<double>(begin);
      engine->push(input);
    }
    engine->render(out.data(), out.size());
    return out;
  };
  const std::vector<float> first = soundOf(1), last = soundOf(24 * 3600);
  CHECK(*std::max_element(first.begin(), first.end()) > 0.1f);
  CHECK(first == last);
}

TEST_CASE("messages with any time and value do no harm") {
  holdsAlways("LiveSession", [] {
    LiveSession session(anyRate());
    SessionCommand use;
    use.kind = CommandKind::program;
    use.program = &anyProgram();
    session.send(Lane::control, use);
    std::vector<float> out(256);
    double entry_s = 0;
    for (int i = count(1, 20); i > 0; --i) {
      SessionCommand command;
      command.kind =
          std::vector<CommandKind>{
              CommandKind::force, CommandKind::displacement, CommandKind::resync,
              CommandKind::burst, CommandKind::grain,        CommandKind::gain}[static_cast<std::size_t>(
              count(0, 5))];
      command.timeBase = static_cast<TimeBase>(count(0, 2));
      command.time = oneIn(2) ? anyDouble() : entry_s;
      command.value = oneIn(2) ? anyDouble() : within(-1, 4);
      command.burst = {oneIn(2) ? anyDouble() : 200, oneIn(2) ? anyDouble() : 0.01,
                       oneIn(2) ? anyDouble() : 0.5, Envelope::falling};
      session.send(static_cast<Lane>(count(0, 3)), command);
      session.process(out.data(), out.size(), entry_s += 0.005);
      for (const float y : out) RC_ASSERT(std::isfinite(y) && std::abs(y) <= 1.0f);
    }
  });
}
