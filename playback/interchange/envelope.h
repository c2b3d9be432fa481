// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stretch of a press as one oscillator: how strong and how high at each time. For formats that have one
// voice.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playback/interchange/played_wave.h"
#include "playback/interchange/press_plan.h"

namespace detent::playback {

/// Half of a press: what begins before the finger turns, or what begins after.
struct Stretch {
  std::int64_t from = 0, to = 0;  ///< samples
};
/// The press and the release; the release is empty where nothing is felt on the way up.
Stretch pressOf(const PressPlan& plan);
Stretch releaseOf(const PressPlan& plan);
/// The sample of the first burst that begins within, or `stretch.to`.
std::int64_t firstOnset(const PressPlan& plan, const Stretch& stretch);
/// The same; what is no jump or bottom-out and leaves one less than `room_s` behind it is passed over for its
/// moment.
std::int64_t firstOnsetWithRoom(const PressPlan& plan, const Stretch& stretch, double room_s);
/// The first on a grid of `grid_s` on which the first jump or bottom-out lies, where there is one: at most a
/// grid's width earlier.
std::int64_t firstOnsetOnGrid(const PressPlan& plan, const Stretch& stretch, double grid_s);

/// Level and frequency between two moments.
struct EnvelopeStep {
  std::int64_t from = 0, to = 0;  ///< samples
  double amplitude = 0;           ///< of the sine that carries the stretch's energy here, at most 1
  double frequency_Hz = 0;        ///< of what is strongest here
  EventKind strongest = EventKind::grain;
  bool onset = false;  ///< a jump or a bottom-out begins with it
};

/// Steps of at least `step_s`, except that each jump and bottom-out begins a new one (`onsets`: at least so
/// far apart, the later ones begin none). They follow each other without a gap and cover the stretch. At most
/// 1e6 steps.
std::vector<EnvelopeStep> stepsOf(const PressPlan& plan, const Stretch& stretch, double step_s,
                                  double onsetsApart_s);

/// The steps as a wave with straight slopes between their middles and a step at each onset; time 0 is sample
/// `zero`.
PlayedWave smoothed(const std::vector<EnvelopeStep>& steps, double sampleRate_Hz, std::int64_t zero);

/// Levels by the millisecond, for players that take a level and how long.
struct TimedLevels {
  struct Level {
    std::int64_t duration_ms = 1;
    int level = 0;  ///< 0..full
  };
  std::int64_t zero = 0;  ///< sample at which they begin
  int full = 255;
  std::vector<Level> levels;         ///< the last one is 0; empty where nothing is felt
  std::vector<std::int64_t> onsets;  ///< of jumps and bottom-outs, as played
};
/// Levels of a stretch, in steps of `step_ms` and never shorter than `least_ms`: each jump and bottom-out at
/// least that far behind the one before begins a level, at most half a millisecond off.
TimedLevels timedLevels(const PressPlan& plan, const Stretch& stretch, int step_ms, int least_ms, int full);
/// The levels as a motor at its own resonance plays them.
PlayedWave waveOf(const TimedLevels& levels, double sampleRate_Hz);

/// Distance in ms of every jump and bottom-out of the stretch from the nearest of `onsets` (samples), at
/// most.
double worstTimingError_ms(const PressPlan& plan, const Stretch& stretch,
                           const std::vector<std::int64_t>& onsets);
std::vector<std::int64_t> onsetsOf(const std::vector<EnvelopeStep>& steps);

/// Largest shift of the press's frequencies by a motor that plays at its own resonance.
double furthestFromResonance_Hz(const PressPlan& plan);

/// Grain positions that were played within.
std::size_t grainsWithin(const PressPlan& plan, const Stretch& stretch);

}  // namespace detent::playback
