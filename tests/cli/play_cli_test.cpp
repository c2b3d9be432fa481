// SPDX-License-Identifier: GPL-3.0-or-later
// detent-play as a program.
#include <algorithm>
#include <cstring>
#include <iostream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#ifdef DETENT_TEST_JACK
#include "tests/playback/device/jack_rig.h"
#endif

using detent::tests::ProgramFolder;
using detent::tests::ProgramResult;
using nlohmann::json;

namespace {

const std::string samples = std::string(DETENT_SOURCE_DIR) + "/samples/buttons/";

class Play : public ProgramFolder {
 public:
  Play() : ProgramFolder("play_cli_test") {
    for (const char* name : {"A", "B"}) {
      std::filesystem::copy_file(samples + name + ".button.json",
                                 path() / (std::string(name) + ".button.json"));
    }
    write("press.csv", "time_s,force_N\n0,0\n0.25,1.5\n0.5,0\n");
  }
  ProgramResult operator()(const std::vector<std::string>& arguments) const {
    return run(DETENT_PLAY, arguments);
  }
  bool has(const std::string& name) const { return files().count(name) == 1; }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("render: the fixed call writes the same float WAV every time") {
  const Play play;
  const ProgramResult first = play({"render", "B.button.json", "--press", "press.csv", "-o", "a.wav"});
  CHECK(first.exitCode == 0);
  CHECK(first.out.empty());
  CHECK(contains(first.err, "1 press jump"));
  CHECK(play({"render", "B.button.json", "--press", "press.csv", "-o", "b.wav"}).exitCode == 0);
  const std::string wav = play.read("a.wav");
  REQUIRE(wav.size() > 100000);
  CHECK(wav == play.read("b.wav"));
  CHECK(wav.substr(0, 4) == "RIFF");
  const std::size_t format = wav.find("fmt ");
  REQUIRE(format != std::string::npos);
  CHECK(wav[format + 8] == 3);   // IEEE float
  CHECK(wav[format + 10] == 1);  // mono
  bool sounds = false;
  for (std::size_t i = wav.find("data") + 8; i + 4 <= wav.size() && !sounds; i += 4) {
    float v = 0;
    std::memcpy(&v, wav.data() + i, 4);
    sounds = v > 0.1f;
  }
  CHECK(sounds);
}

TEST_CASE("render: JSON, events, modes, displacement traces, FLAC") {
  const Play play;
  const ProgramResult r = play(
      {"render", "B.button.json", "--press", "press.csv", "-o", "a.flac", "--events", "e.csv", "--json"});
  REQUIRE(r.exitCode == 0);
  const json object = json::parse(r.out);
  CHECK(std::count(r.out.begin(), r.out.end(), '\n') == 1);
  CHECK(object.at("status") == "ok");
  CHECK(object.at("press_jumps") == 1);
  CHECK(object.at("release_jumps") == 1);
  CHECK(object.at("grains") > 50);
  const std::string events = play.read("e.csv");
  CHECK(events.rfind("time_s,event,state,jump,grains,displacement_mm\n", 0) == 0);
  CHECK(contains(events, ",press_jump,"));
  const ProgramResult off =
      play({"render", "B.button.json", "--press", "press.csv", "-o", "o.wav", "--mode", "off", "--json"});
  CHECK(json::parse(off.out).at("peak") == 0);
  const ProgramResult click = play(
      {"render", "B.button.json", "--press", "press.csv", "-o", "c.wav", "--mode", "click-only", "--json"});
  CHECK(json::parse(click.out).at("grains") == 0);
  CHECK(json::parse(click.out).at("press_jumps") == 1);
  play.write("mm.csv", "time_s,displacement_mm\n0,0\n0.25,4\n0.5,0\n");
  const ProgramResult mm = play({"render", "A.button.json", "--press", "mm.csv", "-o", "m.wav", "--json"});
  CHECK(json::parse(mm.out).at("grains") == 160);
  CHECK(play({"render", "A.button.json", "--standard-press", "-o", "s.wav"}).exitCode == 0);
}

TEST_CASE(
    "render: the level above threshold is the device's where it was measured, and said to be assumed where "
    "not") {
  const Play play;
  play.write("loud.device", "detent-device 1\nfull_scale_dB = 57\n");
  const auto rendered = [&](std::vector<std::string> options) {
    options.insert(options.begin(),
                   {"render", "B.button.json", "--press", "press.csv", "-o", "f.wav", "--json"});
    return play(options);
  };
  const ProgramResult known = rendered({"--profile", "loud.device"}), unknown = rendered({});
  const json loud = json::parse(known.out), assumed = json::parse(unknown.out);
  CHECK(loud.at("full_scale_measured") == true);
  CHECK(assumed.at("full_scale_measured") == false);
  CHECK(assumed.at("full_scale_dB") == 45);
  CHECK(loud.at("felt_dB").get<double>() == Approx(assumed.at("felt_dB").get<double>() + 12).margin(0.01));
  CHECK(contains(unknown.err, "45 dB assumed"));
  CHECK_FALSE(contains(known.err, "assumed"));
}

TEST_CASE("render: faults have their exit codes and leave nothing behind") {
  const Play play;
  const auto expect = [&](const std::vector<std::string>& arguments, int code, const std::string& part) {
    const auto before = play.files();
    const ProgramResult r = play(arguments);
    INFO(r.err);
    CHECK(r.exitCode == code);
    CHECK(contains(r.err, part));
    CHECK(r.out.empty());
    CHECK(play.files() == before);
  };
  play.write("bad.csv", "time_s,force_N\n0,0\n1,much\n");
  play.write("broken.button.json", "{");
  play.write("bad.device", "detent-device 1\ngian = 2\n");
  expect({"render", "none.button.json", "--press", "press.csv", "-o", "a.wav"}, 3, "none.button.json");
  expect({"render", "broken.button.json", "--press", "press.csv", "-o", "a.wav"}, 3, "broken.button.json");
  expect({"render", "B.button.json", "--press", "none.csv", "-o", "a.wav"}, 3, "none.csv");
  expect({"render", "B.button.json", "--press", "bad.csv", "-o", "a.wav"}, 3, "line 3");
  expect({"render", "B.button.json", "--press", "press.csv", "-o", "a.mp3"}, 2, "a.mp3");
  expect({"render", "B.button.json", "--press", "press.csv", "-o", "none/a.wav"}, 2, "none/a.wav");
  expect({"render", "B.button.json", "--press", "press.csv", "-o", "a.wav", "--rate", "7000"}, 2,
         "sample rate");
  expect({"render", "B.button.json", "--press", "press.csv", "-o", "a.wav", "--grain-hz", "-1"}, 2,
         "grainFrequency_Hz");
  expect({"render", "B.button.json", "--press", "press.csv", "-o", "a.wav", "--profile", "bad.device"}, 3,
         "gian");
  expect({"render", "B.button.json", "-o", "a.wav"}, 2, "--press");
  expect({"render", "B.button.json", "--press", "press.csv"}, 2, "output");
}

TEST_CASE("usage: help states defaults and exit codes, nonsense is wrong usage") {
  const Play play;
  const ProgramResult help = play({"--help"});
  CHECK(help.exitCode == 0);
  CHECK(contains(help.out, "6 device trouble"));
  CHECK(contains(help.out, "render"));
  const ProgramResult render = play({"render", "--help"});
  CHECK(contains(render.out, "--grains-per-mm NUMBER=20"));
  CHECK(contains(render.out, "Hz"));
  CHECK(contains(render.out, "click-only|full|off|slope-only=full"));
  CHECK(play({"render", "A.button.json", "--standard-press", "-o", "a.wav", "--mode", "loud"}).exitCode == 2);
  CHECK(play({}).exitCode == 2);
  CHECK(play({"render", "--no-such-option"}).exitCode == 2);
  CHECK(play({"none.button.json"}).exitCode == 3);
}

TEST_CASE("performance: its help says what the forecast hits and what it misses") {
  const std::string help = Play()({"performance", "--help"}).out;
  for (int effect = 1; effect <= 11; ++effect) CHECK(contains(help, "\n  " + std::to_string(effect) + "  "));
  CHECK(contains(help, "  2  peak force, 1.02 : 0.47 N: "));
  CHECK(contains(help, ", people: 1.40, hit\n"));
  CHECK(contains(help, ", people: 0.06 to 0.63, missed\n"));
  CHECK(!contains(help, "**"));
}

TEST_CASE("render: long presses are warned of, samples are as requested") {
  const Play play;
  play.write("long.csv", "time_s,force_N\n0,0\n0.2,1.5\n0.4,0\n601,0\n");
  const ProgramResult warned = play(
      {"render", "B.button.json", "--press", "long.csv", "-o", "a.wav", "--rate", "8000", "--bits", "16"});
  CHECK(warned.exitCode == 0);
  CHECK(contains(warned.err, "lasts 10 minutes"));
  const std::vector<std::pair<std::string, std::string>> formats{
      {"16", {1, 0, 1, 0}}, {"24", {1, 0, 1, 0}}, {"float", {3, 0, 1, 0}}};
  for (const auto& [bits, head] : formats) {
    const ProgramResult r =
        play({"render", "B.button.json", "--standard-press", "-o", "b.wav", "--bits", bits});
    CHECK(r.exitCode == 0);
    CHECK_FALSE(contains(r.err, "warning"));
    const std::string wav = play.read("b.wav");
    CHECK(wav.substr(20, 4) == head);
    CHECK(static_cast<int>(wav[34]) == (bits == "float" ? 32 : std::stoi(bits)));
  }
  CHECK(play({"render", "B.button.json", "--standard-press", "-o", "c.flac", "--bits", "float"}).exitCode ==
        2);
}

TEST_CASE("usage: ports, channels, rates and numbers are looked at before any device or file") {
  const Play play;
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"--osc", "99999"},      {"--osc", "1.2.3.4:"},   {"--osc", "-1"},
      {"--udp", "9000x"},      {"--udp", ""},           {"--signals-to", "localhost"},
      {"--signals-to", "h:0"}, {"--channels", "-3"},    {"--channels", "0"},
      {"--channels", "many"},  {"--gain", "nan"},       {"--gain", "11"},
      {"--seconds", "inf"},    {"--buffer", "-3"},      {"--baud", "0"},
      {"--baud", "4000001"},   {"--device-rate", "-1"}, {"--finger-N", "0,5"}};
  for (const auto& [option, value] : wrong) {
    const ProgramResult r = play({"no-such.button.json", option, value});
    INFO(option << " " << value << ": " << r.err);
    CHECK(r.exitCode == 2);
    CHECK(contains(r.err, option));
    CHECK(r.out.empty());
  }
  CHECK(play({"sweep", "-o", "x.device", "--level", "nan"}).exitCode == 2);
  CHECK(play({"latency", "--sensor-hz", "5"}).exitCode == 2);
  CHECK(play({"study", "run", "s", "--participant", "P", "--noise-level", "0.5"}).exitCode == 2);
  play.write("falling.device",
             "detent-device 1\nsensor.circuit = linear\nsensor.full_scale_counts = 1023\nsensor.coefficients "
             "= 0 -2\n");
  const ProgramResult falling =
      play({"render", "A.button.json", "--standard-press", "-o", "a.wav", "--profile", "falling.device"});
  INFO(falling.err);
  CHECK(falling.exitCode != 0);
  CHECK_FALSE(play.has("a.wav"));
}

TEST_CASE("confusion: a button beside itself differs in nothing, and no cue is named") {
  const Play play;
  const ProgramResult same = play({"confusion", "A.button.json", "A.button.json", "--json"});
  REQUIRE(same.exitCode == 0);
  const json pair = json::parse(same.out)["pairs"][0];
  CHECK(pair["d_prime"] == 0);
  CHECK(pair["reason"] == "nothing differs");
  const ProgramResult other = play({"confusion", "A.button.json", "B.button.json", "--json"});
  REQUIRE(other.exitCode == 0);
  const json forecast = json::parse(other.out)["pairs"][0];
  CHECK(contains(forecast["reason"], "the largest difference is on the "));
  CHECK(forecast["errors_low"] < forecast["errors_per_90"]);
  CHECK(forecast["errors_per_90"] < forecast["errors_high"]);
  CHECK(forecast["errors_high"] <= 45);
}

TEST_CASE("calibrate: known weights become a profile that keeps what it had") {
  const Play play;
  play.write("weights.csv", "mass_g,raw\n20,38\n50,91\n100,168\n200,290\n500,513\n1000,680\n");
  play.write("dev.device", "detent-device 1\nname = mockup\nresonance = 390 8 14\n");
  const ProgramResult r = play({"calibrate", "--weights", "weights.csv", "-o", "dev.device", "--json"});
  INFO(r.err);
  REQUIRE(r.exitCode == 0);
  CHECK(json::parse(r.out).at("weights") == 6);
  CHECK(contains(r.err, "+-"));
  const std::string profile = play.read("dev.device");
  CHECK(contains(profile, "resonance = 390 8 14"));
  CHECK(contains(profile, "sensor.circuit = divider"));
  play.write("few.csv", "mass_g,raw\n20,38\n");
  CHECK(play({"calibrate", "--weights", "few.csv", "-o", "new.device"}).exitCode == 3);
  CHECK_FALSE(play.has("new.device"));
  // A broken profile is not overwritten.
  play.write("bad.device", "rubbish");
  CHECK(play({"calibrate", "--weights", "weights.csv", "-o", "bad.device"}).exitCode == 3);
  CHECK(play.read("bad.device") == "rubbish");
}

#ifdef DETENT_TEST_JACK
TEST_CASE("live: a trace is played, Ctrl-C ends cleanly, a missing device is trouble") {
  const Play play;
  CHECK(play({"B.button.json", "--device", "no such device", "--seconds", "1"}).exitCode == 6);
  detent::test::JackServer server(256);
  if (!server.ready()) {
    std::cout << "SKIPPED detent-play on a sound server: " << server.whyNot() << "\n";
    return;
  }
  const ProgramResult devices = play({"devices", "--json"});
  CHECK(devices.exitCode == 0);
  CHECK(contains(devices.out, "JACK"));
  const ProgramResult traced = play({"B.button.json", "--device", "JACK", "--press", "press.csv", "--json"});
  INFO(traced.err);
  REQUIRE(traced.exitCode == 0);
  const json object = json::parse(traced.out);
  CHECK(object.at("press_jumps") == 1);
  CHECK(object.at("release_jumps") == 1);
  CHECK(object.at("late") == 0);
  const ProgramResult interrupted =
      play.run("timeout", {"--preserve-status", "-s", "INT", "1", DETENT_PLAY, "B.button.json",
                           "A.button.json", "--device", "JACK", "--udp", "0", "--osc", "0", "--json"});
  INFO(interrupted.err);
  CHECK(interrupted.exitCode == 0);
  CHECK(json::parse(interrupted.out).at("status") == "ok");
}
#endif
