// SPDX-License-Identifier: GPL-3.0-or-later
// What is heard of a press: at its sample behind the click, once a press, at its level, on a channel of its
// own.
#include "playback/realtime/press_sound.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <catch2/catch.hpp>

#include "model/file/button_file.h"
#include "playback/prepare/prepare_program.h"
#include "playback/realtime/live_session.h"

using namespace detent;
using namespace detent::playback;

namespace {

constexpr double rate_Hz = 48000, press_s = 0.5, peak_N = 3;
constexpr std::size_t block = 256;

struct Heard {
  std::vector<float> felt, ears;
  std::vector<std::int64_t> clicks;  ///< first jump of each press
};

/// Two presses of half a second each, as a sine, a second apart.
Heard twoPresses(const std::string& name, const PressSound& sound) {
  Result<Button> button = readButtonFile(DETENT_SOURCE_DIR "/samples/buttons/" + name + ".button.json");
  REQUIRE(button);
  const auto program = std::make_unique<HapticProgram>(prepareProgram(*button, {}, {})->program);
  LiveSession session(rate_Hz);
  session.setPressSound(sound);
  SessionCommand use;
  use.kind = CommandKind::program;
  use.program = program.get();
  REQUIRE(session.send(Lane::control, use));
  Heard heard;
  bool clicked = false;
  for (std::size_t at = 0; at < 2 * static_cast<std::size_t>(rate_Hz); at += block) {
    const double t_s = std::fmod(static_cast<double>(at) / rate_Hz, 1.0);
    SessionCommand force;
    force.timeBase = TimeBase::streamFrames;
    force.time = static_cast<double>(at);
    force.value = t_s < press_s ? peak_N * std::pow(std::sin(3.14159265 * t_s / press_s), 2) : 0;
    REQUIRE(session.send(Lane::trace, force));
    std::vector<float> felt(block), ears(block);
    session.process(felt.data(), block, static_cast<double>(at) / rate_Hz);
    if (session.pressSounds()) session.addPressSound(ears.data(), felt.data(), block);
    heard.felt.insert(heard.felt.end(), felt.begin(), felt.end());
    heard.ears.insert(heard.ears.end(), ears.begin(), ears.end());
    if (t_s < 0.02) clicked = false;
    for (SessionReport report; session.receive(report);) {
      const bool click = report.kind == ReportKind::event && (report.event.kind == EventKind::pressJump ||
                                                              report.event.kind == EventKind::bottomOut ||
                                                              report.event.kind == EventKind::contactClosed);
      if (click && !clicked) heard.clicks.push_back(report.event.frame);
      clicked |= click;
    }
  }
  return heard;
}

}  // namespace

TEST_CASE("a recording begins at the click's sample plus the delay, once a press, at its level", "[study]") {
  PressSound sound;
  sound.samples = {0.5F, -0.25F, 0.125F};
  sound.sampleRate_Hz = rate_Hz;
  sound.level_dB = -20 * std::log10(2.0);
  for (const double delay_ms : {0.0, 7.5, 60.0}) {
    sound.delay_s = delay_ms / 1000;
    const auto delay = static_cast<std::int64_t>(std::lround(sound.delay_s * rate_Hz));
    const Heard heard = twoPresses("B", sound);
    REQUIRE(heard.clicks.size() == 2);
    std::vector<float> expected(heard.ears.size(), 0.0F);
    for (const std::int64_t click : heard.clicks)
      for (std::size_t i = 0; i < 3; ++i)
        expected[static_cast<std::size_t>(click + delay) + i] = 0.5F * sound.samples[i];
    for (std::size_t i = 0; i < expected.size(); ++i)
      if (std::abs(heard.ears[i] - expected[i]) > 1e-6F) FAIL("sample " << i << " at " << delay_ms << " ms");
  }
}

TEST_CASE("a button without a jump is heard where it bottoms out or closes its contact", "[study]") {
  PressSound sound;
  sound.samples = {1.0F};
  const Heard heard = twoPresses("A", sound);
  REQUIRE(heard.clicks.size() == 2);
  CHECK(std::count_if(heard.ears.begin(), heard.ears.end(), [](float v) { return v != 0; }) == 2);
  CHECK(heard.ears[static_cast<std::size_t>(heard.clicks[0])] == 1.0F);
}

TEST_CASE("the rendered sound is the vibration's own samples, later, at its level", "[study]") {
  PressSound sound;
  sound.rendered = true;
  sound.level_dB = 6;
  sound.delay_s = 0.0101;
  const Heard heard = twoPresses("B", sound);
  const std::size_t delay = 485;  // 0.0101 s of 48000 Hz
  const float gain = std::pow(10.0F, 0.3F);
  float loudest = 0;
  for (std::size_t i = 0; i < heard.ears.size(); ++i) {
    const float expected = i < delay ? 0.0F : std::clamp(gain * heard.felt[i - delay], -1.0F, 1.0F);
    if (std::abs(heard.ears[i] - expected) > 1e-6F) FAIL("sample " << i);
    loudest = std::max(loudest, std::abs(heard.ears[i]));
  }
  CHECK(loudest > 0.01F);
}

TEST_CASE("without a sound of presses the ears get nothing", "[study]") {
  const Heard heard = twoPresses("B", {});
  CHECK(std::all_of(heard.ears.begin(), heard.ears.end(), [](float v) { return v == 0; }));
}
