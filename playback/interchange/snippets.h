// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Envelopes of levels as snippets of the DA728x's waveform memory: 100 bytes for all.
// docs/develop/decisions/0913-exporting-presses.md

#include <array>
#include <cstddef>
#include <vector>

namespace detent::playback {

inline constexpr std::size_t snippetMemoryBytes = 100;
inline constexpr int snippetLevels = 15;
inline constexpr double snippetCell_s = 0.00136;                 ///< the finest unit of time
inline constexpr std::array<int, 4> snippetUnits{1, 4, 16, 32};  ///< in cells, by the timebase's number

/// One byte: a level at once, or by a straight line from the last one.
struct SnippetPoint {
  bool ramp = false;
  int units = 1;  ///< of its snippet; 1..8
  int level = 0;  ///< 0..15
};

/// Points of one unit; played by one frame.
struct Snippet {
  std::size_t timebase = 0;
  std::vector<SnippetPoint> points;  ///< the first is no ramp
};

/// Envelope to be stored: a level per cell, 0..15, and the cells that begin a point of their own, rising.
struct LevelPath {
  std::vector<double> levels;
  std::vector<std::size_t> onsets;
};

/// The stored part of an envelope. It ends at level 0.
struct SnippetRow {
  std::vector<Snippet> snippets;  ///< at least one
  std::size_t held = 0;           ///< cells of the envelope; after them it is silent
  bool cut = false;               ///< the memory was full before the end
};

/// One row per envelope, by one price per byte for both: the lowest price at which they fit the memory
/// together, which comes near the least squared error. Every stored onset begins a point. If not even the
/// highest price fits, each envelope gets the share that the others leave, at least half, and is cut.
std::array<SnippetRow, 2> snippetsOf(const std::array<LevelPath, 2>& halves);

/// The memory: row 0 is sequence 0. Of rows that snippetsOf gave.
std::array<int, snippetMemoryBytes> memoryOf(const std::array<SnippetRow, 2>& rows);

}  // namespace detent::playback
