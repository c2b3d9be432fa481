// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads whole graphs of a document, for the targets that do so.

#include <vector>

#include "importer/assemble_report.h"
#include "model/button.h"

namespace detent::importer::fuzz {

/// Aborts if a number in the button is not finite.
void mustBeFinite(const Button& button);

Result<FittedStrokes> fitBoth(const StrokePair& strokes, const FitOptions& options);

/// Everything from the document's bytes to the button. Pictures are given their ranges and units: what their
/// labels say is Tesseract's business, which would take nearly all of the time and shows the fuzzer nothing.
/// Documents are read without hints, as they carry their own text.
void importDocument(std::vector<unsigned char> bytes);

}  // namespace detent::importer::fuzz
