// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/rest_band.h"

#include <algorithm>
#include <cmath>

namespace detent::playback {

namespace {

// The values are justified in docs/develop/decisions/0906.
constexpr double negligibleMovement_N = 0.001;
constexpr double fewestTurns = 2.5;   // half swings within the window: 6 Hz and above
constexpr double surestTurns = 8;     // more do not make a drift more certain
constexpr double mostHum_N = 0.04;    // range: hum of 12 mN with its harmonics, or a steadied sensor
constexpr double mostOfForce = 0.08;  // additional range for a tremor of 4 % of the force
// share of the range by which a reading must leave it before the finger counts as moving
constexpr double beyond = 0.5;
constexpr double remembered_s = 2;  // a swing that was not observed for longer is forgotten

}  // namespace

bool SwingWindow::add(double time_s, double reading_N, Swing& swing) {
  if (filled_ == 0 || time_s - binEnds_s_ > bin_s) {
    filled_ = 0;
    open(reading_N);
    binEnds_s_ = time_s + bin_s;
  }
  bool complete = false;
  if (time_s >= binEnds_s_) {
    complete = filled_ == binCount;
    if (complete) swing = this->swing();
    open(last_N_);
    binEnds_s_ += bin_s;
  }
  Bin& bin = bins_[newest_];
  bin.lowest_N = std::min(bin.lowest_N, reading_N);
  bin.highest_N = std::max(bin.highest_N, reading_N);
  bin.way_N += std::fabs(reading_N - last_N_);
  bin.sum_N += reading_N;
  ++bin.count;
  last_N_ = reading_N;
  return complete;
}

void SwingWindow::open(double reading_N) {
  newest_ = (newest_ + 1) % binCount;
  filled_ = std::min(filled_ + 1, binCount);
  bins_[newest_] = {reading_N, reading_N, 0, 0, 0};
  last_N_ = reading_N;
}

SwingWindow::Swing SwingWindow::swing() const {
  Swing swing{bins_[0].lowest_N, bins_[0].highest_N, 0, 0};
  double sums_N[2] = {0, 0}, counts[2] = {0, 0};
  for (std::size_t i = 0; i < binCount; ++i) {
    const Bin& bin = bins_[(newest_ + 1 + i) % binCount];  // the oldest first
    swing.lowest_N = std::min(swing.lowest_N, bin.lowest_N);
    swing.highest_N = std::max(swing.highest_N, bin.highest_N);
    swing.way_N += bin.way_N;
    sums_N[2 * i / binCount] += bin.sum_N;
    counts[2 * i / binCount] += bin.count;
  }
  swing.drift_N = sums_N[1] / counts[1] - sums_N[0] / counts[0];
  return swing;
}

void RestBand::startAnew() {
  window_.startAnew();
  motion_ = Motion::up;
  swing_N_ = 0;
}

double RestBand::next(double time_s, double reading_N) {
  SwingWindow::Swing swing;
  if (!(most_N_ > 0)) return reading_N;
  if (window_.add(time_s, reading_N, swing)) judge(time_s, swing);
  const double margin_N = beyond * swing_N_;
  if (motion_ != Motion::rest) {
    follow(reading_N);
  } else if (reading_N > highest_N_ + margin_N) {
    leave(Motion::up, reading_N);
  } else if (reading_N < lowest_N_ - margin_N) {
    leave(Motion::down, reading_N);
  }
  return force_N_;
}

bool RestBand::swings(const SwingWindow::Swing& swing) const {
  const double range_N = swing.range_N(), middle_N = (swing.lowest_N + swing.highest_N) / 2;
  if (range_N > std::min(most_N_, mostHum_N + mostOfForce * std::fabs(middle_N))) return false;
  return swing.turns() >= fewestTurns;
}

bool RestBand::drifts(const SwingWindow::Swing& swing) {
  return std::fabs(swing.drift_N) > swing.range_N() / std::min(swing.turns(), surestTurns);
}

void RestBand::judge(double time_s, const SwingWindow::Swing& swing) {
  const bool still = swing.range_N() < negligibleMovement_N;
  if (time_s - swungAt_s_ > remembered_s) swing_N_ = 0;
  if (still && swing_N_ == 0 && motion_ == Motion::rest) restWithin(swing);
  if (still || !swings(swing)) return;
  swungAt_s_ = time_s;
  if (drifts(swing)) return;
  swing_N_ = std::max(swing.range_N(), swing_N_);
  if (motion_ != Motion::rest) restWithin(swing);
}

void RestBand::restWithin(const SwingWindow::Swing& swing) {
  motion_ = Motion::rest;
  lowest_N_ = swing.lowest_N;
  highest_N_ = swing.highest_N;
}

void RestBand::leave(Motion motion, double reading_N) {
  motion_ = motion;
  force_N_ = reading_N;
  window_.startAnew();
}

void RestBand::follow(double reading_N) {
  const double sign = motion_ == Motion::up ? 1 : -1;
  const double ahead_N = sign * (reading_N - force_N_);
  if (ahead_N > 0 || swing_N_ == 0) {
    force_N_ = reading_N;
  } else if (-ahead_N > (1 + beyond) * swing_N_) {
    leave(motion_ == Motion::up ? Motion::down : Motion::up, reading_N);
  }
}

}  // namespace detent::playback
