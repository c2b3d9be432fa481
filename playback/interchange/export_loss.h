// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of a press that a format does not carry, reported with every export.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace detent::playback {

/// Frequency bands that fingers feel differently: slow indentation, flutter, the Pacinian band (which
/// contains Kim & Lee's jumps).
struct FeltBand {
  const char* name;  ///< name in JSON
  double low_Hz, high_Hz;
};
inline constexpr std::array<FeltBand, 3> feltBands{
    {{"20_80_Hz", 20, 80}, {"80_230_Hz", 80, 230}, {"230_500_Hz", 230, 500}}};

struct ExportLoss {
  /// Energy as played, per band, as a share of the engine's; above 1 if energy moved there from another band.
  /// Empty: the engine has no energy there.
  std::array<std::optional<double>, feltBands.size()> energyKept;
  double worstTimingError_ms = 0;    ///< largest error of jumps and bottom-outs
  std::size_t grainsMerged = 0;      ///< grains that are no separate events any more
  double frequencyMoved_Hz = 0;      ///< largest shift of a frequency
  bool cut = false;                  ///< the format cannot hold the end of the press, or of its release
  std::vector<std::string> dropped;  ///< as sentences, including the cut
};

/// Shares of the energy of `original` that is played, per band, all at `sampleRate_Hz` and silent after their
/// ends. For parts that are started separately (press and release), the energies are added.
std::array<std::optional<double>, feltBands.size()> energyKept(const std::vector<float>& original,
                                                               const std::vector<std::vector<double>>& parts,
                                                               double sampleRate_Hz);

/// The record as lines of text, without a comment's marks.
std::vector<std::string> linesOf(const ExportLoss& loss);

}  // namespace detent::playback
