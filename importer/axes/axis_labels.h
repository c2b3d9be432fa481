// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The numbers along one axis, and the linear relation between value and position on which they agree.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "importer/axes/graph_reading.h"
#include "importer/axes/progression.h"

namespace detent::importer {

enum class Axis { x, y };

/// One axis with its numbers.
struct AxisLabels {
  std::optional<Progression> progression;            ///< empty: numbers, but no progression
  std::vector<SeenText> words;                       ///< in order along the axis
  std::vector<std::vector<NumberReading>> readings;  ///< per word
  Box extent;                                        ///< around the words
  ThousandsSign thousands = ThousandsSign::none;
  std::string suffix;   ///< unit that stands in the labels themselves ("20gf"), if it does
  int numbers() const;  ///< how many words can be read as numbers
};

/// Splits a text behind its leading number: "20gf" becomes "20" and "gf".
std::pair<std::string, std::string> numberAndSuffix(const std::string& text);

/// The tick labels, each extended by the letters that follow it on its line, in the same order. Labels that
/// are no number stay unchanged. `glyphs`: the blobs outside the frame.
std::vector<Box> withLettersBehind(const std::vector<Box>& glyphs, const AxisLabels& labels);

/// Tries the rows (for y: columns) of words beside the frame, the most regular one first, until one is a
/// progression. nullopt if there is no row of two or more words.
std::optional<AxisLabels> readAxisLabels(GraphReading& r, Axis axis);

/// The column of numbers right of the frame, if it has at least four that are evenly spaced; nullopt
/// otherwise. `lines`: the gridlines and ticks that belong to these numbers; empty if those belong to another
/// scale.
std::optional<AxisLabels> readRightLabels(GraphReading& r, const std::vector<GridLine>& lines);

/// Returns true if a column of numbers covers so much of the frame's height that it is a scale: "PB-01" to
/// "PB-04" in a legend are a progression as well.
bool reachesFar(const AxisLabels& labels, const Box& frame);

}  // namespace detent::importer
