// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/magnetic/magnetic_key.h"

#include <algorithm>

namespace detent::playback {

bool MagneticKey::shouldClose(double displacement_mm) const {
  if (displacement_mm < settings_.actuate_mm) return false;
  return !settings_.rapid_mm || displacement_mm >= turn_mm_ + *settings_.rapid_mm;
}

bool MagneticKey::shouldOpen(double displacement_mm) const {
  if (displacement_mm <= settings_.reset_mm) return true;
  return settings_.rapid_mm && displacement_mm <= turn_mm_ - *settings_.rapid_mm;
}

bool MagneticKey::follow(double displacement_mm) {
  turn_mm_ = closed_ ? std::max(turn_mm_, displacement_mm) : std::min(turn_mm_, displacement_mm);
  if (closed_ ? !shouldOpen(displacement_mm) : !shouldClose(displacement_mm)) return false;
  closed_ = !closed_;
  turn_mm_ = displacement_mm;
  return closed_;
}

}  // namespace detent::playback
