// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/text_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>

namespace detent {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Failure unreadable(const std::string& path, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, path, "", std::move(problem), std::move(remedies)};
}

Failure notWritten(const std::string& path, FailureCode code, Message problem, Remedies remedies) {
  return {code, path, "", Message("cannot be written: %1", std::move(problem)), std::move(remedies)};
}

std::string systemReason() { return std::strerror(errno); }

// A name no other writer uses; short, so that a long target name does not make it too long.
fs::path temporaryBeside(const fs::path& target) {
  std::random_device random;
  char name[48];
  std::snprintf(name, sizeof name, ".detent-%08x%08x.tmp", random(), random());
  return target.parent_path() / name;
}

// The file a path finally stands for.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

std::string writeAll(const fs::path& path, std::string_view text) {
  errno = 0;
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "wbx"));
  if (!file) return systemReason();
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  const bool flushed = std::fflush(file.get()) == 0 && std::ferror(file.get()) == 0;
  const std::string reason = written && flushed ? "" : systemReason();
  const bool closed = std::fclose(file.release()) == 0;
  if (!reason.empty()) return reason;
  return closed ? "" : systemReason();
}

}  // namespace

Result<std::string> readTextFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return unreadable(path, "does not exist", "Check the name and the folder");
  if (fs::is_directory(status)) return unreadable(path, "is a folder", "Name a file");
  if (fs::is_regular_file(status) && fs::file_size(path, error) > maxTextFileBytes)
    return unreadable(path, "is larger than " + std::to_string(maxTextFileBytes >> 20) + " MiB",
                      "Give a button file or a CSV of one force graph");
  errno = 0;
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) return unreadable(path, "cannot be opened: " + systemReason(), "Check its permissions");
  std::string text;
  char buffer[65536];
  for (std::size_t got; (got = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;) {
    text.append(buffer, got);
    if (text.size() > maxTextFileBytes)
      return unreadable(path, "is larger than " + std::to_string(maxTextFileBytes >> 20) + " MiB",
                        "Give a button file or a CSV of one force graph");
  }
  if (std::ferror(file.get())) return unreadable(path, "cannot be read: " + systemReason(), "Check the disk");
  return text;
}

Result<Done> writeTextFileAtomically(const std::string& path, std::string_view text) {
  std::error_code error;
  const fs::path target = resolved(path);
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status))
    return notWritten(path, FailureCode::wrongUsage, "it is a folder", "Name a file inside it");
  if (fs::exists(status) && !fs::is_regular_file(status))
    return notWritten(path, FailureCode::wrongUsage, "it is not a regular file", "Name a file");
  const fs::path folder = target.parent_path().empty() ? fs::path(".") : target.parent_path();
  if (!fs::is_directory(folder, error))
    return notWritten(path, FailureCode::wrongUsage, "its folder does not exist", "Create the folder first");
  const fs::path temporary = temporaryBeside(target);
  if (const std::string reason = writeAll(temporary, text); !reason.empty()) {
    fs::remove(temporary, error);
    return notWritten(path, FailureCode::internalFault, reason,
                      "Check the folder's permissions and free space");
  }
  if (fs::exists(status)) fs::permissions(temporary, status.permissions(), error);
  fs::rename(temporary, target, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    return notWritten(path, FailureCode::internalFault, reason,
                      "Check the folder's permissions and free space");
  }
  return Done{};
}

}  // namespace detent
