// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Programs whose every number that belongs to nothing the button has is a signalling NaN: an operation on
// one, even a comparison, raises the processor's invalid flag. What is not read cannot be evaluated.

#include <cfenv>
#include <cstddef>
#include <initializer_list>
#include <limits>

#include "playback/realtime/force_program.h"
#include "playback/realtime/haptic_program.h"

namespace detent::test {

template <class Float>
void poison(std::initializer_list<Float*> numbers) {
  for (Float* number : numbers) *number = std::numeric_limits<Float>::signaling_NaN();
}

/// Returns true if `run` reads a poisoned number.
template <class Run>
bool meetsPoison(const Run& run) {
  std::feclearexcept(FE_INVALID);
  run();
  return std::fetestexcept(FE_INVALID) != 0;
}

inline void poison(playback::Burst& burst) {
  poison({&burst.frequency_Hz, &burst.duration_s, &burst.amplitude});
}

inline void poison(playback::JumpEntry& jump) {
  poison({&jump.from_mm, &jump.to_mm, &jump.rearm_mm});
  poison(jump.burst);
}

inline void poisonBeyond(playback::StrokeTable& table) {
  for (std::size_t i = table.pointCount; i < playback::maxTablePoints; ++i)
    poison({&table.points[i].displacement_mm, &table.points[i].force_N});
  for (std::size_t i = table.jumpCount; i < playback::maxJumps; ++i) poison(table.jumps[i]);
}

/// The same program, poisoned wherever the button has nothing.
inline playback::HapticProgram poisoned(playback::HapticProgram program) {
  bool bottomsOut = false;
  for (std::size_t i = 0; i < playback::maxStates; ++i) {
    playback::StateProgram& s = program.states[i];
    poisonBeyond(s.press);
    poisonBeyond(s.release);
    if (!s.hasBottomOut) poison({&s.bottomOut_mm, &s.bottomOutRearm_mm});
    if (!s.hasOperatingPoint) poison({&s.operating_mm});
    if (!s.hasResetPoint) poison({&s.reset_mm});
    if (i >= program.stateCount) poison({&s.low_mm, &s.end_mm, &s.start_mm, &s.rest_mm});
    bottomsOut = bottomsOut || s.hasBottomOut;
  }
  if (!bottomsOut) poison(program.bottomOut);
  if (!(program.grainsPerMm > 0)) poison(program.grain);
  for (std::size_t i = program.equalizerBandCount; i < playback::maxEqualizerBands; ++i)
    poison({&program.equalizer[i].frequency_Hz, &program.equalizer[i].q, &program.equalizer[i].gain_dB});
  return program;
}

inline void poisonAbsent(playback::ForceStateTable& table, bool locks) {
  for (std::size_t i = 0; i < playback::maxForceRows; ++i) {
    playback::ForceRow& row = table.rows[i];
    if (i >= table.rowCount) poison({&row.press_N, &row.release_N, &row.stored_mJ});
    if (i >= table.rowCount || !table.damped) poison({&row.damping_Ns_per_mm});
    if (i >= table.rowCount || !locks) poison({&row.pending_N, &row.pendingStored_mJ});
    // With one curve for both directions, the release only serves as the origin of the energy beyond the
    // end.
    if (!table.hysteresis && i + 1 != table.rowCount) poison({&row.release_N});
  }
  if (!locks) poison({&table.rest_mm, &table.operating_mm});
}

inline playback::ForceProgram poisoned(playback::ForceProgram program) {
  for (std::size_t i = 0; i < playback::maxForceStates; ++i) {
    poisonAbsent(program.states[i], program.stateCount > 1);
    if (i >= program.stateCount) poison({&program.states[i].first_mm, &program.states[i].spacing_mm});
  }
  if (program.stateCount < 2) poison({&program.law.settle_mm, &program.law.catchDamping_Ns_per_mm});
  if (!program.guide.present)
    poison({&program.guide.stiffness_N_per_mm, &program.guide.damping_Ns_per_mm, &program.guide.force_N});
  return program;
}

}  // namespace detent::test
