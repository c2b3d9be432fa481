// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The report of a batch on disk, and the record of inputs that a resumed batch need not repeat.

#include <cstdint>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/result.h"

namespace detent::importer {

/// Digest of what a result depends on: the input's bytes, the options and the version of the program. Empty
/// where the input cannot be read: such an input is never done.
std::string resultKey(const std::string& input, const std::string& options);

/// `report.jsonl` in a folder has one line per graph. `report.done` beside it names an input, with its key
/// and its number of lines, once all of its lines are complete. If a batch was killed or the power failed,
/// the next one drops incomplete entries from both files and repeats those inputs. One thread.
class BatchReport {
 public:
  /// Opens an empty report. With `resume`, opens the existing one and keeps the entries of those `inputs`
  /// whose key has not changed (`keyOf`) and whose lines are complete. Failure wrongUsage: the folder cannot
  /// be written to.
  static Result<BatchReport> open(const std::string& folder, const std::vector<std::string>& inputs,
                                  const std::function<std::string(const std::string&)>& keyOf, bool resume);

  const std::string& path() const { return path_; }
  bool has(const std::string& input) const { return done_.count(input) > 0; }
  /// number of inputs that were complete when the report was opened
  std::size_t kept() const { return done_.size(); }

  /// `lines`: complete, each ending in '\n'. Failure internalFault: the disk refused to write; the input is
  /// not done and none of its lines remains. Nothing can be added after that.
  Result<Done> add(const std::string& input, const std::string& key, const std::string& lines);

  /// Sorts the lines in the order of `inputs`; entries that were kept stand before added ones. Nothing can be
  /// added after that.
  Result<Done> sortAs(const std::vector<std::string>& inputs);

 private:
  std::string path_;
  std::set<std::string> done_;
  std::uintmax_t size_ = 0;  ///< size of the report's whole lines
  std::ofstream report_, journal_;
};

}  // namespace detent::importer
