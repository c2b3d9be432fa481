// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/staged_file.h"

#include <cstdio>
#include <mutex>
#include <random>
#include <set>
#include <utility>

#include "model/disk.h"

namespace detent {
namespace {

namespace fs = std::filesystem;

std::mutex listMutex;

std::set<fs::path>& openFiles() {
  static std::set<fs::path> files;
  return files;
}

// Returns the file that a path resolves to.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

// Short, so that a long target name stays within the limit.
fs::path temporaryBeside(const fs::path& target) {
  std::random_device random;
  char name[48];
  std::snprintf(name, sizeof name, ".detent-%08x%08x.tmp", random(), random());
  return target.parent_path() / name;
}

Failure refused(const fs::path& target, const Message& problem, const Message& remedy) {
  return {FailureCode::wrongUsage, target.string(), "", Message("the file cannot be written: %1", problem),
          remedy};
}

}  // namespace

StagedFile::StagedFile(fs::path target, fs::path path) : target_(std::move(target)), path_(std::move(path)) {
  const std::lock_guard lock(listMutex);
  openFiles().insert(path_);
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)), path_(std::exchange(other.path_, {})) {}

StagedFile::~StagedFile() {
  if (path_.empty()) return;
  std::error_code ignored;
  fs::remove(path_, ignored);
  forget(path_);
}

void StagedFile::forget(const fs::path& path) {
  const std::lock_guard lock(listMutex);
  openFiles().erase(path);
}

void StagedFile::removeAll() {
  const std::unique_lock lock(listMutex, std::try_to_lock);
  if (!lock) return;
  std::error_code ignored;
  for (const fs::path& file : openFiles()) fs::remove(file, ignored);
}

Result<StagedFile> StagedFile::beside(const fs::path& target) {
  std::error_code error;
  const fs::path file = resolved(target);
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status))
    return refused(target, Message("this is a folder, not a file"),
                   Message("Name a file inside this folder"));
  if (fs::exists(status) && !fs::is_regular_file(status))
    return refused(target, Message("this is not an ordinary file"), Message("Name an ordinary file"));
  const fs::path folder = file.parent_path().empty() ? fs::path(".") : file.parent_path();
  if (!fs::is_directory(folder, error))
    return refused(target, Message("the folder of the file does not exist"),
                   Message("Create the folder first"));
  return StagedFile(file, temporaryBeside(file));
}

Result<Done> StagedFile::commit() {
  std::error_code error;
  const fs::file_status status = fs::status(target_, error);
  if (fs::exists(status)) fs::permissions(path_, status.permissions(), error);
  // Otherwise the name could reach the disk before the contents, and a power cut would leave an empty file.
  if (const std::error_code refused = writeToDisk(path_)) return notWritten(refused.message());
  fs::rename(path_, target_, error);
  if (error) return notWritten(error.message());
  writeFolderToDisk(target_);
  forget(path_);
  path_.clear();
  return Done{};
}

Failure StagedFile::notWritten(const std::string& reason) const {
  return {FailureCode::internalFault,
          target_.string(),
          "",
          reason.empty() ? Message("the file cannot be written")
                         : Message("the file cannot be written: %1", reason),
          Message("Check the folder's permissions and free space"),
          "not_written"};
}

}  // namespace detent
