// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/staged_outputs.h"

#include "model/file/staged_text.h"

namespace detent::importer {

Result<Done> StagedOutputs::stage(const std::string& path, std::string_view bytes) {
  auto file = stagedText(path, bytes);
  if (!file) return file.failure();
  files_.push_back(*std::move(file));
  paths_.push_back(path);
  return Done{};
}

Result<Done> StagedOutputs::commit() {
  for (StagedFile& file : files_)
    if (auto done = file.commit(); !done) return done;
  return Done{};
}

}  // namespace detent::importer
