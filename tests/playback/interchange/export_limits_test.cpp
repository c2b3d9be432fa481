// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of every format over drawn buttons and presses: a slice of what tests/bench/export_limits counts a
// million of.

#include <map>

#include <catch2/catch.hpp>

#include "tests/playback/interchange/fuzzed_exports.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

TEST_CASE("Drawn buttons and presses keep every limit of every format, or are refused with a sentence") {
  std::map<ExportFormat, int> written;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    const FuzzedExport drawn = fuzzedExport(seed);
    const ExportVerdict verdict = judged(drawn);
    INFO("seed " << seed << ", " << exportFormats.word(drawn.settings.format));
    CHECK(verdict.violations == std::vector<std::string>{});
    if (seed % 5 == 0) CHECK(judgedByLimits(drawn).refusal == verdict.refusal);
    if (verdict.refusal.empty()) ++written[drawn.settings.format];
  }
  for (const auto& format : exportFormats.all) {
    INFO(format.word);
    CHECK(written[format.value] > 12);  // the rest draws nothing that is felt
  }
}

TEST_CASE("Draws that were written as silence are refused by the format's name") {
  for (const std::uint64_t seed : {114066U, 118428U}) {
    INFO("seed " << seed);
    const FuzzedExport drawn = fuzzedExport(seed);
    const ExportVerdict verdict = judged(drawn);
    CHECK(verdict.violations == std::vector<std::string>{});
    CHECK(verdict.refusal.find(exportFormats.word(drawn.settings.format)) != std::string::npos);
  }
}

TEST_CASE("The counting of limits notices what passes one") {
  const auto passes = [](ExportFormat format, const std::string& text) {
    return !violationsOf(format, {{"", "", text}}).empty();
  };
  CHECK(passes(ExportFormat::bos1921, "detent_slices[] = {\n  {4096, 1, 1},\n};"));
  CHECK_FALSE(passes(ExportFormat::bos1921, "detent_slices[] = {\n  {4095, 1, 1},\n};"));
  CHECK(passes(ExportFormat::drv2605, "detent_press[] = {{127, 4}};detent_release[] = {{0, 5}};"));
  CHECK(passes(ExportFormat::android,
               "object DetentButton { createWaveform(longArrayOf(5, 5), intArrayOf(256, 0), -1) }"));
  CHECK(
      passes(ExportFormat::android,
             "object DetentButton { WaveformEnvelopeBuilder().addControlPoint(0.5f, 200.0f, 20L).build() }"));
  CHECK(passes(
      ExportFormat::ahap,
      R"({"Version": 1.0, "Pattern": [{"Event": {"Time": 31, "EventType": "HapticTransient", "EventParameters": []}}]})"));
  CHECK(passes(ExportFormat::pcm, "static const int8_t detent_samples[2] = {\n  1, 128,\n};"));
  CHECK(passes(ExportFormat::pcm, "static const int8_t detent_samples[2] = {\n  0, 0,\n};"));
  CHECK_FALSE(passes(ExportFormat::pcm, "static const int8_t detent_samples[2] = {\n  1, 127,\n};"));
  CHECK(passes(ExportFormat::bos1921, "detent_slices[] = {\n  {0, 1, 1},\n};"));
}
