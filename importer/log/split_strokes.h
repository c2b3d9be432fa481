// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One run of samples cut at its turning points into strokes.

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

/// Takes the dwell off the end of a press: where the handle stands at its deepest place (within 3 noises) and
/// the force relaxes, or falls over to the release, the stroke ends with its strongest sample there. Kept,
/// the fall would read as a tactile point at the end of the travel.
void endBeforeDwell(std::vector<CurvePoint>& press, double noise_mm, double noise_N);

/// Straight lines, as samples as far apart as the others, across places far longer than samples stand apart
/// elsewhere: tables that were thinned out keep only the ends of a straight piece, and a curve that is free
/// between them bulges.
std::vector<CurvePoint> bridged(const std::vector<CurvePoint>& stroke);

/// Standard deviation of white noise from second differences (median absolute deviation: steps and corners do
/// not count); at least what the instrument's resolution makes: the smallest step between samples, or
/// `lastDigit` where that is finer (rows in even steps are no rounding). Fewer than 16 values cannot tell
/// noise from shape: they count as written.
double noiseOf(const std::vector<double>& values, double lastDigit = std::numeric_limits<double>::infinity());

/// Readings recorded before the key is touched.
struct BeforeContact {
  double force_N = 0;         ///< of the unloaded gauge
  double contact_mm = 0;      ///< place of contact
  double uncertainty_mm = 0;  ///< standard error of the contact
};
/// The flat stretch at the start of a press, if there is one: five readings or more of one small force, on no
/// slope.
std::optional<BeforeContact> beforeContact(const std::vector<CurvePoint>& press, double noise_N);

}  // namespace detent::importer
