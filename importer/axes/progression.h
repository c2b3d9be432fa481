// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The linear relation between positions along an axis and the numbers printed there. It is found by
// consensus, so a misread label changes nothing.

#include <optional>
#include <vector>

#include "importer/axes/printed_number.h"
#include "importer/frame/plot_frame.h"

namespace detent::importer {

/// A label: its position, the numbers it could mean, and the tolerance of its position.
struct LabelPlace {
  double center_px = 0;
  double reach_px = 1;  ///< a tick within this distance of the centre is its tick; > 0
  std::vector<NumberReading> readings;
};

/// value = offset + perPx * position.
struct Progression {
  double offset = 0, perPx = 0;
  double step = 0;  ///< common step of the labels' values, > 0
  /// step of the gridlines and ticks between labels: `step` divided by 1, 2, 4, 5 or 10
  double substep = 0;
  std::vector<int> reading;    ///< per label: which reading agreed, -1: none
  std::vector<double> tickOf;  ///< per label: place of its tick; its own centre where there is none
  int labels = 0;              ///< that agreed
  int ticks = 0;               ///< lines and ticks that carried the final fit
  double residual_px = 0;      ///< rms of those
  double agree_px = 0;         ///< tolerance of a label's tick against the progression
  bool fromTicks = false;      ///< false: no ticks were found, so the centres of the labels were used
  double value(double position_px) const { return offset + perPx * position_px; }
  double position(double v) const { return (v - offset) / perPx; }
};

/// `ticks` increasing; lines that span the frame are preferred to tick marks. `rising` = values grow with the
/// position. nullopt if fewer than two labels agree on round values.
std::optional<Progression> fitProgression(const std::vector<LabelPlace>& labels,
                                          const std::vector<GridLine>& ticks, bool rising);

}  // namespace detent::importer
