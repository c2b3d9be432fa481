// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/staged_outputs.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

using namespace detent::importer;
namespace fs = std::filesystem;

namespace {

/// An empty folder that goes away with the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("detent-staged-" + std::to_string(std::rand()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string file(const char* name) const { return (path / name).string(); }
  auto count() const { return std::distance(fs::directory_iterator(path), fs::directory_iterator()); }
};

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("Staged files appear together on commit, with exactly their bytes") {
  const Folder folder;
  StagedOutputs outputs;
  REQUIRE(outputs.stage(folder.file("a.json"), std::string_view("a\0b", 3)));
  REQUIRE(outputs.stage(folder.file("b.csv"), "x,y\n"));
  CHECK_FALSE(fs::exists(folder.file("a.json")));
  REQUIRE(outputs.commit());
  CHECK(read(folder.file("a.json")) == std::string("a\0b", 3));
  CHECK(read(folder.file("b.csv")) == "x,y\n");
  CHECK(folder.count() == 2);
}

TEST_CASE("What is not committed leaves nothing behind and touches nothing that was there") {
  const Folder folder;
  std::ofstream(folder.file("old.csv")) << "old";
  {
    StagedOutputs outputs;
    REQUIRE(outputs.stage(folder.file("old.csv"), "new"));
    const auto refused = outputs.stage(folder.file("missing/x.csv"), "new");
    REQUIRE_FALSE(refused);
    CHECK(refused.failure().exitCode() == 2);
    CHECK_THAT(refused.failure().sentence(), Catch::Contains("does not exist"));
  }
  CHECK(read(folder.file("old.csv")) == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("A folder is no file to write to") {
  const Folder folder;
  StagedOutputs outputs;
  const auto refused = outputs.stage(folder.path.string(), "x");
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.failure().sentence(), Catch::Contains("this is a folder, not a file"));
}
