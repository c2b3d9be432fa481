// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The only connection between the audio callback and other threads: bounded queues of plain messages, with
// one producer each. The callback owns the engine; other threads own everything that must be allocated or
// freed.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "playback/realtime/haptic_engine.h"
#include "playback/realtime/press_sound.h"
#include "playback/realtime/take_player.h"

namespace detent::playback {

/// Sender of a message. Each lane has exactly one producer thread at a time.
enum class Lane : std::uint8_t { control, sensor, network, trace };
inline constexpr std::size_t laneCount = 4;

enum class TimeBase : std::uint8_t {
  now,          ///< as soon as possible
  clock,        ///< seconds on the clock the callback is called with
  streamFrames  ///< samples since the stream started (recorded traces: the live sound equals the offline
                ///< render)
};

enum class CommandKind : std::uint8_t {
  force,
  displacement,
  resync,              ///< value in N
  resyncDisplacement,  ///< value in mm
  forget,              ///< drops readings that are not due yet, because another trace replaces them
  burst,
  grain,
  program,
  gain,
  take  ///< plays samples of another program; null: stops them
};

/// One message to the callback. Plain value.
struct SessionCommand {
  CommandKind kind = CommandKind::force;
  TimeBase timeBase = TimeBase::now;
  double time = 0;
  double value = 0;                        ///< N, mm, or gain
  Burst burst;                             ///< for burst
  const HapticProgram* program = nullptr;  ///< for program; must live until it is reported as retired
  const std::vector<SpeedProgram>* speeds = nullptr;  ///< speeds of that program; must live as long
  const SoundTake* take = nullptr;  ///< for take; must live until it is reported as takeEnded
};

/// Status of the stream; sent about 50 times a second.
struct SessionStatus {
  std::int64_t frame = 0;
  StrokePosition position;
  float peak = 0;  ///< largest |sample| since the status before
  double felt_dB = -std::numeric_limits<
      double>::infinity();  ///< strongest 10 ms since then, above threshold (felt_meter.h)
  double load = 0;          ///< largest share of a block's time spent in the callback since the status before
  double meanLoad = 0;
  std::uint32_t blockFrames = 0;
  std::uint64_t xruns = 0;
  std::uint64_t callbacks = 0;
  std::uint64_t droppedReports = 0;
  std::uint64_t limitedBlocks = 0;  ///< blocks in which the limiter turned the sound down
  std::uint64_t staleCommands = 0;  ///< waited too long for a callback; used at most as a new position
  EngineCounts counts;
};

enum class ReportKind : std::uint8_t { event, status, retired, takeEnded };

/// One message from the callback.
struct SessionReport {
  ReportKind kind = ReportKind::event;
  EngineEvent event;
  SessionStatus status;
  const HapticProgram* retired = nullptr;  ///< no longer read by the callback; may be freed
  const SoundTake* endedTake = nullptr;    ///< no longer read by the callback; may be freed
};

/// One stream's engine and its queues. Construct and destroy outside the callback.
class LiveSession {
 public:
  explicit LiveSession(double sampleRate_Hz);
  ~LiveSession();
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  /// Any thread.
  double sampleRate_Hz() const;

  /// Both functions are for the owner of the stream, while no callback runs. This one sets the rate of the
  /// next stream: program, position, gain and counts are kept; a trace or take that was playing is dropped.
  void setSampleRate(double sampleRate_Hz);
  /// Takes over programs and gains that were sent while no stream ran and drops all other commands, so that
  /// the queue does not fill up.
  void takeWhileAway();
  /// Sets the sound that plays with each press, on a channel beside the vibration.
  void setPressSound(PressSound sound);

  /// Called on the lane's producer thread. Returns false if the queue is full and the message was not taken
  /// (never allocates, never blocks).
  bool send(Lane lane, const SessionCommand& command);

  /// Takes the next report, on the single consumer thread. Returns false if there is none.
  bool receive(SessionReport& report);

  /// Callback thread: handles the messages, renders `count` samples. `entry_s`: time of the callback's entry
  /// on the clock of time-stamped messages.
  void process(float* out, std::size_t count, double entry_s);

  /// Callback thread, after process: adds the sound of presses, if there is any, to `count` samples; `felt`:
  /// the samples that process wrote.
  bool pressSounds() const;
  void addPressSound(float* ears, const float* felt, std::size_t count);

  /// Callback thread, after process: records the time the block took, and whether the device reported an
  /// xrun.
  void account(double spent_s, std::size_t count, bool xrun);

 private:
  struct State;
  void handle(const SessionCommand& command, std::size_t count);
  double frameOf(const SessionCommand& command) const;
  void publish();
  void publishRetired();
  void publishEndedTakes();

  std::unique_ptr<State> state_;
};

}  // namespace detent::playback
