// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Texts written under temporary names before the first one replaces its target.

#include <string>
#include <string_view>
#include <vector>

#include "model/staged_file.h"

namespace detent {

/// Written and closed, not committed. Failures: as of StagedFile.
Result<StagedFile> stagedText(const std::string& path, std::string_view text);

struct NamedText {
  std::string path, text;
};
/// Writes files that belong together: the first replaces its target after all are complete.
Result<Done> writeTextFilesAtomically(const std::vector<NamedText>& files);

}  // namespace detent
