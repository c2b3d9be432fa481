// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/word_match.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace detent::importer {
namespace {

bool isLetter(char c) { return c >= 'a' && c <= 'z'; }

}  // namespace

std::size_t editsBetween(std::string_view a, std::string_view b, std::size_t most) {
  if (a.size() > b.size() + most || b.size() > a.size() + most) return most + 1;
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return std::min(row.back(), most + 1);
}

bool mentions(std::string_view text, std::string_view word) {
  constexpr std::size_t longEnough = 5;
  if (text.find(word) != std::string_view::npos) return true;
  if (word.size() < longEnough || !std::all_of(word.begin(), word.end(), isLetter)) return false;
  for (std::size_t from = 0; from < text.size();) {
    if (!isLetter(text[from])) {
      ++from;
      continue;
    }
    std::size_t to = from;
    while (to < text.size() && isLetter(text[to])) ++to;
    if (editsBetween(text.substr(from, to - from), word, 1) <= 1) return true;
    from = to;
  }
  return false;
}

}  // namespace detent::importer
