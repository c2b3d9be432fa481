// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The report of a batch on the disk, and what a batch that goes on need not repeat.

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "model/result.h"

namespace detent::importer {

/// Digest of what a result depends on: the input's bytes, the options and the version of the program. Empty where the input cannot be
/// read: such an input is never done.
std::string resultKey(const std::string& input, const std::string& options);

/// `report.jsonl` of a folder, one line per graph, and `report.done` beside it, which names an input with its key once all of its lines are
/// complete: what a killed batch left half is dropped by the next one and made anew. One thread.
class BatchReport {
 public:
  /// An empty report, or with `resume` the one that is there, cut down to those of `inputs` whose key is the one of now.
  /// Failure wrongUsage: the folder cannot be written to.
  static Result<BatchReport> open(const std::string& folder, const std::vector<std::string>& inputs,
                                  const std::string& options, bool resume);

  const std::string& path() const { return path_; }
  bool has(const std::string& input) const { return done_.count(input) > 0; }
  std::size_t kept() const { return done_.size(); }  ///< inputs that the report answered when it was opened

  /// `lines`: complete, each ending in '\n'. Failure internalFault: the disk refused; the input is not done,
  /// and no part of its lines stays. Nothing can be added after that.
  Result<Done> add(const std::string& input, const std::string& key, const std::string& lines);

  /// Puts the lines in the order of `inputs`, where kept ones stand before those that were added. Nothing can be added after that.
  Result<Done> sortAs(const std::vector<std::string>& inputs);

 private:
  std::string path_;
  std::map<std::string, std::string> done_;
  std::uintmax_t size_ = 0;  ///< of the report, whole lines
  std::ofstream report_, journal_;
};

}  // namespace detent::importer
