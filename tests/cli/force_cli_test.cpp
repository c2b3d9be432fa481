// SPDX-License-Identifier: GPL-3.0-or-later
// detent-play force and identify as programs.
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

using detent::tests::ProgramFolder;
using detent::tests::ProgramResult;
using nlohmann::json;

namespace {

class Force : public ProgramFolder {
 public:
  Force() : ProgramFolder("force_cli_test") {
    for (const char* name : {"B", "push", "latch"}) {
      std::filesystem::copy_file(std::string(DETENT_SOURCE_DIR) + "/samples/buttons/" + name + ".button.json",
                                 path() / (std::string(name) + ".button.json"));
    }
  }
  ProgramResult operator()(const std::vector<std::string>& arguments) const {
    return run(DETENT_PLAY, arguments);
  }
  bool has(const std::string& name) const { return files().count(name) == 1; }
};

std::string recordOf(bool constantSpeed) {
  std::ostringstream text;
  text << "time_s,displacement_mm,force_N\n";
  for (int i = 0; i <= 400; ++i) {
    const double t = i * 0.001, x = constantSpeed ? 10 * t : 2 - 2 * std::cos(t / 0.4 * 6.283185307),
                 v = constantSpeed ? 10 : 2 * 6.283185307 / 0.4 * std::sin(t / 0.4 * 6.283185307);
    text << t << ',' << x << ',' << 0.1 + 0.25 * x + 0.004 * v << '\n';
  }
  return text.str();
}

}  // namespace

TEST_CASE(
    "force: one row per step under the fixed header, the same each time; pictures and figures beside it") {
  const Force force;
  const std::vector<std::string> call{"force",     "push.button.json", "--device", "sim:falcon", "--seconds",
                                      "1",         "--fast",           "--json",   "--plot",     "run.svg",
                                      "--figures", "paper.svg",        "--log"};
  auto first = call, second = call;
  first.push_back("a.csv");
  second.push_back("b.csv");
  const ProgramResult result = force(first);
  REQUIRE(result.exitCode == 0);
  const json j = json::parse(result.out);
  CHECK(j["rows"] == 1000);
  CHECK(j["encoder_step_mm"] == 0.038);
  CHECK(force.read("a.csv").starts_with("time_s,position_mm,velocity_mm_per_s,force_N,energy_mJ,state\n0,"));
  REQUIRE(force(second).exitCode == 0);
  CHECK(force.read("a.csv") == force.read("b.csv"));
  CHECK(force.read("run.svg").ends_with("</svg>\n"));
  for (const char* figure : {"Figure 4", "Figure 5", "Figure 6"}) {
    CHECK(force.read("paper.svg").find(figure) != std::string::npos);
  }
}

TEST_CASE("force: the encoder step of a device profile counts, and the one given by hand counts more") {
  const Force force;
  force.write("mine.device",
              "detent-force-device 1\nmass_kg = 0.05\nfriction_N = 0.05\ndamping_Ns_per_mm = 0.001\n"
              "delay_s = 0.001\nlag_s = 0\nrate_Hz = 1000\nstep_mm = 0.025\n");
  std::vector<std::string> call{
      "force",  "B.button.json", "--device",         "sim",        "--seconds", "0.1",
      "--fast", "--json",        "--device-profile", "mine.device"};
  const ProgramResult profile = force(call);
  REQUIRE(profile.exitCode == 0);
  CHECK(json::parse(profile.out)["encoder_step_mm"] == 0.025);
  call.insert(call.end(), {"--step-mm", "0.02"});
  const ProgramResult given = force(call);
  REQUIRE(given.exitCode == 0);
  CHECK(json::parse(given.out)["encoder_step_mm"] == 0.02);
}

TEST_CASE("force: the on/off button changes its state under the finger") {
  const Force force;
  const ProgramResult result = force({"force", "latch.button.json", "--device", "sim:rig", "--seconds", "4",
                                      "--fast", "--json", "--finger", "press"});
  REQUIRE(result.exitCode == 0);
  CHECK(json::parse(result.out)["state_changes"] >= 2);
}

TEST_CASE("force: wrong words, files and devices leave no log and say what to give") {
  const Force force;
  const std::vector<std::pair<std::vector<std::string>, int>> calls{
      {{"--device", "simulated"}, 2},
      {{"--device", "sim:"}, 2},
      {{"--device", "falcon:x"}, 2},
      {{"--device", "serial:"}, 2},
      {{"--finger", "hold=x"}, 2},
      {{"--finger", "hold=99"}, 2},
      {{"--finger", "nothing.csv"}, 3},
      {{"--rate", "1"}, 2},
      {{"--law", "other"}, 2},
      {{"--max-N", "0"}, 2},
      {{"--max-N", "-1"}, 2},
      {{"--max-N", "nan"}, 2},
      {{"--device", "serial:/nowhere"}, 6},
      {{"--device", "odrive:/nowhere"}, 6},
      {{"--device", "serial:/dev/null", "--baud", "1199"}, 2},
      {{"--device", "falcon:99"}, 6},
      {{"--device", "falcon", "--firmware", "none.bin"}, 3},
      {{"--device", "falcon", "--firmware", "B.button.json"}, 3},
      {{"--stiffness", "0.2"}, 2},
      {{"--log", "no/where.csv"}, 2}};
  for (const auto& [words, code] : calls) {
    std::vector<std::string> call{"force", "B.button.json", "--seconds", "0.1", "--log", "x.csv"};
    if (words[0] == "--log") call.resize(4);
    call.insert(call.end(), words.begin(), words.end());
    const ProgramResult result = force(call);
    INFO(words[0] << " " << words[1]);
    CHECK(result.exitCode == code);
    CHECK_FALSE(result.err.empty());
    CHECK_FALSE(force.has("x.csv"));
    CHECK_FALSE(force.has("x.csv.part"));
  }
  CHECK(force({"force", "missing.button.json"}).exitCode == 3);
  CHECK(force({"force"}).exitCode == 2);
}

TEST_CASE("force: a spring and damper straight from its polynomials") {
  const Force force;
  const ProgramResult result =
      force({"force", "--stiffness=0.3325,-0.25,0.05", "--damping=0.001,0.004,-0.0008", "--travel", "5",
             "--seconds", "1", "--fast", "--json"});
  REQUIRE(result.exitCode == 0);
  CHECK(json::parse(result.out)["button"] == "Spring and damper");
  CHECK(json::parse(result.out)["strongest_N"] > 0.3);
  CHECK(force({"force", "--stiffness", "0.2", "--damping=-1"}).exitCode == 2);
  CHECK(force({"force", "--damping", "0.1"}).exitCode == 2);
}

TEST_CASE("identify: k and b with errors, b null with a reason at constant speed") {
  const Force force;
  force.write("press.csv", recordOf(false));
  force.write("steady.csv", recordOf(true));
  const ProgramResult result =
      force({"identify", "press.csv", "--json", "-o", "found.button.json", "--plot", "profile.svg"});
  REQUIRE(result.exitCode == 0);
  const json j = json::parse(result.out);
  CHECK(j["k_N_per_mm"].get<double>() == Approx(0.25).epsilon(0.02));
  CHECK(j["b_Ns_per_mm"].get<double>() == Approx(0.004).epsilon(0.05));
  CHECK(j["sigma_k_N_per_mm"].is_number());
  CHECK(j["sigma_b_Ns_per_mm"].is_number());
  CHECK(force.has("found.button.json"));
  CHECK(force.has("profile.svg"));
  const json steady = json::parse(force({"identify", "steady.csv", "--json"}).out);
  CHECK(steady["b_Ns_per_mm"].is_null());
  CHECK(steady["b_reason_code"] == "constant_speed");
  force.write("broken.csv", "time_s,displacement_mm,force_N\n0,0\n");
  CHECK(force({"identify", "broken.csv"}).exitCode == 3);
  CHECK(force({"identify", "missing.csv"}).exitCode == 3);
}
