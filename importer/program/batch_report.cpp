// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/batch_report.h"

#include <filesystem>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "model/sha256.h"
#include "model/version.h"

namespace detent::importer {
namespace {

namespace fs = std::filesystem;
using Keys = std::map<std::string, std::string>;

std::string memberOf(const nlohmann::json& object, const char* name) {
  return object.is_object() && object.contains(name) && object[name].is_string() ? object[name] : "";
}

std::string journalLine(const std::string& input, const std::string& key) {
  return jsonText(nlohmann::json{{"input", input}, {"key", key}}) + "\n";
}

/// Inputs of the journal with the key they were done under. A line that was cut off counts for nothing.
Keys journalIn(const std::string& path) {
  Keys keys;
  std::ifstream journal(path);
  for (std::string line; std::getline(journal, line);) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (const std::string input = memberOf(json, "input"); !input.empty())
      keys[input] = memberOf(json, "key");
  }
  return keys;
}

Keys stillValid(const Keys& journal, const std::vector<std::string>& inputs, const std::string& options) {
  Keys valid;
  for (const std::string& input : inputs) {
    const auto known = journal.find(input);
    if (known == journal.end() || known->second.empty() || valid.count(input)) continue;
    if (known->second == resultKey(input, options)) valid.insert(*known);
  }
  return valid;
}

/// The report's lines of the inputs for which `wanted` is true, in the order of `inputs`.
template <typename Wanted>
std::string linesInOrder(const std::string& path, const std::vector<std::string>& inputs,
                         const Wanted& wanted) {
  std::map<std::string, std::string> linesOf;
  std::ifstream report(path);
  for (std::string line; std::getline(report, line);) {
    const std::string input = memberOf(nlohmann::json::parse(line, nullptr, false), "input");
    if (wanted(input)) linesOf[input] += line + "\n";
  }
  std::string lines;
  for (const std::string& input : inputs) lines += std::exchange(linesOf[input], "");
  return lines;
}

std::string journalOf(const Keys& done) {
  std::string lines;
  for (const auto& [input, key] : done) lines += journalLine(input, key);
  return lines;
}

Failure unwritable(const std::string& path) {
  return {FailureCode::wrongUsage, path, "", "cannot be written",
          "Pass an --out-dir that can be made or written to"};
}

}  // namespace

std::string resultKey(const std::string& input, const std::string& options) {
  const auto bytes = readTextFile(input);
  if (!bytes) return "";
  return sha256Hex(sha256Hex(*bytes) + "\n" + version() + "\n" + options);
}

Result<BatchReport> BatchReport::open(const std::string& folder, const std::vector<std::string>& inputs,
                                      const std::string& options, bool resume) {
  BatchReport report;
  report.path_ = (fs::path(folder) / "report.jsonl").string();
  const std::string journal = (fs::path(folder) / "report.done").string();
  if (resume) {
    report.done_ = stillValid(journalIn(journal), inputs, options);
    // The journal shrinks first: what it names is in the report at any moment.
    if (!writeTextFileAtomically(journal, journalOf(report.done_)) ||
        !writeTextFileAtomically(report.path_, linesInOrder(report.path_, inputs, [&](const auto& input) {
                                   return report.has(input);
                                 })))
      return unwritable(report.path_);
  }
  const auto mode = resume ? std::ios::app : std::ios::trunc;
  report.journal_.open(journal, mode);
  report.report_.open(report.path_, mode);
  if (!report.report_ || !report.journal_) return unwritable(report.path_);
  std::error_code none;
  report.size_ = fs::file_size(report.path_, none);
  return report;
}

Result<Done> BatchReport::add(const std::string& input, const std::string& key, const std::string& lines) {
  if (report_ << lines << std::flush && journal_ << journalLine(input, key) << std::flush) {
    size_ += lines.size();
    return Done{};
  }
  report_.close();
  std::error_code none;
  fs::resize_file(path_, size_, none);  // no half line stays
  return Failure{FailureCode::internalFault, path_, "", "the disk takes no more",
                 "Make room, then run it again with --resume"};
}

Result<Done> BatchReport::sortAs(const std::vector<std::string>& inputs) {
  if (done_.empty()) return Done{};  // added in order
  report_.close();
  return writeTextFileAtomically(path_, linesInOrder(path_, inputs, [](const auto&) { return true; }));
}

}  // namespace detent::importer
