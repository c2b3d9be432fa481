// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Renders a press without a device: the same engine as the live path, driven by a list of readings.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "model/result.h"
#include "playback/realtime/force_conditioner.h"
#include "playback/realtime/haptic_engine.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

/// One reading of a recorded or designed press.
struct PressReading {
  double time_s = 0;
  double value = 0;  ///< N or mm
};

/// A press over time. Its readings may have any errors; they are conditioned like those of a live sensor.
struct PressTrace {
  enum class Quantity { force_N, displacement_mm };
  Quantity quantity = Quantity::force_N;
  std::vector<PressReading> readings;
};

/// Reads `time_s,force_N` or `time_s,displacement_mm` as text (header required; LF or CRLF; blank lines and
/// lines starting with # are skipped; "nan" is allowed, because a sensor may send it). Failure names the
/// line; `name` for messages.
Result<PressTrace> parsePressTrace(const std::string& text, const std::string& name);

/// The readings after conditioning, with times in samples from `origin_s`; live playback of a trace uses them
/// too. A trace is linear between readings: if these are farther apart than the program's sensor period,
/// further ones are interpolated, so that every event gets its own time.
std::vector<EngineInput> conditionedInputs(const PressTrace& trace, const HapticProgram& program,
                                           double sampleRate_Hz, double origin_s, ConditionerCounts& counts);

/// Format of samples in a file.
enum class SampleFormat : std::uint8_t {
  standard,  ///< WAV: 32 bit float, FLAC: 24 bit
  bits16,
  bits24,
  float32  ///< WAV only
};

struct RenderSettings {
  SampleFormat format = SampleFormat::standard;  ///< of files
  double sampleRate_Hz = 48000;                  ///< 8000..192000
  std::size_t block = 4096;  ///< samples per engine call, 1..8192; does not change the result
  std::function<bool()>
      cancelled;        ///< called once per block; true: Failure::cancelled, no file is left behind
  double tail_s = 0.5;  ///< at most this much after the last reading; ends early when all is silent
};

/// Checks a rendering before anything is computed or written. Failure wrongUsage: settings outside their
/// ranges, a trace without readings, or one that begins more than a week after 0.
Result<Done> checkRendering(const PressTrace& trace, const RenderSettings& settings);

struct RenderSummary {
  double duration_s = 0;
  double computing_s = 0;
  float peak = 0;
  /// Strongest 10 ms, dB above threshold (felt_meter.h). Computed only when rendering to a file, because it
  /// costs a tenth of the time.
  double felt_dB = -std::numeric_limits<double>::infinity();
  EngineCounts counts;
  ConditionerCounts sensor;
  std::vector<EngineEvent> events;

  double timesRealTime() const { return computing_s > 0 ? duration_s / computing_s : 0; }
};

/// Receives rendered blocks; returns false to stop.
using SampleSink = std::function<bool(const float* samples, std::size_t count)>;

/// Renders the whole trace and passes it to `sink`. Time 0 of the sound is time 0 of the trace, or its first
/// reading if that is earlier. Failure: as checkRendering; unreadableInput if no reading of the trace is
/// valid.
Result<RenderSummary> renderPress(const HapticProgram& program, const PressTrace& trace,
                                  const RenderSettings& settings, const SampleSink& sink);

/// Renders into memory.
struct RenderedPress {
  std::vector<float> samples;
  RenderSummary summary;
};
Result<RenderedPress> renderPress(const HapticProgram& program, const PressTrace& trace,
                                  const RenderSettings& settings);

}  // namespace detent::playback
