// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/word_match.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace detent::importer {
namespace {

bool isLetter(char c) { return c >= 'a' && c <= 'z'; }

}  // namespace

bool differByOneAtMost(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1) return false;
  std::size_t i = 0;
  while (i < a.size() && a[i] == b[i]) ++i;
  const std::string_view restA = a.substr(i), restB = b.substr(i);
  if (restB.empty()) return true;
  return a.size() == b.size() ? restA.substr(1) == restB.substr(1) : restA == restB.substr(1);
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
    if (differByOneAtMost(text.substr(from, to - from), word)) return true;
    from = to;
  }
  return false;
}

}  // namespace detent::importer
