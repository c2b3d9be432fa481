// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Adds folders of measured switches to a library. Unchanged files are not read again.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "importer/library/store.h"

namespace detent::importer {

/// Reads pages and pictures, each in isolation so that a crash or a hang affects it alone, and passes on the
/// result of each.
using PageReader = std::function<Result<Done>(
    const std::vector<std::string>& paths,
    const std::function<void(const std::string& path, Result<std::vector<LibrarySwitch>>)>& take)>;

struct IndexRequest {
  std::vector<std::string> folders;  ///< or single files
  std::string database;
  /// for everything that this run reads; empty: taken from the folders (Origin)
  std::string licence, credit;
  int jobs = 0;               ///< threads; 0: one for each processor
  PageReader readPages = {};  ///< also reads pages and pictures of datasheets; empty: they are skipped
};

struct IndexSummary {
  std::size_t imported = 0;           ///< files read now
  std::size_t refused = 0;            ///< files that could not be added, in this run or an earlier one
  std::size_t unchanged = 0;          ///< files in the library that have not changed
  std::size_t gone = 0;               ///< files that no longer exist: their switches are kept but not found
  std::size_t switches = 0;           ///< of the files read now
  std::size_t ratings = 0;            ///< of score sheets read now
  std::vector<RefusedFile> refusals;  ///< one for each refused file
  Message rebuilt;                    ///< reason why the library was rebuilt; empty if it was not
};

struct IndexProgress {
  std::function<void(double fraction, const std::string& file)> report;  ///< may be empty
  std::function<bool()> cancelled;  ///< called from any thread; may be empty
};

/// Files that were read before a Failure or a forced end stay in the library. Failure unreadableInput: no
/// such folder; also those of LibraryStore::openToWrite and put; cancelled.
Result<IndexSummary> indexFolders(const IndexRequest& request, const IndexProgress& progress = {});

}  // namespace detent::importer
