// SPDX-License-Identifier: GPL-3.0-or-later
// A press through the live engine, reading by reading as a sensor gives them, for live_speed_test.py:
//   live_speed_probe BUTTON PRESS.csv SAMPLES.f32   (time_s,force_N or time_s,displacement_mm)
// prints what was felt, `felt,time_s,kind,displacement_mm,amplitude,count`, and after each reading
// `at,time_s,displacement_mm`.
#include <cstdio>
#include <fstream>
#include <memory>

#include "model/file/button_file.h"
#include "playback/offline/press_files.h"
#include "playback/prepare/prepare_speeds.h"
#include "playback/realtime/force_conditioner.h"
#include "playback/realtime/haptic_engine.h"

using namespace detent;
using namespace detent::playback;

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const Result<Button> button = readButtonFile(arguments[1]);
  const Result<PressTrace> trace = readPressTrace(arguments[2]);
  if (!button || !trace) return 3;
  const PlaybackSettings settings = usualSettings();
  const Result<PreparedProgram> front = prepareProgram(*button, {}, settings);
  if (!front) return 3;
  const Result<LiveProgram> live = prepareLive(*front, *button, {}, settings);
  if (!live) return 3;
  constexpr double rate_Hz = 48000;
  constexpr std::size_t block = 64;
  const auto engine = std::make_unique<HapticEngine>(rate_Hz);
  engine->use(&live->program, &live->speeds);
  const bool force = trace->quantity == PressTrace::Quantity::force_N;
  ForceConditioner conditioner(limitsFor(live->program));
  std::ofstream samples(arguments[3], std::ios::binary);
  float out[block];
  std::size_t next = 0;
  const double end_s = trace->readings.back().time_s + 0.3;
  while (static_cast<double>(engine->frame()) < end_s * rate_Hz) {
    const double until_s = static_cast<double>(engine->frame() + static_cast<std::int64_t>(block)) / rate_Hz;
    const std::size_t from = next;
    for (; next < trace->readings.size() && trace->readings[next].time_s < until_s; ++next) {
      const PressReading& r = trace->readings[next];
      double value = r.value;
      if (force) {
        if (conditioner.judge(r.time_s, value) == ConditionerVerdict::reject) continue;
        value = conditioner.value();
      }
      engine->push({force ? InputKind::force : InputKind::displacement, r.time_s * rate_Hz, value});
    }
    engine->render(out, block);
    if (next > from)
      std::printf("at,%.9f,%.9f\n", trace->readings[next - 1].time_s, engine->position().displacement_mm);
    samples.write(reinterpret_cast<const char*>(out), sizeof out);
    EngineEvent e;
    while (engine->nextEvent(e))
      std::printf("felt,%.9f,%d,%.9f,%.9f,%u\n", static_cast<double>(e.frame) / rate_Hz,
                  static_cast<int>(e.kind), e.displacement_mm, e.amplitude, e.count);
  }
  return 0;
}
