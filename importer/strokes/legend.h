// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a legend calls the strokes, in the languages datasheets are written in.

#include <optional>
#include <string_view>

#include "model/stroke_curve.h"

namespace detent::importer {

/// The stroke a legend text names: "Downstroke", "press (loading)", "Rückhub", "按压". Words are matched
/// whole, one wrong letter is forgiven in long ones (OCR). Nothing if it names none, both, or a point rather
/// than a stroke ("reset point").
std::optional<Stroke> strokeNamedBy(std::string_view utf8);

}  // namespace detent::importer
