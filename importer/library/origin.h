// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Author and licence of the measurements in a folder, as the folder itself states them.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace detent::importer {

/// Text of a row without a stated licence.
inline constexpr const char* noLicenceStated = "none stated";

struct Origin {
  std::string licence = noLicenceStated;
  std::string credit;  ///< "owner/name" of the clone the file stands in; empty where there is none
};

/// Searches licence files and clones, from a file's folder up to the root it was reached by. Remembers the
/// contents of each folder. One thread.
class Origins {
 public:
  /// Given values override; empty: found.
  Origins(std::string givenLicence, std::string givenCredit);
  Origin of(const std::filesystem::path& folder, const std::filesystem::path& root);

 private:
  Origin found(const std::filesystem::path& folder, const std::filesystem::path& root);
  std::string givenLicence_, givenCredit_;
  std::map<std::filesystem::path, Origin> seen_;
};

/// Name of a licence from its text. Its first line if the licence is not known; empty for an empty text.
std::string licenceNamed(std::string_view text);

/// "owner/name" from the first URL of a git configuration, without any password in it; empty if there is
/// none.
std::string creditFrom(std::string_view gitConfig);

}  // namespace detent::importer
