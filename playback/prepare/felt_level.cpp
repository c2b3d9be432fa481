// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/felt_level.h"

#include <algorithm>
#include <cmath>

#include "playback/realtime/felt_meter.h"

namespace detent::playback {

namespace {

constexpr double window_s = 0.010;
constexpr double anyRate_Hz = 192000;  // the highest rate, at which every band is at its intended frequency

double dB(double ratio) { return 20 * std::log10(ratio); }

double raised_dB(double band_Hz, double q, double gain_dB, double frequency_Hz) {
  return dB(magnitude(peaking(anyRate_Hz, band_Hz, q, gain_dB), anyRate_Hz, frequency_Hz));
}

/// Mean square of the strongest part of a saw-tooth envelope, averaged over `window_s` even if the envelope
/// is shorter.
double meanSquareOfSaw(double duration_s) {
  const double rest = std::max(0.0, 1 - window_s / duration_s);
  return duration_s / window_s * (1 - rest * rest * rest) / 3;
}

}  // namespace

double pacinianWeight_dB(double frequency_Hz) {
  const double detuning = pacinianQ * (frequency_Hz / pacinianBest_Hz - pacinianBest_Hz / frequency_Hz);
  return -20 * std::log10(1 + detuning * detuning);
}

double raisedBy_dB(const DeviceProfile& device, const HapticProgram& program, double frequency_Hz) {
  double sum_dB = dB(program.gain);
  for (const Resonance& r : device.resonances)
    sum_dB += raised_dB(r.frequency_Hz, r.q, r.gain_dB, frequency_Hz);
  for (std::size_t i = 0; i < program.equalizerBandCount; ++i) {
    const EqualizerBand& band = program.equalizer[i];
    sum_dB += raised_dB(band.frequency_Hz, band.q, band.gain_dB, frequency_Hz);
  }
  return sum_dB;
}

double feltLevel_dB(const Burst& burst, const DeviceProfile& device, const HapticProgram& program) {
  return fullScale_dB(device) + dB(burst.amplitude) + 10 * std::log10(meanSquareOfSaw(burst.duration_s)) +
         pacinianWeight_dB(burst.frequency_Hz) + raisedBy_dB(device, program, burst.frequency_Hz);
}

double feltSlopeLevel_dB(const DeviceProfile& device, const HapticProgram& program) {
  const double frequency_Hz = program.grain.frequency_Hz;
  double level_dB = fullScale_dB(device) + dB(program.grain.amplitude) + pacinianWeight_dB(frequency_Hz) +
                    raisedBy_dB(device, program, frequency_Hz);
  if (program.lowPass.placement != LowPassPlacement::none)
    level_dB += dB(magnitude(lowPass(anyRate_Hz, program.lowPass.cutoff_Hz, program.lowPass.order),
                             anyRate_Hz, frequency_Hz));
  return level_dB;
}

}  // namespace detent::playback
