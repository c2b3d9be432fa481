// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/force_log.h"

#include <algorithm>
#include <utility>

#include "playback/measurement/exact_number.h"
#include "playback/program/force_words.h"

namespace detent::playback {

namespace {

/// A state's name in the form of one CSV field.
std::string fieldOf(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return c == ',' || c == '"' || static_cast<unsigned char>(c) < ' '; }, ' ');
  return name;
}

}  // namespace

ForceLog::ForceLog(StagedFile file) : file_(std::move(file)), out_(file_.path(), std::ios::binary) {}

Result<ForceLog> ForceLog::open(const std::string& path) {
  auto file = StagedFile::beside(path);
  if (!file) return file.failure();
  ForceLog log(*std::move(file));
  log.out_ << "time_s,position_mm,velocity_mm_per_s,force_N,energy_mJ,state\n";
  if (!log.out_) return log.file_.notWritten("");
  return log;
}

void ForceLog::write(const ForceStep& step, double period_s, const Button& button) {
  out_ << exact(static_cast<double>(step.index - 1) * period_s) << ',' << exact(step.position_mm) << ','
       << exact(step.velocity_mm_per_s) << ',' << exact(step.force_N) << ',' << exact(step.energy_mJ) << ','
       << fieldOf(stateName(button, step.state)) << '\n';
}

Result<Done> ForceLog::finish() {
  out_.close();
  return out_ ? file_.commit() : file_.notWritten("");
}

}  // namespace detent::playback
