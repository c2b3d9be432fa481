// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Texts that are complete under temporary names before one of them takes its place.

#include <string>
#include <string_view>
#include <vector>

#include "model/staged_file.h"

namespace detent {

/// Written and closed, not committed. Failures as StagedFile's.
Result<StagedFile> stagedText(const std::string& path, std::string_view text);

struct NamedText {
  std::string path, text;
};
/// Files that belong together: the first takes its place when the last is complete beside its own.
Result<Done> writeTextFilesAtomically(const std::vector<NamedText>& files);

}  // namespace detent
