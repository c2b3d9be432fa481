// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/text_file.h"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "model/file/staged_text.h"
#include "tests/model/file/test_folder.h"

using namespace detent;
namespace fs = std::filesystem;

namespace {

void requireFailure(const Result<Done>& result, int exitCode, const std::string& part) {
  REQUIRE_FALSE(result.ok());
  CHECK(result.failure().exitCode() == exitCode);
  CHECK_THAT(result.failure().sentence(), Catch::Contains(part));
}

}  // namespace

TEST_CASE("a written file holds exactly the text, and nothing else is left") {
  const TestFolder folder;
  const std::string text("a\0b\r\n\xFF", 6);
  REQUIRE(writeTextFileAtomically(folder / "out", text).ok());
  CHECK(readTextFile(folder / "out").value() == text);
  REQUIRE(writeTextFileAtomically(folder / "out", "").ok());
  CHECK(readTextFile(folder / "out").value().empty());
  CHECK(folder.entries() == 1);
}

TEST_CASE("an existing file keeps its permissions, a link its target") {
  const TestFolder folder;
  REQUIRE(writeTextFileAtomically(folder / "target", "old").ok());
  fs::permissions(folder / "target", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("target", folder / "link");
  REQUIRE(writeTextFileAtomically(folder / "link", "new").ok());
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(readTextFile(folder / "target").value() == "new");
  CHECK(fs::status(folder / "target").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("where nothing can be written, nothing is left and the old file stands") {
  const TestFolder folder;
  requireFailure(writeTextFileAtomically(folder.path().string(), "x"), 2, "this is a folder, not a file");
  requireFailure(writeTextFileAtomically(folder / "no/such/folder/out", "x"), 2,
                 "the folder of the file does not exist");
  requireFailure(writeTextFileAtomically("/dev/null", "x"), 2, "this is not an ordinary file");
  requireFailure(writeTextFileAtomically(folder / std::string(300, 'n'), "x"), 1, "cannot be written");
  CHECK(folder.entries() == 0);
}

TEST_CASE("files that belong together are all written, or none and the old ones stand") {
  const TestFolder folder;
  REQUIRE(writeTextFilesAtomically({{folder / "a", "old"}, {folder / "b", "old"}}).ok());
  fs::create_directory(folder / "taken");
  requireFailure(
      writeTextFilesAtomically({{folder / "a", "new"}, {folder / "c", "new"}, {folder / "taken", "new"}}), 2,
      "this is a folder, not a file");
  CHECK(readTextFile(folder / "a").value() == "old");
  CHECK(folder.entries() == 3);
  REQUIRE(writeTextFilesAtomically({{folder / "a", "new"}, {folder / "b", "newer"}}).ok());
  CHECK(readTextFile(folder / "a").value() == "new");
  CHECK(readTextFile(folder / "b").value() == "newer");
  CHECK(folder.entries() == 3);
}

TEST_CASE("long names are written as well") {
  const TestFolder folder;
  const std::string name(250, 'n');
  REQUIRE(writeTextFileAtomically(folder / name, "x").ok());
  CHECK(readTextFile(folder / name).value() == "x");
}

TEST_CASE("what cannot be read is refused by name") {
  const TestFolder folder;
  const auto missing = readTextFile(folder / "missing");
  REQUIRE_FALSE(missing.ok());
  CHECK(missing.failure().exitCode() == 3);
  CHECK_THAT(missing.failure().sentence(), Catch::Contains("missing: the file does not exist"));
  CHECK_THAT(readTextFile(folder.path().string()).failure().sentence(),
             Catch::Contains("this is a folder, not a file"));
  std::ofstream(folder / "large").close();
  fs::resize_file(folder / "large", maxTextFileBytes + 1);
  CHECK_THAT(readTextFile(folder / "large").failure().sentence(), Catch::Contains("is larger than 256 MiB"));
}
