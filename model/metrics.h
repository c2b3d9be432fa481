// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Figures for comparing buttons, derived from the state.

#include <optional>
#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

/// One tactile point and the extremum after it.
struct TactileEvent {
  TactilePoint point;                   ///< the tactile point; its force is the tactile force
  std::optional<CurvePoint> following;  ///< press: the valley after it; release: the hump after it
  std::optional<double>
      snapRatio;  ///< press: (tactile force - valley)/tactile force; only for a tactile force > 0
  std::optional<Section> jump;  ///< the jump that begins here; nullopt inside an earlier jump
  double jumpArea_mJ = 0;
};

struct StrokeMetrics {
  std::vector<TactileEvent> tactile;  ///< in the order travelled
  std::vector<Section> sections;
  double startForce_N = 0, endForce_N = 0;  ///< forces at the two ends, by increasing displacement
  double minForce_N = 0, maxForce_N = 0;
  BottomOut bottomOut;
  double work_mJ = 0;  ///< area under the curve
};

struct StateMetrics {
  double travel_mm = 0;  ///< distance from displacement zero to the end of the press
  StrokeMetrics press;
  std::optional<StrokeMetrics> release;
  std::optional<double> hysteresisArea_mJ;  ///< press minus release over the displacements both cover; signed
  /// with the force of their stroke there, if they are known
  std::optional<CurvePoint> operatingPoint, resetPoint;
};

StrokeMetrics metricsOf(const StrokeCurve& curve, Stroke stroke, const SectionSettings& settings = {});
StateMetrics metricsOf(const ButtonState& state, const SectionSettings& settings = {});

}  // namespace detent
