// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/batch/batch.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <thread>

#include <catch2/catch.hpp>
#include <unistd.h>

using namespace detent;
using namespace detent::importer;

namespace {

const auto neverCancelled = [] { return false; };

const auto killedBefore = std::filesystem::current_path() / "batch_test.killed";

/// Children that behave as their input's name says.
int misbehave(const std::string& input, std::string& lines) {
  lines = "started " + input + "\n";
  if (input == "crash") std::abort();
  if (input == "hang") std::this_thread::sleep_for(std::chrono::hours(1));
  if (input == "refuse") return 4;
  if (input == "slow") std::this_thread::sleep_for(std::chrono::milliseconds(120));
  if (input == "large") {
    try {
      std::string huge(std::size_t{3} << 30, 'x');
      return huge.back() == 'x' ? 0 : 1;
    } catch (const std::bad_alloc&) {
      return 3;
    }
  }
  if (input == "killed") kill(getpid(), SIGKILL);
  if (input == "killed once" && !std::filesystem::exists(killedBefore)) {
    std::ofstream(killedBefore) << "yes";
    kill(getpid(), SIGKILL);
  }
  if (input == "chatty") lines.assign(1 << 20, 'c');  // more than a pipe holds
  return 0;
}

std::vector<InputOutcome> outcomesOf(const std::vector<std::string>& inputs, BatchOptions options) {
  std::vector<InputOutcome> outcomes;
  const auto ran = runIsolated(
      inputs, options, misbehave, [&](const InputOutcome& outcome) { outcomes.push_back(outcome); },
      neverCancelled);
  REQUIRE(ran);
  return outcomes;
}

}  // namespace

TEST_CASE("A crash or a hang costs its own input only") {
  const auto outcomes = outcomesOf({"a", "crash", "hang", "refuse", "b"}, {2, 1.0, 4096});
  REQUIRE(outcomes.size() == 5);
  CHECK(outcomes[0].exitCode == 0);
  CHECK(outcomes[0].reportLines == "started a\n");
  CHECK(outcomes[1].exitCode == 1);
  CHECK_THAT(outcomes[1].death, Catch::Contains("crashed"));
  CHECK(outcomes[1].reportLines.empty());
  CHECK(outcomes[2].exitCode == 3);
  CHECK_THAT(outcomes[2].death, Catch::Contains("longer than the limit of 1 s"));
  CHECK(outcomes[3].exitCode == 4);
  CHECK(outcomes[4].reportLines == "started b\n");
}

TEST_CASE("A child that somebody else kills is started once more") {
  std::filesystem::remove(killedBefore);
  const auto outcomes = outcomesOf({"killed once", "killed", "b"}, {1, 20, 4096});
  std::filesystem::remove(killedBefore);
  REQUIRE(outcomes.size() == 3);
  CHECK(outcomes[0].death.empty());
  CHECK(outcomes[0].reportLines == "started killed once\n");
  CHECK(outcomes[1].exitCode == 1);
  CHECK_FALSE(outcomes[1].death.empty());
  CHECK(outcomes[2].reportLines == "started b\n");
}

TEST_CASE("Results come in the order of the inputs whatever the number of processes") {
  const std::vector<std::string> inputs{"slow", "a", "b", "slow", "c", "d"};
  for (const int jobs : {1, 2, 5}) {
    const auto outcomes = outcomesOf(inputs, {jobs, 20, 4096});
    REQUIRE(outcomes.size() == inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) CHECK(outcomes[i].input == inputs[i]);
  }
}

TEST_CASE("A report longer than a pipe's buffer arrives whole") {
  const auto outcomes = outcomesOf({"chatty"}, {1, 20, 4096});
  REQUIRE(outcomes.size() == 1);
  CHECK(outcomes[0].reportLines.size() == (1u << 20));
}

// AddressSanitizer reserves terabytes of address space, so the limit cannot be tested under it.
#if defined(__SANITIZE_ADDRESS__)
#define DETENT_UNDER_ASAN
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define DETENT_UNDER_ASAN
#endif
#endif
#ifndef DETENT_UNDER_ASAN
TEST_CASE("Memory beyond the limit is refused to the child") {
  CHECK(outcomesOf({"large"}, {1, 20, 1024})[0].exitCode == 3);
}
#endif

TEST_CASE("A cancelled batch ends at once and leaves no process behind") {
  const auto start = std::chrono::steady_clock::now();
  const auto ran = runIsolated(
      {"hang", "hang"}, {2, 60, 4096}, misbehave, [](const InputOutcome&) {}, [] { return true; });
  REQUIRE_FALSE(ran);
  CHECK_THAT(ran.failure().sentence(), Catch::Contains("--resume"));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
}
