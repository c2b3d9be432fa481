// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A part of a press as one oscillator: amplitude and frequency over time. For formats with a single voice.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playback/interchange/played_wave.h"
#include "playback/interchange/press_plan.h"

namespace detent::playback {

/// Half of a press: the sounds that begin before the finger turns back, or those that begin after it.
struct Stretch {
  std::int64_t from = 0, to = 0;  ///< samples
};
/// The halves of a press. The release is empty if nothing is felt on the way up.
Stretch pressOf(const PressPlan& plan);
Stretch releaseOf(const PressPlan& plan);
/// First sample of the first burst of a half; `stretch.to` if there is none.
std::int64_t firstOnset(const PressPlan& plan, const Stretch& stretch);
/// As firstOnset, but skips a burst that begins less than `room_s` before a jump or bottom-out, unless it is
/// one itself.
std::int64_t firstOnsetWithRoom(const PressPlan& plan, const Stretch& stretch, double room_s);
/// As firstOnset, moved earlier by at most `grid_s`, so that the first jump or bottom-out, if there is one,
/// lies on a grid of that width.
std::int64_t firstOnsetOnGrid(const PressPlan& plan, const Stretch& stretch, double grid_s);

/// Level and frequency between two moments.
struct EnvelopeStep {
  std::int64_t from = 0, to = 0;  ///< samples
  double amplitude = 0;           ///< amplitude of the sine with the energy of this step, at most 1
  double frequency_Hz = 0;        ///< frequency of the strongest sound in it
  EventKind strongest = EventKind::grain;
  bool onset = false;  ///< the step begins with a jump or a bottom-out
};

/// Steps of at least `step_s`, except that each jump and bottom-out begins a new one (`onsets`: their least
/// distance; closer ones begin none). They cover the stretch without gaps. At most 1e6 steps.
std::vector<EnvelopeStep> stepsOf(const PressPlan& plan, const Stretch& stretch, double step_s,
                                  double onsetsApart_s);

/// The steps as a wave, linear between their middles and with a step at each onset; time 0 is sample `zero`.
PlayedWave smoothed(const std::vector<EnvelopeStep>& steps, double sampleRate_Hz, std::int64_t zero);

/// Levels in whole milliseconds, for players that take a level and a duration.
struct TimedLevels {
  struct Level {
    std::int64_t duration_ms = 1;
    int level = 0;  ///< 0..full
  };
  std::int64_t zero = 0;  ///< sample at which the steps begin
  int full = 255;
  std::vector<Level> levels;         ///< the last one is 0; empty if nothing is felt
  std::vector<std::int64_t> onsets;  ///< times of jumps and bottom-outs, as played
};
/// Levels of a stretch, in steps of `step_ms` and never shorter than `least_ms`. Each jump and bottom-out
/// that is at least that far behind the previous one begins a level, with an error of at most half a
/// millisecond.
TimedLevels timedLevels(const PressPlan& plan, const Stretch& stretch, int step_ms, int least_ms, int full);
/// The levels as a motor plays them at its own resonance.
PlayedWave waveOf(const TimedLevels& levels, double sampleRate_Hz);

/// Largest distance in ms of a jump or bottom-out of the stretch from the nearest of `onsets` (samples).
double worstTimingError_ms(const PressPlan& plan, const Stretch& stretch,
                           const std::vector<std::int64_t>& onsets);
std::vector<std::int64_t> onsetsOf(const std::vector<EnvelopeStep>& steps);

/// Largest shift of the press's frequencies by a motor that plays at its own resonance.
double furthestFromResonance_Hz(const PressPlan& plan);

/// Number of grain positions that are played in the stretch.
std::size_t grainsWithin(const PressPlan& plan, const Stretch& stretch);

}  // namespace detent::playback
