// SPDX-License-Identifier: GPL-3.0-or-later
// DETENT_TRAP_FLOATS=1: an invalid operation or an overflow ends the test on the spot (SIGFPE), instead of
// leaving a NaN or an infinity to be found later, or not. For tests whose input is finite and within its
// range: tag [finite].

#include <cfenv>
#include <cstdlib>

#define CATCH_CONFIG_EXTERNAL_INTERFACES  // listeners
#include <catch2/catch.hpp>

namespace {

struct FloatTraps : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo&) override {
    if (std::getenv("DETENT_TRAP_FLOATS") == nullptr) return;
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_OVERFLOW);
  }
  void testCaseEnded(const Catch::TestCaseStats&) override { fedisableexcept(FE_INVALID | FE_OVERFLOW); }
};

}  // namespace

CATCH_REGISTER_LISTENER(FloatTraps)

TEST_CASE("the traps work", "[.traps]") {
  volatile double large = 1e308;
  CHECK(large * 10 > 0);
}
