// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Many inputs, each in a process of its own: a crash or a hang on one costs that one only. POSIX.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace detent::importer {

struct BatchOptions {
  int jobs = 0;                  ///< processes at once; 0: one per core
  double timeLimit_s = 120;      ///< per input, elapsed time; > 0
  double memoryLimit_MB = 4096;  ///< per input, address space; > 0
};

/// A child's result for its input: lines for the report, already complete.
struct InputOutcome {
  std::string input;
  int exitCode = 0;
  std::string reportLines;  ///< JSON lines, each ending in '\n'; empty if the child died
  std::string death;        ///< "crashed (signal 11)", "hung for more than 120 s"; else empty
  bool killed = false;      ///< by somebody else: a person, a machine out of memory
};

/// Runs `handle(input)` in a child for every input; it prints JSON lines to the file descriptor it is given
/// as a stream of text and returns the exit code. A child that is killed from outside is started once more.
/// `finished` is called in the order of the inputs, whatever `jobs` is, on the calling thread; `cancelled` is
/// called several times a second. Call from a process without other threads.
Result<Done> runIsolated(const std::vector<std::string>& inputs, const BatchOptions& options,
                         const std::function<int(const std::string& input, std::string& reportLines)>& handle,
                         const std::function<void(const InputOutcome&)>& finished,
                         const std::function<bool()>& cancelled);

}  // namespace detent::importer
