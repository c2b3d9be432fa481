// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A signal that another program made, to be felt for comparison with a button. It never becomes a button,
// because no such file states the force or displacement of what is felt (docs/reference/export-formats.md:
// how each is played).

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/message.h"
#include "model/named_values.h"
#include "model/result.h"

namespace detent::playback {

enum class ReferenceFormat : std::uint8_t {
  ahap,    ///< Apple, version 1
  haptic,  ///< Lofelt and Meta, version 1
  hjif,    ///< ISO/IEC 23090-31
  sound    ///< WAV, FLAC and other files that libsndfile reads
};

inline constexpr auto referenceFormats = named<ReferenceFormat>({{"ahap", ReferenceFormat::ahap},
                                                                 {"haptic", ReferenceFormat::haptic},
                                                                 {"hjif", ReferenceFormat::hjif},
                                                                 {"sound", ReferenceFormat::sound}});

/// Sample rate of every reference: every format is played at this rate.
inline constexpr double referenceRate_Hz = 48000;
/// Longest reference, in seconds.
inline constexpr double longestReference_s = 120;

struct ReferenceSignal {
  ReferenceFormat format = ReferenceFormat::sound;
  std::vector<float> samples;  ///< at referenceRate_Hz, within [-1, 1]; at least one
  double peak = 0;             ///< largest |sample|
  std::size_t events = 0;      ///< number of events in the file; 0 for sound
  std::vector<Message> notes;  ///< parts of the file that are not played, or are played differently

  double duration_s() const { return static_cast<double>(samples.size()) / referenceRate_Hz; }
};

/// Reads a file by its content, not its ending. Failure unreadableInput names the file, the place in it and
/// the fault: cut off, another version, invalid numbers, longer than `longestReference_s`. Any thread;
/// allocates; at most some 100 ms.
Result<ReferenceSignal> readReference(const std::filesystem::path& file);

/// The same for a text that is JSON of one of the formats; `name` is its name in a Failure.
Result<ReferenceSignal> referenceFromText(std::string_view text, const std::string& name);

}  // namespace detent::playback
