// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A press in the form of one format, before it becomes text, so that the file can contain its own loss
// record.

#include <functional>
#include <string>
#include <vector>

#include "model/button.h"
#include "playback/interchange/export_loss.h"
#include "playback/interchange/exported_file.h"
#include "playback/interchange/played_wave.h"
#include "playback/interchange/press_plan.h"

namespace detent::playback {

struct Reduction {
  /// Signal that a player makes of it, on the plan's time axis and at its rate; press and release separately
  /// if they are started separately.
  std::vector<std::vector<double>> played;
  ExportLoss loss;  ///< complete except for the energies, which follow from `played`
  std::function<std::vector<ExportedFile>(const ExportLoss&)> write;
};

/// Data for the header of every file.
struct ExportSource {
  const Button& button;
  const HapticProgram& program;
  const PressPlan& plan;
};

Reduction packageOf(const ExportSource& source);
Reduction cHeaderOf(const ExportSource& source);
Reduction ahapOf(const ExportSource& source);
Reduction hapticOf(const ExportSource& source);
Reduction androidOf(const ExportSource& source);
Reduction openxrOf(const ExportSource& source);
Reduction hjifOf(const ExportSource& source);
Reduction bos1921Of(const ExportSource& source);
Reduction da728xOf(const ExportSource& source);
Reduction drv2605Of(const ExportSource& source);
/// The samples of the plan at any rate, band-limited (docs/develop/decisions/0913).
Reduction pcmOf(const ExportSource& source, unsigned bits, double sampleRate_Hz);
Reduction touchpadOf(const ExportSource& source);

/// The waves as samples of the plan's length.
std::vector<double> playedBy(const std::vector<PlayedWave>& waves, const PressPlan& plan);

/// "Made by Detent 0.3.0 from button "B": human-like press of 120 ms" and the loss, for comments.
std::vector<std::string> headLines(const ExportSource& source, const ExportLoss& loss);

/// A C block comment with these lines; no content can end it early.
std::string cComment(const std::vector<std::string>& lines);
/// A C string literal of any bytes.
std::string cString(const std::string& text);
/// A float literal.
std::string cFloat(double value);
/// Numbers in rows of twelve, separated by commas.
template <class Numbers, class Text>
std::string rows(const Numbers& numbers, const Text& text) {
  std::string lines;
  std::size_t column = 0;
  for (const auto& number : numbers) {
    lines += (column % 12 == 0 ? "\n  " : " ") + text(number) + ",";
    ++column;
  }
  return lines + "\n";
}

}  // namespace detent::playback
