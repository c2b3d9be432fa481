// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/batch_report.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "model/sha256.h"
#include "model/version.h"

namespace detent::importer {
namespace {

namespace fs = std::filesystem;

struct Entry {
  std::string key;
  std::size_t lines = 0;
};
using Journal = std::map<std::string, Entry>;

std::string memberOf(const nlohmann::json& object, const char* name) {
  return object.is_object() && object.contains(name) && object[name].is_string() ? object[name] : "";
}

/// A file name as written to report and journal, where invalid UTF-8 is replaced.
std::string asWritten(const std::string& input) {
  return nlohmann::json::parse(jsonText(nlohmann::json(input))).get<std::string>();
}

std::string journalLine(const std::string& input, const Entry& entry) {
  return jsonText(nlohmann::json{{"input", input}, {"key", entry.key}, {"lines", entry.lines}}) + "\n";
}

/// The journal's inputs with the keys they were processed under. A truncated line is ignored.
Journal journalIn(const std::string& path) {
  Journal entries;
  std::ifstream journal(path);
  for (std::string line; std::getline(journal, line);) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    const std::string input = memberOf(json, "input");
    if (input.empty() || !json.contains("lines") || !json["lines"].is_number_unsigned()) continue;
    entries[input] = {memberOf(json, "key"), json["lines"]};
  }
  return entries;
}

/// The complete lines of a report, by input.
std::map<std::string, std::string> linesOfInputs(const std::string& path) {
  std::map<std::string, std::string> linesOf;
  std::ifstream report(path);
  for (std::string line; std::getline(report, line);)
    if (const std::string input = memberOf(nlohmann::json::parse(line, nullptr, false), "input");
        !input.empty())
      linesOf[input] += line + "\n";
  return linesOf;
}

std::size_t countLines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

Failure unwritable(const std::string& path) {
  return {FailureCode::wrongUsage, path, "", "the file or folder cannot be written",
          "Pass an --out-dir that can be made or written to"};
}

}  // namespace

std::string resultKey(const std::string& input, const std::string& options) {
  std::error_code ignored;
  if (!fs::is_regular_file(input, ignored)) return "";  // a pipe would wait for its writer
  const auto bytes = readTextFile(input);
  if (!bytes) return "";
  return sha256Hex(sha256Hex(*bytes) + "\n" + version() + "\n" + options);
}

Result<BatchReport> BatchReport::open(const std::string& folder, const std::vector<std::string>& inputs,
                                      const std::function<std::string(const std::string&)>& keyOf,
                                      bool resume) {
  BatchReport report;
  report.path_ = (fs::path(folder) / "report.jsonl").string();
  const std::string journal = (fs::path(folder) / "report.done").string();
  if (resume) {
    const Journal entries = journalIn(journal);
    auto linesOf = linesOfInputs(report.path_);
    std::string lines, journalLines;
    for (const std::string& input : inputs) {
      const std::string written = asWritten(input);
      const auto known = entries.find(written);
      if (known == entries.end() || known->second.key.empty() || report.has(input)) continue;
      if (countLines(linesOf[written]) != known->second.lines || keyOf(input) != known->second.key) continue;
      report.done_.insert(input);
      journalLines += journalLine(input, known->second);
      lines += std::exchange(linesOf[written], "");
    }
    // The journal is shortened first, so that at every moment all inputs it names are in the report.
    if (!writeTextFileAtomically(journal, journalLines) || !writeTextFileAtomically(report.path_, lines))
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
  if (report_ << lines << std::flush && journal_ << journalLine(input, {key, countLines(lines)})
                                                 << std::flush) {
    size_ += lines.size();
    return Done{};
  }
  report_.close();
  std::error_code none;
  fs::resize_file(path_, size_, none);  // removes a partial line
  return Failure{FailureCode::internalFault,
                 path_,
                 "",
                 "the disk takes no more",
                 "Make room, then run it again with --resume",
                 "not_written"};
}

Result<Done> BatchReport::sortAs(const std::vector<std::string>& inputs) {
  if (done_.empty()) return Done{};  // already in order
  report_.close();
  auto linesOf = linesOfInputs(path_);
  std::string lines;
  for (const std::string& input : inputs) lines += std::exchange(linesOf[asWritten(input)], "");
  return writeTextFileAtomically(path_, lines);
}

}  // namespace detent::importer
