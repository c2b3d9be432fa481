// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/haptic_engine.h"

#include <cmath>

#include "playback/realtime/grain_density.h"
#include "playback/realtime/sine.h"

namespace detent::playback {

namespace {

constexpr double gainRamp_s = 0.01;
constexpr double scanAhead_s = 0.004;  // more than the half wave of a grain, 3.3 ms
// Fastest decrease of the output by the limiter, as share of full scale per second: that of a sine of 240 Hz,
// which is no click.
constexpr double steepestTurn_per_s = 1500;

// Longest queue of bursts that keep their distance. Only a tremor that no finger can make reaches it.
constexpr double longestQueue_s = 0.1;

// A time that is a whole sample except for rounding (0.01 s at 48 kHz) gives that sample.
constexpr double frameRounding = 1e-6;

// Converts NaN and times that no stream reaches to the ends of the time line: at once, or never.
std::int64_t wholeFrame(double time_frames) {
  constexpr double farthest_frames = 0x1p62;  // 0.8 million years at 192 kHz
  if (!(time_frames > -farthest_frames)) return -(std::int64_t{1} << 62);
  if (time_frames > farthest_frames) return std::int64_t{1} << 62;
  return static_cast<std::int64_t>(std::ceil(time_frames - frameRounding));
}

double withinLimits(double sampleRate_Hz) {
  if (!(sampleRate_Hz >= HapticEngine::lowestSampleRate_Hz)) return HapticEngine::lowestSampleRate_Hz;
  return sampleRate_Hz > HapticEngine::highestSampleRate_Hz ? HapticEngine::highestSampleRate_Hz
                                                            : sampleRate_Hz;
}

}  // namespace

EventKind kindOf(CrossingKind kind) {
  switch (kind) {
    case CrossingKind::grain:
      return EventKind::grain;
    case CrossingKind::pressJump:
      return EventKind::pressJump;
    case CrossingKind::releaseJump:
      return EventKind::releaseJump;
    case CrossingKind::bottomOut:
      return EventKind::bottomOut;
    case CrossingKind::contactClosed:
      return EventKind::contactClosed;
    case CrossingKind::contactOpened:
      break;
  }
  return EventKind::contactOpened;
}

HapticEngine::HapticEngine(double sampleRate_Hz) : sampleRate_Hz_(withinLimits(sampleRate_Hz)) {}

void HapticEngine::setSampleRate(double sampleRate_Hz) {
  sampleRate_Hz_ = withinLimits(sampleRate_Hz);
  inputHead_ = inputCount_ = 0;
  hasLastInput_ = false;
  forgetWaiting();
  for (SoundChain& c : chains_) c.stop();
  gain_ = gainTarget_;
  limiter_.reset();
  scanFrame_ = never;
  if (program_ == nullptr) return;
  chain().use(*program_, sampleRate_Hz_);
  limiter_.configure(program_->limiterCeiling, program_->limiterRelease_s * sampleRate_Hz_);
}

void HapticEngine::forgetWaiting() {
  pendingCount_ = 0;
  lastScheduled_ = now_;
  nextBurstFrame_ = jumpEnds_ = now_;
  lastGrain_frames_ = never_frames;
}

void HapticEngine::use(const HapticProgram* program, const std::vector<SpeedProgram>* speeds) {
  const StrokePosition held = tracker_.position();
  program_ = program;
  counts_.suppressed = tracker_.suppressed();
  tracker_.use(program, speeds);
  forgetWaiting();  // waiting events belong to the old program
  if (program == nullptr) return;
  // A finger with a known displacement is placed by it, because its force belongs to the previous button.
  if (heldByDisplacement_) {
    tracker_.placeAtDisplacement(held_mm_);
  } else {
    tracker_.placeAtForce(held.force_N);
  }
  if (!chain().silent()) current_ = (current_ + 1) % chainCount;
  chain().use(*program, sampleRate_Hz_);
  limiter_.configure(program->limiterCeiling, program->limiterRelease_s * sampleRate_Hz_);
  scanFrame_ = now_;
}

void HapticEngine::setGain(double gain) {
  gainTarget_ = gain > 0 ? gain : 0;
  gainStep_ = (gainTarget_ - gain_) / (gainRamp_s * sampleRate_Hz_);
  scanFrame_ = now_;
}

std::int64_t HapticEngine::inputFrame(const EngineInput& input) const {
  const std::int64_t frame = wholeFrame(input.time_frames);
  return frame > now_ ? frame : now_;
}

void HapticEngine::forgetInputs() { inputCount_ = 0; }

bool HapticEngine::push(const EngineInput& input) {
  if (inputCount_ == inputCapacity) {
    ++counts_.droppedInputs;
    return false;
  }
  inputs_[(inputHead_ + inputCount_++) % inputCapacity] = input;
  return true;
}

void HapticEngine::applyDueInputs() {
  while (inputCount_ > 0 && inputFrame(inputs_[inputHead_]) <= now_) {
    const EngineInput input = inputs_[inputHead_];
    inputHead_ = (inputHead_ + 1) % inputCapacity;
    --inputCount_;
    apply(input);
  }
}

void HapticEngine::apply(const EngineInput& input) {
  ++counts_.inputs;
  if (program_ == nullptr || !std::isfinite(input.value)) return;
  const double time = input.time_frames;
  heldByDisplacement_ = input.kind == InputKind::displacement || input.kind == InputKind::resyncDisplacement;
  if (heldByDisplacement_) held_mm_ = input.value;
  if (input.kind == InputKind::resync) {
    tracker_.placeAtForce(input.value);
  } else if (input.kind == InputKind::resyncDisplacement) {
    tracker_.placeAtDisplacement(input.value);
  } else {
    const double longest = program_->longestInterval_s * sampleRate_Hz_;
    double from = hasLastInput_ ? lastInput_frames_ : time - longest;
    if (from < time - longest) from = time - longest;
    if (from > time) from = time;
    const double time_s = time / sampleRate_Hz_;
    schedule(input.kind == InputKind::force ? tracker_.updateForce(input.value, time_s)
                                            : tracker_.updateDisplacement(input.value, time_s),
             from, time);
    counts_.suppressed = tracker_.suppressed();
  }
  hasLastInput_ = true;
  lastInput_frames_ = time;
}

void HapticEngine::schedule(const Crossings& crossings, double from_frames, double to_frames) {
  const bool atOnce = program_->placement == EventPlacement::atOnce;
  const double delay = bufferDelay_frames_ + program_->interpolationDelay_s * sampleRate_Hz_;
  for (std::size_t i = 0; i < crossings.count; ++i) {
    const Crossing& c = crossings.items[i];
    const double met_frames = from_frames + (to_frames - from_frames) * c.fraction;
    scheduleOne(c, atOnce ? static_cast<double>(now_) : met_frames + delay, met_frames);
  }
}

Burst HapticEngine::grainOf(const Crossing& crossing, double met_frames) {
  const StateProgram& state = tracker_.program()->states[crossing.state];
  Burst burst = program_->grain;
  burst.amplitude *= crossing.level;
  burst.amplitude *= tracker_.position().releasing ? state.release.slopeLevel : state.press.slopeLevel;
  if (program_->loudestDensity_per_s > 0) {
    const double gap_s = (met_frames - lastGrain_frames_) / sampleRate_Hz_;
    burst.amplitude *=
        levelOfDensity(crossing.count / gap_s, program_->loudestDensity_per_s, 1 / burst.duration_s);
  }
  lastGrain_frames_ = met_frames;
  return burst;
}

Burst HapticEngine::burstOf(const Crossing& crossing, double met_frames) {
  const StateProgram& state = tracker_.program()->states[crossing.state];
  switch (crossing.kind) {
    case CrossingKind::grain:
      return grainOf(crossing, met_frames);
    case CrossingKind::pressJump:
      return state.press.jumps[crossing.jump].burst;
    case CrossingKind::releaseJump:
      return state.release.jumps[crossing.jump].burst;
    case CrossingKind::bottomOut: {
      Burst burst = program_->bottomOut;
      burst.amplitude *= state.bottomOutLevel;
      return burst;
    }
    default:
      return {};
  }
}

// Delays a jump or bottom-out so that it keeps its distance. Returns false if too many wait already.
bool HapticEngine::waitForTurn(Pending& p) {
  const bool bottomOut = p.event.kind == EventKind::bottomOut;
  const double waits_frames = static_cast<double>(nextBurstFrame_ - p.frame);
  // The bottom-out always plays, because without it a press has no end.
  if (!bottomOut && waits_frames > longestQueue_s * sampleRate_Hz_) {
    ++counts_.crowded;
    return false;
  }
  if (bottomOut) {
    const std::int64_t latest = p.frame + wholeFrame(program_->longestBottomOutWait_s * sampleRate_Hz_);
    if (p.frame < jumpEnds_) p.frame = jumpEnds_ < latest ? jumpEnds_ : latest;
  }
  if (p.frame < nextBurstFrame_) p.frame = nextBurstFrame_;
  nextBurstFrame_ = p.frame + wholeFrame(program_->burstSpacing_s * sampleRate_Hz_);
  if (!bottomOut) jumpEnds_ = p.frame + wholeFrame(samplesIn(p.burst.duration_s, sampleRate_Hz_));
  return true;
}

void HapticEngine::scheduleOne(const Crossing& crossing, double time_frames, double met_frames) {
  Pending p;
  p.frame = wholeFrame(time_frames);
  if (p.frame < now_) {
    ++counts_.late;
    p.frame = now_;
  }
  // Events of one finger stay in the order travelled even if sensor times were uneven.
  if (p.frame < lastScheduled_) p.frame = lastScheduled_;
  lastScheduled_ = p.frame;
  p.event.kind = kindOf(crossing.kind);
  p.event.state = crossing.state;
  p.event.jump = crossing.jump;
  p.event.count = crossing.count;
  p.event.displacement_mm = crossing.displacement_mm;
  p.burst = burstOf(crossing, met_frames);
  if (p.event.kind != EventKind::grain && p.burst.amplitude > 0 && !waitForTurn(p)) return;
  insert(p);
}

void HapticEngine::trigger(double time_frames, const Burst& burst) {
  Pending p;
  p.frame = wholeFrame(time_frames);
  if (p.frame < now_) {
    if (program_ != nullptr && program_->placement == EventPlacement::timeStamped) ++counts_.late;
    p.frame = now_;
  }
  p.event.kind = EventKind::trigger;
  p.burst = burst;
  insert(p);
}

void HapticEngine::triggerGrain(double time_frames) {
  if (program_ == nullptr) return;
  Pending p;
  p.frame = wholeFrame(time_frames);
  if (p.frame < now_) p.frame = now_;
  p.event.kind = EventKind::grain;
  p.event.displacement_mm = tracker_.position().displacement_mm;
  p.burst = program_->grain;
  insert(p);
}

// Inserts by frame; equal frames keep the order of arrival. Nearly always appends.
void HapticEngine::insert(const Pending& pending) {
  if (pendingCount_ == pendingCapacity) {
    const Pending oldest = pending_[pendingHead_];
    pendingHead_ = (pendingHead_ + 1) % pendingCapacity;
    --pendingCount_;
    ++counts_.hastened;
    play(oldest);
  }
  std::size_t i = pendingCount_++;
  for (; i > 0; --i) {
    const Pending& before = pending_[(pendingHead_ + i - 1) % pendingCapacity];
    if (before.frame <= pending.frame) break;
    pending_[(pendingHead_ + i) % pendingCapacity] = before;
  }
  pending_[(pendingHead_ + i) % pendingCapacity] = pending;
}

void HapticEngine::playDue() {
  while (pendingCount_ > 0 && pending_[pendingHead_].frame <= now_) {
    const Pending due = pending_[pendingHead_];
    pendingHead_ = (pendingHead_ + 1) % pendingCapacity;
    --pendingCount_;
    play(due);
  }
}

void HapticEngine::play(const Pending& pending) {
  EngineEvent event = pending.event;
  event.frame = now_;
  event.amplitude = pending.burst.amplitude;
  switch (event.kind) {
    case EventKind::grain:
      counts_.grains += event.count;
      if (!chain().grainSounds() || pending.burst.amplitude > chain().grainLoudness()) scanFrame_ = now_;
      chain().startGrain(pending.burst);
      break;
    case EventKind::pressJump:
      ++counts_.pressJumps;
      startBurst(pending.burst);
      break;
    case EventKind::releaseJump:
      ++counts_.releaseJumps;
      startBurst(pending.burst);
      break;
    case EventKind::bottomOut:
      ++counts_.bottomOuts;
      startBurst(pending.burst);
      break;
    case EventKind::trigger:
      ++counts_.triggers;
      startBurst(pending.burst);
      break;
    case EventKind::contactClosed:
    case EventKind::contactOpened:
      break;
  }
  report(event);
}

void HapticEngine::startBurst(const Burst& burst) {
  scanFrame_ = now_;
  if (chain().startBurst(burst)) ++counts_.stolenVoices;
}

void HapticEngine::report(const EngineEvent& event) {
  if (reportCount_ == reportCapacity) {
    reportHead_ = (reportHead_ + 1) % reportCapacity;
    --reportCount_;
    ++counts_.droppedEvents;
  }
  reports_[(reportHead_ + reportCount_++) % reportCapacity] = event;
}

bool HapticEngine::nextEvent(EngineEvent& event) {
  if (reportCount_ == 0) return false;
  event = reports_[reportHead_];
  reportHead_ = (reportHead_ + 1) % reportCapacity;
  --reportCount_;
  return true;
}

float HapticEngine::takePeak() {
  const float peak = peak_;
  peak_ = 0;
  return peak;
}

bool HapticEngine::silent() const {
  if (!limiter_.idle() || gain_ != gainTarget_) return false;
  for (const SoundChain& c : chains_) {
    if (!c.silent()) return false;
  }
  return true;
}

bool HapticEngine::idle() const { return silent() && pendingCount_ == 0 && inputCount_ == 0; }

void HapticEngine::render(float* out, std::size_t count) {
  const std::int64_t end = now_ + static_cast<std::int64_t>(count);
  while (now_ < end) {
    applyDueInputs();
    playDue();
    if (now_ >= scanFrame_) scanAhead();
    std::int64_t until = scanFrame_ < end ? scanFrame_ : end;
    if (inputCount_ > 0 && inputFrame(inputs_[inputHead_]) < until) until = inputFrame(inputs_[inputHead_]);
    if (pendingCount_ > 0 && pending_[pendingHead_].frame < until) until = pending_[pendingHead_].frame;
    const auto n = static_cast<std::size_t>(until - now_);
    if (silent()) {
      for (std::size_t i = 0; i < n; ++i) out[i] = 0;
      now_ += static_cast<std::int64_t>(n);
      out += n;
      continue;
    }
    const std::size_t step = n < span ? n : span;
    renderSpan(out, step);
    now_ += static_cast<std::int64_t>(step);
    out += step;
  }
}

double HapticEngine::loudestWithin(double samples) const {
  double sum = 0;
  for (const SoundChain& c : chains_) sum += c.loudestWithin(samples);
  return sum * (gain_ > gainTarget_ ? gain_ : gainTarget_);
}

// Computes the sounding voices in advance, up to the next event, so that the limiter knows a peak before it
// arrives without delaying the sound.
void HapticEngine::scanAhead() {
  const double horizon = std::floor(scanAhead_s * sampleRate_Hz_);
  const bool everLoud = loudestWithin(highestSampleRate_Hz) > limiter_.ceiling();
  scanFrame_ = everLoud ? now_ + static_cast<std::int64_t>(horizon / 2) : never;
  if (!everLoud || !(loudestWithin(horizon) > limiter_.ceiling())) {
    limiter_.expect(1, 0);
    return;
  }
  double first = 0;
  const double peak = peakWithin(static_cast<std::size_t>(horizon), first);
  const double wanted = peak > limiter_.ceiling() ? limiter_.ceiling() / peak : 1;
  // The decrease may begin as soon as the present sound allows: after silence at once.
  const double step = first * std::fmax(0.0, limiter_.gain() - wanted);
  const double wait_s = std::fmin(step / steepestTurn_per_s, 1);  // also for an infinite level
  limiter_.expect(wanted, static_cast<std::size_t>(wait_s * sampleRate_Hz_));
}

// Peak of the next samples, computed with a copy of all that sounds. `first`: the level of the very next
// sample.
double HapticEngine::peakWithin(std::size_t samples, double& first) {
  const double gain = gain_ > gainTarget_ ? gain_ : gainTarget_;
  ahead_ = chains_;
  double peak = 0;
  for (std::size_t done = 0; done < samples;) {
    const std::size_t count = samples - done < span ? samples - done : span;
    for (std::size_t i = 0; i < count; ++i) mix_[i] = 0;
    for (SoundChain& c : ahead_) {
      if (!c.silent()) c.addTo(mix_.data(), bus_.data(), count);
    }
    if (done == 0) first = std::fabs(mix_[0]) * gain;
    for (std::size_t i = 0; i < count; ++i) peak = std::fmax(peak, std::fabs(mix_[i]) * gain);
    done += count;
  }
  return peak;
}

void HapticEngine::renderSpan(float* out, std::size_t count) {
  double* mix = mix_.data();
  for (std::size_t i = 0; i < count; ++i) mix[i] = 0;
  for (SoundChain& c : chains_) {
    if (!c.silent()) c.addTo(mix, bus_.data(), count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (gain_ != gainTarget_) {
      gain_ += gainStep_;
      if ((gainStep_ >= 0) == (gain_ >= gainTarget_)) gain_ = gainTarget_;
    }
    mix[i] *= gain_;
  }
  limiter_.process(mix, out, count);
  for (std::size_t i = 0; i < count; ++i) {
    const float level = out[i] < 0 ? -out[i] : out[i];
    if (level > peak_) peak_ = level;
  }
}

}  // namespace detent::playback
