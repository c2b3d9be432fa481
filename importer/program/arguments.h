// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The command line of detent-import: a fixed contract, scripts rely on it.

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "importer/batch/batch.h"
#include "importer/importer.h"

namespace detent::importer {

struct Arguments {
  std::vector<std::string> inputs;  ///< one, or many with `batch`, lists read
  ImportRequest request;            ///< path empty; page, graph, quality, hints, limits
  bool list = false;
  bool all = false;
  bool json = false;
  bool pair = false;  ///< the release's file is in the hints, or in `releaseOf`, no longer among `inputs`
  std::map<std::string, std::string> releaseOf;  ///< of a batch, by the press
  bool ask = false;
  bool explain = false;
  bool jsonLines = false;                                              ///< with it json
  std::string buttonPath, csvPath, tracePath, overlayPath, stepsPath;  ///< empty: not written

  bool family = false;  ///< `inputs` are records of one button at different speeds

  bool batch = false;
  bool resume = false;
  bool withoutOverlays = false;  ///< of a batch
  std::string outDir;
  std::string settledBy;  ///< the options that bear on a result, as given, a line each
  BatchOptions batchOptions;
  std::optional<double> timeLimit_s;  ///< of an input that is imported alone
};

/// `arguments` is empty where the program should end at once with `exitCode` (help, version, wrong usage).
struct Parsed {
  std::optional<Arguments> arguments;
  int exitCode = 0;
};

/// Help and version go to `out`, what is wrong with the words to `err`.
Parsed parseArguments(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace detent::importer
