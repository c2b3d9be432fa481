// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_steadier.h"

#include <algorithm>
#include <cmath>

namespace detent::playback {

namespace {

// The fourth difference of white noise has sqrt(1 + 16 + 36 + 16 + 1) times its SD.
constexpr double differenceGain = 8.366600265340756;
constexpr double medianOfNormal = 0.6744897501960817;  // median |x| of a standard normal variable
constexpr double clipping_sd = 3.5;
constexpr std::size_t fewestDifferences = 16;
constexpr double quickReadings = 128, slowReadings = 1024;

constexpr double negligible_N = 0.001;  // a tenth of a grain on the softest sample button
constexpr double follow_sd = 2.5, turn_sd = 8, leave_sd = 7, agree_sd = 2;
// least number of readings over which a resting force is averaged before it stays,
constexpr std::size_t surest = 256;
constexpr double surest_s = 0.25;    // and least time: 256 readings at 10 kHz may be the end of a stroke
constexpr double released_sd = 1.5;  // a resting force this close to zero is zero

double shareOf(std::size_t window) { return 1 / std::sqrt(static_cast<double>(std::size_t{1} << window)); }

}  // namespace

void NoiseEstimate::add(double reading) {
  const std::array<double, differenceOrder> before = history_;
  std::copy_backward(history_.begin(), history_.end() - 1, history_.end());
  history_[0] = reading;
  if (historyCount_ < differenceOrder) {
    ++historyCount_;
    return;
  }
  const double magnitude =
      std::fabs(reading - 4 * before[0] + 6 * before[1] - 4 * before[2] + before[3]) / differenceGain;
  const double clip = clipping_sd / medianOfNormal * medianWith(magnitude);
  const double square = magnitude < clip ? magnitude * magnitude : clip * clip;
  count_ = std::min(count_ + 1, slowReadings);
  slowMean_ += (square - slowMean_) / count_;
  quickMean_ += (square - quickMean_) / std::min(count_, quickReadings);
}

double NoiseEstimate::medianWith(double magnitude) {
  double* const first = sorted_.data();
  if (ringCount_ == medianLength) {
    double* const old = std::lower_bound(first, first + ringCount_, ring_[ringNext_]);
    std::copy(old + 1, first + ringCount_, old);
    --ringCount_;
  }
  ring_[ringNext_] = magnitude;
  ringNext_ = (ringNext_ + 1) % medianLength;
  double* const place = std::upper_bound(first, first + ringCount_, magnitude);
  std::copy_backward(place, first + ringCount_, first + ringCount_ + 1);
  *place = magnitude;
  ++ringCount_;
  return sorted_[ringCount_ / 2];
}

double NoiseEstimate::sd() const {
  if (ringCount_ < fewestDifferences) return 0;
  return std::sqrt(std::max(quickMean_, slowMean_));
}

double ForceSteadier::noise() const {
  const double s = std::min(std::max(known_, noise_.sd()), most_);
  return s < negligible_N ? 0 : s;
}

void ForceSteadier::startAnew() {
  noise_.startAnew();
  count_ = 0;
  turn(Motion::up, 0);
}

double ForceSteadier::next(double time_s, double reading) {
  noise_.add(reading);
  const double s = noise();
  const bool first = count_ == 0;
  remember(reading);
  if (first || s == 0) {
    // Without noise: the finger is where the reading says, and may move in either direction from there.
    turn(reading < force_ ? Motion::down : Motion::up, 1);
    force_ = reading;
    return force_;
  }
  if (motion_ == Motion::rest) {
    moveIfLeft(s, time_s, reading);
  } else {
    ++age_;
    if (turned(s)) turn(motion_ == Motion::up ? Motion::down : Motion::up, 1);
    restIfStill(s, time_s);
  }
  if (motion_ != Motion::rest) followMotion(s);
  return force_;
}

void ForceSteadier::remember(double reading) {
  newest_ = (newest_ + 1) % longest;
  ring_[newest_] = reading;
  count_ = std::min(count_ + 1, longest);
  double sum = 0;
  std::size_t taken = 0;
  for (std::size_t k = 0; k < windows; ++k) {
    const std::size_t n = std::size_t{1} << k;
    if (n > count_) break;
    for (; taken < n; ++taken) sum += ring_[(newest_ + longest - taken) % longest];
    means_[k] = sum / static_cast<double>(n);
  }
}

void ForceSteadier::turn(Motion motion, std::size_t age) {
  motion_ = motion;
  age_ = age;
  extremeCount_ = 0;
}

bool ForceSteadier::turned(double s) const {
  const double sign = motion_ == Motion::up ? 1 : -1;
  for (std::size_t k = 0; k < extremeCount_; ++k) {
    if (sign * (extremes_[k] - means_[k]) > turn_sd * s * shareOf(k)) return true;
  }
  return false;
}

void ForceSteadier::followMotion(double s) {
  const double sign = motion_ == Motion::up ? 1 : -1;
  for (std::size_t k = 0; k < windows && (std::size_t{1} << k) <= std::min(age_, count_); ++k) {
    if (k >= extremeCount_) {
      extremes_[k] = means_[k];
      extremeCount_ = k + 1;
    } else if (sign * means_[k] > sign * extremes_[k]) {
      extremes_[k] = means_[k];
    }
    const double sure = means_[k] - sign * follow_sd * s * shareOf(k);
    if (sign * sure > sign * force_) force_ = sure;
  }
}

void ForceSteadier::restIfStill(double s, double time_s) {
  if (age_ < longest || count_ < longest) return;
  const double half = means_[windows - 2], whole = means_[windows - 1];
  const double difference = 2 * (half - whole);  // mean of the newer half minus that of the older one
  if (std::fabs(difference) > agree_sd * s * std::sqrt(4.0 / static_cast<double>(longest))) return;
  resting_ = whole;
  restingCount_ = longest;
  restingSince_s_ = time_s;
  // The force is kept: a step to the resting mean would be a movement under a still finger.
  if (motion_ == Motion::down && resting_ < released_sd * s) force_ = std::min({force_, resting_, 0.0});
  motion_ = Motion::rest;
}

void ForceSteadier::moveIfLeft(double s, double time_s, double reading) {
  const double restingVariance = 1 / static_cast<double>(restingCount_);
  for (std::size_t k = 0; k < windows; ++k) {
    const double away = means_[k] - resting_;
    if (std::fabs(away) <= leave_sd * s * std::sqrt(shareOf(k) * shareOf(k) + restingVariance)) continue;
    turn(away > 0 ? Motion::up : Motion::down, std::size_t{1} << k);
    return;
  }
  if (restingCount_ >= surest && time_s - restingSince_s_ >= surest_s) return;
  resting_ += (reading - resting_) / static_cast<double>(++restingCount_);
}

}  // namespace detent::playback
