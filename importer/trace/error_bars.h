// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds and erases the error bars on a curve: upright strokes in the curve's colour, as far above it as
// below. A path search would follow the first and the last one, and every one on a steep stretch. Private
// to importer/trace.

#include <cstddef>

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// Erases the bars, and the caps at their ends, from the coverage by one colour. Fewer than five in a row on
/// one curve stay: a marker line or a leader crosses a curve as well, and letters have such parts. Returns
/// the number of erased bars.
std::size_t eraseErrorBars(Plane& coverage);

}  // namespace detent::importer::trace
