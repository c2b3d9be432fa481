// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The numbers along one axis, and the relation of value and place that they agree on.

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

/// "20gf" -> "20" and "gf"; no digits in front: nothing.
std::pair<std::string, std::string> numberAndSuffix(const std::string& text);

/// The tick labels with the letters that follow each on its line, in their order; labels that are no number
/// stay as they are. `glyphs`: the blobs outside the frame.
std::vector<Box> withLettersBehind(const std::vector<Box>& glyphs, const AxisLabels& labels);

/// Rows (columns for y) of words beside the frame are tried from the most regular one on, until one makes a
/// progression. nullopt if no row of two or more words is there.
std::optional<AxisLabels> readAxisLabels(GraphReading& r, Axis axis);

/// The column of numbers right of the frame, if one of four or more stands there evenly spaced; else nothing
/// is read. `lines`: the gridlines and ticks they stand at, none where those are another scale's.
std::optional<AxisLabels> readRightLabels(GraphReading& r, const std::vector<GridLine>& lines);

/// Returns true if a column of numbers covers so much of the frame's height that it is a scale: "PB-01" to
/// "PB-04" in a legend are a progression as well.
bool reachesFar(const AxisLabels& labels, const Box& frame);

}  // namespace detent::importer
