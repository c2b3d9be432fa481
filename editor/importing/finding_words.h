// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Findings, doubts and remedies of an import, in words for a user who sees the page.

#include <QString>
#include <vector>

#include "editor/document/message_words.h"
#include "importer/importer.h"

namespace detent::editor {

/// A fault or doubt, what to do about it, and the corrections that do it, the likeliest first.
struct Advice {
  QString problem, remedy;
  std::vector<RemedyKind> remedies;
};

/// `documentName` is left out of the sentence: the dialogue shows it anyway.
Advice adviceFor(const Failure& failure, const QString& documentName, const DisplayUnits& units = modelUnits);

/// Advice for a doubt with these corrections; corrections that are already given are not advised again.
Advice adviceFor(const importer::Doubt& doubt, const std::vector<RemedyKind>& corrections,
                 const DisplayUnits& units = modelUnits);

/// Returns true if the dialogue has a control for this remedy.
bool isCorrection(RemedyKind kind);
/// The corrections among remedies, for which the dialogue has a control, in their order.
std::vector<RemedyKind> correctionsAmong(const Remedies& remedies);

QString inWords(const importer::Remark& remark, const DisplayUnits& units);
/// One line; empty without evidence.
QString inWords(const std::vector<importer::EvidenceItem>& evidence, const DisplayUnits& units);

/// "Which switch should be read? A (#000000), B (#ff0000)"
QString inWords(const importer::Question& question);

/// Text of a correction's button: "Draw plot frame"; empty if the remedy is not a correction.
QString textOnButton(RemedyKind correction);

inline constexpr double sureEnough = 0.95;  ///< confidence from which nothing needs a check
/// The reason why an import is not more certain, in a line: its doubts, else the weakest step with its
/// evidence. Empty if it is sure enough.
QString causeOf(const importer::ImportReport& report, const DisplayUnits& units);

/// "Plot frame": name of a step's result.
QString nameOfFinding(importer::ImportStep step);
/// "tracing": name of a step, shown beside its time.
QString nameOfWork(importer::ImportStep step);
/// "Tracing the curves …".
QString inProgress(importer::ImportStep step);

}  // namespace detent::editor
