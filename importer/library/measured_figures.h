// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Key figures of a measured switch from its samples, with the errors that the meter's noise and step size
// cause.

#include "importer/importer.h"
#include "model/key_figures.h"

namespace detent::importer {

struct MeasuredFigures {
  /// Figures from the samples, if they determine them; else from the fit.
  KeyFigures figures;
  /// Standard errors: half of what holds 68.3 % of the errors of noise and steps together. Empty if the
  /// samples do not determine one, for example of a peak of too few samples.
  KeyFigures sigmas;
};

/// Figures of an imported log's first state. Not included: the meter's own calibration, and the difference of
/// another unit of the switch (docs/develop/decisions/0813). Any thread.
MeasuredFigures measuredFiguresOf(const ImportReport& report);

}  // namespace detent::importer
