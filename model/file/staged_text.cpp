// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/staged_text.h"

#include "model/file/c_file.h"

namespace detent {
namespace {

std::string writeAll(const std::filesystem::path& path, std::string_view text) {
  errno = 0;
  CFile file(std::fopen(path.c_str(), "wbx"));
  if (!file) return systemReason();
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  const bool flushed = std::fflush(file.get()) == 0 && std::ferror(file.get()) == 0;
  std::string reason = written && flushed ? "" : systemReason();
  const bool closed = std::fclose(file.release()) == 0;
  if (!reason.empty()) return reason;
  return closed ? "" : systemReason();
}

}  // namespace

Result<StagedFile> stagedText(const std::string& path, std::string_view text) {
  auto file = StagedFile::beside(path);
  if (!file) return file;
  if (const std::string reason = writeAll(file->path(), text); !reason.empty())
    return file->notWritten(reason);
  return file;
}

Result<Done> writeTextFilesAtomically(const std::vector<NamedText>& files) {
  std::vector<StagedFile> complete;
  for (const NamedText& each : files) {
    auto file = stagedText(each.path, each.text);
    if (!file) return file.failure();
    complete.push_back(*std::move(file));
  }
  for (StagedFile& file : complete)
    if (Result<Done> done = file.commit(); !done) return done;
  return Done{};
}

}  // namespace detent
