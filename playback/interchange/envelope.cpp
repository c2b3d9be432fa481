// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "playback/interchange/player_conventions.h"

namespace detent::playback {

namespace {

bool isEvent(const PlannedBurst& burst) { return burst.kind != EventKind::grain; }

std::int64_t framesIn(double time_s, const PressPlan& plan) {
  return std::max<std::int64_t>(1, std::llround(time_s * plan.sampleRate_Hz));
}

/// Amplitude of a burst at a sample.
double levelAt(const PlannedBurst& planned, std::int64_t frame, double sampleRate_Hz) {
  const double share =
      static_cast<double>(frame - planned.frame) / (planned.burst.duration_s * sampleRate_Hz);
  if (share < 0 || share >= 1) return 0;
  return planned.burst.amplitude * (planned.burst.envelope == Envelope::falling ? 1 - share : share);
}

/// nullptr if nothing sounds.
const PlannedBurst* strongestAt(const PressPlan& plan, std::int64_t frame) {
  const PlannedBurst *grain = nullptr, *event = nullptr;
  double slope = 0, strongest = 0, slopeLevel = 1;
  for (const PlannedBurst& planned : plan.bursts) {
    if (planned.frame > frame) break;
    const double level = levelAt(planned, frame, plan.sampleRate_Hz);
    if (level > 0 && planned.burst.quietensSlope) slopeLevel = plan.slopeUnderJump;
    if (level <= (isEvent(planned) ? strongest : slope)) continue;
    (isEvent(planned) ? strongest : slope) = level;
    (isEvent(planned) ? event : grain) = &planned;
  }
  return slopeLevel * slope > strongest ? grain : event;
}

double amplitudeWithin(const PressPlan& plan, std::int64_t from, std::int64_t to) {
  double sum = 0;
  for (std::int64_t i = from; i < to && i < static_cast<std::int64_t>(plan.samples.size()); ++i) {
    const double sample = static_cast<double>(plan.samples[static_cast<std::size_t>(i)]);
    sum += sample * sample;
  }
  return std::fmin(1, std::numbers::sqrt2 * std::sqrt(sum / static_cast<double>(to - from)));
}

/// Forced starts of steps: the stretch's start, and all jumps and bottom-outs that are far enough apart.
std::vector<std::int64_t> hardStarts(const PressPlan& plan, const Stretch& stretch, std::int64_t apart) {
  std::vector<std::int64_t> starts{stretch.from};
  for (const PlannedBurst& planned : plan.bursts)
    if (isEvent(planned) && planned.frame < stretch.to && planned.frame - starts.back() >= apart)
      starts.push_back(planned.frame);
  return starts;
}

bool beginsEvent(const PressPlan& plan, std::int64_t frame) {
  return std::any_of(plan.bursts.begin(), plan.bursts.end(),
                     [&](const PlannedBurst& b) { return isEvent(b) && b.frame == frame; });
}

}  // namespace

Stretch pressOf(const PressPlan& plan) {
  return {0, std::min<std::int64_t>(plan.turn_frame, static_cast<std::int64_t>(plan.samples.size()))};
}

Stretch releaseOf(const PressPlan& plan) {
  return {pressOf(plan).to, static_cast<std::int64_t>(plan.samples.size())};
}

std::int64_t firstOnset(const PressPlan& plan, const Stretch& stretch) {
  for (const PlannedBurst& planned : plan.bursts)
    if (planned.frame >= stretch.from && planned.frame < stretch.to) return planned.frame;
  return stretch.to;
}

std::int64_t firstOnsetWithRoom(const PressPlan& plan, const Stretch& stretch, double room_s) {
  const std::int64_t first = firstOnset(plan, stretch);
  for (const PlannedBurst& planned : plan.bursts)
    if (isEvent(planned) && planned.frame >= first && planned.frame < stretch.to &&
        plan.time_s(planned.frame - first) < room_s)
      return planned.frame;
  return first;
}

std::int64_t firstOnsetOnGrid(const PressPlan& plan, const Stretch& stretch, double grid_s) {
  const std::int64_t first = firstOnset(plan, stretch);
  const double grid = grid_s * plan.sampleRate_Hz;
  for (const PlannedBurst& planned : plan.bursts) {
    if (!isEvent(planned) || planned.frame < first || planned.frame >= stretch.to) continue;
    const double before = std::ceil(static_cast<double>(planned.frame - first) / grid) * grid;
    return planned.frame - std::llround(before);
  }
  return first;
}

std::vector<EnvelopeStep> stepsOf(const PressPlan& plan, const Stretch& stretch, double step_s,
                                  double onsetsApart_s) {
  constexpr std::int64_t mostSteps = 1000000;
  const std::int64_t step = std::max(framesIn(step_s, plan), (stretch.to - stretch.from) / mostSteps + 1);
  std::vector<std::int64_t> starts = hardStarts(plan, stretch, framesIn(onsetsApart_s, plan));
  starts.push_back(stretch.to);
  std::vector<EnvelopeStep> steps;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    // The last step before an onset takes the remainder, so that no step is shorter than requested.
    const std::int64_t count = std::max<std::int64_t>(1, (starts[i + 1] - starts[i]) / step);
    for (std::int64_t k = 0; k < count && starts[i] < starts[i + 1]; ++k) {
      const std::int64_t from = starts[i] + k * step;
      const std::int64_t to = k + 1 == count ? starts[i + 1] : from + step;
      const PlannedBurst* strongest = strongestAt(plan, (from + to) / 2);
      steps.push_back({from, to, amplitudeWithin(plan, from, to),
                       strongest ? strongest->burst.frequency_Hz : 0,
                       strongest ? strongest->kind : EventKind::grain, k == 0 && beginsEvent(plan, from)});
    }
  }
  // In silence the frequency stays unchanged, so that there is no sweep before the next burst.
  double last_Hz = steps.empty() ? 0 : plan.bursts.front().burst.frequency_Hz;
  for (EnvelopeStep& s : steps) last_Hz = s.frequency_Hz = s.frequency_Hz > 0 ? s.frequency_Hz : last_Hz;
  return steps;
}

PlayedWave smoothed(const std::vector<EnvelopeStep>& steps, double sampleRate_Hz, std::int64_t zero) {
  PlayedWave wave;
  const auto time_s = [&](double frame) { return (frame - static_cast<double>(zero)) / sampleRate_Hz; };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const EnvelopeStep& here = steps[i];
    const double middle = static_cast<double>(here.from + here.to) / 2;
    const bool begins = i == 0 || here.onset || steps[i - 1].frequency_Hz != here.frequency_Hz;
    if (begins) {
      // After an onset the level is extrapolated backwards, because a falling burst is strongest at its
      // beginning.
      const bool falls = i + 1 < steps.size() && !steps[i + 1].onset;
      const double slope = falls ? (here.amplitude - steps[i + 1].amplitude) / 2 : 0;
      const double first = here.onset ? std::clamp(here.amplitude + slope, 0.0, 1.0) : here.amplitude;
      if (i > 0)
        wave.points.push_back(
            {time_s(static_cast<double>(here.from)), steps[i - 1].amplitude, steps[i - 1].frequency_Hz});
      wave.points.push_back({time_s(static_cast<double>(here.from)), first, here.frequency_Hz});
    }
    wave.points.push_back({time_s(middle), here.amplitude, here.frequency_Hz});
  }
  if (!steps.empty())
    wave.points.push_back({time_s(static_cast<double>(steps.back().to)), 0, steps.back().frequency_Hz});
  return wave;
}

TimedLevels timedLevels(const PressPlan& plan, const Stretch& stretch, int step_ms, int least_ms, int full) {
  TimedLevels result{firstOnsetWithRoom(plan, stretch, least_ms / 1000.0), full, {}, {}};
  if (result.zero >= stretch.to) return result;
  std::int64_t last_ms = 0;
  for (const EnvelopeStep& step :
       stepsOf(plan, {result.zero, stretch.to}, step_ms / 1000.0, least_ms / 1000.0)) {
    const std::int64_t end_ms =
        std::max<std::int64_t>(last_ms + least_ms, std::llround(1000 * plan.time_s(step.to - result.zero)));
    result.levels.push_back({end_ms - last_ms, static_cast<int>(std::lround(full * step.amplitude))});
    if (step.onset)
      result.onsets.push_back(result.zero +
                              std::llround(static_cast<double>(last_ms) * plan.sampleRate_Hz / 1000));
    last_ms = end_ms;
  }
  while (!result.levels.empty() && result.levels.back().level == 0) result.levels.pop_back();
  result.levels.push_back({least_ms, 0});
  return result;
}

PlayedWave waveOf(const TimedLevels& levels, double sampleRate_Hz) {
  PlayedWave wave;
  double time_s = static_cast<double>(levels.zero) / sampleRate_Hz;
  for (const TimedLevels::Level& level : levels.levels) {
    const double amplitude = static_cast<double>(level.level) / levels.full;
    wave.points.push_back({time_s, amplitude, assumedResonance_Hz});
    time_s += static_cast<double>(level.duration_ms) / 1000;
    wave.points.push_back({time_s, amplitude, assumedResonance_Hz});
  }
  return wave;
}

double worstTimingError_ms(const PressPlan& plan, const Stretch& stretch,
                           const std::vector<std::int64_t>& onsets) {
  double worst_s = 0;
  for (const PlannedBurst& planned : plan.bursts) {
    if (!isEvent(planned) || planned.frame < stretch.from || planned.frame >= stretch.to) continue;
    double nearest_s = std::numeric_limits<double>::infinity();
    for (const std::int64_t onset : onsets)
      nearest_s = std::fmin(nearest_s, std::fabs(plan.time_s(planned.frame - onset)));
    worst_s = std::fmax(worst_s, std::fmin(nearest_s, plan.duration_s()));
  }
  return 1000 * worst_s;
}

std::vector<std::int64_t> onsetsOf(const std::vector<EnvelopeStep>& steps) {
  std::vector<std::int64_t> onsets;
  for (const EnvelopeStep& step : steps)
    if (step.onset) onsets.push_back(step.from);
  return onsets;
}

double furthestFromResonance_Hz(const PressPlan& plan) {
  double furthest = 0;
  for (const PlannedBurst& planned : plan.bursts)
    furthest = std::fmax(furthest, std::fabs(planned.burst.frequency_Hz - assumedResonance_Hz));
  return furthest;
}

std::size_t grainsWithin(const PressPlan& plan, const Stretch& stretch) {
  std::size_t grains = 0;
  for (const PlannedBurst& planned : plan.bursts)
    if (planned.frame >= stretch.from && planned.frame < stretch.to) grains += planned.grains;
  return grains;
}

}  // namespace detent::playback
