// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A subcommand of detent-play: a file of its own that adds its options to the command line and, if it was
// chosen, returns the function to run. run.cpp lists them all.

#include <functional>

#include "model/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace detent::playback {

/// Called often by everything that takes long; true if the user wants the program to end.
using Cancelled = std::function<bool()>;

/// A parsed subcommand, ready to run. Human text to stderr, results to stdout; gives the exit code.
using Action = std::function<int(const Cancelled&)>;

/// Prints a failure's sentence to stderr; gives its exit code.
int fail(const Failure& failure);

}  // namespace detent::playback
