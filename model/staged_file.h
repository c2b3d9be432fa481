// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files that are either complete or absent, for every writer.

#include <filesystem>
#include <string>

#include "model/result.h"

namespace detent {

/// A file under a temporary name beside its target, which it replaces on commit; removed if not committed.
/// Any thread; one thread at a time.
class StagedFile {
 public:
  /// Creates it without writing. Failure wrongUsage: the target is a folder, no regular file, or in no
  /// folder.
  static Result<StagedFile> beside(const std::filesystem::path& target);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  /// Path to write to; unique.
  const std::filesystem::path& path() const { return path_; }
  /// Path after commit.
  const std::filesystem::path& target() const { return target_; }
  /// Replaces the target. An existing target keeps its permissions, a symbolic link its target. After a power
  /// cut the target is unchanged or complete, and complete once this has returned. Failure internalFault: the
  /// disk refused; the target is unchanged.
  Result<Done> commit();
  /// Removes all uncommitted files of this process before it is ended by force. Any thread; does nothing if
  /// another thread holds the list.
  static void removeAll();
  /// Failure for a target that could not be written for `reason` (may be empty).
  Failure notWritten(const std::string& reason) const;

 private:
  StagedFile(std::filesystem::path target, std::filesystem::path path);
  static void forget(const std::filesystem::path& path);
  std::filesystem::path target_, path_;  // path_ empty: committed or moved from
};

}  // namespace detent
