// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A prepared button for the audio callback: fixed size, plainly copyable, independent of the sample rate,
// nothing to allocate or free while it plays. Built by playback/prepare, played by haptic_engine.h.

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace detent::playback {

/// Capacities of a program. Prepare says in its summary when a button needed more and what was left out.
inline constexpr std::size_t maxStates = 2;
inline constexpr std::size_t maxTablePoints =
    1024;                                    ///< per stroke; force error of the table is in the summary
inline constexpr std::size_t maxJumps = 32;  ///< per stroke
inline constexpr std::size_t maxSlopes = maxJumps + 1;
inline constexpr std::size_t maxEqualizerBands = 16;
inline constexpr std::size_t maxProgramName = 64;

enum class Envelope : std::uint8_t {
  falling,  ///< 1 - t/T, the paper's "inverted saw-tooth"
  rising    ///< t/T, the paper's bottom-out
};

/// amplitude * envelope(t) * sin(2*pi*frequency*t) for 0 <= t < duration.
struct Burst {
  double frequency_Hz = 0;
  double duration_s = 0;
  double amplitude = 0;  ///< of full scale, 0..1
  Envelope envelope = Envelope::falling;
  bool quietensSlope = false;  ///< while it sounds, grains are as quiet as HapticProgram::slopeUnderJump
};

/// One vertex of a stroke's force table; linear in between, two vertices at one displacement make a vertical
/// rise.
struct TablePoint {
  double displacement_mm = 0;
  double force_N = 0;
};

/// One jump of a stroke, in the direction travelled (release: from_mm > to_mm).
struct JumpEntry {
  double from_mm = 0, to_mm = 0;
  double rearm_mm =
      0;        ///< armed again once the position has come back to here; no machine-gun at a tactile point
  Burst burst;  ///< amplitude 0: the jump is counted but makes no sound (mode)
};

/// Grains first..last (inclusive, none if last < first) of the grid k / grainsPerMm, k counted from
/// `start_mm`.
struct GrainRange {
  std::int64_t first = 0, last = -1;
  double level = 1;  ///< on the amplitude of its grains; steeper is louder where Feel::clear says so
};

/// One stroke of one state.
struct StrokeTable {
  std::uint32_t pointCount = 0;
  std::uint32_t jumpCount = 0;
  std::uint32_t slopeCount = 0;
  std::array<TablePoint, maxTablePoints> points{};  ///< by increasing displacement, both strokes
  std::array<JumpEntry, maxJumps> jumps{};          ///< in the order travelled
  std::array<GrainRange, maxSlopes> slopes{};       ///< by increasing grain index, both strokes
  double slopeLevel = 1;                            ///< on the amplitude of its grains
};

struct StateProgram {
  double low_mm = 0, end_mm = 0;  ///< range of both strokes' tables
  double start_mm = 0;            ///< where the press stroke begins; an unactuated press returns to here
  double rest_mm =
      0;  ///< where a release ends after an actuation: where a self-locking button latches, else low_mm
  StrokeTable press, release;
  bool hasBottomOut = false;
  double bottomOut_mm = 0;       ///< felt when a press arrives here
  double bottomOutRearm_mm = 0;  ///< armed again once the position has come back to here
  double bottomOutLevel = 1;     ///< on its amplitude
  bool hasOperatingPoint = false;
  bool hasResetPoint = false;
  double operating_mm =
      0;  ///< contact closes when a press arrives here; also the actuation of a self-locking button
  double reset_mm = 0;  ///< contact opens when a release arrives here
};

/// Position of the 150 Hz low-pass (docs/develop/decisions/0900).
enum class LowPassPlacement : std::uint8_t { slopeOnly, wholeChain, none };

/// Effect of a grain on the sine of the one still sounding (grain_voice.h, docs/develop/decisions/0900).
enum class GrainCarrier : std::uint8_t {
  running,     ///< it runs on, only the envelope begins anew
  retriggered  ///< it begins anew too: for comparison; fast strokes lose their vibration
};

struct LowPass {
  LowPassPlacement placement = LowPassPlacement::slopeOnly;
  double cutoff_Hz = 150;
  std::uint32_t order = 2;  ///< 1 or 2 (Butterworth)
};

/// One peaking section of the device equalizer. Sections at or above 0.45 of the sample rate are left out.
struct EqualizerBand {
  double frequency_Hz = 0;
  double q = 1;
  double gain_dB = 0;
};

/// Time at which an event sounds that happened between two sensor samples (docs/develop/decisions/0901).
enum class EventPlacement : std::uint8_t {
  atOnce,      ///< as soon as the sample that shows it arrives: least mean delay, jitter of sensor and buffer
  timeStamped  ///< at its interpolated time plus a constant delay: a little later, but evenly
};

struct HapticProgram {
  std::array<char, maxProgramName> name{};  ///< zero-terminated, for displays
  std::uint32_t stateCount = 0;             ///< 1 momentary, 2 self-locking
  std::array<StateProgram, maxStates> states{};

  double grainsPerMm = 0;    ///< 0: no slope feedback
  double gridOrigin_mm = 0;  ///< grain k lies at gridOrigin_mm + k / grainsPerMm, for all states
  Burst grain;
  Burst bottomOut;

  /// Settings of the clear feel (docs/develop/decisions/0915); 0, 1 and 0: as in the paper.
  double loudestDensity_per_s =
      0;                      ///< > 0: a grain is as loud as so many in a second make it (grain_density.h)
  double slopeUnderJump = 1;  ///< level of the slope while a jump sounds
  double longestBottomOutWait_s =
      0;  ///< a bottom-out begins when the jump before it has ended, at most so much later

  GrainCarrier grainCarrier = GrainCarrier::running;
  LowPass lowPass;
  double highPass_Hz = 20;  ///< of the slope's grains; 0: none. Nothing constant reaches a transducer
  std::uint32_t equalizerBandCount = 0;
  std::array<EqualizerBand, maxEqualizerBands> equalizer{};
  /// Response of the device, for felt_meter.h alone: its resonances, strongest first, and the level beside
  /// them.
  std::uint32_t resonanceCount = 0;
  std::array<EqualizerBand, maxEqualizerBands> resonances{};
  double fullScale_dB = 0;  ///< of a sine of full scale at 250 Hz, above threshold

  double limiterCeiling = 1;  ///< (0, 1]
  double limiterRelease_s = 0.05;

  double hysteresis_N = 0.02;   ///< force must turn back this far before the stroke turns; >= 0
  double hysteresis_mm = 0.01;  ///< the same for displacement inputs
  double restForce_N = 0.005;   ///< at or below this the button is fully released; < hysteresis_N
  double sensorNoise_N =
      0;  ///< SD of the sensor's readings on a still finger, where known (force_steadier.h)

  EventPlacement placement = EventPlacement::timeStamped;
  double interpolationDelay_s =
      1.0 / 425;  ///< time-stamped mode: one sensor period, so that no event is late
  double longestInterval_s =
      0.02;  ///< events are never spread over more than this before a sample (sensor gaps)
  double burstSpacing_s = 0.005;  ///< a jump or bottom-out starts no sooner than this after the one before it
  double stealFade_s = 0.001;     ///< a stolen voice fades out over this
  double gain = 1;                ///< of the device profile, before the limiter
};

/// Strongest force of any press stroke; 0 for an empty program.
inline double strongestForce_N(const HapticProgram& program) {
  double strongest = 0;
  for (std::size_t s = 0; s < program.stateCount; ++s) {
    const StrokeTable& press = program.states[s].press;
    for (std::size_t i = 0; i < press.pointCount; ++i) {
      if (press.points[i].force_N > strongest) strongest = press.points[i].force_N;
    }
  }
  return strongest;
}

static_assert(std::is_trivially_copyable_v<HapticProgram>, "a program crosses threads by plain copy");
static_assert(sizeof(HapticProgram) < 128 * 1024, "a program stays small enough to copy between callbacks");

}  // namespace detent::playback
