// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/direction_proof.h"

#include <algorithm>
#include <cmath>

namespace detent::playback {

namespace {

constexpr double longestPush_s = 0.15, longestProof_s = 3;
constexpr std::uint32_t turnsThatProve = 3;

}  // namespace

void DirectionProof::restart() { *this = DirectionProof(settings_, period_s_); }

void DirectionProof::begin(double position_mm, double push) {
  begun_ = true;
  push_ = push;
  from_mm_ = farthest_mm_ = position_mm;
  turns_ = 0;
  time_s_ = 0;
}

// First push, from rest: in whichever direction the handle moves, that is its answer.
void DirectionProof::firstPush(double position_mm) {
  const double way_mm = position_mm - from_mm_;
  if (std::abs(way_mm) >= settings_.way_mm) {
    moving_ = std::copysign(1.0, way_mm);
    answer_ = moving_ * push_;
  } else if (time_s_ < longestPush_s) {
    return;
  } else {
    return begin(position_mm, -push_);  // the handle may be at a stop, so the other direction is tried
  }
  farthest_mm_ = position_mm;
  turns_ = 1;
  push_ = -push_;
  time_s_ = 0;
}

// Push in the other direction: the handle must slow down, turn, and come back.
void DirectionProof::turningPush(double position_mm) {
  farthest_mm_ = moving_ > 0 ? std::max(farthest_mm_, position_mm) : std::min(farthest_mm_, position_mm);
  if (moving_ * (farthest_mm_ - position_mm) >= settings_.way_mm) {
    moving_ = -moving_;
    farthest_mm_ = position_mm;
    push_ = -push_;
    time_s_ = 0;
    if (++turns_ == turnsThatProve) verdict_ = answer_ > 0 ? Verdict::agrees : Verdict::reversed;
  } else if (time_s_ >= longestPush_s) {
    begin(position_mm, -push_);  // something else moves the handle, so this push is repeated
  }
}

double DirectionProof::step_N(double position_mm) {
  if (!begun_) begin(position_mm, 1);
  time_s_ += period_s_;
  all_s_ += period_s_;
  if (turns_ == 0) {
    firstPush(position_mm);
  } else {
    turningPush(position_mm);
  }
  if (verdict_ == Verdict::running && all_s_ >= longestProof_s) verdict_ = Verdict::unmoved;
  return verdict_ == Verdict::running ? -push_ * settings_.push_N : 0;
}

}  // namespace detent::playback
