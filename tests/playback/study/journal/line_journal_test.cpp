// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/journal/line_journal.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <unistd.h>

using namespace detent;
using namespace detent::playback;

namespace {

class TestFile {
 public:
  TestFile()
      : path_(std::filesystem::temp_directory_path() / ("detent_journal_" + std::to_string(::getpid()))) {
    std::filesystem::remove(path_);
  }
  ~TestFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }
  std::string text() const {
    std::ifstream in(path_, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }

 private:
  std::filesystem::path path_;
};

/// No file may grow beyond `bytes` while one lives: a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

}  // namespace

TEST_CASE("journal: what was appended is there when it is opened again") {
  const TestFile file;
  {
    Result<LineJournal> journal = LineJournal::open(file.path());
    REQUIRE(journal);
    CHECK(journal->opened().lines.empty());
    CHECK(journal->append("one"));
    CHECK(journal->append("two"));
  }
  const Result<LineJournal> again = LineJournal::open(file.path());
  REQUIRE(again);
  CHECK(again->opened().lines == std::vector<std::string>{"one", "two"});
  CHECK(again->opened().unfinished.empty());
}

TEST_CASE("journal: cut off at any byte, whole lines stay and the rest is reported and taken out") {
  const std::string whole = "{first line\nsecond\nthird one\n";
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    const TestFile file;
    file.write(whole.substr(0, length));
    {
      Result<LineJournal> journal = LineJournal::open(file.path());
      REQUIRE(journal);
      const std::string kept = whole.substr(0, whole.substr(0, length).rfind('\n') + 1);
      CHECK(journal->opened().unfinished == whole.substr(kept.size(), length - kept.size()));
      CHECK(file.text() == kept);
      CHECK(journal->append("next"));
      CHECK(file.text() == kept + "next\n");
    }
  }
}

TEST_CASE("journal: a file of another kind is refused and stays as it is") {
  const TestFile file;
  file.write("my notes, without an end of line");
  const Result<LineJournal> journal = LineJournal::open(file.path());
  REQUIRE_FALSE(journal);
  CHECK_THAT(journal.failure().sentence(), Catch::Contains("is not a journal"));
  CHECK(file.text() == "my notes, without an end of line");
}

TEST_CASE("journal: a second one is refused while the first lives") {
  const TestFile file;
  {
    const Result<LineJournal> first = LineJournal::open(file.path());
    REQUIRE(first);
    const Result<LineJournal> second = LineJournal::open(file.path());
    REQUIRE_FALSE(second);
    CHECK(second.failure().sentence().find("another program is writing") != std::string::npos);
  }
  CHECK(LineJournal::open(file.path()));
}

TEST_CASE(
    "journal: a disk that fills in the middle of a line leaves whole lines, and the line can be given "
    "again") {
  const TestFile file;
  Result<LineJournal> journal = LineJournal::open(file.path());
  REQUIRE(journal);
  REQUIRE(journal->append("kept"));
  {
    const FullDisk full(9);
    const Result<Done> refused = journal->append("does not fit");
    REQUIRE_FALSE(refused);
    CHECK(refused.failure().code == FailureCode::unreadableInput);
    CHECK(file.text() == "kept\n");
  }
  CHECK(journal->append("does not fit"));
  CHECK(file.text() == "kept\ndoes not fit\n");
}

TEST_CASE("journal: where it cannot be is said") {
  const Result<LineJournal> nowhere = LineJournal::open("/nonexistent-folder/P01.jsonl");
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.failure().exitCode() == 3);
}
