// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Combines records of one button, pressed at different speeds, into one button with a graph for each speed.

#include <string>
#include <vector>

#include "importer/importer.h"

namespace detent::importer {

/// Remarks about such records. They are reported; none is a reason to refuse.
enum class FamilyDoubt {
  speedsClose,  ///< two speeds are so close that the difference of their graphs may be noise
  pressUneven,  ///< one half of the press was much faster than the other, so the graph has no single speed
  /// the release was much faster or slower than the press; the graph is listed under the press's speed
  releaseApart,
};
/// "speeds-close".
const char* nameOf(FamilyDoubt doubt);

struct FamilyRecord {
  std::string input;
  double speed_mm_per_s = 0;  ///< speed of the press
  std::optional<double> releaseSpeed_mm_per_s;
  double confidence = 0;
};

struct Family {
  Button button;
  std::vector<FamilyRecord> records;                        ///< as given
  std::vector<std::pair<FamilyDoubt, std::string>> doubts;  ///< with their sentences
};

/// Failures: those of an import; unreadableInput for a record without times; wrongUsage for a file that is no
/// record, for fewer than two speeds and for more than four records; a broken rule of Button.
Result<Family> importFamily(const std::vector<std::string>& inputs, const ImportRequest& request,
                            const Progress& progress);

/// One object: status, output, records, warnings, warning_codes.
std::string familyJson(const Family& family, const std::string& output);
std::string familyText(const Family& family, const std::string& output);

}  // namespace detent::importer
