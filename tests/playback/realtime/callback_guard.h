// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Test-only proof that the callback neither allocates nor blocks: interposes malloc, free, locks and the
// system calls that wait or write (POSIX symbols of the test program win over the C library's) and counts
// what happens inside a guarded scope. Never linked into a product.

#include <cstdint>
#include <string>

namespace detent::test {

/// While one lives on this thread, every guarded call is a hit.
class GuardedScope {
 public:
  GuardedScope();
  ~GuardedScope();
  GuardedScope(const GuardedScope&) = delete;
  GuardedScope& operator=(const GuardedScope&) = delete;
};

/// Plain functions with the same meaning, for hooks.
void enterGuard();
void leaveGuard();

std::uint64_t guardHits();
/// Number of guarded calls that allocate or free memory.
std::uint64_t guardedMemoryCalls();
/// Name of the first guarded call since the last reset; empty if none.
std::string firstGuardHit();
void resetGuard();
/// False where another tool (AddressSanitizer) owns malloc.
bool guardWorks();

}  // namespace detent::test
