// SPDX-License-Identifier: GPL-3.0-or-later
// What a power cut leaves is decided by the order in which content and names are handed to the disk. This
// program's own fsync and rename stand before the C library's, note who is called for which file, and hand
// on.

#include <cerrno>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "model/file/text_file.h"
#include "tests/model/file/test_folder.h"

using namespace detent;
namespace fs = std::filesystem;

namespace {

std::vector<std::string>& calls() {
  static std::vector<std::string> list;
  return list;
}
bool diskRefuses = false;

std::string fileOf(int descriptor) {
  std::error_code error;
  return fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error).string();
}

}  // namespace

extern "C" int fsync(int descriptor) {
  calls().push_back("sync " + fileOf(descriptor));
  if (!diskRefuses) return static_cast<int>(::syscall(SYS_fsync, descriptor));
  errno = EIO;
  return -1;
}

extern "C" int rename(const char* from, const char* to) noexcept {
  calls().push_back(std::string("rename ") + from);
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

TEST_CASE(
    "a file takes its name when its content is on the disk, and the name is there too when the call "
    "returns") {
  const TestFolder folder;
  calls().clear();
  REQUIRE(writeTextFileAtomically(folder / "out", "text").ok());
  REQUIRE(calls().size() == 3);
  const std::string temporary = calls()[1].substr(std::string("rename ").size());
  CHECK(calls()[0] == "sync " + temporary);
  CHECK(fs::path(temporary).parent_path() == folder.path());
  CHECK(calls()[2] == "sync " + folder.path().string());
}

TEST_CASE("what the disk does not take replaces nothing") {
  const TestFolder folder;
  REQUIRE(writeTextFileAtomically(folder / "out", "old").ok());
  diskRefuses = true;
  const Result<Done> written = writeTextFileAtomically(folder / "out", "new");
  diskRefuses = false;
  REQUIRE_FALSE(written.ok());
  CHECK(written.failure().code == FailureCode::internalFault);
  CHECK(readTextFile(folder / "out").value() == "old");
  CHECK(folder.entries() == 1);
}
