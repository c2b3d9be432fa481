// SPDX-License-Identifier: GPL-3.0-or-later
// A participant at a real terminal with a sound server: keys, answers, masking noise, and how soon a key is
// felt.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "model/file/button_file.h"
#include "playback/device/steady_clock.h"
#include "playback/study.h"
#include "tests/cli/run_program.h"
#include "tests/cli/terminal_program.h"
#include "tests/playback/device/jack_rig.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;
using detent::tests::ProgramFolder;
using detent::tests::ProgramResult;
using detent::tests::TerminalProgram;
using nlohmann::json;

namespace {

const std::string samples = DETENT_SOURCE_DIR "/samples/buttons/";
constexpr int keys = 12;

std::unique_ptr<ProgramFolder> studyOf(const std::vector<std::string>& buttons) {
  auto folder = std::make_unique<ProgramFolder>("study_trial_test");
  std::vector<std::string> arguments{"study", "new", "s"};
  for (const std::string& name : buttons) arguments.push_back(samples + name + ".button.json");
  arguments.insert(arguments.end(), {"--trials", "4", "--seed", "3"});
  REQUIRE(folder->run(DETENT_PLAY, arguments).exitCode == 0);
  return folder;
}

/// Seconds from `pressKey` to the first sample, median.
template <class PressKey>
double medianOnset_s(JackListener& listener, PressKey pressKey) {
  std::vector<double> delays_s;
  for (int i = 0; i < keys; ++i) {
    sleepUntil(now_s() + 0.6);
    listener.armOnset(1e-4f);
    const double pressed_s = now_s();
    pressKey();
    for (double onset_s = -1; now_s() < pressed_s + 0.5; sleepUntil(now_s() + 0.002)) {
      if ((onset_s = listener.takeOnset()) < 0) continue;
      delays_s.push_back(onset_s - pressed_s);
      break;
    }
  }
  REQUIRE(delays_s.size() >= keys - 2);
  std::sort(delays_s.begin(), delays_s.end());
  return delays_s[delays_s.size() / 2];
}

}  // namespace

TEST_CASE("study: a key is felt as soon as the player's own finger is") {
  JackServer server(64);
  if (!server.ready()) {
    std::cout << "SKIPPED a trial at a terminal: " << server.whyNot() << "\n";
    return;
  }
  const auto folder = studyOf({"A", "B"});
  double byKey_s = 0, byPlayer_s = 0;
  {
    TerminalProgram study({DETENT_PLAY, "study", "run", "s", "--participant", "P1", "--device", "JACK"},
                          folder->path());
    REQUIRE(study.shows("I agree", 10));
    study.type("y");
    REQUIRE(study.shows("Trial 1 of", 10));
    JackListener listener;
    REQUIRE(listener.listenTo("detent:out_1"));
    study.type("1");  // the first press of all
    byKey_s = medianOnset_s(listener, [&] { study.type("1"); });
    study.type("p");
    CHECK(study.exitCode(5) == 0);
  }
  {
    Result<Button> button = readButtonFile(samples + "A.button.json");
    REQUIRE(button);
    const auto program = std::make_unique<HapticProgram>(prepareProgram(*button, {}, {})->program);
    PlayerSettings settings;
    settings.device = "JACK Audio Connection Kit: system";
    Result<std::unique_ptr<LivePlayer>> player = LivePlayer::start(settings, *program);
    REQUIRE(player);
    JackListener listener;
    REQUIRE(listener.listenTo("detent:out_1"));
    const double peak_N = std::max(1.25 * strongestForce_N(*program), 0.1);
    byPlayer_s = medianOnset_s(listener, [&] { (*player)->fingerTap(peak_N, 0.15); });
  }
  std::printf("key to vibration, median of %d: %.2f ms in a trial, %.2f ms by the player itself\n", keys,
              1e3 * byKey_s, 1e3 * byPlayer_s);
  CHECK(byKey_s < byPlayer_s + 0.02);  // another buffer, or a poll of the keys every 50 ms, would show
}

TEST_CASE("study: a masked trial at a terminal: rain on the second output, answers on the disk") {
  JackServer server(256);
  if (!server.ready()) {
    std::cout << "SKIPPED a masked trial at a terminal: " << server.whyNot() << "\n";
    return;
  }
  const auto folder = studyOf({"A", "B"});
  {
    TerminalProgram study({DETENT_PLAY, "study", "run", "s", "--participant", "P1", "--device", "JACK",
                           "--condition", "masked", "--noise-level", "0.05"},
                          folder->path());
    REQUIRE(study.shows("I agree", 10));
    study.type("Y");  // Caps Lock
    REQUIRE(study.shows("Trial 1 of 4", 10));
    CHECK(study.screen().find("Rain plays") != std::string::npos);
    JackListener ears, finger;
    REQUIRE(ears.listenTo("detent:out_2"));
    REQUIRE(finger.listenTo("detent:out_1"));
    sleepUntil(now_s() + 1.5);
    const std::vector<float> heard = ears.recorded(), felt = finger.recorded();
    REQUIRE(heard.size() > 24000);
    double squares = 0;
    for (std::size_t i = heard.size() - 24000; i < heard.size(); ++i)
      squares += static_cast<double>(heard[i]) * static_cast<double>(heard[i]);
    CHECK(std::sqrt(squares / 24000) == Approx(0.05).epsilon(0.25));
    CHECK(std::all_of(felt.begin(), felt.end(), [](float v) { return v == 0; }));

    study.type("a");
    CHECK(study.shows("press them first", 3));
    for (int trial = 1; trial <= 2; ++trial) {
      const std::size_t from = study.screen().size();
      study.type("12x");  // too quick to be felt: the finger has not come up between
      CHECK(study.shows(" X", 3, from));
      study.type("a");
      CHECK(study.shows("press them first", 3, from));
      for (const char* key : {"1", "2", "x"}) {
        sleepUntil(now_s() + 0.6);
        study.type(key);
      }
      sleepUntil(now_s() + 0.6);
      study.type("A");  // Caps Lock
      CHECK(study.shows("Trial " + std::to_string(trial + 1), 3, from));
    }
    study.type("\x03");
    CHECK(study.exitCode(3) == 0);
  }
  const ProgramResult status = folder->run(DETENT_PLAY, {"study", "status", "s", "--json"});
  CHECK(json::parse(status.out).at("participants")[0].at("next_trial") == 3);
  const std::string journal = folder->read("s/participants/P1.jsonl");
  CHECK(journal.find("\"noise_level\":0.05") != std::string::npos);
  REQUIRE(folder->run(DETENT_PLAY, {"study", "report", "s", "--csv", "t.csv"}).exitCode == 0);
  CHECK(folder->read("t.csv").find("masked") != std::string::npos);
}

TEST_CASE("study: who says no at a terminal is in no journal, and is counted") {
  const auto folder = studyOf({"A", "B"});
  {
    TerminalProgram study(
        {DETENT_PLAY, "study", "run", "s", "--participant", "P1", "--rehearse", "--language", "de"},
        folder->path());
    REQUIRE(study.shows("virtuelle Tasten", 10));
    REQUIRE(study.shows("nein, danke", 10));
    study.type("1");
    study.type("n");
    CHECK(study.exitCode(5) == 0);
    CHECK(study.screen().find("Danke, dass Sie gekommen sind") != std::string::npos);
  }
  const json status = json::parse(folder->run(DETENT_PLAY, {"study", "status", "s", "--json"}).out);
  CHECK(status.at("participants").empty());
  CHECK(status.at("declined") == 1);
  CHECK(folder->read("s/declined.jsonl").find("\"language\":\"de\"") != std::string::npos);
}

TEST_CASE("study: a German participant reads German at a terminal, also the next time") {
  const auto folder = studyOf({"A", "B"});
  std::vector<std::string> command{DETENT_PLAY, "study", "run", "s", "--participant", "P1", "--rehearse"};
  for (const bool again : {false, true}) {
    std::vector<std::string> asked = command;
    if (!again) asked.insert(asked.end(), {"--language", "de"});
    TerminalProgram study(asked, folder->path());
    if (!again) {
      REQUIRE(study.shows("j = Ich bin einverstanden", 10));
      study.type("j");
    }
    REQUIRE(study.shows("Frage 1 von 4", 10));
    CHECK(study.shows("a = X ist 1", 3));
    study.type("a");
    CHECK(study.shows("erst dr\u00fccken", 3));
    study.type("q");
    REQUIRE(study.shows("aufh\u00f6ren? j h\u00f6rt auf", 3));
    study.type("n");
    study.type("p");
    CHECK(study.exitCode(5) == 0);
    for (const char* english : {"press:", "answer:", "Trial ", "Paused"})
      CHECK(study.screen().find(english) == std::string::npos);
  }
}

TEST_CASE("study: what was agreed to stands in the journal, and is asked once") {
  const auto folder = studyOf({"A", "B"});
  for (const bool again : {false, true}) {
    TerminalProgram study({DETENT_PLAY, "study", "run", "s", "--participant", "P1", "--rehearse"},
                          folder->path());
    if (!again) {
      REQUIRE(study.shows("I agree", 10));
      study.type("y");
    }
    REQUIRE(study.shows("Trial 1 of 4", 10));
    study.type("p");
    CHECK(study.exitCode(5) == 0);
  }
  const json status = json::parse(folder->run(DETENT_PLAY, {"study", "status", "s", "--json"}).out);
  CHECK(status.at("participants")[0].at("consent").at("language") == "en");
  CHECK(status.at("participants")[0].at("consent").at("sha256").get<std::string>().size() == 64);
}
