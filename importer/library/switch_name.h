// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Name of a measured file: the switch, and its unit and run.

#include <filesystem>
#include <string>

namespace detent::importer {

/// "JWK-Bouquet-Sample-2-Measurement-1.ods" is run 1 of unit "2" of "JWK Bouquet".
struct SwitchName {
  std::string name;  ///< never empty; words as the file has them
  std::string unit;  ///< "2", "B"; empty where the name says none
  std::string run;   ///< likewise
  bool operator==(const SwitchName&) const = default;
};

/// Name from the file's name. Words that only describe the kind of file ("Raw Data CSV", "truth") are no
/// name: if nothing else is left, the folder's name is the switch's. Any thread.
SwitchName switchNameFrom(const std::filesystem::path& path);

}  // namespace detent::importer
