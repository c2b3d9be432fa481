// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cuts one run of samples into strokes at its turning points.

#include <limits>
#include <optional>
#include <vector>

#include "model/stroke_curve.h"

namespace detent::importer {

/// Samples [from, to] of a run, both ends included; displacement grows on a press.
struct StrokeSpan {
  std::size_t from = 0, to = 0;
  Stroke stroke = Stroke::press;
};

/// Cuts at the turning points of displacement. A turn counts once the displacement has come back by
/// `least_mm`.
std::vector<StrokeSpan> spansOf(const std::vector<CurvePoint>& samples, double least_mm);

/// Removes the dwell at the end of a press. If the handle rests at its deepest place (within 3 times the
/// noise) while the force relaxes or falls towards the release, the stroke ends with its strongest sample
/// there. Otherwise that fall would be read as a tactile point.
void endBeforeDwell(std::vector<CurvePoint>& press, double noise_mm, double noise_N);

/// Fills gaps far wider than the usual distance of samples with samples on a straight line. Thinned tables
/// keep only the ends of straight pieces, and a curve without points there would bulge.
std::vector<CurvePoint> bridged(const std::vector<CurvePoint>& stroke);

/// Standard deviation of white noise, from second differences. They are combined by the median absolute
/// deviation, so that steps and corners do not count. At least the noise of the instrument's resolution,
/// which is the smallest step between samples, or `lastDigit` if that is finer (even steps are not caused by
/// rounding). Fewer than 16 values cannot show noise and count as exact.
double noiseOf(const std::vector<double>& values, double lastDigit = std::numeric_limits<double>::infinity());

/// Readings recorded before the key is touched.
struct BeforeContact {
  double force_N = 0;         ///< force of the unloaded gauge
  double contact_mm = 0;      ///< place of contact
  double uncertainty_mm = 0;  ///< standard error of the contact
};
/// The flat stretch at the start of a press, if there is one: at least five readings of one small force,
/// without a slope.
std::optional<BeforeContact> beforeContact(const std::vector<CurvePoint>& press, double noise_N);

}  // namespace detent::importer
