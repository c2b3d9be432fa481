// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The log of a force loop: one row per step, written while it runs. The file appears only when it is
// complete.

#include <fstream>
#include <string>

#include "model/result.h"
#include "model/staged_file.h"
#include "playback/force_feedback.h"

namespace detent::playback {

class ForceLog {
 public:
  /// Opens a file beside `path`, which `finish` moves there. Failure: as StagedFile's.
  static Result<ForceLog> open(const std::string& path);
  ForceLog(ForceLog&& other) noexcept = default;
  ForceLog& operator=(ForceLog&&) = delete;

  /// Writes one step. `period_s` determines its time; names of states come from `button`, without commas.
  void write(const ForceStep& step, double period_s, const Button& button);
  Result<Done> finish();

 private:
  explicit ForceLog(StagedFile file);
  StagedFile file_;  // an unfinished file is removed
  std::ofstream out_;
};

}  // namespace detent::playback
