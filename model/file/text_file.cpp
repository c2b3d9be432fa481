// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/text_file.h"

#include <filesystem>

#include "model/file/c_file.h"
#include "model/file/staged_text.h"

namespace detent {
namespace {

namespace fs = std::filesystem;

Failure unreadable(const std::string& path, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, path, "", std::move(problem), std::move(remedies)};
}

}  // namespace

Result<std::string> readTextFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    return unreadable(path, "the file does not exist", "Check the name and the folder");
  if (fs::is_directory(status))
    return unreadable(path, "this is a folder, not a file", "Choose a file in this folder");
  if (fs::is_regular_file(status) && fs::file_size(path, error) > maxTextFileBytes)
    return unreadable(path, "the file is larger than " + std::to_string(maxTextFileBytes >> 20) + " MiB",
                      "Give a button file or a CSV of one force graph");
  errno = 0;
  const CFile file(std::fopen(path.c_str(), "rb"));
  if (!file)
    return unreadable(path, "the file cannot be opened: " + systemReason(),
                      "Check the permissions of the file");
  std::string text;
  char buffer[65536];
  for (std::size_t got; (got = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;) {
    text.append(buffer, got);
    if (text.size() > maxTextFileBytes)
      return unreadable(path, "the file is larger than " + std::to_string(maxTextFileBytes >> 20) + " MiB",
                        "Give a button file or a CSV of one force graph");
  }
  if (std::ferror(file.get()))
    return unreadable(path, "the file cannot be read: " + systemReason(), "Check the disk");
  return text;
}

Result<Done> writeTextFileAtomically(const std::string& path, std::string_view text) {
  auto file = stagedText(path, text);
  return file ? file->commit() : file.failure();
}

}  // namespace detent
