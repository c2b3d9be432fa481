// SPDX-License-Identifier: GPL-3.0-or-later
// The journal's hash and the next difference of a threshold study as WebAssembly, linked with
// page_engine.cpp. Compiled only for wasm32-wasi; station.js calls it on the page's thread.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/sha256.h"
#include "playback/study/statistics/quest_plus.h"

namespace {

std::string& text() {
  static std::string only;
  return only;
}
std::vector<double>& values() {
  static std::vector<double> only;
  return only;
}

}  // namespace

#define DETENT_EXPORT(name) extern "C" __attribute__((export_name(#name), visibility("default")))

/// Room for this many bytes of UTF-8.
DETENT_EXPORT(detent_text) char* detent_text(std::uint32_t bytes) {
  text().assign(bytes, '\0');
  return text().data();
}
/// SHA-256 of detent_text's bytes: 64 hexadecimal digits.
DETENT_EXPORT(detent_sha256) const char* detent_sha256() {
  text() = detent::sha256Hex(std::string_view(text()));
  return text().data();
}

/// Room for this many numbers, for detent_next_level.
DETENT_EXPORT(detent_values) double* detent_values(std::uint32_t count) {
  values().assign(count, 0);
  return values().data();
}
/// Index of the difference that QUEST+ would ask next. detent_values contains `levels` increasing
/// differences, then two numbers per answer: its level, and 1 if it was correct.
DETENT_EXPORT(detent_next_level) std::uint32_t detent_next_level(std::uint32_t levels) {
  const std::vector<double>& v = values();
  detent::playback::QuestPlus quest({v.data(), v.data() + levels});
  for (std::size_t i = levels; i + 1 < v.size(); i += 2)
    quest.take({static_cast<std::size_t>(v[i]), v[i + 1] == 1});
  return static_cast<std::uint32_t>(quest.nextLevel());
}
