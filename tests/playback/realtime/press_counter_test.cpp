// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/press_counter.h"

#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

/// Applies a finger's forces to a button and counts the presses.
class Finger {
 public:
  explicit Finger(const Button& button) : program_(std::make_unique<HapticProgram>(programOf(button))) {
    tracker_.use(program_.get());
    counter_.use(program_.get());
  }
  /// From the force before to this one and no further, in small steps.
  Finger& to(double force_N) {
    for (int i = 1; i <= 50; ++i) {
      const double f = last_N_ + (force_N - last_N_) * i / 50;
      tracker_.updateForce(f);
      counter_.take(tracker_.position());
    }
    last_N_ = force_N;
    return *this;
  }
  PressCount taken() { return counter_.taken(); }
  PressCounter& counter() { return counter_; }
  const HapticProgram* program() const { return program_.get(); }

 private:
  std::unique_ptr<HapticProgram> program_;
  StrokeTracker tracker_;
  PressCounter counter_;
  double last_N_ = 0;
};

}  // namespace

TEST_CASE(
    "presses: to the end and back is one; the strongest force and the deepest place are reported once") {
  for (const Button& button : {linearButton(), tactileButton(), twoLevelButton()}) {
    Finger finger(button);
    finger.to(0);
    CHECK(finger.taken().begun == 0);
    finger.to(4).to(0);
    const PressCount one = finger.taken();
    CHECK(one.begun == 1);
    CHECK(one.whole == 1);
    CHECK(one.peak_N == Approx(4));
    CHECK(one.travel_mm > 1.9);
    finger.to(4).to(0).to(4).to(0);
    CHECK(finger.taken().whole == 2);
    CHECK(finger.taken().peak_N == 0);
  }
}

TEST_CASE("presses: what was let go early, is held still, or sends nothing is none") {
  Finger light(tactileButton());
  light.to(0).to(0.4).to(0).to(0.5).to(0);
  const PressCount early = light.taken();
  CHECK(early.begun == 2);
  CHECK(early.whole == 0);
  Finger held(tactileButton());
  held.to(0).to(4);
  CHECK(held.taken().whole == 0);
  Finger dead(tactileButton());
  for (int i = 0; i < 1000; ++i) dead.to(i % 2 == 0 ? 0 : 0.02);
  CHECK(dead.taken().begun == 0);
  Finger nothing(tactileButton());
  CHECK(nothing.taken().whole == 0);
}

TEST_CASE("presses: a finger that is down when the button comes under it has to come up first") {
  Finger finger(tactileButton());
  finger.to(0).to(4);
  finger.counter().use(finger.program());
  finger.to(0);
  CHECK(finger.taken().whole == 0);
  finger.to(4).to(0);
  CHECK(finger.taken().whole == 1);
}

TEST_CASE("presses: a self-locking button is pressed in both states") {
  Finger finger(lockingButton());
  finger.to(0).to(4).to(0);
  CHECK(finger.taken().whole == 1);
  finger.to(4).to(0);
  CHECK(finger.taken().whole == 1);
}
