// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/staged_outputs.h"

#include <fstream>

namespace detent::importer {

Result<Done> StagedOutputs::stage(const std::string& path, std::string_view bytes) {
  auto file = StagedFile::beside(path);
  if (!file) return file.failure();
  files_.push_back(*std::move(file));
  paths_.push_back(path);
  std::ofstream out(files_.back().path(), std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  return out ? Result<Done>(Done{}) : files_.back().notWritten("no permission or no space");
}

Result<Done> StagedOutputs::commit() {
  for (StagedFile& file : files_)
    if (auto done = file.commit(); !done) return done;
  return Done{};
}

}  // namespace detent::importer
