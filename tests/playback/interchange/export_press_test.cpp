// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/export_press.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "model/file/button_file.h"
#include "playback/interchange/limiter_gains.h"
#include "playback/interchange/press_plan.h"
#include "playback/offline/standard_press.h"
#include "playback/prepare/prepare_program.h"
#include "playback/realtime/grain_density.h"
#include "tests/playback/interchange/fuzzed_exports.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

Button sample(const std::string& name) {
  return readButtonFile(DETENT_SOURCE_DIR "/samples/buttons/" + name + ".button.json").value();
}

Result<Exported> exported(const Button& button, ExportFormat format, const std::string& press = "standard") {
  const HapticProgram program = prepareProgram(button, {}, {}).value().program;
  const Result<PressTrace> trace = namedPress(press, program);
  if (!trace) return trace.failure();
  ExportSettings settings;
  settings.format = format;
  settings.pressName = press;
  return exportPress(button, program, *trace, settings);
}

Button named(const std::string& name) { return Button::fromStates(name, sample("B").states()).value(); }

}  // namespace

TEST_CASE("Every format of every sample is written, twice the same, with a loss record") {
  for (const char* name : {"A", "B", "C", "D", "E", "EF", "F", "latch", "push"}) {
    for (const auto& format : exportFormats.all) {
      INFO(name << " " << format.word);
      const Result<Exported> first = exported(sample(name), format.value);
      REQUIRE(first.ok());
      REQUIRE_FALSE(first->files.empty());
      const Result<Exported> second = exported(sample(name), format.value);
      for (std::size_t i = 0; i < first->files.size(); ++i) {
        CHECK_FALSE(first->files[i].text.empty());
        CHECK(first->files[i].text == second->files[i].text);
      }
      for (const auto& kept : first->loss.energyKept) CHECK((!kept || (*kept >= 0 && *kept < 100)));
    }
  }
}

TEST_CASE("Presses from 10 ms to 10 s are written in every format") {
  for (const char* press : {"human:10ms", "human:60ms", "human:0.5s", "human:10s"}) {
    for (const auto& format : exportFormats.all) {
      INFO(press << " " << format.word);
      CHECK(exported(sample("C"), format.value, press).ok());
    }
  }
}

TEST_CASE("A press by name is read with its unit, and refused by name") {
  const HapticProgram program = prepareProgram(sample("B"), {}, {}).value().program;
  const Result<PressTrace> milliseconds = namedPress("human:120ms", program),
                           seconds = namedPress("human:0.12s", program);
  REQUIRE(milliseconds.ok());
  REQUIRE(seconds.ok());
  CHECK(milliseconds->readings.size() == seconds->readings.size());
  for (const char* wrong : {"human:", "human:120", "human:9ms", "human:11s", "human:-5ms", "human:nans",
                            "human:1e9s", "human:120 ms", "human:infs"}) {
    INFO(wrong);
    const Result<PressTrace> refused = namedPress(wrong, program);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.failure().code == FailureCode::wrongUsage);
    CHECK(refused.failure().sentence().find(wrong) != std::string::npos);
  }
  CHECK_FALSE(namesPress("press.csv"));
  CHECK(namedPress("", program).failure().sentence().find("no press is named") != std::string::npos);
  ExportSettings slow;
  slow.format = ExportFormat::pcm;
  slow.sampleRate_Hz = 1;
  CHECK(exportPress(sample("B"), program, *seconds, slow).failure().sentence().find("--rate") !=
        std::string::npos);
}

TEST_CASE("A press under which nothing is felt, or that never ends, is refused") {
  const Button button = sample("B");
  const HapticProgram program = prepareProgram(button, {}, {}).value().program;
  const PressTrace light{PressTrace::Quantity::force_N, {{0, 0}, {0.1, 1e-4}, {0.2, 0}}};
  const Result<Exported> nothing = exportPress(button, program, light, {});
  REQUIRE_FALSE(nothing.ok());
  CHECK(nothing.failure().code == FailureCode::wrongUsage);
  CHECK(nothing.failure().sentence().find("readings") == std::string::npos);
  const PressTrace backwards{PressTrace::Quantity::force_N, {{1, 0}, {0.5, 1}, {0.2, 2}}};
  const Result<Exported> leftOut = exportPress(button, program, backwards, {});
  REQUIRE_FALSE(leftOut.ok());
  CHECK(leftOut.failure().sentence().find("2 of its 3 readings") != std::string::npos);
  const PressTrace endless{PressTrace::Quantity::force_N, {{0, 0}, {31, 1}}};
  const Result<Exported> refused = exportPress(button, program, endless, {});
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.failure().sentence().find("31") != std::string::npos);
}

TEST_CASE("A press whose times begin below 0, or with readings that are none, is cut where it turns") {
  const Button button = sample("A");
  const HapticProgram program = prepareProgram(button, {}, {}).value().program;
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const PressTrace plain{PressTrace::Quantity::force_N, {{0, 0}, {1, 1.5}, {2, 0}}};
  const PressTrace early{PressTrace::Quantity::force_N, {{-5, 0}, {-4, 1.5}, {-3, 0}}};
  const PressTrace broken{PressTrace::Quantity::force_N,
                          {{0, nan}, {0.001, 0}, {1, 1.5}, {1.5, inf}, {2, 0}}};
  const PressPlan expected = planPress(button, program, plain, "press", {}).value();
  for (const PressTrace& trace : {early, broken}) {
    const Result<PressPlan> plan = planPress(button, program, trace, "press", {});
    REQUIRE(plan.ok());
    CHECK(plan->turn_frame == expected.turn_frame);
    for (const auto& format : exportFormats.all) {
      INFO(format.word);
      ExportSettings settings;
      settings.format = format.value;
      CHECK(exportPress(button, program, trace, settings).ok());
    }
  }
}

TEST_CASE("A press too faint for a format is refused by its name, never written as silence") {
  const Button button = sample("B");
  DeviceProfile faint;
  faint.gain = 1e-6;
  const HapticProgram program = prepareProgram(button, faint, usualSettings()).value().program;
  ExportSettings settings;
  for (const auto& format : exportFormats.all) {
    INFO(format.word);
    settings.format = format.value;
    const Result<Exported> written = exportPress(button, program, standardPress(program), settings);
    const bool exact = format.value == ExportFormat::package || format.value == ExportFormat::cHeader ||
                       format.value == ExportFormat::ahap || format.value == ExportFormat::haptic ||
                       format.value == ExportFormat::openxr ||
                       format.value == ExportFormat::hjif;    // formats that can state any number
    const bool pad = format.value == ExportFormat::touchpad;  // formats that play their own waves
    CHECK(written.ok() == (exact || pad));
    if (written) continue;
    CHECK(written.failure().code == FailureCode::wrongUsage);
    CHECK(written.failure().sentence().find(format.word) != std::string::npos);
    CHECK_FALSE(written.failure().remedies.empty());
  }
}

TEST_CASE("The gain of a limiter that acted gives every sample, by few points") {
  DeviceProfile loud;
  loud.gain = 4;
  for (const char* name : {"B", "D", "F"}) {
    INFO(name);
    const Button button = sample(name);
    const HapticProgram program = prepareProgram(button, loud, usualSettings()).value().program;
    const PressPlan plan =
        planPress(button, program, standardPress(program), "standard", RenderSettings{}).value();
    REQUIRE(plan.unlimited.size() == plan.samples.size());
    const std::vector<GainPoint> gains = limiterGains(plan.unlimited, plan.samples, 1e-4);
    CHECK(gains.size() < plan.samples.size() / 20);
    REQUIRE(gains.size() > 2);
    CHECK(gains.front().frame == 0);
    CHECK(gains.back().frame == static_cast<std::int64_t>(plan.samples.size()) - 1);
    double worst = 0;
    for (std::size_t i = 0; i + 1 < gains.size(); ++i) {
      const GainPoint &a = gains[i], &b = gains[i + 1];
      REQUIRE(a.frame < b.frame);
      CHECK((b.gain >= 0 && b.gain <= 1));
      for (std::int64_t frame = a.frame; frame <= b.frame; ++frame) {
        const double share = static_cast<double>(frame - a.frame) / static_cast<double>(b.frame - a.frame);
        const double gain = a.gain + share * (b.gain - a.gain);
        const auto at = static_cast<std::size_t>(frame);
        worst = std::max(worst, std::fabs(gain * static_cast<double>(plan.unlimited[at]) -
                                          static_cast<double>(plan.samples[at])));
      }
    }
    CHECK(worst <= 1.01e-4);
  }
  CHECK(limiterGains({}, {}, 1e-4).empty());
  CHECK(limiterGains({2}, {1}, 1e-4).front().gain == Approx(0.5).margin(1e-4));
}

TEST_CASE("A package says where a stroke has grains, and how strong each piece of a slope is") {
  const Button button = sample("B");
  const HapticProgram program = prepareProgram(button, {}, usualSettings()).value().program;
  const auto package = nlohmann::json::parse(
      exportPress(button, program, standardPress(program), {}).value().files.front().text);
  CHECK(package["grains"]["level_by_density"] == levelByDensity);
  const auto& pieces = package["states"][0]["slopes"]["press"];
  const StrokeTable& press = program.states[0].press;
  REQUIRE(pieces.size() == press.slopeCount);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    CHECK(pieces[i]["level"].get<double>() == press.slopes[i].level * press.slopeLevel);
    CHECK(pieces[i]["from_mm"].get<double>() <= pieces[i]["to_mm"].get<double>());
  }
  // Every grain of the example lies within a piece and is no louder than it says.
  for (const auto& event : package["example_press"]["events"]) {
    if (event["kind"] != "grain") continue;
    const double at_mm = event["displacement_mm"], amplitude = event["wave"]["amplitude"];
    bool within = false;
    for (const char* stroke : {"press", "release"})
      for (const auto& piece : package["states"][0]["slopes"][stroke])
        within = within || (at_mm >= piece["from_mm"].get<double>() - 1e-9 &&
                            at_mm <= piece["to_mm"].get<double>() + 1e-9 &&
                            amplitude <= program.grain.amplitude * piece["level"].get<double>() + 1e-9);
    INFO(at_mm << " mm, " << amplitude);
    CHECK(within);
  }
}

TEST_CASE("A memory of 100 bytes holds what it says of presses that get longer and longer") {
  const Button button = sample("B");
  const HapticProgram program = prepareProgram(button, {}, usualSettings()).value().program;
  ExportSettings settings;
  settings.format = ExportFormat::da728x;
  std::size_t cut = 0, whole = 0;
  for (int readings = 200; readings < 12000; readings += readings < 1600 ? 200 : 800) {
    INFO(readings);
    PressTrace trace{PressTrace::Quantity::displacement_mm, {}};
    for (int i = 0; i <= readings; ++i)
      trace.readings.push_back({i * 0.0025, i == readings ? 4.2 : i % 400 < 200 ? 0.02 * (i % 400) : 0});
    const Result<Exported> written = exportPress(button, program, trace, settings);
    REQUIRE(written.ok());
    CHECK(violationsOf(settings.format, written->files) == std::vector<std::string>{});
    const bool said =
        written->loss.dropped.size() > 1 && written->loss.dropped.back().find("memory") != std::string::npos;
    ++(said ? cut : whole);
  }
  CHECK(cut > 2);
  CHECK(whole > 2);
}

TEST_CASE("A press of very many jumps ends, and what a memory cannot hold of it is reported") {
  const Button button = sample("B");
  const HapticProgram program = prepareProgram(button, {}, {}).value().program;
  PressTrace trace{PressTrace::Quantity::displacement_mm, {}};
  for (int i = 0; i <= 4000; ++i)
    trace.readings.push_back({i * 0.0025, i == 4000 ? 4.2 : i % 50 < 25 ? 0.16 * (i % 50) : 0});
  ExportSettings settings;
  for (const ExportFormat format :
       {ExportFormat::android, ExportFormat::da728x, ExportFormat::bos1921, ExportFormat::openxr}) {
    INFO(exportFormats.word(format));
    settings.format = format;
    const Result<Exported> written = exportPress(button, program, trace, settings);
    REQUIRE(written.ok());
    CHECK(violationsOf(format, written->files) == std::vector<std::string>{});
    const auto& dropped = written->loss.dropped;
    const bool cut = std::any_of(dropped.begin(), dropped.end(), [](const std::string& what) {
      return what.find("memory is full") != std::string::npos ||
             what.find("points are used up") != std::string::npos;
    });
    CHECK(cut == (format == ExportFormat::da728x || format == ExportFormat::openxr));
    CHECK(cut == written->loss.cut);
    CHECK(written->loss.worstTimingError_ms <= 1);  // the kept part of the press is in time
  }
}

TEST_CASE("A file says which feel went out, and its bursts are as strong as the engine's") {
  const Button button = sample("C");
  const HapticProgram program = prepareProgram(button, {}, usualSettings()).value().program;
  ExportSettings settings;
  for (const auto& format : exportFormats.all) {
    INFO(format.word);
    settings.format = format.value;
    const Result<Exported> written = exportPress(button, program, standardPress(program), settings);
    REQUIRE(written.ok());
    CHECK(written->files.front().text.find("clear") != std::string::npos);
  }
  settings.format = ExportFormat::package;
  const auto package = nlohmann::json::parse(
      exportPress(button, program, standardPress(program), settings).value().files.front().text);
  CHECK(package["chain"]["slope_under_jump"]["level"] == program.slopeUnderJump);
  double loudest = 0, quietest = 1;
  for (const auto& event : package["example_press"]["events"]) {
    if (event["kind"] != "grain") continue;
    loudest = std::max(loudest, event["wave"]["amplitude"].get<double>());
    quietest = std::min(quietest, event["wave"]["amplitude"].get<double>());
  }
  CHECK(loudest < program.grain.amplitude);  // by the density of a press
  CHECK(quietest < loudest);
}

TEST_CASE("A name cannot end a comment, a string or a document") {
  const std::string hostile = "*/ int x; /* \" \\ ?\?/ \n\r </script> \xFF";
  for (const auto& format : exportFormats.all) {
    INFO(format.word);
    const Result<Exported> files = exported(named(hostile), format.value);
    REQUIRE(files.ok());
    for (const ExportedFile& file : files->files) {
      const std::string& text = file.text;
      if (text.front() == '{') {
        CHECK(nlohmann::json::accept(text));
        continue;
      }
      // One comment at the head: its end is the first one, and it is followed by code.
      const auto end = text.find("*/");
      REQUIRE(end != std::string::npos);
      CHECK(text.find("int x", 0) < end);
      CHECK(text.find("int x", end) == std::string::npos);
    }
  }
}

TEST_CASE("What pads, phones and headsets bear is never exceeded") {
  for (const char* name : {"A", "C", "F", "latch", "push"}) {
    for (const char* press : {"human:10ms", "human:200ms", "human:3s"}) {
      INFO(name << " " << press);
      const auto json = [&](ExportFormat format, std::size_t file = 0) {
        return nlohmann::json::parse(exported(sample(name), format, press).value().files[file].text);
      };
      const auto openxr = json(ExportFormat::openxr);
      CHECK(openxr["amplitudePoints"].size() <= 500);
      CHECK(openxr["frequencyPoints"].size() <= 500);
      std::int64_t last = -1;
      for (const auto& point : openxr["amplitudePoints"]) {
        CHECK(point["value"] >= 0);
        CHECK(point["value"] <= 1);
        CHECK(point["time"].get<std::int64_t>() > last);
        last = point["time"];
      }
      const auto touchpad = json(ExportFormat::touchpad);
      CHECK(touchpad["press_threshold_g"] >= 110);
      CHECK(touchpad["press_threshold_g"] <= 190);
      CHECK(touchpad["intensity"]["press"] <= 4);
      for (const std::size_t part : {0U, 1U}) {
        const auto ahap = json(ExportFormat::ahap, part);
        for (const auto& entry : ahap["Pattern"]) {
          const auto& event = entry["Event"];
          CHECK(event["Time"] >= 0);
          CHECK(event["Time"] <= 30);
          for (const auto& parameter : event["EventParameters"]) {
            CHECK(parameter["ParameterValue"] >= 0);
            CHECK(parameter["ParameterValue"] <= 1);
          }
        }
      }
    }
  }
}

TEST_CASE("Files of a pair stand beside each other under the requested name") {
  CHECK(pathOf("x/click.ahap", {".press", "", ""}) == "x/click.press.ahap");
  CHECK(pathOf("click.json", {"", ".h", ""}) == "click.h");
  CHECK(pathOf("click", {".release", "", ""}) == "click.release");
}
