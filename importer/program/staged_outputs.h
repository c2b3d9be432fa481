// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Output files that appear all together or not at all: a failed run leaves no partial file and overwrites
// nothing.

#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"
#include "model/staged_file.h"

namespace detent::importer {

/// Writes a run's output files beside their final paths; `commit` moves them there. Without a commit they are
/// removed.
class StagedOutputs {
 public:
  /// Failures: as of StagedFile.
  Result<Done> stage(const std::string& path, std::string_view bytes);
  Result<Done> commit();

  /// Final paths of everything staged so far.
  const std::vector<std::string>& paths() const { return paths_; }

 private:
  std::vector<StagedFile> files_;
  std::vector<std::string> paths_;
};

}  // namespace detent::importer
