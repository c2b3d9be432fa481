// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// --json-lines: progress as one JSON object per line on stdout; the last line is what --json prints.

#include <cstddef>
#include <optional>
#include <string>

#include "importer/page/findings.h"

namespace detent::importer {

/// Progress of one import: one line at the start of each step and at every twentieth of the whole. One
/// thread.
class StepLines {
 public:
  void show(double fraction, ImportStep step);  ///< 0..1 over the whole import

 private:
  std::optional<ImportStep> last_;
  double shown_ = 0;
};

/// Progress of a batch: an input is done, the `done`th of `total`. `exitCode` is that of detent-import for
/// it.
void showInputDone(const std::string& input, int exitCode, std::size_t done, std::size_t total);

}  // namespace detent::importer
