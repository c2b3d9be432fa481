// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The engine that runs in the audio callback: readings in, samples out. Its sound depends only on program,
// inputs and sample index: no clock, allocation, lock, file, exception or unseeded random number. Live
// playback and offline rendering use this same class.
//
// Reading order: haptic_program.h (what is played), stroke_tracker.h, speed_tracker.h (readings ->
// crossings), grain_voice.h, voice.h, biquad.h, sound_chain.h, limiter.h (crossings -> samples), this file
// (when), live_session.h (connection to other threads).

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "playback/realtime/haptic_program.h"
#include "playback/realtime/limiter.h"
#include "playback/realtime/sound_chain.h"
#include "playback/realtime/speed_tracker.h"

namespace detent::playback {

enum class InputKind : std::uint8_t {
  force,              ///< value in N
  displacement,       ///< value in mm
  resync,             ///< value in N: the sensor is back; move to this position without any sound
  resyncDisplacement  ///< value in mm: the same, for a finger that is tracked by its displacement
};

/// One conditioned reading on the engine's time line.
struct EngineInput {
  InputKind kind = InputKind::force;
  double time_frames = 0;  ///< time of the reading, in samples since the engine started; never decreasing
  double value = 0;
};

/// Subject of an EngineEvent.
enum class EventKind : std::uint8_t {
  grain,
  pressJump,
  releaseJump,
  bottomOut,
  contactClosed,
  contactOpened,
  trigger
};

/// The event for a display that corresponds to a crossing.
EventKind kindOf(CrossingKind kind);

/// One thing that was felt, for displays and logs.
struct EngineEvent {
  EventKind kind = EventKind::grain;
  std::uint8_t state = 0;
  std::uint16_t jump = 0;
  std::uint32_t count = 1;  ///< number of grains merged into this burst
  std::int64_t frame = 0;   ///< sample at which the burst sounds
  double displacement_mm = 0;
  double amplitude = 0;  ///< amplitude of its burst, before filters and gain; 0 if none sounds
};

/// Running totals; all since the engine started.
struct EngineCounts {
  std::uint64_t inputs = 0;
  std::uint64_t grains = 0;  ///< grain positions crossed and played (merged ones are counted singly)
  std::uint64_t pressJumps = 0, releaseJumps = 0, bottomOuts = 0, triggers = 0;
  std::uint64_t suppressed = 0;     ///< crossings while not armed (chatter)
  std::uint64_t crowded = 0;        ///< jumps left out because too many were waiting for their turn
  std::uint64_t late = 0;           ///< events whose time had already been rendered; played at once
  std::uint64_t droppedInputs = 0;  ///< input ring full (flooding); the next reading sets the position
  std::uint64_t hastened = 0;       ///< events played early because the event ring was full
  std::uint64_t stolenVoices = 0;
  std::uint64_t droppedEvents = 0;  ///< reports that were not taken in time
};

/// A large object of fixed size: construct it once, outside the callback, and do not move it.
class HapticEngine {
 public:
  static constexpr double lowestSampleRate_Hz = 8000;
  static constexpr double highestSampleRate_Hz = 192000;

  /// Rates outside the limits are set to the nearest limit.
  explicit HapticEngine(double sampleRate_Hz);
  HapticEngine(const HapticEngine&) = delete;
  HapticEngine& operator=(const HapticEngine&) = delete;

  double sampleRate_Hz() const { return sampleRate_Hz_; }
  /// Continues at another rate, within the same limits. Program, position, gain and counts are kept; sounding
  /// and waiting events are dropped. Only while no callback runs.
  void setSampleRate(double sampleRate_Hz);
  std::int64_t frame() const { return now_; }

  /// Plays another program from the next sample on; `program` must outlive its use (nullptr: silence).
  /// Sounding events end by their own program; a pressed finger is taken over without a sound. Callback
  /// thread, or before the stream starts.
  void use(const HapticProgram* program) { use(program, nullptr); }
  /// Sets a button with graphs at several speeds (live_program.h); `speeds` must also outlive its use.
  void use(const HapticProgram* program, const std::vector<SpeedProgram>* speeds);
  const HapticProgram* program() const { return program_; }

  /// Additional constant delay of time-stamped events, in samples: the buffer of live playback. Default 0.
  /// Callback thread.
  void setBufferDelay(double frames) { bufferDelay_frames_ = frames > 0 ? frames : 0; }

  /// Click-free change of the output gain (10 ms ramp), >= 0. Callback thread.
  void setGain(double gain);

  /// Takes a reading, which is applied at its own time, or at once if that has passed. Returns false if the
  /// ring is full, which is counted.
  bool push(const EngineInput& input);
  /// Drops all readings that are not due yet.
  void forgetInputs();

  /// Plays a burst that another program requested (signal messages). Calls may be in any order of time.
  void trigger(double time_frames, const Burst& burst);
  /// Plays one grain of the current program.
  void triggerGrain(double time_frames);

  /// Writes `count` samples, each within [-1, 1]. Any count; the result does not depend on how it is divided
  /// into calls.
  void render(float* out, std::size_t count);

  /// The next report, oldest first; returns false if there is none.
  bool nextEvent(EngineEvent& event);

  const EngineCounts& counts() const { return counts_; }
  const StrokePosition& position() const { return tracker_.position(); }
  /// Speed of the present or last press, of a button with several; 0: unknown.
  double speed_mm_per_s() const { return tracker_.speed_mm_per_s(); }
  /// Largest |sample| since the last call.
  float takePeak();
  /// Returns true while the limiter lowers the output.
  bool limiting() const { return !limiter_.idle(); }
  /// Returns true if nothing sounds and nothing is waiting.
  bool idle() const;

 private:
  struct Pending {
    std::int64_t frame;
    EngineEvent event;
    Burst burst;
  };
  static constexpr std::size_t inputCapacity = 4096;  // powers of two
  static constexpr std::size_t pendingCapacity = 4096;
  static constexpr std::size_t reportCapacity = 4096;
  static constexpr std::size_t chainCount = 3;
  static constexpr std::size_t span = 256;
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
  static constexpr double never_frames = -0x1p62;

  void applyDueInputs();
  void apply(const EngineInput& input);
  void schedule(const Crossings& crossings, double from_frames, double to_frames);
  void scheduleOne(const Crossing& crossing, double time_frames, double met_frames);
  Burst burstOf(const Crossing& crossing, double met_frames);
  Burst grainOf(const Crossing& crossing, double met_frames);
  bool waitForTurn(Pending& pending);
  void insert(const Pending& pending);
  void playDue();
  void play(const Pending& pending);
  void startBurst(const Burst& burst);
  double loudestWithin(double samples) const;
  void scanAhead();
  double peakWithin(std::size_t samples, double& first);
  void report(const EngineEvent& event);
  void renderSpan(float* out, std::size_t count);
  bool silent() const;
  void forgetWaiting();
  std::int64_t inputFrame(const EngineInput& input) const;

  double sampleRate_Hz_;
  const HapticProgram* program_ = nullptr;
  std::int64_t now_ = 0;
  double bufferDelay_frames_ = 0;

  SpeedTracker tracker_;
  bool hasLastInput_ = false;
  bool heldByDisplacement_ = false;  ///< the last reading was a displacement
  double held_mm_ = 0;               ///< position of the last input
  double lastInput_frames_ = 0;
  std::int64_t lastScheduled_ = 0;
  std::int64_t nextBurstFrame_ = 0;
  std::int64_t jumpEnds_ = 0;               ///< frame at which the last planned jump will have ended
  double lastGrain_frames_ = never_frames;  ///< time of the last grain

  std::array<EngineInput, inputCapacity> inputs_;
  std::size_t inputHead_ = 0, inputCount_ = 0;
  std::array<Pending, pendingCapacity> pending_;
  std::size_t pendingHead_ = 0, pendingCount_ = 0;
  std::array<EngineEvent, reportCapacity> reports_;
  std::size_t reportHead_ = 0, reportCount_ = 0;

  SoundChain& chain() { return chains_[current_]; }

  std::array<SoundChain, chainCount> chains_;  // the current program's, and those that are still ending
  std::size_t current_ = 0;
  double gain_ = 1, gainTarget_ = 1, gainStep_ = 0;
  Limiter limiter_;
  std::int64_t scanFrame_ = never;  // frame of the next report to the limiter
  std::array<SoundChain, chainCount> ahead_;
  float peak_ = 0;
  EngineCounts counts_;
  std::array<double, span> mix_, bus_;
};

}  // namespace detent::playback
