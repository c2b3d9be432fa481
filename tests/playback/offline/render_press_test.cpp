// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include <catch2/catch.hpp>

#include "playback/offline/press_files.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

PressTrace raisedCosine(double duration_s, double peak_N, double rate_Hz = 425) {
  PressTrace trace;
  for (double t = 0; t <= duration_s; t += 1 / rate_Hz) {
    trace.readings.push_back({t, peak_N * 0.5 * (1 - std::cos(2 * M_PI * t / duration_s))});
  }
  return trace;
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() /
                               ("detent-render-" + std::to_string(std::rand()) + std::to_string(std::rand()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

}  // namespace

TEST_CASE("trace: header, quantities, comments and faults") {
  Result<PressTrace> t =
      parsePressTrace("\xEF\xBB\xBF# recorded\r\ntime_s,force_N\r\n0,0\r\n0.1,nan\r\n\n0.2,1e-3\n", "x.csv");
  REQUIRE(t);
  CHECK(t->readings.size() == 3);
  CHECK(t->quantity == PressTrace::Quantity::force_N);
  REQUIRE(parsePressTrace("time_s,displacement_mm\n0,0\n", "x"));
  CHECK(parsePressTrace("", "bad.csv").failure().sentence().find("is empty") != std::string::npos);
  for (const char* bad : {"0,0\n", "time_s,force_N\n", "time_s,force_N\n1;2\n", "time_s,force_N\nnan,1\n",
                          "time_s,force_N\n1,abc\n", "time_s,newton\n0,0\n"}) {
    const Result<PressTrace> refused = parsePressTrace(bad, "bad.csv");
    REQUIRE_FALSE(refused);
    CHECK(refused.failure().exitCode() == 3);
    CHECK(refused.failure().sentence().find("line ") != std::string::npos);
  }
}

TEST_CASE("render: the same bits for every block, and for every call") {
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  const PressTrace trace = raisedCosine(0.3, 1.3);
  RenderSettings settings;
  const Result<RenderedPress> expected = renderPress(*program, trace, settings);
  REQUIRE(expected);
  CHECK(expected->summary.peak > 0.3f);
  for (const std::size_t block : std::initializer_list<std::size_t>{1, 64, 333, 8192}) {
    settings.block = block;
    const Result<RenderedPress> other = renderPress(*program, trace, settings);
    REQUIRE(other);
    CHECK(other->samples == expected->samples);
  }
}

TEST_CASE("render: a sparse trace is a straight line between its readings") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  const PressTrace sparse{PressTrace::Quantity::force_N, {{0, 0}, {0.5, 0.8}}};
  PressTrace dense;
  for (int i = 0; i <= 400; ++i) dense.readings.push_back({i / 800.0, i / 500.0});
  const auto a = renderPress(*program, sparse, {});
  const auto b = renderPress(*program, dense, {});
  REQUIRE(a);
  REQUIRE(b);
  REQUIRE(a->summary.events.size() == b->summary.events.size());
  for (std::size_t i = 0; i < a->summary.events.size(); ++i) {
    CHECK(std::llabs(a->summary.events[i].frame - b->summary.events[i].frame) <= 2);
  }
}

TEST_CASE("render: not-a-numbers and glitches in a trace are left out and counted") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  PressTrace trace = raisedCosine(0.5, 1);
  const auto clean = renderPress(*program, trace, {});
  trace.readings.insert(trace.readings.begin() + 50, {trace.readings[49].time_s + 1e-3, std::nan("")});
  trace.readings.insert(trace.readings.begin() + 80, {trace.readings[79].time_s + 1e-3, 29});
  trace.readings.insert(trace.readings.begin() + 90, {trace.readings[89].time_s - 0.1, 0.3});
  const auto dirty = renderPress(*program, trace, {});
  REQUIRE(dirty);
  CHECK(dirty->summary.sensor.notFinite == 1);
  CHECK(dirty->summary.sensor.glitches == 1);
  CHECK(dirty->summary.sensor.outOfOrder == 1);
  CHECK(dirty->samples == clean->samples);
}

TEST_CASE("render: an emergency stop of 60 N is no fault of the sensor") {
  const Button heavy =
      buttonOf("heavy", {stateOf("", {{0, 2}, {4, 60}, {6, 30}, {10, 70}}, {{0, 1}, {10, 60}})});
  const auto program = std::make_unique<HapticProgram>(programOf(heavy));
  const auto rendered = renderPress(*program, raisedCosine(0.05, 90), {});
  REQUIRE(rendered);
  CHECK(rendered->summary.counts.pressJumps == 1);
  CHECK(rendered->summary.sensor.outOfRange + rendered->summary.sensor.glitches == 0);
}

TEST_CASE("render: bad settings are refused") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  RenderSettings settings;
  settings.sampleRate_Hz = 7999;
  CHECK_FALSE(renderPress(*program, raisedCosine(0.1, 1), settings));
  settings.sampleRate_Hz = std::nan("");
  CHECK_FALSE(renderPress(*program, raisedCosine(0.1, 1), settings));
  settings = {};
  settings.block = 8193;
  CHECK_FALSE(renderPress(*program, raisedCosine(0.1, 1), settings));
  CHECK_FALSE(renderPress(*program, PressTrace{}, {}));
}

TEST_CASE("render to file: whole or not at all, and bit for bit the same") {
  const Folder folder;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  const PressTrace trace = raisedCosine(0.3, 1.3);
  REQUIRE(renderPressToFile(*program, trace, {}, folder.path / "a.wav"));
  REQUIRE(renderPressToFile(*program, trace, {}, folder.path / "b.wav"));
  REQUIRE(renderPressToFile(*program, trace, {}, folder.path / "c.FLAC"));
  CHECK(contentOf(folder.path / "a.wav") == contentOf(folder.path / "b.wav"));
  CHECK(contentOf(folder.path / "c.FLAC").substr(0, 4) == "fLaC");
  CHECK(renderPressToFile(*program, trace, {}, folder.path / "a.mp3").failure().exitCode() == 2);
  CHECK(renderPressToFile(*program, trace, {}, folder.path / "none" / "a.wav").failure().exitCode() == 2);
  // Cancelled half way: the old file stands, nothing else does.
  const std::string before = contentOf(folder.path / "a.wav");
  RenderSettings settings;
  settings.block = 64;
  int calls = 0;
  settings.cancelled = [&] { return ++calls > 20; };
  CHECK_FALSE(renderPressToFile(*program, trace, settings, folder.path / "a.wav"));
  CHECK(contentOf(folder.path / "a.wav") == before);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path))
    files += entry.is_regular_file() ? 1 : 0;
  CHECK(files == 3);
}

TEST_CASE("render to file: what may pass 4 GiB is an RF64, whose lengths have 64 bits") {
  const Folder folder;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  RenderSettings settings;
  settings.sampleRate_Hz = 192000;
  const auto kind = [&](double bytes) {
    // The last reading may be NaN: the file is planned for it, and ends before.
    PressTrace trace = raisedCosine(0.05, 1.3);
    const double bytesEach = settings.format == SampleFormat::bits16 ? 2 : 4;
    trace.readings.push_back({bytes / bytesEach / settings.sampleRate_Hz, std::nan("")});
    const Result<RenderSummary> summary =
        renderPressToFile(*program, trace, settings, folder.path / "long.wav");
    REQUIRE(summary);
    CHECK(summary->duration_s < 10);
    return contentOf(folder.path / "long.wav").substr(0, 4);
  };
  constexpr double limit_bytes = 4.0 * 1024 * 1024 * 1024;
  CHECK(kind(0.99 * limit_bytes) == "RIFF");
  CHECK(kind(1.01 * limit_bytes) == "RF64");
  settings.format = SampleFormat::bits16;
  CHECK(kind(0.99 * limit_bytes) == "RIFF");
  CHECK(kind(1.01 * limit_bytes) == "RF64");
}
