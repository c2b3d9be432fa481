// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/progress_json.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"

namespace detent::importer {
namespace {

using Json = nlohmann::ordered_json;

constexpr double shownEvery = 0.05;  // share of the whole work

void printLine(const Json& json) {
  std::fprintf(stdout, "%s\n", jsonText(json).c_str());
  std::fflush(stdout);  // flushed at once, because a reader acts on each line
}

}  // namespace

void StepLines::show(double fraction, ImportStep step) {
  if (last_ == step && fraction < shown_ + shownEvery) return;
  last_ = step;
  shown_ = fraction;
  printLine({{"progress", fraction}, {"step", nameOf(step)}});
}

void showInputDone(const std::string& input, int exitCode, std::size_t done, std::size_t total) {
  printLine({{"progress", static_cast<double>(done) / static_cast<double>(total)},
             {"input", input},
             {"exit_code", exitCode},
             {"done", done},
             {"total", total}});
}

}  // namespace detent::importer
