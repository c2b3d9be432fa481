// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The only bridge between the audio callback and the rest: bounded queues of plain messages, one producer
// each. The callback owns the engine; other threads own everything that has to be allocated or freed.

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
  forget,              ///< readings that are not due yet never come: another trace takes their place
  burst,
  grain,
  program,
  gain,
  take  ///< samples of another program; none: what plays of them ends
};

/// One message to the callback. Plain value.
struct SessionCommand {
  CommandKind kind = CommandKind::force;
  TimeBase timeBase = TimeBase::now;
  double time = 0;
  double value = 0;                        ///< N, mm, or gain
  Burst burst;                             ///< for burst
  const HapticProgram* program = nullptr;  ///< for program; must live until it comes back as retired
  const std::vector<SpeedProgram>* speeds = nullptr;  ///< of that program; must live as long
  const SoundTake* take = nullptr;  ///< for take; must live until it comes back as takeEnded
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
  std::uint64_t staleCommands = 0;  ///< waited too long for a callback: not played, at most a new position
  EngineCounts counts;
};

enum class ReportKind : std::uint8_t { event, status, retired, takeEnded };

/// One message from the callback.
struct SessionReport {
  ReportKind kind = ReportKind::event;
  EngineEvent event;
  SessionStatus status;
  const HapticProgram* retired = nullptr;  ///< no longer read by the callback; may be freed
  const SoundTake* endedTake = nullptr;    ///< likewise
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

  /// These two belong to whoever opens and closes the stream, while no callback runs. The next stream runs at
  /// this rate: program, position, gain and counts stay; a trace or take that was playing is gone.
  void setSampleRate(double sampleRate_Hz);
  /// Takes the programs and gains that were sent while no stream ran and drops all other commands, so that
  /// the queue does not fill up.
  void takeWhileAway();
  /// Sets the sound that plays with each press, on a channel beside the vibration.
  void setPressSound(PressSound sound);

  /// The lane's producer thread. False: queue full, message not taken (never allocates, never blocks).
  bool send(Lane lane, const SessionCommand& command);

  /// Takes the next report, on the one consumer thread. False: none.
  bool receive(SessionReport& report);

  /// Callback thread: handles what arrived, renders `count` samples. `entry_s`: the callback's entry on the
  /// clock that time-stamped messages use.
  void process(float* out, std::size_t count, double entry_s);

  /// Callback thread, after process: adds what is heard of presses, if anything is, to `count` samples;
  /// `felt`: what process gave.
  bool pressSounds() const;
  void addPressSound(float* ears, const float* felt, std::size_t count);

  /// Callback thread, after process: what the block cost, and whether the device reported an xrun.
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
