// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/ratings.h"

#include <algorithm>
#include <optional>
#include <set>

#include "model/number_table.h"
#include "model/text.h"

namespace detent::importer {
namespace {

using Cells = std::vector<std::string>;

std::string oneLine(const std::string& cell) {
  std::string text;
  for (const char c : cell) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank)
      text += c;
    else if (!text.empty() && text.back() != ' ')
      text += ' ';
  }
  if (text.ends_with(' ')) text.pop_back();
  return text;
}

/// Lines of cells (RFC 4180): quotes hold commas, line ends and, doubled, quotes.
std::vector<Cells> cellsOf(std::string_view csv) {
  constexpr std::string_view mark("\xef\xbb\xbf");
  if (csv.starts_with(mark)) csv.remove_prefix(mark.size());
  std::vector<Cells> lines(1);
  std::string cell;
  bool quoted = false;
  const auto endCell = [&] { lines.back().push_back(oneLine(std::exchange(cell, {}))); };
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (quoted && c == '"' && i + 1 < csv.size() && csv[i + 1] == '"')
      cell += csv[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      endCell();
    else if (c == '\n' && !quoted)
      endCell(), lines.emplace_back();
    else
      cell += c;
  }
  endCell();
  return lines;
}

std::optional<std::size_t> columnOf(const Cells& headings, std::string_view name) {
  for (std::size_t i = 0; i < headings.size(); ++i)
    if (lowered(headings[i]) == name) return i;
  return {};
}

/// Words of a name: letters, digits and all non-ASCII characters; "switch" is left out because it
/// distinguishes nothing.
std::set<std::string> ratingWords(const std::string& name) {
  std::set<std::string> words;
  std::string word;
  for (const char c : lowered(name) + " ") {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || (c & 0x80) != 0;
    if (kept) word += c;
    if (kept || word.empty()) continue;
    if (word != "switch" && word != "switches") words.insert(word);
    word.clear();
  }
  return words;
}

std::string keyOf(const std::set<std::string>& words) {
  std::string key;
  for (const std::string& each : words) key.append(each).append(" ");
  return key;
}

/// The sets of words by which this switch may be named.
std::set<std::string> keysOf(const Rating& rating) {
  const std::set<std::string> own = ratingWords(rating.name);
  std::set<std::string> keys{keyOf(own)};
  std::string makers = rating.maker + "/";
  for (std::size_t slash = makers.find('/'); slash != std::string::npos; slash = makers.find('/')) {
    const std::set<std::string> maker = ratingWords(makers.substr(0, slash));
    makers.erase(0, slash + 1);
    std::set<std::string> with = own, without;
    with.insert(maker.begin(), maker.end());
    keys.insert(keyOf(with));
    std::ranges::set_difference(own, maker, std::inserter(without, without.end()));
    if (without.size() >= 2) keys.insert(keyOf(without));
  }
  keys.erase("");
  return keys;
}

}  // namespace

std::vector<Rating> ratingsIn(std::string_view csv) {
  const std::vector<Cells> lines = cellsOf(csv);
  const auto head = std::ranges::find_if(
      lines, [](const Cells& each) { return columnOf(each, "switch name") && columnOf(each, "push feel"); });
  if (head == lines.end()) return {};
  const std::size_t name = *columnOf(*head, "switch name");
  const auto maker = columnOf(*head, "manufacturer");
  std::size_t end = name + 1;
  while (end < head->size() && !(*head)[end].empty()) ++end;
  std::vector<Rating> all;
  for (auto line = head + 1; line != lines.end(); ++line) {
    if (line->size() <= name || (*line)[name].empty()) continue;
    Rating rating;
    rating.name = (*line)[name];
    if (maker && *maker < line->size()) rating.maker = (*line)[*maker];
    for (std::size_t i = name + 1; i < std::min(end, line->size()); ++i)
      if (const auto score = finiteNumberFrom((*line)[i])) rating.scores.emplace_back((*head)[i], *score);
    if (!rating.scores.empty()) all.push_back(std::move(rating));
  }
  return all;
}

std::string ratingWords(const Rating& rating) {
  std::string words =
      (rating.credit.empty() ? "credit unknown" : rating.credit) + " of \"" + rating.name + "\":";
  for (const auto& [what, score] : rating.scores)
    words.append(&what == &rating.scores.front().first ? " " : ", ")
        .append(what)
        .append(" ")
        .append(shortestText(score));
  return words;
}

RatingsByName::RatingsByName(const std::vector<Rating>& all) {
  for (const Rating& each : all)
    for (const std::string& key : keysOf(each)) byWords_[key].push_back(each);
}

std::vector<Rating> RatingsByName::of(const std::string& switchName) const {
  const auto at = byWords_.find(keyOf(ratingWords(switchName)));
  if (at == byWords_.end()) return {};
  std::vector<Rating> most;
  for (const Rating& each : at->second) {
    const auto same = std::ranges::find_if(most, [&](const Rating& other) {
      return other.credit == each.credit && other.name == each.name && other.maker == each.maker;
    });
    if (same == most.end())
      most.push_back(each);
    else if (each.scores.size() > same->scores.size())
      *same = each;
  }
  return most;
}

}  // namespace detent::importer
