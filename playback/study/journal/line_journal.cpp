// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/journal/line_journal.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "model/disk.h"

namespace detent::playback {

namespace {

constexpr mode_t rights = 0644;
constexpr std::size_t chunk_bytes = 65536;

/// Writes the whole text; returns 0 or the error code.
int writeWhole(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t wrote = ::write(descriptor, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return wrote < 0 ? errno : ENOSPC;
    done += static_cast<std::size_t>(wrote);
  }
  return 0;
}

Failure journalTrouble(const std::filesystem::path& file, Message what, int error) {
  return {FailureCode::unreadableInput, file.string(), "",
          Message("%1 (%2)", std::move(what), std::strerror(error)),
          Message("Check the folder, its permissions and the free space, then try again")};
}

}  // namespace

bool JournalText::isForeign() const {
  return lines.empty() && !unfinished.empty() && unfinished.front() != '{' && unfinished.front() != '\0';
}

Failure notAJournal(const std::filesystem::path& file) {
  return {FailureCode::unreadableInput, file.string(), Message("line 1"),
          Message("the file is not a journal of a study"), Message("Move this file out of the study")};
}

JournalText splitJournal(const std::string& text) {
  JournalText journal;
  std::size_t from = 0;
  for (std::size_t end; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
    journal.lines.push_back(text.substr(from, end - from));
  journal.unfinished = text.substr(from);
  return journal;
}

Result<LineJournal> LineJournal::open(const std::filesystem::path& file) {
  LineJournal journal(file, ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, rights));
  if (journal.descriptor_ < 0) return journalTrouble(file, Message("the journal cannot be opened"), errno);
  if (::flock(journal.descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) return journalTrouble(file, Message("the journal cannot be locked"), errno);
    return Failure{FailureCode::unreadableInput, file.string(), "",
                   Message("another program is writing this journal"),
                   Message("End that session first, or give another participant's id")};
  }
  writeFolderToDisk(file);
  if (Result<Done> ok = journal.readAndCut(); !ok) return ok.failure();
  return journal;
}

Result<Done> LineJournal::readAndCut() {
  std::string text;
  for (std::string chunk(chunk_bytes, '\0');;) {
    const ssize_t got = ::read(descriptor_, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return journalTrouble(file_, Message("the journal cannot be read"), errno);
    if (got == 0) break;
    text.append(chunk, 0, static_cast<std::size_t>(got));
  }
  opened_ = splitJournal(text);
  if (opened_.isForeign()) return notAJournal(file_);
  length_bytes_ = static_cast<std::int64_t>(text.size() - opened_.unfinished.size());
  if (!opened_.unfinished.empty() && ::ftruncate(descriptor_, length_bytes_) != 0)
    return journalTrouble(file_, Message("the journal cannot be shortened to its last complete line"), errno);
  return Done{};
}

Result<Done> LineJournal::append(const std::string& line) {
  int error = writeWhole(descriptor_, line + "\n");
  if (error == 0 && ::fdatasync(descriptor_) != 0) error = errno;
  if (error == 0) {
    length_bytes_ += static_cast<std::int64_t>(line.size()) + 1;
    return Done{};
  }
  // If even this fails, the incomplete line is removed when the journal is opened again.
  if (::ftruncate(descriptor_, length_bytes_) == 0) ::fdatasync(descriptor_);
  return journalTrouble(file_, Message("a line could not be added to the journal"), error);
}

LineJournal::~LineJournal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

LineJournal::LineJournal(LineJournal&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      length_bytes_(other.length_bytes_),
      opened_(std::move(other.opened_)) {}

LineJournal& LineJournal::operator=(LineJournal&& other) noexcept {
  if (this == &other) return *this;
  if (descriptor_ >= 0) ::close(descriptor_);
  file_ = std::move(other.file_);
  descriptor_ = std::exchange(other.descriptor_, -1);
  length_bytes_ = other.length_bytes_;
  opened_ = std::move(other.opened_);
  return *this;
}

}  // namespace detent::playback
