// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A subcommand of detent-play: a separate file that adds its options to the command line and, if it is
// chosen, returns the function to run. run.cpp lists all of them.

#include <functional>

#include "model/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace detent::playback {

/// Called often by everything that takes long; returns true if the user wants the program to end.
using Cancelled = std::function<bool()>;

/// A parsed subcommand, ready to run. Writes messages to stderr and results to stdout; returns the exit code.
using Action = std::function<int(const Cancelled&)>;

/// Prints a failure's sentence to stderr; returns its exit code.
int fail(const Failure& failure);

}  // namespace detent::playback
