// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/staged_outputs.h"

#include <fstream>
#include <system_error>

namespace detent::importer {
namespace {

namespace fs = std::filesystem;

Failure cannotWrite(const std::string& path, const std::string& why) {
  return {FailureCode::wrongUsage, path, "", "cannot be written (" + why + ")",
          "Pass a path in a folder that exists and can be written to"};
}

}  // namespace

StagedOutputs::~StagedOutputs() {
  for (const File& file : files_) {
    std::error_code ignored;
    if (!file.staged.empty()) fs::remove(file.staged, ignored);
  }
}

Result<Done> StagedOutputs::stage(const std::string& path, std::string_view bytes) {
  std::error_code error;
  const fs::path target(path);
  if (fs::is_directory(target, error)) return cannotWrite(path, "it is a folder");
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    return cannotWrite(path, "folder " + folder.string() + " does not exist");
  fs::path staged = target;
  staged += ".part";
  files_.push_back({staged, target});
  std::ofstream out(staged, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) return cannotWrite(path, "no permission or no space");
  return Done{};
}

Result<Done> StagedOutputs::commit() {
  for (File& file : files_) {
    std::error_code error;
    fs::rename(file.staged, file.final, error);
    if (error) return cannotWrite(file.final.string(), error.message());
    file.staged.clear();
  }
  return Done{};
}

std::vector<std::string> StagedOutputs::paths() const {
  std::vector<std::string> all;
  for (const File& file : files_) all.push_back(file.final.string());
  return all;
}

}  // namespace detent::importer
