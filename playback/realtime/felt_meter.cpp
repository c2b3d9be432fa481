// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/felt_meter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace detent::playback {

namespace {
constexpr double window_s = 0.010;
}

void FeltMeter::use(const HapticProgram& program, double sampleRate_Hz) {
  sectionCount_ = 0;
  const auto append = [&](const BiquadCoefficients& coefficients) {
    sections_[sectionCount_] = {};
    sections_[sectionCount_++].setCoefficients(coefficients);
  };
  for (std::size_t i = 0; i < program.resonanceCount; ++i) {
    const EqualizerBand& r = program.resonances[i];
    append(peaking(sampleRate_Hz, r.frequency_Hz, r.q, r.gain_dB));
  }
  for (std::size_t i = 0; i < pacinianSections; ++i)
    append(bandPass(sampleRate_Hz, pacinianBest_Hz, pacinianQ));
  fullScale_dB_ = program.fullScale_dB;
  slotLength_ = static_cast<std::size_t>(std::lround(sampleRate_Hz * window_s / slots));
  inSlot_ = slot_ = 0;
  sums_ = {};
}

bool FeltMeter::silent() const {
  return std::all_of(sections_.begin(), sections_.begin() + static_cast<std::ptrdiff_t>(sectionCount_),
                     [](const Biquad& section) { return section.silent(); }) &&
         std::all_of(sums_.begin(), sums_.end(), [](double sum) { return sum == 0; });
}

void FeltMeter::add(const float* samples, std::size_t count) {
  if (sectionCount_ == 0) return;
  const bool nothing = std::all_of(samples, samples + count, [](float sample) { return sample == 0; });
  if (nothing && silent()) return;
  while (count > 0) {
    const std::size_t step = std::min({count, span, slotLength_ - inSlot_});
    addSpan(samples, step);
    samples += step;
    count -= step;
  }
}

void FeltMeter::addSpan(const float* samples, std::size_t count) {
  std::copy_n(samples, count, samples_.begin());
  for (std::size_t i = 0; i < sectionCount_; ++i) sections_[i].process(samples_.data(), count);
  for (std::size_t i = 0; i < count; ++i) sums_[slot_] += samples_[i] * samples_[i];
  inSlot_ += count;
  if (inSlot_ == slotLength_) endSlot();
}

void FeltMeter::endSlot() {
  double sum = 0;
  for (double s : sums_) sum += s;
  strongest_ = std::max(strongest_, sum / static_cast<double>(slots * slotLength_));
  slot_ = (slot_ + 1) % slots;
  sums_[slot_] = 0;
  inSlot_ = 0;
}

double FeltMeter::take_dB() {
  const double strongest = strongest_;
  strongest_ = 0;
  // A sine of full scale has a mean square of 1/2.
  return strongest > 0 ? fullScale_dB_ + 10 * std::log10(2 * strongest)
                       : -std::numeric_limits<double>::infinity();
}

}  // namespace detent::playback
