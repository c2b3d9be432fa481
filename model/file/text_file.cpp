// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/text_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "model/staged_file.h"

namespace detent {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Failure unreadable(const std::string& path, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, path, "", std::move(problem), std::move(remedies)};
}

std::string systemReason() { return std::strerror(errno); }

std::string writeAll(const fs::path& path, std::string_view text) {
  errno = 0;
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "wbx"));
  if (!file) return systemReason();
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  const bool flushed = std::fflush(file.get()) == 0 && std::ferror(file.get()) == 0;
  std::string reason = written && flushed ? "" : systemReason();
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
  auto staged = StagedFile::beside(path);
  if (!staged) return staged.failure();
  if (const std::string reason = writeAll(staged->path(), text); !reason.empty())
    return staged->notWritten(reason);
  return staged->commit();
}

}  // namespace detent
