// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/active_state.h"

#include <catch2/catch.hpp>

#include "model/templates.h"

using namespace detent;

namespace {

// Forces of one full press and release.
std::vector<ButtonPosition> cycle(ButtonTracker& tracker, double peak_N) {
  std::vector<ButtonPosition> positions;
  for (int i = 1; i <= 200; ++i) positions.push_back(tracker.update(peak_N * i / 200));
  for (int i = 199; i >= 0; --i) positions.push_back(tracker.update(peak_N * i / 200));
  return positions;
}

}  // namespace

TEST_CASE("a self-locking button alternates at each actuation") {
  const auto button = selfLockingButton();
  REQUIRE(button.ok());
  ButtonTracker tracker(*button);
  for (std::size_t actuation = 1; actuation <= 4; ++actuation) {
    const std::size_t before = tracker.activeState().index();
    CHECK(before == (actuation - 1) % 2);
    cycle(tracker, 1.4);
    CHECK(tracker.activeState().actuations() == actuation);
    CHECK(tracker.activeState().index() == actuation % 2);
  }
}

TEST_CASE("the locked button rests at its lock, the unlocked one at 0") {
  const auto button = selfLockingButton();
  REQUIRE(button.ok());
  ButtonTracker tracker(*button);
  CHECK(cycle(tracker, 1.4).back().position.displacement_mm == 2.5);
  CHECK(cycle(tracker, 1.4).back().position.displacement_mm == 0);
}

TEST_CASE("a press that does not reach the operating point changes nothing") {
  const auto button = selfLockingButton();
  REQUIRE(button.ok());
  ButtonTracker tracker(*button);
  cycle(tracker, 0.6);
  CHECK(tracker.activeState().actuations() == 0);
  CHECK(tracker.activeState().index() == 0);
}

TEST_CASE("one stroke never changes its curve") {
  const auto button = selfLockingButton();
  REQUIRE(button.ok());
  ButtonTracker tracker(*button);
  std::size_t changes = 0;
  for (const ButtonPosition& p : cycle(tracker, 1.4)) {
    changes += p.stateChanged;
    if (p.position.stroke == Stroke::press) CHECK(p.state == 0);
  }
  CHECK(changes == 1);
}

TEST_CASE("a momentary button counts and stays") {
  const auto button = clickyButton();
  REQUIRE(button.ok());
  ButtonTracker tracker(*button);
  cycle(tracker, 1.0);
  cycle(tracker, 1.0);
  CHECK(tracker.activeState().actuations() == 2);
  CHECK(tracker.activeState().index() == 0);
}
