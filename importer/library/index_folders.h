// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Folders of measured switches into a library. What is unchanged is not read again.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "importer/library/store.h"

namespace detent::importer {

/// Reads pages and pictures, each so that a crash or a hang costs it alone; hands over what comes of each.
using PageReader = std::function<Result<Done>(
    const std::vector<std::string>& paths,
    const std::function<void(const std::string& path, Result<std::vector<LibrarySwitch>>)>& take)>;

struct IndexRequest {
  std::vector<std::string> folders;  ///< or single files
  std::string database;
  std::string licence, credit;  ///< of all that is read now; empty: as the folders say
  int jobs = 0;                 ///< threads; 0: one for each processor
  PageReader readPages = {};    ///< pages and pictures of datasheets too; empty: they are passed over
};

struct IndexSummary {
  std::size_t imported = 0;   ///< files read now
  std::size_t refused = 0;    ///< files that are not in it, read now or before
  std::size_t unchanged = 0;  ///< files that were in it and are as they were
  std::size_t gone = 0;       ///< files that were there and are not: their switches are kept, and not found
  std::size_t switches = 0;   ///< of the files read now
  std::size_t ratings = 0;    ///< of score sheets read now
  std::vector<RefusedFile> refusals;  ///< one for each refused file
  Message rebuilt;                    ///< why the library was made anew; empty where it was not
};

struct IndexProgress {
  std::function<void(double fraction, const std::string& file)> report;  ///< may be empty
  std::function<bool()> cancelled;  ///< called from any thread; may be empty
};

/// Files that were read before a Failure or a forced end stay read. Failure unreadableInput: no such folder;
/// those of LibraryStore::openToWrite and put; cancelled.
Result<IndexSummary> indexFolders(const IndexRequest& request, const IndexProgress& progress = {});

}  // namespace detent::importer
