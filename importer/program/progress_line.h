// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Shows progress in one line of a terminal; silent if stderr is no terminal.

#include <string_view>

namespace detent::importer {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();  ///< wipes the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double fraction, std::string_view what);

 private:
  bool onTerminal_;
  bool shown_ = false;
};

}  // namespace detent::importer
