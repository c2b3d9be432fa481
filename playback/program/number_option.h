// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Options whose value is a number.

#include <CLI/CLI.hpp>

#include "model/program/command_line.h"

namespace detent::playback {

inline CLI::Validator numberWithin(double low, double high) {
  return detent::numberWithin<CLI::Validator>(low, high);
}

}  // namespace detent::playback
