// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Level envelopes as snippets in the DA728x's waveform memory, which has 100 bytes for all.
// docs/develop/decisions/0913-exporting-presses.md

#include <array>
#include <cstddef>
#include <vector>

namespace detent::playback {

inline constexpr std::size_t snippetMemoryBytes = 100;
inline constexpr int snippetLevels = 15;
inline constexpr double snippetCell_s = 0.00136;                 ///< the finest unit of time
inline constexpr std::array<int, 4> snippetUnits{1, 4, 16, 32};  ///< in cells, by the timebase's number

/// One byte: a level reached at once, or by a linear ramp from the previous one.
struct SnippetPoint {
  bool ramp = false;
  int units = 1;  ///< duration in units of its snippet; 1..8
  int level = 0;  ///< 0..15
};

/// Points with a common time unit, played by one frame.
struct Snippet {
  std::size_t timebase = 0;
  std::vector<SnippetPoint> points;  ///< the first point is not a ramp
};

/// Envelope to be stored: one level per cell, 0..15, and the cells that must begin a new point, ascending.
struct LevelPath {
  std::vector<double> levels;
  std::vector<std::size_t> onsets;
};

/// The part of an envelope that is stored. It ends at level 0.
struct SnippetRow {
  std::vector<Snippet> snippets;  ///< at least one
  std::size_t held = 0;           ///< number of stored cells; after them the envelope is silent
  bool cut = false;               ///< the memory was full before the end
};

/// One row per envelope. Both are reduced with one common price per byte, the lowest at which they fit the
/// memory together, which comes close to the least squared error. Every stored onset begins a point. If they
/// do not fit even at the highest price, each envelope gets the share that the other leaves, at least half,
/// and is cut.
std::array<SnippetRow, 2> snippetsOf(const std::array<LevelPath, 2>& halves);

/// The contents of the memory for rows that snippetsOf returned; row 0 is sequence 0.
std::array<int, snippetMemoryBytes> memoryOf(const std::array<SnippetRow, 2>& rows);

}  // namespace detent::playback
