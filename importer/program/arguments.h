// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The command line of detent-import. Its options are a fixed contract because scripts rely on them.

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "importer/batch/batch.h"
#include "importer/importer.h"

namespace detent::importer {

struct Arguments {
  std::vector<std::string> inputs;  ///< one file, or many with `batch`; file lists are already expanded
  ImportRequest request;            ///< path empty; page, graph, quality, hints, limits
  bool list = false;
  bool all = false;
  bool json = false;
  /// press and release are in separate files; the release's is in the hints or in `releaseOf`, not in
  /// `inputs`
  bool pair = false;
  std::map<std::string, std::string> releaseOf;  ///< for a batch: file of the release by file of the press
  bool ask = false;
  bool explain = false;
  bool jsonLines = false;                                              ///< also sets `json`
  std::string buttonPath, csvPath, tracePath, overlayPath, stepsPath;  ///< empty: not written

  bool family = false;  ///< `inputs` are records of one button at different speeds

  bool batch = false;
  bool resume = false;
  bool withoutOverlays = false;  ///< writes no overlays of a batch
  std::string outDir;
  std::string settledBy;  ///< the options that affect a result, as given, one per line
  BatchOptions batchOptions;
  std::optional<double> timeLimit_s;  ///< time limit of an input that is imported alone
};

/// Result of parsing. `arguments` is empty if the program should end at once with `exitCode` (help, version,
/// wrong usage).
struct Parsed {
  std::optional<Arguments> arguments;
  int exitCode = 0;
};

/// Help and version are written to `out`, error messages to `err`.
Parsed parseArguments(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace detent::importer
