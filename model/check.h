// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Checks for programming errors. They stay on in release builds. Not for external errors, and not in the
// audio callback.

namespace detent {

/// Prints file, line and condition to stderr and aborts.
[[noreturn]] void failCheck(const char* file, int line, const char* condition, const char* why);

}  // namespace detent

/// `why` names the broken contract, e.g. DETENT_CHECK(i < n, "piece index inside the curve").
#define DETENT_CHECK(condition, why) \
  ((condition) ? static_cast<void>(0) : ::detent::failCheck(__FILE__, __LINE__, #condition, why))
