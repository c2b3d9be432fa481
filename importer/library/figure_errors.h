// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far a measured switch's figures may be off, by what the meter's noise and the fit leave open.

#include "importer/importer.h"
#include "model/key_figures.h"

namespace detent::importer {

struct FigureErrors {
  /// What the figures of the few pieces of the fit lack to those of the samples: to be added to them.
  KeyFigures misses;
  /// Standard errors of the sums, in the figures' units: of the noise of the samples, of what correcting leaves, of the step between
  /// samples at contact points and at the end.
  KeyFigures sigmas;
};

/// Of an imported log's first state (ImportRequest::curveErrors). Empty where the button has no such figure. Not contained: the
/// meter's own calibration, and that another unit of the switch differs. Any thread.
FigureErrors figureErrorsOf(const ImportReport& report);

}  // namespace detent::importer
