// SPDX-License-Identifier: GPL-3.0-or-later
// The product's engine as a WebAssembly module: what share_page.h puts into a page. Compiled for wasm32-wasi
// only (playback/page/CMakeLists.txt); page.js and worklet.js call what is exported here. One instance
// renders whole presses in the page's thread, another runs in the audio worklet; each has one thread.
//
// Nothing is allocated after detent_start: detent_process, detent_press, detent_lift, detent_steer,
// detent_use and detent_place touch only what is there. detent_allocations counts, so that a browser can
// tell.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "playback/offline/press_speed.h"
#include "playback/offline/standard_press.h"
#include "playback/page/button_numbers.h"
#include "playback/prepare/prepare_program.h"
#include "playback/prepare/prepare_speeds.h"
#include "playback/realtime/finger_profile.h"
#include "playback/realtime/force_conditioner.h"
#include "playback/realtime/haptic_engine.h"
#include "playback/realtime/press_counter.h"
#include "playback/realtime/press_sound.h"

namespace detent::playback {

namespace {

constexpr std::size_t mostFrames = 8192;  // in one call of detent_process
std::uint32_t allocations = 0;
constexpr double steadier_per_s = 60;  // smoothing of a dragged or measured force between its messages

/// State of the button that the page draws, as a row of numbers.
struct ShownState {
  double displacement_mm = 0, force_N = 0, releasing = 0, state = 0, contact = 0;
  double pressJumps = 0, releaseJumps = 0, bottomOuts = 0, peak = 0;
};

/// A button of the page. Its address is fixed once the engine has begun.
struct PageButton {
  Button button;
  PreparedProgram front;
  std::vector<SpeedProgram> speeds;  ///< filled by detent_start
  PlaybackSettings settings;
  std::unique_ptr<HapticProgram> locked;  ///< a study's stimulus that starts in its locked state
  bool stimulus = false;                  ///< played at the speed of its drawn graph, as in studies
};

constexpr std::size_t mostSlots = 65;  // stimuli of a trial: the choices and X
constexpr std::size_t noSlot = mostSlots;

/// Source that moves the finger.
enum class Hand : std::uint8_t { none, timed, steered };

class Page {
 public:
  double* numbers(std::size_t count) {
    numbers_.assign(count, 0);
    return numbers_.data();
  }

  int add(const PlaybackSettings& settings, bool stimulus) {
    Result<Button> button = buttonFrom(numbers_);
    if (!button) return -1;
    Result<PreparedProgram> prepared = prepareProgram(*button, {}, settings);
    if (!prepared) return -1;
    buttons_.push_back({*std::move(button), *std::move(prepared), {}, settings, {}, stimulus});
    PageButton& added = buttons_.back();
    if (stimulus && added.front.program.stateCount > 1) {
      added.locked = std::make_unique<HapticProgram>(added.front.program);
      std::swap(added.locked->states[0], added.locked->states[1]);
    }
    return static_cast<int>(buttons_.size()) - 1;
  }

  int renderStandard(std::size_t index, double sampleRate_Hz) {
    if (index >= buttons_.size()) return -1;
    const PageButton& b = buttons_[index];
    const PressTrace press = standardPress(b.front.program);
    Result<PressedButton> felt = asPressed(b.button, b.front, press, {}, b.settings);
    if (!felt) return -1;
    RenderSettings settings;
    settings.sampleRate_Hz = sampleRate_Hz;
    Result<RenderedPress> rendered = renderPress(felt->prepared.program, press, settings);
    if (!rendered) return -1;
    rendered_ = std::move(rendered->samples);
    return static_cast<int>(rendered_.size());
  }
  const float* rendered() const { return rendered_.data(); }

  int start(double sampleRate_Hz) {
    if (buttons_.empty()) return -1;
    for (PageButton& b : buttons_) {
      if (b.stimulus) continue;
      Result<std::vector<SpeedProgram>> speeds = prepareSpeeds(b.button, {}, b.settings);
      if (!speeds) return -1;
      b.speeds = *std::move(speeds);
    }
    engine_ = std::make_unique<HapticEngine>(sampleRate_Hz);
    block_.assign(mostFrames, 0);
    use(0);
    return 0;
  }

  void use(std::size_t index) {
    if (!engine_ || index >= buttons_.size()) return;
    exchange(buttons_[index].front.program, &buttons_[index].speeds);
  }

  /// Resets every stimulus of a trial to unlocked, X as well as the choice that is the same button.
  void beginTrial() {
    locked_.fill(false);
    slot_ = noSlot;
    presses_.use(nullptr);
    presses_.taken();
  }

  /// Puts a stimulus under a finger that starts above it. Each slot has its own lock state.
  void place(std::size_t slot, std::size_t index) {
    if (!engine_ || slot >= mostSlots || index >= buttons_.size()) return;
    if (slot == slot_) return;
    if (slot_ != noSlot && engine_->position().state == 1) locked_[slot_] = !locked_[slot_];
    const PageButton& b = buttons_[index];
    const HapticProgram& program = locked_[slot] && b.locked ? *b.locked : b.front.program;
    hand_ = Hand::none;
    force_N_ = 0;
    exchange(program, nullptr);
    presses_.use(&program);
    presses_.taken();
    slot_ = slot;
  }

  /// Presses since the last call: begun, whole, peak in N, travel in mm.
  const double* felt() {
    const PressCount count = presses_.taken();
    felt_ = {static_cast<double>(count.begun), static_cast<double>(count.whole), count.peak_N,
             count.travel_mm};
    return felt_.data();
  }

  /// Starts a press like a person's, which then holds.
  void press() { move(Hand::timed, true); }
  void lift() {
    if (hand_ == Hand::steered) steered_N_ = 0;
    move(Hand::timed, false);
  }

  /// Sets a force that a person controls: by dragging, a pen, or a sensor.
  void steer(double force_N) {
    if (!std::isfinite(force_N)) return;
    hand_ = Hand::steered;
    steered_N_ = force_N;
  }

  const float* process(std::size_t frames) {
    frames = std::min(frames, mostFrames);
    if (!engine_) return block_.data();
    feedUntil(static_cast<double>(engine_->frame()) + static_cast<double>(frames));
    engine_->render(block_.data(), frames);
    presses_.take(engine_->position());
    EngineEvent event;
    while (engine_->nextEvent(event)) sounder_.take(event);
    if (!sounder_.audible()) return block_.data();
    sounder_.take(engine_->program(), engine_->position());
    ears_.assign(frames, 0.0F);
    sounder_.addTo(ears_.data(), block_.data(), frames, engine_->frame());
    return block_.data();
  }

  /// For studies: adds the sound of presses.
  float* soundSamples(std::size_t count) {
    sound_.samples.assign(count, 0.0F);
    return sound_.samples.data();
  }
  void useSound(bool rendered, double sampleRate_Hz, double level_dB, double delay_s) {
    sound_.rendered = rendered;
    sound_.level_dB = level_dB;
    sound_.delay_s = delay_s;
    sound_.sampleRate_Hz = sampleRate_Hz;
    ears_.reserve(mostFrames);
    if (engine_) sounder_.setSampleRate(engine_->sampleRate_Hz());
    sounder_.use(sound_);
  }
  const float* heard() const { return ears_.data(); }

  const ShownState* shown() {
    if (!engine_) return &shown_;
    const StrokePosition& at = engine_->position();
    const EngineCounts& counts = engine_->counts();
    shown_ = {at.displacement_mm,
              at.force_N,
              at.releasing ? 1.0 : 0.0,
              static_cast<double>(at.state),
              at.contact ? 1.0 : 0.0,
              static_cast<double>(counts.pressJumps),
              static_cast<double>(counts.releaseJumps),
              static_cast<double>(counts.bottomOuts),
              static_cast<double>(engine_->takePeak())};
    return &shown_;
  }

 private:
  void exchange(const HapticProgram& program, const std::vector<SpeedProgram>* speeds) {
    engine_->use(&program, speeds);
    profile_.peak_N = standardPeak_N(program);
    conditioner_ = ForceConditioner(limitsFor(program));
  }

  void move(Hand hand, bool down) {
    hand_ = hand;
    down_ = down;
    from_N_ = force_N_;
    since_s_ = now_s();
  }

  double now_s() const {
    return engine_ ? static_cast<double>(engine_->frame()) / engine_->sampleRate_Hz() : 0;
  }

  double forceAt(double time_s) const {
    if (hand_ == Hand::none) return 0;
    if (hand_ == Hand::steered)
      return force_N_ + (steered_N_ - force_N_) * (1 - std::exp(-steadier_per_s / profile_.rate_Hz));
    const double t_s = std::max(0.0, time_s - since_s_);
    return down_ ? pressedForce(profile_, from_N_, t_s) : releasedForce(profile_, from_N_, t_s);
  }

  /// Feeds readings at the finger's own rate, with times on the time line of the samples.
  void feedUntil(double end_frames) {
    const double step_frames = engine_->sampleRate_Hz() / profile_.rate_Hz;
    for (; nextReading_frames_ < end_frames; nextReading_frames_ += step_frames) {
      const double time_s = nextReading_frames_ / engine_->sampleRate_Hz();
      force_N_ = forceAt(time_s);
      if (conditioner_.judge(time_s, force_N_) == ConditionerVerdict::reject) continue;
      engine_->push({InputKind::force, nextReading_frames_, conditioner_.value()});
    }
  }

  std::vector<double> numbers_;
  std::vector<PageButton> buttons_;
  std::vector<float> rendered_;
  std::unique_ptr<HapticEngine> engine_;
  std::vector<float> block_;
  FingerProfile profile_;
  ForceConditioner conditioner_;
  ShownState shown_;
  Hand hand_ = Hand::none;
  bool down_ = false;
  double from_N_ = 0, force_N_ = 0, steered_N_ = 0, since_s_ = 0, nextReading_frames_ = 0;
  PressCounter presses_;
  std::array<bool, mostSlots> locked_{};
  std::size_t slot_ = noSlot;
  std::array<double, 4> felt_{};
  PressSound sound_;
  PressSounder sounder_;
  std::vector<float> ears_;
};

Page& page() {
  static Page only;
  return only;
}

}  // namespace

}  // namespace detent::playback

void* operator new(std::size_t size) {
  ++detent::playback::allocations;
  void* const room = std::malloc(size > 0 ? size : 1);
  if (room == nullptr) __builtin_trap();  // out of memory: the page cannot continue
  return room;
}
void operator delete(void* room) noexcept { std::free(room); }
void operator delete(void* room, std::size_t) noexcept { std::free(room); }

#define DETENT_EXPORT(name) extern "C" __attribute__((export_name(#name), visibility("default")))

using detent::playback::page;

/// Room for `count` numbers of a button (button_numbers.h), to be filled before detent_add.
DETENT_EXPORT(detent_numbers) double* detent_numbers(std::uint32_t count) { return page().numbers(count); }
/// Adds the button in detent_numbers' room; returns its index, or -1 if it is invalid.
DETENT_EXPORT(detent_add) std::int32_t detent_add() {
  return page().add(detent::playback::usualSettings(), false);
}
/// The same for a study's stimulus: feel (1: clear), mode (FeedbackMode), and the settings that a threshold
/// study increases.
DETENT_EXPORT(detent_add_stimulus)
std::int32_t detent_add_stimulus(std::uint32_t feel, std::uint32_t mode, double grainAmplitude,
                                 double jumpAmplitudePerArea_per_mJ, double faintestJump) {
  detent::playback::PlaybackSettings settings;
  settings.feel = feel == 1 ? detent::playback::Feel::clear : detent::playback::Feel::paper;
  settings.mode = static_cast<detent::playback::FeedbackMode>(mode);
  settings.grainAmplitude = grainAmplitude;
  settings.jumpAmplitudePerArea_per_mJ = jumpAmplitudePerArea_per_mJ;
  settings.faintestJump = faintestJump;
  return page().add(settings, true);
}
/// Studies: starts a trial; puts one of its stimuli under the finger; returns its presses since the last
/// call.
DETENT_EXPORT(detent_begin_trial) void detent_begin_trial() { page().beginTrial(); }
DETENT_EXPORT(detent_place) void detent_place(std::uint32_t slot, std::uint32_t index) {
  page().place(slot, index);
}
/// Studies, after detent_start: room for a recording; then the sound of presses (press_sound.h).
/// detent_heard: samples in parallel to those of the last detent_process.
DETENT_EXPORT(detent_sound_samples) float* detent_sound_samples(std::uint32_t count) {
  return page().soundSamples(count);
}
DETENT_EXPORT(detent_sound)
void detent_sound(std::uint32_t rendered, double sampleRate_Hz, double level_dB, double delay_s) {
  page().useSound(rendered == 1, sampleRate_Hz, level_dB, delay_s);
}
DETENT_EXPORT(detent_heard) const float* detent_heard() { return page().heard(); }
DETENT_EXPORT(detent_felt) const double* detent_felt() { return page().felt(); }
/// Renders a standard press (`detent-play render --standard-press`); returns its number of samples, or -1.
/// detent_rendered returns the samples.
DETENT_EXPORT(detent_render) std::int32_t detent_render(std::uint32_t index, double sampleRate_Hz) {
  return page().renderStandard(index, sampleRate_Hz);
}
DETENT_EXPORT(detent_rendered) const float* detent_rendered() { return page().rendered(); }
/// Creates the engine for live playing; returns 0, or -1 without a button.
DETENT_EXPORT(detent_start) std::int32_t detent_start(double sampleRate_Hz) {
  return page().start(sampleRate_Hz);
}
DETENT_EXPORT(detent_use) void detent_use(std::uint32_t index) { page().use(index); }
DETENT_EXPORT(detent_press) void detent_press() { page().press(); }
DETENT_EXPORT(detent_lift) void detent_lift() { page().lift(); }
DETENT_EXPORT(detent_steer) void detent_steer(double force_N) { page().steer(force_N); }
/// The next `frames` samples, at most 8192.
DETENT_EXPORT(detent_process) const float* detent_process(std::uint32_t frames) {
  return page().process(frames);
}
/// Number of allocations since the module began.
DETENT_EXPORT(detent_allocations) std::uint32_t detent_allocations() { return detent::playback::allocations; }
/// Nine doubles: displacement mm, force N, releasing, state, contact, counts of press jumps, release jumps,
/// bottom-outs, peak.
DETENT_EXPORT(detent_shown) const double* detent_shown() {
  return reinterpret_cast<const double*>(page().shown());
}
