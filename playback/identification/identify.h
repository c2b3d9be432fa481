// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From a recorded press to the parameters of a spring-damper button, F = c + k(x) x + b(x) v + f sgn(v) + m
// a, with standard errors. What Shrestha leaves to future work; after Colton and Hollerbach (ICRA 2007) with
// k and b over displacement.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/button.h"
#include "model/result.h"
#include "playback/identification/force_record.h"

namespace detent::playback {

struct IdentifySettings {
  std::size_t knots = 1;  ///< 1..32 positions of k and b over the travel, smooth between them; 1: constants
  double lowestQuanta = 10;     ///< > 0; a velocity window spans at least this many encoder steps of movement
  double largestSpread = 0.20;  ///< b is reported only if its standard error is below this share of it
};

/// The reason why b is not reported.
enum class DampingDoubt : std::uint8_t {
  none,
  constantSpeed,  ///< speed hardly varies: damping and friction cannot be separated
  notCertain      ///< the standard error is too large
};

struct Estimate {
  double value = 0, sigma = 0;
};

struct Identification {
  Estimate offset_N;                   ///< c
  std::vector<double> knots_mm;        ///< positions of k and b
  std::vector<Estimate> k_N_per_mm;    ///< one per knot
  std::vector<Estimate> b_Ns_per_mm;   ///< one per knot; empty if b is not reported
  std::optional<Estimate> friction_N;  ///< Coulomb's f; only if it is significantly larger than its error
  std::optional<Estimate> mass_kg;     ///< only if it is significantly larger than its error
  DampingDoubt doubt = DampingDoubt::none;
  double doubtFigure = 0;  ///< constantSpeed: spread of speed, share; notCertain: sigma(b) / b
  /// condition number of the fit's columns, each scaled to length 1; large: the parameters are hard to
  /// distinguish
  double condition = 1;
  double residual_N = 0;                  ///< rms
  double step_mm = 0;                     ///< smallest step of the recorded displacement
  std::size_t samples = 0;                ///< number of samples in the fit
  std::vector<double> velocity_mm_per_s;  ///< velocity at every sample of the record, for plots
};

/// Failure: wrongUsage for settings out of range; unreadableInput where the record is too short or does not
/// move. Any thread.
Result<Identification> identify(const ForceRecord& record, const IdentifySettings& settings = {});

/// The identified button: c + k(x) x as press curve, and b(x) as damping if it is reported.
Result<Button> buttonFrom(const Identification& found, const std::string& name, double travel_mm);

}  // namespace detent::playback
