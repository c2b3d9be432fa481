// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the place of importer/page/tuned.cpp in `import_ablation`: DETENT_TUNED="choice.minSpan=0.2,chroma.halo=0.3" changes thresholds.

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "importer/page/tuned.h"

namespace detent::importer {

namespace {

std::map<std::string, double> changedThresholds() {
  std::map<std::string, double> changed;
  const char* const text = std::getenv("DETENT_TUNED");
  std::istringstream pairs(text ? text : "");
  for (std::string pair; std::getline(pairs, pair, ',');)
    if (const auto sign = pair.find('='); sign != std::string::npos)
      changed[pair.substr(0, sign)] = std::strtod(pair.c_str() + sign + 1, nullptr);
  return changed;
}

}  // namespace

double tuned(const char* name, double standard) {
  static const std::map<std::string, double> changed = changedThresholds();
  const auto found = changed.find(name);
  return found == changed.end() ? standard : found->second;
}

}  // namespace detent::importer
