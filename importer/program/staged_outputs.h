// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Output files that appear all together or not at all: nothing is left behind or half
// overwritten.

#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"
#include "model/staged_file.h"

namespace detent::importer {

/// Collects a run's output files beside their places; `commit` puts them there. What is not committed is
/// removed.
class StagedOutputs {
 public:
  /// Failure wrongUsage: the folder does not exist, cannot be written to, or the disk is full.
  Result<Done> stage(const std::string& path, std::string_view bytes);
  Result<Done> commit();

  /// Final paths of everything staged so far.
  const std::vector<std::string>& paths() const { return paths_; }

 private:
  std::vector<StagedFile> files_;
  std::vector<std::string> paths_;
};

}  // namespace detent::importer
