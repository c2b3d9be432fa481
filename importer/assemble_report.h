// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The last step of an import: from fitted strokes to a Button with its provenance, and how sure all of it is.

#include "importer/graph_findings.h"
#include "importer/importer.h"

namespace detent::importer {

/// Position of the graph, and source of its file.
struct GraphSource {
  std::string fileName, stem, sha256;
  int page = 1, graph = 1;
  std::vector<Remark> remarks;
};

/// Failure notCertain below the request's `sure`, with what to pass; a broken rule of the model otherwise.
Result<ImportReport> assembleReport(GraphFindings findings, const GraphSource& source,
                                    const ImportRequest& request);

/// The names of the options that were given, as provenance keeps them.
std::vector<std::string> givenByHand(const ImportHints& hints);

/// Remarks as the button's file keeps them: code and words.
std::vector<RecordedWarning> recorded(const std::vector<Remark>& remarks);

/// A button of one state; callouts become its operating and reset point.
Result<Button> buttonFrom(const std::string& name, const FittedStrokes& fitted,
                          const std::vector<Callout>& callouts, Provenance provenance);

}  // namespace detent::importer
