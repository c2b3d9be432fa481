// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the importer says to people at a command line, in the words of someone who sits before the page.

#include <QString>
#include <string>
#include <vector>

#include "model/result.h"

namespace detent::editor {

/// A correction that the dialogue offers.
enum class Remedy { frame, xAxis, yAxis, xUnit, yUnit, pressColor, releaseColor, mask, dpi, swap };

/// A fault, what to do about it, and the corrections that do it, the likeliest first.
struct Advice {
  QString problem, remedy;
  std::vector<Remedy> remedies;
};

/// `documentName` is left out of the sentence: the dialogue shows it anyway. Never names an option of a
/// program.
Advice adviceFor(const Failure& failure, const QString& documentName);

/// The same, for these corrections alone: what is already given need not be advised again.
Advice adviceWith(const Failure& failure, const QString& documentName, const std::vector<Remedy>& remedies);

/// A warning of an import, without options of a program.
QString warningInWords(const std::string& warning);

/// "Drag the corners of the plot frame", on a button.
QString nameOf(Remedy remedy);

}  // namespace detent::editor
