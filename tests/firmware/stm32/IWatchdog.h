// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The watchdog library of the STM32 core, as far as force1d uses it: see other_cores.h.

#include <cstdint>

struct StmWatchdog {
  void begin(std::uint32_t timeout_us);
  void reload();
};
extern StmWatchdog IWatchdog;
