// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every rule of the paper as a named setting; the defaults are the paper's where it gives a number. "K&L" is
// Kim & Lee, "Haptic Feedback Design for a Virtual Button Along Force-Displacement Curves", UIST 2013; the
// section follows.

#include "model/named_values.h"
#include "model/sections.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

/// Parts of the feedback. K&L, Conclusion: "A shortcoming of the current study is the lack of comparison with
/// a base case, e.g., the case of click-only feedback."
enum class FeedbackMode {
  full,       ///< slopes, jumps, bottom-out
  clickOnly,  ///< jumps and bottom-out
  slopeOnly,  ///< grains only
  off         ///< nothing sounds; the position is still followed
};

inline constexpr auto feedbackModes = named<FeedbackMode>({{"full", FeedbackMode::full},
                                                           {"click-only", FeedbackMode::clickOnly},
                                                           {"slope-only", FeedbackMode::slopeOnly},
                                                           {"off", FeedbackMode::off}});
inline const char* nameOf(FeedbackMode mode) { return feedbackModes.word(mode); }

inline constexpr auto eventPlacements =
    named<EventPlacement>({{"fast", EventPlacement::atOnce}, {"time-stamped", EventPlacement::timeStamped}});

/// Frequencies that the profile's equalizer may flatten.
enum class EqualizerUse {
  off,
  sparingJumps,  ///< every band but those that change the jumps' own frequencies
  full
};

/// Source of the jumps' frequency.
enum class JumpFrequencySource {
  paper,   ///< pressJumpFrequency_Hz and releaseJumpFrequency_Hz
  profile  ///< the profile's resonance nearest to pressJumpFrequency_Hz; release in the same ratio as the two
           ///< settings
};

/// Relative levels of slope, jumps and bottom-out.
enum class Feel {
  paper,  ///< levels of K&L's paper
  clear   ///< the jumps stand out, and a denser slope feels stronger (docs/develop/decisions/0915)
};

inline constexpr auto feels = named<Feel>({{"paper", Feel::paper}, {"clear", Feel::clear}});

/// The rules of Feel::clear; docs/develop/decisions/0915 has the effect of each.
struct ClearFeel {
  /// amplitude by the square root of the paper's: twice the area is 3 dB more, and few jumps reach full scale
  bool jumpsByRoot = true;
  /// Distance in dB by felt_level.h that the slope stays below the weakest jump of its stroke, and the
  /// bottom-out below the jump before it; neither is raised. > 0.
  double jumpAbove_dB = 8;
  double slopeUnderJump = 0.1;  ///< level of the slope while a jump sounds; [0, 1]
  /// the bottom-out begins when the jump before it has ended, at most this much later; tactile feedback
  /// may be so late (TAP 2014)
  double longestBottomOutWait_s = 0.05;
  /// grain rate at which a grain has its full amplitude; slower grains are quieter, by 1.9 dB per halving
  double loudestSpeed_mm_per_s = 200;
  double plainSlope_N_per_mm = 0.32;  ///< slope whose grains have their plain amplitude; > 0
  /// A slope twice as steep is louder by 6.02 dB times this, up to full scale; [0, 2]
  double levelBySteepness = 0.6875;
};

struct PlaybackSettings {
  FeedbackMode mode = FeedbackMode::full;

  // Slope. K&L, "Slope Feedback Generation".
  double grainsPerMm =
      20;  ///< "distributed ... evenly along the displacement range (20 grains/mm)"; [0, 1000]
  double grainFrequency_Hz =
      150;  ///< "a 150Hz sinusoidal wave with an inverted saw-tooth envelope"; (0, 2000]
  double grainDuration_s =
      0.020;  ///< not given by K&L. 3 cycles: PseudoBend (UIST 2019) uses 3, HapticButton 5; (0, 1]
  double grainAmplitude = 0.5;  ///< not given by K&L, who state only that jumps are clearly stronger; [0, 1]
  GrainCarrier grainCarrier = GrainCarrier::running;  ///< docs/develop/decisions/0900
  /// cutoff of the grains' high-pass, so that no constant signal reaches a transducer; 0: none; [0, 100]
  double highPass_Hz = 20;
  LowPassPlacement lowPassPlacement = LowPassPlacement::slopeOnly;  ///< docs/develop/decisions/0900
  double lowPassCutoff_Hz = 150;  ///< "a low-pass filter with cutoff frequency of 150Hz"; (0, 20000]
  unsigned lowPassOrder = 2;      ///< not given by K&L; 1 or 2 (docs/develop/decisions/0900)

  // Jump. K&L, "Jump Feedback Generation".
  double jumpDurationPerTravel_s_per_mm =
      0.020;  ///< "duration ... proportional to the change of displacement"; > 0
  /// 2 cycles of 390 Hz: a shorter burst has no pitch and is hardly felt; > 0
  double shortestJump_s = 0.005;
  double longestJump_s = 0.150;  ///< >= shortestJump_s, <= 1
  double jumpAmplitudePerArea_per_mJ =
      2.5;                    ///< "amplitude ... proportional to the area"; full scale at 0.4 mJ; > 0
  double faintestJump = 0.1;  ///< so that every tactile point is felt; [0, 1]
  JumpFrequencySource jumpFrequencySource = JumpFrequencySource::paper;
  double pressJumpFrequency_Hz = 390;  ///< "the resonant frequency of the device, which is 390Hz"; (0, 2000]
  double releaseJumpFrequency_Hz = 410;  ///< "a slightly higher frequency (410Hz)"; (0, 2000]

  // Bottom-out. K&L, "Bottom-out Feedback Generation".
  double bottomOutFrequency_Hz = 200;  ///< "a 200Hz sinusoidal burst"; [1, 2000]
  double bottomOutDuration_s =
      0.030;  ///< "with an increasing 30ms saw-tooth envelope"; rounded to half cycles; (0, 1]
  double bottomOutAmplitude = 0.7;  ///< not given by K&L; [0, 1]

  Feel feel = Feel::paper;
  ClearFeel clear;  ///< used only by Feel::clear

  // Following the finger.
  SectionSettings sections;  ///< decides which extrema are tactile points (model/sections.h)
  /// force by which the stroke turns back; 0: from the sensor's noise (docs/develop/decisions/0906); [0,
  /// 10]
  double hysteresis_N = 0;
  double hysteresis_mm = 0.01;  ///< the same for displacement inputs; (0, 1]
  /// decrease from a tactile force after which its jump can fire again, at most half the way to the stroke's
  /// start; 0: 2.5 times the hysteresis; [0, 10]
  double rearm_N = 0;

  // Time.
  EventPlacement placement = EventPlacement::timeStamped;  ///< docs/develop/decisions/0901
  double sensorPeriod_s = 1.0 / 425;  ///< "at a refresh rate of 425Hz" (Apparatus); [1e-5, 0.25]
  double burstSpacing_s = 0.005;      ///< two taps closer than about 5 ms are felt as one; [0, 0.1]

  // Output.
  double limiterCeiling = 1;  ///< (0, 1]
  /// "the frequency of the signal is predetermined from the resonant frequency of the device": an equalizer
  /// that flattened this resonance would weaken the jump (docs/develop/decisions/0907).
  EqualizerUse equalizer = EqualizerUse::sparingJumps;
};

/// The settings that are used unless those of the paper are requested.
inline PlaybackSettings usualSettings() {
  PlaybackSettings settings;
  settings.feel = Feel::clear;
  return settings;
}

}  // namespace detent::playback
