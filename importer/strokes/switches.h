// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Several switches in one plot: the traces of each, its name in the legend, and the requested one.
// docs/develop/decisions/0701-several-switches.md

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// One of the switches (springs, samples) that a plot shows.
struct PlotSwitch {
  std::string name;                 ///< the name in the legend; empty without one
  Rgb pressColor;                   ///< of the press, as determined by names and heights
  std::optional<Rgb> releaseColor;  ///< empty: press only
  std::vector<std::size_t>
      traces;       ///< one or two of the traces it was found among, in the order of the colours
  double sure = 1;  ///< confidence in what belongs together, 0..1
};

/// Switches of a plot, numbered from 1 in the order of the legend (row by row from its top), without a legend
/// from the highest curve to the lowest. Empty if it is not clear which curves belong together. Traces of
/// less than two points are ignored.
std::vector<PlotSwitch> switchesAmong(const std::vector<CurveTrace>& traces);

/// Index of the requested switch: its name or the legend's words of one of its strokes, or its number from 1.
/// Case, blanks and signs do not matter, nor letters that a text engine confuses (B and 8, O and 0), as long
/// as one switch alone fits. An empty request: the only one. Failure notCertain if there are several and none
/// is requested, wrongUsage if no or more than one fits; both name all switches.
Result<std::size_t> chosenSwitch(const std::vector<PlotSwitch>& switches,
                                 const std::vector<CurveTrace>& traces, const std::string& requested);

/// Returns true if the request is this switch's number or name, except for letters that a text engine
/// confuses: an exact match, not a similar one.
bool isNamed(const std::vector<PlotSwitch>& switches, std::size_t partner,
             const std::vector<CurveTrace>& traces, const std::string& requested);

}  // namespace detent::importer
