// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/switch_name.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "model/text.h"

namespace detent::importer {
namespace {

/// Words that laboratories add to the name of a switch to describe the file.
constexpr std::array<std::string_view, 17> fileWords{
    "raw",     "data", "csv",        "ods",     "json",  "truth",  "curve",  "force", "log",
    "datalog", "high", "resolution", "highres", "hires", "button", "output", "result"};
constexpr std::array<std::string_view, 2> unitWords{"sample", "unit"};
constexpr std::array<std::string_view, 4> runWords{"measurement", "run", "datalog", "repeat"};

template <std::size_t count>
bool among(const std::array<std::string_view, count>& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

std::vector<std::string> nameWords(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text) {
    if (isBlank(c) || c == '_' || c == '-') {
      if (!word.empty()) words.push_back(std::move(word));
      word.clear();
    } else {
      word += c;
    }
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

/// A short mark that distinguishes units: "2", "B", "01".
bool isMark(const std::string& word) {
  const bool digits = std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
  return (digits && word.size() <= 3) ||
         (word.size() == 1 && ((word[0] >= 'a' && word[0] <= 'z') || (word[0] >= 'A' && word[0] <= 'Z')));
}

/// Removes "sample 2" from the words, anywhere behind the first word, and returns the mark.
template <std::size_t count>
std::string takeMark(std::vector<std::string>& words, const std::array<std::string_view, count>& kinds) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (!among(kinds, lowered(words[i])) || !isMark(words[i + 1])) continue;
    std::string mark = words[i + 1];
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                words.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    return mark;
  }
  return {};
}

/// "Sony_BKE_Gray_02": unit 02. The number must begin with a zero.
std::string takeNumberedUnit(std::vector<std::string>& words) {
  if (words.size() < 2 || words.back().size() != 2 || words.back()[0] != '0' || !isMark(words.back()))
    return {};
  std::string mark = std::move(words.back());
  words.pop_back();
  return mark;
}

/// "Clickiez 2" in a folder "Clickiez": unit 2 of the switch that the folder names.
std::string takeUnitOfFolder(std::vector<std::string>& words, const std::vector<std::string>& folder) {
  if (folder.empty() || words.size() != folder.size() + 1 || !isMark(words.back())) return {};
  const auto same = [](const std::string& a, const std::string& b) { return lowered(a) == lowered(b); };
  if (!std::equal(folder.begin(), folder.end(), words.begin(), same)) return {};
  std::string mark = std::move(words.back());
  words.pop_back();
  return mark;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// Removes words at the end that only describe the kind of file.
void dropFileWords(std::vector<std::string>& words) {
  while (!words.empty() && among(fileWords, lowered(words.back()))) words.pop_back();
}

/// "Maker Model__Maker Model Raw Data CSV": the last part names the switch.
std::string_view lastPart(std::string_view stem) {
  const std::size_t at = stem.rfind("__");
  return at == std::string_view::npos || at + 2 == stem.size() ? stem : stem.substr(at + 2);
}

/// The part before the last one, or the folder: "Maker Model".
std::string folderPart(std::string_view stem, const std::filesystem::path& path) {
  const std::size_t at = stem.rfind("__");
  return at == std::string_view::npos ? path.parent_path().filename().string()
                                      : std::string(stem.substr(0, at));
}

std::string stemOf(const std::filesystem::path& path) {
  std::string stem = path.stem().string();
  if (lowered(path.filename().string()).ends_with(".button.json"))
    stem = std::filesystem::path(stem).stem().string();
  return stem;
}

}  // namespace

SwitchName switchNameFrom(const std::filesystem::path& path) {
  SwitchName is;
  const std::string stem = stemOf(path);
  std::vector<std::string> words = nameWords(lastPart(stem));
  dropFileWords(words);
  is.run = takeMark(words, runWords);
  is.unit = takeMark(words, unitWords);
  dropFileWords(words);
  const std::vector<std::string> folder = nameWords(folderPart(stem, path));
  if (words.empty()) {
    words = nameWords(path.parent_path().filename().string());
    is.unit = is.unit.empty() ? takeMark(words, unitWords) : is.unit;
  }
  if (is.unit.empty()) is.unit = takeUnitOfFolder(words, folder);
  if (is.unit.empty()) is.unit = takeNumberedUnit(words);
  is.name = joined(words);
  if (is.name.empty()) is.name = stem.empty() ? path.filename().string() : stem;
  return is;
}

}  // namespace detent::importer
