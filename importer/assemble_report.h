// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The last step of an import: makes a Button with its provenance from the fitted strokes, and states the
// confidence of the whole import.

#include "importer/graph_findings.h"
#include "importer/importer.h"

namespace detent::importer {

/// Position of the graph, and source of its file.
struct GraphSource {
  std::string fileName, stem, sha256;
  int page = 1, graph = 1;
  std::vector<Remark> remarks;
};

/// Failure notCertain if the confidence is below the request's `sure`; its remedies name the options that
/// would help. Failure of the model if the button breaks one of its rules.
Result<ImportReport> assembleReport(GraphFindings findings, const GraphSource& source,
                                    const ImportRequest& request);

/// The names of the options that were given, as provenance keeps them.
std::vector<std::string> givenByHand(const ImportHints& hints);

/// Remarks as the button's file keeps them, code and words; the last ones are doubts that a person accepted.
std::vector<RecordedWarning> recorded(const std::vector<Remark>& remarks, const std::vector<Doubt>& accepted);

/// A button of one state. Callouts set its operating point and its reset point.
Result<Button> buttonFrom(const std::string& name, const FittedStrokes& fitted,
                          const std::vector<Callout>& callouts, Provenance provenance);

}  // namespace detent::importer
