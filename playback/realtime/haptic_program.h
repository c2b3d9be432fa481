// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A prepared button for the audio callback: fixed size, trivially copyable, independent of the sample rate,
// without allocation during playback. Built by playback/prepare, played by haptic_engine.h.

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace detent::playback {

/// Capacities of a program. If a button needs more, the summary of the preparation lists what was left out.
inline constexpr std::size_t maxStates = 2;
inline constexpr std::size_t maxTablePoints =
    1024;                                    ///< per stroke; the summary states the force error of the table
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
  double amplitude = 0;  ///< share of full scale, 0..1
  Envelope envelope = Envelope::falling;
  bool quietensSlope = false;  ///< while it sounds, grains have the level HapticProgram::slopeUnderJump
};

/// One vertex of a stroke's force table; linear between vertices, and two vertices at one displacement are a
/// vertical rise.
struct TablePoint {
  double displacement_mm = 0;
  double force_N = 0;
};

/// One jump of a stroke, in the direction travelled (release: from_mm > to_mm).
struct JumpEntry {
  double from_mm = 0, to_mm = 0;
  /// the jump is armed again once the position has come back to here, so that it cannot fire repeatedly
  /// at a tactile point
  double rearm_mm = 0;
  Burst burst;  ///< amplitude 0: the jump is counted but silent (mode)
};

/// Grains first..last (inclusive, none if last < first) of the grid k / grainsPerMm, k counted from
/// `start_mm`.
struct GrainRange {
  std::int64_t first = 0, last = -1;
  double level = 1;  ///< factor on the amplitude of its grains; a steeper slope is louder with Feel::clear
};

/// One stroke of one state.
struct StrokeTable {
  std::uint32_t pointCount = 0;
  std::uint32_t jumpCount = 0;
  std::uint32_t slopeCount = 0;
  std::array<TablePoint, maxTablePoints> points{};  ///< by increasing displacement, both strokes
  std::array<JumpEntry, maxJumps> jumps{};          ///< in the order travelled
  std::array<GrainRange, maxSlopes> slopes{};       ///< by increasing grain index, both strokes
  double slopeLevel = 1;                            ///< factor on the amplitude of its grains
};

struct StateProgram {
  double low_mm = 0, end_mm = 0;  ///< range of both strokes' tables
  /// displacement where the press stroke begins; a press without actuation returns to it
  double start_mm = 0;
  /// displacement where a release ends after an actuation: the latched position of a self-locking button,
  /// otherwise low_mm
  double rest_mm = 0;
  StrokeTable press, release;
  bool hasBottomOut = false;
  double bottomOut_mm = 0;       ///< a press that reaches this displacement plays the bottom-out
  double bottomOutRearm_mm = 0;  ///< the bottom-out is armed again once the position has come back to here
  double bottomOutLevel = 1;     ///< factor on its amplitude
  bool hasOperatingPoint = false;
  bool hasResetPoint = false;
  /// the contact closes when a press reaches this displacement, which is also the actuation of a
  /// self-locking button
  double operating_mm = 0;
  double reset_mm = 0;  ///< the contact opens when a release reaches this displacement
};

/// Position of the 150 Hz low-pass (docs/develop/decisions/0900).
enum class LowPassPlacement : std::uint8_t { slopeOnly, wholeChain, none };

/// Effect of a new grain on the sine of the previous one (grain_voice.h, docs/develop/decisions/0900).
enum class GrainCarrier : std::uint8_t {
  running,     ///< the sine continues; only the envelope restarts
  retriggered  ///< the sine restarts too: for comparison; fast strokes lose their vibration
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

/// Time at which an event between two sensor readings sounds (docs/develop/decisions/0901).
enum class EventPlacement : std::uint8_t {
  /// as soon as the reading that reveals it arrives: least mean delay, but jitter of sensor and buffer
  atOnce,
  timeStamped  ///< at its interpolated time plus a constant delay: slightly later, but without jitter
};

struct HapticProgram {
  std::array<char, maxProgramName> name{};  ///< zero-terminated, for displays
  std::uint32_t stateCount = 0;             ///< 1 momentary, 2 self-locking
  std::array<StateProgram, maxStates> states{};

  double grainsPerMm = 0;    ///< 0: no slope feedback
  double gridOrigin_mm = 0;  ///< grain k lies at gridOrigin_mm + k / grainsPerMm, for all states
  Burst grain;
  Burst bottomOut;

  /// Settings of the clear feel (docs/develop/decisions/0915); 0, 1 and 0 give that of the paper.
  double loudestDensity_per_s =
      0;  ///< > 0: grain rate at which a grain is loudest; its level depends on the rate (grain_density.h)
  double slopeUnderJump = 1;  ///< level of the slope while a jump sounds
  double longestBottomOutWait_s =
      0;  ///< a bottom-out begins when the jump before it has ended, but at most this much later

  GrainCarrier grainCarrier = GrainCarrier::running;
  LowPass lowPass;
  /// cutoff of the grains' high-pass, so that no constant signal reaches a transducer; 0: none
  double highPass_Hz = 20;
  std::uint32_t equalizerBandCount = 0;
  std::array<EqualizerBand, maxEqualizerBands> equalizer{};
  /// Response of the device, used only by felt_meter.h: its resonances, strongest first, and its level
  /// without them.
  std::uint32_t resonanceCount = 0;
  std::array<EqualizerBand, maxEqualizerBands> resonances{};
  double fullScale_dB = 0;  ///< felt level of a sine of full scale at 250 Hz, above threshold

  double limiterCeiling = 1;  ///< (0, 1]
  double limiterRelease_s = 0.05;

  double hysteresis_N = 0.02;   ///< force by which a stroke must turn back before it is reversed; >= 0
  double hysteresis_mm = 0.01;  ///< the same for displacement inputs
  double restForce_N = 0.005;   ///< at or below this the button is fully released; < hysteresis_N
  double sensorNoise_N = 0;  ///< SD of the sensor's readings on a still finger; 0: unknown (force_steadier.h)

  EventPlacement placement = EventPlacement::timeStamped;
  double interpolationDelay_s =
      1.0 / 425;  ///< delay in time-stamped mode: one sensor period, so that no event is late
  double longestInterval_s =
      0.02;  ///< after a sensor gap, events are spread over at most this time before a reading
  double burstSpacing_s = 0.005;  ///< a jump or bottom-out starts at least this much after the one before it
  double stealFade_s = 0.001;     ///< fade-out of a stolen voice
  double gain = 1;                ///< gain of the device profile, before the limiter
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
