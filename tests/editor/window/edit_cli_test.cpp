// SPDX-License-Identifier: GPL-3.0-or-later
// detent-edit as a program: what it answers without opening a window.

#include <catch2/catch.hpp>

#include "tests/cli/run_program.h"

using namespace detent::tests;

namespace {

ProgramResult run(const std::vector<std::string>& arguments) {
  // environment of a terminal without a screen
  std::vector<std::string> words = {"-u", "DISPLAY",         "-u",       "WAYLAND_DISPLAY",
                                    "-u", "QT_QPA_PLATFORM", DETENT_EDIT};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return ProgramFolder("edit_cli").run("/usr/bin/env", words);
}

}  // namespace

TEST_CASE("detent-edit states its arguments, units and exit codes without a screen") {
  const auto help = run({"--help"});
  CHECK(help.exitCode == 0);
  CHECK(help.err.empty());
  for (const char* word : {"FILES", "mm", ".button.json", "PDF", "Exit codes"})
    CHECK_THAT(help.out, Catch::Contains(word));
  const auto version = run({"--version"});
  CHECK(version.exitCode == 0);
  CHECK_THAT(version.out, Catch::StartsWith("detent-edit "));
}

TEST_CASE("detent-edit refuses what it does not know, and says what to do") {
  const auto wrong = run({"--nonsense"});
  CHECK(wrong.exitCode == 2);
  CHECK(wrong.out.empty());
  CHECK(wrong.err == "detent-edit: --nonsense is not an option. See detent-edit --help.\n");
}

TEST_CASE("detent-edit without a screen is no crash") {
  const auto noScreen = run({"some.button.json"});
  CHECK(noScreen.exitCode == 6);
  CHECK_THAT(noScreen.err, Catch::Contains("no screen"));
}
