// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A recorded press of a real button: displacement and force over time.

#include <string>
#include <vector>

#include "model/result.h"

namespace detent::playback {

/// Samples in the order recorded; same length, times strictly increasing, all finite.
struct ForceRecord {
  std::vector<double> time_s, displacement_mm, force_N;
};

/// Reads `time_s,displacement_mm,force_N` (header required, columns in any order, more columns allowed; LF or
/// CRLF; blank lines and lines starting with # are skipped). Failure unreadableInput names the line.
Result<ForceRecord> readForceRecord(const std::string& file);
/// The same from text; `name` for messages.
Result<ForceRecord> parseForceRecord(const std::string& text, const std::string& name);

}  // namespace detent::playback
