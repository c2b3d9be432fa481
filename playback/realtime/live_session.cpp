// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/live_session.h"

#include <array>
#include <atomic>
#include <utility>

#include <readerwriterqueue/readerwriterqueue.h>

#include "playback/realtime/felt_meter.h"
#include "playback/realtime/stream_clock.h"

namespace detent::playback {

namespace {
constexpr std::size_t commandCapacity = 4096;
constexpr std::size_t reportCapacity = 8192;
constexpr double statusInterval_s = 0.02;
// A reading that waited this long for a callback is used as a new position without sound.
constexpr double stale_s = 0.2;

/// Returns true for a message that contains a position of the finger.
bool carriesPosition(CommandKind kind) {
  return kind == CommandKind::force || kind == CommandKind::displacement || kind == CommandKind::resync ||
         kind == CommandKind::resyncDisplacement;
}

/// The message that sets the same position without any sound.
CommandKind placing(CommandKind kind) {
  return kind == CommandKind::displacement || kind == CommandKind::resyncDisplacement
             ? CommandKind::resyncDisplacement
             : CommandKind::resync;
}

InputKind inputKindOf(CommandKind kind) {
  switch (kind) {
    case CommandKind::displacement:
      return InputKind::displacement;
    case CommandKind::resync:
      return InputKind::resync;
    case CommandKind::resyncDisplacement:
      return InputKind::resyncDisplacement;
    default:
      return InputKind::force;
  }
}
}  // namespace

/// Data shared by the callback and the other threads, and the callback's own state.
struct LiveSession::State {
  explicit State(double wanted_Hz)
      : engine(wanted_Hz), sampleRate_Hz(engine.sampleRate_Hz()), clock(engine.sampleRate_Hz()) {
    takes.setSampleRate(engine.sampleRate_Hz());
    pressSound.setSampleRate(engine.sampleRate_Hz());
  }

  HapticEngine engine;
  TakePlayer takes;
  float takePeak = 0;  // largest sample while a take played, since the last status
  FeltMeter felt;
  PressSounder pressSound;
  std::atomic<double> sampleRate_Hz;  // the engine's rate, for other threads
  StreamClock clock;
  double lastInput_frames = 0;
  double entry_s = 0;  // entry time of the running callback
  std::int64_t lastStatusFrame = 0;
  bool placeUnknown = false;  // the device was absent, so the finger's movement is unknown
  SessionStatus status;
  std::array<const HapticProgram*, 16> retired{};  // programs to be reported as retired
  std::size_t retiredCount = 0;
  std::array<moodycamel::ReaderWriterQueue<SessionCommand>, laneCount> lanes{
      moodycamel::ReaderWriterQueue<SessionCommand>(commandCapacity),
      moodycamel::ReaderWriterQueue<SessionCommand>(commandCapacity),
      moodycamel::ReaderWriterQueue<SessionCommand>(commandCapacity),
      moodycamel::ReaderWriterQueue<SessionCommand>(commandCapacity)};
  moodycamel::ReaderWriterQueue<SessionReport> reports{reportCapacity};
};

LiveSession::LiveSession(double sampleRate_Hz) : state_(std::make_unique<State>(sampleRate_Hz)) {}
LiveSession::~LiveSession() = default;

double LiveSession::sampleRate_Hz() const { return state_->sampleRate_Hz.load(std::memory_order_relaxed); }

void LiveSession::setSampleRate(double sampleRate_Hz) {
  State& s = *state_;
  takeWhileAway();
  s.engine.setSampleRate(sampleRate_Hz);
  s.takes.setSampleRate(s.engine.sampleRate_Hz());
  s.pressSound.setSampleRate(s.engine.sampleRate_Hz());
  s.sampleRate_Hz.store(s.engine.sampleRate_Hz(), std::memory_order_relaxed);
  s.clock = StreamClock(s.engine.sampleRate_Hz());
  if (s.engine.program() != nullptr) s.felt.use(*s.engine.program(), s.engine.sampleRate_Hz());
}

void LiveSession::takeWhileAway() {
  State& s = *state_;
  SessionCommand command;
  for (auto& lane : s.lanes) {
    while (lane.try_dequeue(command)) {
      if (command.kind == CommandKind::program || command.kind == CommandKind::gain ||
          command.kind == CommandKind::take) {
        handle(command, 0);
      } else {
        ++s.status.staleCommands;
      }
    }
  }
  s.placeUnknown = s.engine.frame() > 0;  // before the first stream nothing was missed
  s.takes.stop();
  publishRetired();
  publishEndedTakes();
}

bool LiveSession::send(Lane lane, const SessionCommand& command) {
  return state_->lanes[static_cast<std::size_t>(lane)].try_enqueue(command);
}

bool LiveSession::receive(SessionReport& report) { return state_->reports.try_dequeue(report); }

void LiveSession::process(float* out, std::size_t count, double entry_s) {
  State& s = *state_;
  s.entry_s = entry_s;
  s.clock.onCallback(entry_s, s.engine.frame(), static_cast<std::int64_t>(count));
  s.engine.setBufferDelay(static_cast<double>(count));
  s.status.blockFrames = static_cast<std::uint32_t>(count);
  SessionCommand command;
  for (auto& lane : s.lanes) {
    while (lane.try_dequeue(command)) handle(command, count);
  }
  s.engine.render(out, count);
  s.felt.add(out, count);
  const float peak = s.takes.addTo(out, count);
  if (peak > s.takePeak) s.takePeak = peak;
  if (s.engine.limiting()) ++s.status.limitedBlocks;
  publish();
}

double LiveSession::frameOf(const SessionCommand& command) const {
  const State& s = *state_;
  const auto now = static_cast<double>(s.engine.frame());
  switch (command.timeBase) {
    case TimeBase::now:
      return now;
    case TimeBase::clock: {
      // At the latest now, because the reading was taken before the callback.
      const double frame = s.clock.frameAt(command.time);
      return frame < now ? frame : now;
    }
    case TimeBase::streamFrames:
      break;
  }
  return command.time;
}

void LiveSession::handle(const SessionCommand& sent, std::size_t count) {
  State& s = *state_;
  SessionCommand command = sent;
  if (command.timeBase == TimeBase::clock && s.entry_s - command.time > stale_s) {
    ++s.status.staleCommands;
    if (!carriesPosition(command.kind)) return;
    command.kind = placing(command.kind);
  }
  // The first position after the device was absent: movements before it were not felt.
  if (s.placeUnknown && carriesPosition(command.kind)) {
    command.kind = placing(command.kind);
    s.placeUnknown = false;
  }
  HapticEngine& engine = s.engine;
  switch (command.kind) {
    case CommandKind::force:
    case CommandKind::displacement:
    case CommandKind::resync:
    case CommandKind::resyncDisplacement: {
      EngineInput input;
      input.kind = inputKindOf(command.kind);
      input.value = command.value;
      input.time_frames = frameOf(command);
      if (input.time_frames < s.lastInput_frames) input.time_frames = s.lastInput_frames;
      s.lastInput_frames = input.time_frames;
      engine.push(input);
      break;
    }
    case CommandKind::forget:
      engine.forgetInputs();
      s.lastInput_frames = static_cast<double>(engine.frame());
      break;
    case CommandKind::burst:
    case CommandKind::grain: {
      const bool stamped = engine.program() != nullptr &&
                           engine.program()->placement == EventPlacement::timeStamped &&
                           command.timeBase == TimeBase::clock;
      const double frame = command.timeBase == TimeBase::streamFrames ? command.time
                           : stamped ? s.clock.frameAt(command.time) + static_cast<double>(count)
                                     : static_cast<double>(engine.frame());
      if (command.kind == CommandKind::burst) {
        engine.trigger(frame, command.burst);
      } else {
        engine.triggerGrain(frame);
      }
      break;
    }
    case CommandKind::program: {
      const HapticProgram* old = engine.program();
      engine.use(command.program, command.speeds);
      if (command.program != nullptr) s.felt.use(*command.program, engine.sampleRate_Hz());
      if (old == nullptr) break;
      if (s.retiredCount == s.retired.size()) publishRetired();
      if (s.retiredCount < s.retired.size()) s.retired[s.retiredCount++] = old;
      break;
    }
    case CommandKind::gain:
      engine.setGain(command.value);
      s.takes.setGain(command.value > 0 ? command.value : 0);
      break;
    case CommandKind::take:
      s.takes.play(command.take);
      break;
  }
}

void LiveSession::setPressSound(PressSound sound) { state_->pressSound.use(std::move(sound)); }
bool LiveSession::pressSounds() const { return state_->pressSound.audible(); }
void LiveSession::addPressSound(float* ears, const float* felt, std::size_t count) {
  state_->pressSound.addTo(ears, felt, count, state_->engine.frame());
}

void LiveSession::account(double spent_s, std::size_t count, bool xrun) {
  SessionStatus& status = state_->status;
  const double share = count > 0 ? spent_s * sampleRate_Hz() / static_cast<double>(count) : 0;
  if (share > status.load) status.load = share;
  ++status.callbacks;
  status.meanLoad += (share - status.meanLoad) / static_cast<double>(status.callbacks);
  if (xrun) ++status.xruns;
}

void LiveSession::publishRetired() {
  State& s = *state_;
  SessionReport report;
  report.kind = ReportKind::retired;
  while (s.retiredCount > 0) {
    report.retired = s.retired[s.retiredCount - 1];
    // every program must be reported, so this is tried again with the next block
    if (!s.reports.try_enqueue(report)) return;
    --s.retiredCount;
  }
}

// Every take must be reported; reports that do not fit now follow with a later block.
void LiveSession::publishEndedTakes() {
  State& s = *state_;
  SessionReport report;
  report.kind = ReportKind::takeEnded;
  while (s.reports.size_approx() < reportCapacity && s.takes.nextEnded(report.endedTake)) {
    if (!s.reports.try_enqueue(report)) ++s.status.droppedReports;
  }
}

void LiveSession::publish() {
  State& s = *state_;
  publishRetired();
  publishEndedTakes();
  SessionReport report;
  report.kind = ReportKind::event;
  while (s.engine.nextEvent(report.event)) {
    s.pressSound.take(report.event);
    if (!s.reports.try_enqueue(report)) ++s.status.droppedReports;
  }
  s.pressSound.take(s.engine.program(), s.engine.position());
  const std::int64_t now = s.engine.frame();
  if (static_cast<double>(now - s.lastStatusFrame) < statusInterval_s * sampleRate_Hz()) return;
  s.lastStatusFrame = now;
  s.status.frame = now;
  s.status.position = s.engine.position();
  s.status.peak = s.engine.takePeak();
  if (s.takePeak > s.status.peak) s.status.peak = s.takePeak;
  s.takePeak = 0;
  s.status.felt_dB = s.felt.take_dB();
  s.status.counts = s.engine.counts();
  report.kind = ReportKind::status;
  report.status = s.status;
  if (!s.reports.try_enqueue(report)) ++s.status.droppedReports;
  s.status.load = 0;
}

}  // namespace detent::playback
