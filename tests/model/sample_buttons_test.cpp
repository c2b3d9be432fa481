// SPDX-License-Identifier: GPL-3.0-or-later
// samples/buttons holds exactly what its program writes, and what its manifest promises.
#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>

#include "model/file/button_file.h"
#include "model/file/text_file.h"
#include "model/metrics.h"
#include "model/validation.h"

using namespace detent;
namespace fs = std::filesystem;

namespace {

const fs::path committed = fs::path(DETENT_SOURCE_DIR) / "samples" / "buttons";

Button sample(const std::string& name) {
  auto button = readButtonFile((committed / (name + ".button.json")).string());
  INFO((button.ok() ? "" : button.failure().sentence()));
  REQUIRE(button.ok());
  return *button;
}

StateMetrics metrics(const std::string& name, std::size_t state = 0) {
  return metricsOf(sample(name).states().at(state));
}

}  // namespace

TEST_CASE("the committed samples are what the committed program writes") {
  const fs::path made = fs::current_path() / "sample_buttons_test.out";
  fs::remove_all(made);
  fs::create_directories(made);
  REQUIRE(std::system(("\"" DETENT_MAKE_BUTTONS "\" \"" + made.string() + "\"").c_str()) == 0);
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(made)) {
    INFO(entry.path().filename().string());
    CHECK(readTextFile(entry.path().string()).value() ==
          readTextFile((committed / entry.path().filename()).string()).value());
    ++files;
  }
  CHECK(files == 9);
  for (const auto& entry : fs::directory_iterator(committed))
    if (entry.path().extension() == ".json") CHECK(fs::exists(made / entry.path().filename()));
  fs::remove_all(made);
}

TEST_CASE("nothing about the samples is odd") {
  for (const char* name : {"A", "B", "C", "D", "E", "F", "EF", "push", "latch"})
    for (const Warning& w : validate(sample(name))) FAIL_CHECK(name << ": " << w.sentence());
}

TEST_CASE("Kim & Lee: what the paper says of its buttons holds") {
  CHECK(metrics("A").press.tactile.empty());
  REQUIRE(metrics("B").press.tactile.size() == 1);
  CHECK(metrics("B").press.tactile[0].point.force_N == 0.55);
  REQUIRE(metrics("C").press.tactile.size() == 1);
  CHECK(metrics("C").press.tactile[0].point.force_N == 0.65);
  // B, C and D have tactile points on both curves; D has two, the second one stronger.
  for (const char* name : {"B", "C"}) CHECK(metrics(name).release->tactile.size() == 1);
  const StateMetrics d = metrics("D");
  REQUIRE(d.press.tactile.size() == 2);
  CHECK(d.release->tactile.size() == 2);
  CHECK(d.press.tactile[1].jumpArea_mJ > d.press.tactile[0].jumpArea_mJ);
  // E and F give no tactile feedback during the release.
  for (const char* name : {"E", "F"}) {
    CHECK(metrics(name).press.tactile.size() == 1);
    CHECK(metrics(name).release->tactile.empty());
  }
  CHECK(sample("EF").states()[0].graph == sample("E").states()[0].graph);
  CHECK(sample("EF").states()[1].graph == sample("F").states()[0].graph);
}

TEST_CASE("Shrestha: parabolas with one axis, and a latch at 22.9 mm") {
  const ButtonState push = sample("push").states()[0];
  const auto stiffness = [&](double x) { return push.graph.press().force_N(x) / x; };
  for (double off : {0.5, 1.0, 2.0}) {
    CHECK(stiffness(2.5 + off) == Approx(stiffness(2.5 - off)));
    CHECK(stiffness(2.5 + off) > stiffness(2.5));
  }
  CHECK(push.damping.size() == 21);
  CHECK(push.damping[10].damping_Ns_per_mm > push.damping[0].damping_Ns_per_mm);
  CHECK(push.damping[4].damping_Ns_per_mm == Approx(push.damping[16].damping_Ns_per_mm));
  CHECK(metricsOf(push).press.tactile.size() == 1);  // the detent
  const Button latch = sample("latch");
  REQUIRE(latch.states().size() == 2);
  CHECK(latch.states()[0].graph.release()->start_mm() == 22.9);
  CHECK(latch.states()[1].graph.press().start_mm() == 22.9);
  CHECK(latch.states()[0].graph.press().monotoneStretches().size() == 1);
}
