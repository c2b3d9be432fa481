// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Records of one button, pressed at different speeds, as one button with a graph at each speed.

#include <string>
#include <vector>

#include "importer/importer.h"

namespace detent::importer {

/// Remarks on such records; each is reported, none is a reason to refuse.
enum class FamilyDoubt {
  speedsClose,   ///< two speeds so close that noise may be all their graphs differ by
  pressUneven,   ///< one half of the press was much faster than the other: the graph is not of one speed
  releaseApart,  ///< the release was much faster or slower than the press, and stands at the press' speed
};
/// "speeds-close".
const char* nameOf(FamilyDoubt doubt);

struct FamilyRecord {
  std::string input;
  double speed_mm_per_s = 0;  ///< of the press
  std::optional<double> releaseSpeed_mm_per_s;
  double confidence = 0;
};

struct Family {
  Button button;
  std::vector<FamilyRecord> records;                        ///< as given
  std::vector<std::pair<FamilyDoubt, std::string>> doubts;  ///< with their sentences
};

/// Failures: those of an import; unreadableInput for a record without times; wrongUsage for what is no
/// record, for fewer than two speeds, and for more than four records; a broken rule of Button.
Result<Family> importFamily(const std::vector<std::string>& inputs, const ImportRequest& request,
                            const Progress& progress);

/// One object: status, output, records, warnings, warning_codes.
std::string familyJson(const Family& family, const std::string& output);
std::string familyText(const Family& family, const std::string& output);

}  // namespace detent::importer
