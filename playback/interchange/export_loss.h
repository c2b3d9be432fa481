// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of a press that a format does not carry, reported with every export.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace detent::playback {

/// Bands in which fingers feel differently: slow indentation, flutter, the Pacinian band (Kim & Lee's jumps
/// lie in the last).
struct FeltBand {
  const char* name;  ///< as JSON spells it
  double low_Hz, high_Hz;
};
inline constexpr std::array<FeltBand, 3> feltBands{
    {{"20_80_Hz", 20, 80}, {"80_230_Hz", 80, 230}, {"230_500_Hz", 230, 500}}};

struct ExportLoss {
  /// Energy as played, per band, as a share of the engine's; above 1 where it came from another band. Empty:
  /// the engine has none there.
  std::array<std::optional<double>, feltBands.size()> energyKept;
  double worstTimingError_ms = 0;    ///< of jumps and bottom-outs
  std::size_t grainsMerged = 0;      ///< that are no events of their own any more
  double frequencyMoved_Hz = 0;      ///< at most
  bool cut = false;                  ///< the format has no room for the end of the press, or of its release
  std::vector<std::string> dropped;  ///< in words; where it is cut, too
};

/// Shares of energy of what is played against `original`, all at `sampleRate_Hz` and silent after their ends.
/// Parts that are played apart (a press and a release, each begun by itself) have each an energy of their
/// own.
std::array<std::optional<double>, feltBands.size()> energyKept(const std::vector<float>& original,
                                                               const std::vector<std::vector<double>>& parts,
                                                               double sampleRate_Hz);

/// The record as lines of text, without a comment's marks.
std::vector<std::string> linesOf(const ExportLoss& loss);

}  // namespace detent::playback
