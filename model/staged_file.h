// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files that are complete or not there, for every writer of the product.

#include <filesystem>
#include <string>

#include "model/result.h"

namespace detent {

/// A file under a temporary name beside its target, which it replaces when it is committed; what is not committed goes.
/// Any thread; one at a time.
class StagedFile {
 public:
  /// Nothing is written yet. Failure wrongUsage: the target is a folder, no regular file, or lies in no folder.
  static Result<StagedFile> beside(const std::filesystem::path& target);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  /// Where to write: a name that no other writer has.
  const std::filesystem::path& path() const { return path_; }
  /// What it will be.
  const std::filesystem::path& target() const { return target_; }
  /// An existing target keeps its permissions, a symbolic link what it points to. A power cut leaves the target as it was or
  /// complete, and complete once this has returned. Failure internalFault: the disk refused, and the target is as it was.
  Result<Done> commit();
  /// Removes all that are open in this process: for the moment before it is ended by force. Any thread; does nothing where another
  /// one holds the list.
  static void removeAll();
  /// What to say of a target whose writing failed for `reason` (may be empty).
  Failure notWritten(const std::string& reason) const;

 private:
  StagedFile(std::filesystem::path target, std::filesystem::path path);
  static void forget(const std::filesystem::path& path);
  std::filesystem::path target_, path_;  // path_ empty: committed or moved from
};

}  // namespace detent
