// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/press_sound.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace detent::playback {

namespace {
constexpr double upShareOfTravel = 0.1;  // the same as in PressCounter
}  // namespace

void PressSounder::use(PressSound sound) {
  sound_ = std::move(sound);
  gain_ = std::pow(10, sound_.level_dB / 20);
  setSampleRate(rate_Hz_);
}

void PressSounder::setSampleRate(double sampleRate_Hz) {
  rate_Hz_ = sampleRate_Hz;
  delay_frames_ = std::llround(sound_.delay_s * rate_Hz_);
  late_.assign(sound_.rendered ? static_cast<std::size_t>(delay_frames_) : 0, 0.0F);
  lateAt_ = 0;
  from_ = -1;
}

void PressSounder::take(const EngineEvent& event) {
  const bool click = event.kind == EventKind::pressJump || event.kind == EventKind::bottomOut ||
                     event.kind == EventKind::contactClosed;
  if (!click || !up_) return;
  up_ = false;
  from_ = event.frame + delay_frames_;
}

void PressSounder::take(const HapticProgram* program, const StrokePosition& position) {
  if (program == nullptr) return;
  const StateProgram& state = program->states[position.state];
  up_ |= position.displacement_mm - state.start_mm <= upShareOfTravel * (state.end_mm - state.start_mm);
}

void PressSounder::addTo(float* out, const float* felt, std::size_t count, std::int64_t end_frame) {
  std::int64_t frame = end_frame - static_cast<std::int64_t>(count);
  for (std::size_t i = 0; i < count; ++i, ++frame) {
    double sample = 0;
    if (sound_.rendered) {
      sample = static_cast<double>(felt[i]);
      if (!late_.empty()) {
        sample = static_cast<double>(std::exchange(late_[lateAt_], felt[i]));
        lateAt_ = (lateAt_ + 1) % late_.size();
      }
    } else if (from_ >= 0 && frame >= from_) {
      // Interpolated between two samples if the device came back at another rate than that to which the
      // recording was converted.
      const double at = static_cast<double>(frame - from_) * sound_.sampleRate_Hz / rate_Hz_;
      const auto first = static_cast<std::size_t>(at);
      const double share = at - static_cast<double>(first);
      if (first >= sound_.samples.size()) {
        from_ = -1;
      } else {
        const double next = first + 1 < sound_.samples.size() ? sound_.samples[first + 1] : 0.0F;
        sample = (1 - share) * static_cast<double>(sound_.samples[first]) + share * next;
      }
    }
    out[i] = static_cast<float>(std::clamp(static_cast<double>(out[i]) + gain_ * sample, -1.0, 1.0));
  }
}

}  // namespace detent::playback
