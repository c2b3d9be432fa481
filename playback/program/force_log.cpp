// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/force_log.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "playback/program/force_words.h"
#include "playback/study/text_output.h"

namespace detent::playback {

namespace {

Failure cannotWrite(const std::string& path) {
  return {FailureCode::unreadableInput, path, "", "the log cannot be written",
          "Name a file in a folder you may write to"};
}

/// A state's name as one field.
std::string fieldOf(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return c == ',' || c == '"' || static_cast<unsigned char>(c) < ' '; }, ' ');
  return name;
}

}  // namespace

ForceLog::ForceLog(std::string path)
    : path_(std::move(path)), partPath_(path_ + ".part"), out_(partPath_, std::ios::binary) {}

Result<ForceLog> ForceLog::open(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return cannotWrite(path);
  ForceLog log(path);
  log.out_ << "time_s,position_mm,velocity_mm_per_s,force_N,energy_mJ,state\n";
  if (!log.out_) return cannotWrite(path);
  return log;
}

ForceLog::~ForceLog() {
  if (!out_.is_open()) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(partPath_, ignored);
}

void ForceLog::write(const ForceStep& step, double period_s, const Button& button) {
  out_ << exact(static_cast<double>(step.index - 1) * period_s) << ',' << exact(step.position_mm) << ','
       << exact(step.velocity_mm_per_s) << ',' << exact(step.force_N) << ',' << exact(step.energy_mJ) << ','
       << fieldOf(stateName(button, step.state)) << '\n';
}

Result<Done> ForceLog::finish() {
  out_.close();
  std::error_code error;
  if (out_) std::filesystem::rename(partPath_, path_, error);
  if (out_ && !error) return Done{};
  std::filesystem::remove(partPath_, error);
  return cannotWrite(path_);
}

}  // namespace detent::playback
