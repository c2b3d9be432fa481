// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The functions of detent-import: from a file to a button and its report.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "editor/python/core/interruptible.h"
#include "editor/python/core/refusal.h"
#include "importer/importer.h"
#include "model/button.h"

namespace detent::python {

struct ReadButton {
  Button button;
  std::string reportJson;  ///< output of `detent-import --json`, without outputs
};

/// Options as detent-import takes them ("--page=2"), checked by its own parser. Throws Refusal.
importer::ImportRequest requestOf(const std::vector<std::string>& options);

/// Any thread. Throws Refusal.
ReadButton readGraph(importer::ImportRequest request, const std::string& path, const Cancelled& cancelled);

/// Reads many files on several threads and returns the results in the order of the files. Called by one
/// thread.
class ReadMany {
 public:
  /// Starts at once. `jobs` >= 1.
  ReadMany(const std::vector<std::string>& paths, const importer::ImportRequest& request, std::size_t jobs);
  ~ReadMany() { stop(); }
  ReadMany(const ReadMany&) = delete;
  ReadMany& operator=(const ReadMany&) = delete;

  /// Result of the next file; waits as `await` does, and stops where that throws.
  Answer<ReadButton> next();
  /// Starts no further files, and cancels those that are being read. Returns at once.
  void stop();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::size_t given_ = 0;
};

}  // namespace detent::python
