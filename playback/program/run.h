// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What detent-play does with its arguments. Human text to stderr, results to stdout.

#include <functional>

#include "playback/program/arguments.h"

namespace detent::playback {

using Cancelled = std::function<bool()>;

/// Exit code.
int run(const Arguments& arguments, const Cancelled& cancelled);

/// The live view of `detent-play BUTTON` (live_view.cpp; without devices it explains itself).
int runLive(const Arguments& arguments, const std::vector<Button>& buttons, const DeviceProfile& profile,
            const Cancelled& cancelled);

/// Prints a failure's sentence to stderr; gives its exit code.
int fail(const Failure& failure);

}  // namespace detent::playback
