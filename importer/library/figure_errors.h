// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far a measured switch's figures may be off, by what the meter's noise and the fit leave open.

#include "importer/importer.h"
#include "model/key_figures.h"

namespace detent::importer {

/// Standard errors of the figures of an imported button's first state, in their units: of the noise of the samples, of the few pieces
/// of the fit, and of the step between samples at contact points. Empty where the button has no such figure. Not contained: the
/// meter's own calibration, and that another unit of the switch differs. Any thread.
KeyFigures figureErrorsOf(const ImportReport& report);

}  // namespace detent::importer
