// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/snippets.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

using namespace detent::playback;

namespace {

using Paths = std::array<LevelPath, 2>;

struct Played {
  std::vector<double> levels;      // in the middle of every cell
  std::vector<std::size_t> begun;  // cells at which a point that is no ramp begins
};

/// Contents of the memory, read by its pointers.
std::array<Played, 2> playedSnippets(const std::array<int, snippetMemoryBytes>& memory) {
  const auto at = [&](std::size_t i) { return static_cast<std::size_t>(memory.at(i)); };
  const std::size_t snippets = at(0), sequences = at(1), begin = 2 + snippets + sequences;
  REQUIRE(snippets <= 15);
  REQUIRE(sequences == 2);
  std::array<Played, 2> played;
  for (std::size_t k = 0; k < 2; ++k) {
    double last = 0;
    for (std::size_t i = at(1 + snippets + k) + 1; i <= at(2 + snippets + k); ++i) {
      std::size_t number = at(i) & 7U;
      const std::size_t unit = std::array<std::size_t, 4>{1, 4, 16, 32}.at(at(i) >> 3U & 3U);
      if (i < at(2 + snippets + k) && (at(i + 1) & 0x80U) != 0) number += (at(++i) & 1U) << 3U;
      REQUIRE((number >= 1 && number <= snippets));
      for (std::size_t p = number == 1 ? begin : at(number) + 1; p <= at(1 + number); ++p) {
        const std::size_t cells = unit * ((at(p) >> 4U & 7U) + 1);
        const bool ramp = (at(p) & 0x80U) != 0;
        const double level = static_cast<double>(at(p) & 15U);
        if (!ramp) played[k].begun.push_back(played[k].levels.size());
        for (std::size_t c = 0; c < cells; ++c)
          played[k].levels.push_back(ramp ? last + (level - last) * (static_cast<double>(c) + 0.5) /
                                                       static_cast<double>(cells)
                                          : level);
        last = level;
      }
    }
    CHECK(last == 0);
  }
  return played;
}

/// A path like that of presses: a slowly varying level with bursts that decay, at random places.
LevelPath drawn(std::mt19937& bits, std::size_t cells, std::size_t bursts) {
  LevelPath path{std::vector<double>(cells, 0), {}};
  for (std::size_t i = 0; i < cells; ++i) path.levels[i] = 2 + 1.5 * std::sin(static_cast<double>(i) / 40);
  for (std::size_t b = 0; b < bursts; ++b) path.onsets.push_back(bits() % cells);
  std::ranges::sort(path.onsets);
  for (const std::size_t onset : path.onsets)
    for (std::size_t i = onset; i < std::min(cells, onset + 28); ++i)
      path.levels[i] = std::max(path.levels[i], 14 - 0.5 * static_cast<double>(i - onset));
  return path;
}

}  // namespace

TEST_CASE("The memory holds whole snippets, in time and near the levels") {
  std::mt19937 bits(7);
  int cut = 0;
  for (const std::size_t cells : {1U, 30U, 220U, 1500U, 8000U}) {
    for (const std::size_t bursts : {0U, 1U, 3U, 40U}) {
      INFO(cells << " cells, " << bursts << " bursts");
      const Paths paths{drawn(bits, cells, bursts), drawn(bits, cells / 2 + 1, bursts / 2)};
      const auto rows = snippetsOf(paths);
      const auto found = playedSnippets(memoryOf(rows));
      for (std::size_t k = 0; k < 2; ++k) {
        CHECK(rows[k].held <= found[k].levels.size());
        CHECK(rows[k].cut == (rows[k].held < paths[k].levels.size()));
        cut += rows[k].cut ? 1 : 0;
        for (const std::size_t onset : paths[k].onsets)
          if (onset < rows[k].held) CHECK(std::ranges::binary_search(found[k].begun, onset));
        if (bursts > 3 || cells > 1500) continue;
        double squares = 0;
        for (std::size_t i = 0; i < paths[k].levels.size(); ++i)
          squares += std::pow(found[k].levels.at(i) - paths[k].levels[i], 2);
        CHECK(std::sqrt(squares / static_cast<double>(paths[k].levels.size())) < 0.6);
      }
      if (bursts <= 3) CHECK_FALSE((rows[0].cut || rows[1].cut));
    }
  }
  CHECK(cut > 0);
}

TEST_CASE("One envelope takes the memory that the other leaves; an empty one is one silent point") {
  std::mt19937 bits(8);
  const LevelPath busy = drawn(bits, 600, 20);
  const auto alone = snippetsOf({busy, {}});
  CHECK_FALSE(alone[0].cut);
  REQUIRE(alone[1].snippets.size() == 1);
  const auto twice = snippetsOf({busy, busy});
  CHECK((twice[0].cut && twice[1].cut));
  CHECK(twice[0].held > 100);
  playedSnippets(memoryOf(twice));
}
