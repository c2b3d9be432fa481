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
  std::size_t knots = 1;     ///< 1..32 places of k and b over the travel, smooth between them; 1: constants
  double lowestQuanta = 10;  ///< > 0; a velocity window spans at least so many encoder steps of movement
  double largestSpread = 0.20;  ///< b is named only if its standard error is below this share of it
};

/// The reason why b is not reported.
enum class DampingDoubt : std::uint8_t {
  none,
  constantSpeed,  ///< speed hardly varies: damping and friction cannot be separated
  notCertain      ///< its standard error is too large
};

struct Estimate {
  double value = 0, sigma = 0;
};

struct Identification {
  Estimate offset_N;                   ///< c
  std::vector<double> knots_mm;        ///< where k and b stand
  std::vector<Estimate> k_N_per_mm;    ///< one per knot
  std::vector<Estimate> b_Ns_per_mm;   ///< one per knot; empty where b is not named
  std::optional<Estimate> friction_N;  ///< Coulomb's f; only where it stands out of its error
  std::optional<Estimate> mass_kg;     ///< only where it stands out of its error
  DampingDoubt doubt = DampingDoubt::none;
  double doubtFigure = 0;   ///< constantSpeed: spread of speed, share; notCertain: sigma(b) / b
  double condition = 1;     ///< of the columns of the fit, each scaled to length 1; large: hard to tell apart
  double residual_N = 0;    ///< rms
  double step_mm = 0;       ///< of the recording's displacement
  std::size_t samples = 0;  ///< that entered the fit
  std::vector<double> velocity_mm_per_s;  ///< of every sample of the record, for plots
};

/// Failure: wrongUsage for settings out of range; unreadableInput where the record is too short or does not
/// move. Any thread.
Result<Identification> identify(const ForceRecord& record, const IdentifySettings& settings = {});

/// The button that was identified: c + k(x) x as press curve, b(x) as damping where it is named.
Result<Button> buttonFrom(const Identification& found, const std::string& name, double travel_mm);

}  // namespace detent::playback
