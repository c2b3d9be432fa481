// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Our own bugs: a check that stays on in release. Never for the world's faults, never in the audio
// callback.

namespace detent {

/// Prints file, line and condition to stderr and aborts.
[[noreturn]] void failCheck(const char* file, int line, const char* condition, const char* why);

}  // namespace detent

/// `why` says which contract was broken, e.g. DETENT_CHECK(i < n, "piece index inside the curve").
#define DETENT_CHECK(condition, why) \
  ((condition) ? static_cast<void>(0) : ::detent::failCheck(__FILE__, __LINE__, #condition, why))
