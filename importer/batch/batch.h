// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Imports many inputs, each in its own process, so that a crash or a hang affects one input only. POSIX.

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
  bool killed = false;      ///< killed from outside: by a person, or because the machine ran out of memory
};

/// Runs `handle(input)` in a child process for every input. It writes JSON lines to the given file descriptor
/// and returns the exit code. A child that was killed from outside is started once more. `finished` is called
/// in the order of the inputs, whatever `jobs` is, on the calling thread; `cancelled` is called several times
/// a second. Call from a process without other threads.
Result<Done> runIsolated(const std::vector<std::string>& inputs, const BatchOptions& options,
                         const std::function<int(const std::string& input, std::string& reportLines)>& handle,
                         const std::function<void(const InputOutcome&)>& finished,
                         const std::function<bool()>& cancelled);

}  // namespace detent::importer
