// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forced into every file of the copy that tests/bench/ablate.py builds: there each threshold of a step reads
// DETENT_TUNED="trace/loop_path.cpp:kSteepFall=2.6,..." once and is what the source says where that does not
// name it.

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

inline double detentTuned(const char* threshold, double standard) {
  static const std::map<std::string, double> changed = [] {
    std::map<std::string, double> values;
    const char* const text = std::getenv("DETENT_TUNED");
    std::istringstream pairs(text ? text : "");
    for (std::string pair; std::getline(pairs, pair, ',');)
      if (const auto sign = pair.find('='); sign != std::string::npos)
        values[pair.substr(0, sign)] = std::strtod(pair.c_str() + sign + 1, nullptr);
    return values;
  }();
  const auto found = changed.find(threshold);
  return found == changed.end() ? standard : found->second;
}

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): stands where a literal stood, so it is an expression, and reads its value once.
#define DETENT_TUNED(type, threshold, standard)                                    \
  ([]() -> type {                                                                  \
    static const type value = static_cast<type>(detentTuned(threshold, standard)); \
    return value;                                                                  \
  }())
