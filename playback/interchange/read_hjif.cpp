// SPDX-License-Identifier: GPL-3.0-or-later
// Reads HJIF, the JSON of ISO/IEC 23090-31. Bands are evaluated as in its reference software, except that the
// phase of several frequencies is in seconds at any timescale (the reference software is right only at 1000
// ticks per second).

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "playback/interchange/reference_signal.h"
#include "playback/interchange/reference_waves.h"

namespace detent::playback {

namespace {

constexpr double mostTicks = 2147483647, fastest_Hz = 20000, strongest = 1000;
constexpr int cubicParts = 16;  // straight pieces that approximate a cubic one

enum class BandKind : std::uint8_t { curve, vectorial, transient };

struct Band {
  BandKind kind = BandKind::vectorial;
  bool cubic = true;
  double gain = 1, low_Hz = 0, high_Hz = fastest_Hz, ticks_per_s = 1000;
};

struct Keyframe {
  double time_s = 0;
  std::optional<double> amplitude, frequency_Hz;
};

WaveShape shapeOf(const JsonPlace& effect) {
  const std::string name = effect.textOr("base_signal", "Sine");
  if (name == "Sine") return WaveShape::sine;
  if (name == "Square") return WaveShape::square;
  if (name == "Triangle") return WaveShape::triangle;
  if (name == "SawToothUp") return WaveShape::sawtoothUp;
  if (name == "SawToothDown") return WaveShape::sawtoothDown;
  effect.at("base_signal")
      .refuse(Message("there is no base signal %1", name),
              Message("Give Sine, Square, Triangle, SawToothUp or SawToothDown"));
}

std::vector<Keyframe> keyframesOf(const JsonPlace& effect, const Band& band) {
  std::vector<Keyframe> keyframes;
  if (!effect.has("keyframes")) return keyframes;
  for (const JsonPlace& entry : effect.at("keyframes").elements()) {
    Keyframe keyframe;
    keyframe.time_s =
        entry.numberOr("relative_position",
                       keyframes.empty() ? 0 : keyframes.back().time_s * band.ticks_per_s, 0, mostTicks) /
        band.ticks_per_s;
    if (!keyframes.empty() && keyframe.time_s < keyframes.back().time_s)
      entry.refuse(Message("this keyframe lies before the previous one"),
                   Message("Sort the keyframes by relative_position"));
    if (entry.has("amplitude_modulation"))
      keyframe.amplitude = band.gain * entry.at("amplitude_modulation").number(-strongest, strongest);
    if (entry.has("frequency_modulation"))
      keyframe.frequency_Hz = entry.at("frequency_modulation").number(0, fastest_Hz);
    keyframes.push_back(keyframe);
  }
  return keyframes;
}

/// Linear between the keyframes that have the value; outside, that of the nearest one.
double between(const std::vector<Keyframe>& keyframes, std::optional<double> Keyframe::*member, double time_s,
               double otherwise) {
  const Keyframe* before = nullptr;
  for (const Keyframe& keyframe : keyframes) {
    if (!(keyframe.*member)) continue;
    if (keyframe.time_s >= time_s) {
      if (before == nullptr || keyframe.time_s == time_s) return *(keyframe.*member);
      const double share = (time_s - before->time_s) / (keyframe.time_s - before->time_s);
      return *(before->*member) + share * (*(keyframe.*member) - *(before->*member));
    }
    before = &keyframe;
  }
  return before != nullptr ? *(before->*member) : otherwise;
}

PlayedWave vectorial(const std::vector<Keyframe>& keyframes, const JsonPlace& effect, double from_s,
                     const Band& band) {
  PlayedWave wave;
  wave.shape = shapeOf(effect);
  wave.phase_cycles = effect.numberOr("phase", 0, -1e6, 1e6) / (2 * std::numbers::pi);
  const auto frequencies = std::count_if(keyframes.begin(), keyframes.end(),
                                         [](const Keyframe& k) { return k.frequency_Hz.has_value(); });
  double start_s = 0;
  const auto add = [&](double time_s) {
    double frequency_Hz = between(keyframes, &Keyframe::frequency_Hz, time_s, 0);
    if (frequencies > 1) frequency_Hz = std::clamp(frequency_Hz, band.low_Hz, band.high_Hz);
    wave.points.push_back(
        {from_s + time_s, between(keyframes, &Keyframe::amplitude, time_s, band.gain), frequency_Hz});
  };
  if (keyframes.front().time_s > start_s) add(start_s);
  for (const Keyframe& keyframe : keyframes) add(keyframe.time_s);
  return wave;
}

/// For each keyframe two cycles of constant amplitude within 22 ms, whatever its frequency.
void addTransients(const std::vector<Keyframe>& keyframes, double from_s, ReferenceWaves& result) {
  for (const Keyframe& keyframe : keyframes) {
    if (!keyframe.amplitude) continue;
    const double at_s = from_s + keyframe.time_s, frequency_Hz = 2 / transient_s;
    result.waves.push_back({{{at_s, *keyframe.amplitude, frequency_Hz},
                             {at_s + transient_s, *keyframe.amplitude, frequency_Hz}}});
  }
}

PlayedWave curve(const std::vector<Keyframe>& keyframes, double from_s, bool cubic) {
  PlayedWave wave;
  wave.shape = WaveShape::constant;
  const Keyframe* before = nullptr;
  for (const Keyframe& keyframe : keyframes) {
    if (!keyframe.amplitude) continue;
    for (int i = 1; before != nullptr && cubic && i < cubicParts; ++i) {
      const double share = static_cast<double>(i) / cubicParts, eased = share * share * (3 - 2 * share);
      wave.points.push_back({from_s + before->time_s + share * (keyframe.time_s - before->time_s),
                             *before->amplitude + eased * (*keyframe.amplitude - *before->amplitude), 0});
    }
    wave.points.push_back({from_s + keyframe.time_s, *keyframe.amplitude, 0});
    before = &keyframe;
  }
  return wave;
}

/// Includes the sample of the last keyframe, as the reference software does.
PlayedWave endIncluded(PlayedWave wave) {
  if (wave.points.empty()) return wave;
  wave.points.push_back(wave.points.back());
  wave.points.back().time_s += 1e-3 / referenceRate_Hz;
  return wave;
}

void addEffect(const JsonPlace& effect, double from_s, const Band& band, ReferenceWaves& result) {
  const std::vector<Keyframe> keyframes = keyframesOf(effect, band);
  if (keyframes.empty()) return;
  ++result.events;
  if (band.kind == BandKind::transient) addTransients(keyframes, from_s, result);
  if (band.kind == BandKind::curve) result.waves.push_back(endIncluded(curve(keyframes, from_s, band.cubic)));
  if (band.kind == BandKind::vectorial)
    result.waves.push_back(endIncluded(vectorial(keyframes, effect, from_s, band)));
}

/// Returns false for a kind of band that is not played, which is noted.
bool readBand(const JsonPlace& entry, Band& band, ReferenceWaves& result) {
  const std::string kind = entry.at("band_type").text();
  if (kind == "WaveletWave") {
    result.note(Message("wavelet bands are left out"));
    return false;
  }
  if (kind != "VectorialWave" && kind != "Transient" && kind != "Curve")
    entry.at("band_type")
        .refuse(Message("there is no band type %1", kind), Message("Give Transient, Curve or VectorialWave"));
  band.kind = kind == "Curve"       ? BandKind::curve
              : kind == "Transient" ? BandKind::transient
                                    : BandKind::vectorial;
  const std::string path = entry.textOr("curve_type", "Cubic");
  band.cubic = path == "Cubic";
  if (band.kind == BandKind::curve && !band.cubic && path != "Linear")
    result.note(Message("curves of the type %1 are played as straight lines", path));
  band.low_Hz = entry.numberOr("lower_frequency_limit", 0, 0, fastest_Hz);
  band.high_Hz = std::max(band.low_Hz, entry.numberOr("upper_frequency_limit", fastest_Hz, 0, 1e9));
  return true;
}

using Library = std::map<double, JsonPlace>;

Library libraryOf(const JsonPlace& perception) {
  Library library;
  if (!perception.has("effect_library")) return library;
  for (const JsonPlace& effect : perception.at("effect_library").elements())
    library.emplace(effect.numberOr("id", -1, -mostTicks, mostTicks), effect);
  return library;
}

void readEffect(const JsonPlace& effect, const Library& library, const Band& band, ReferenceWaves& result) {
  const std::string type = effect.textOr("effect_type", "Basis");
  const double from_s = effect.numberOr("position", 0, 0, mostTicks) / band.ticks_per_s;
  if (type == "Basis") return addEffect(effect, from_s, band, result);
  if (type != "Reference") return result.note(Message("effects of the type %1 are left out", type));
  const auto found = library.find(effect.at("id").number(-mostTicks, mostTicks));
  if (found == library.end())
    effect.at("id").refuse(Message("this effect is not in the effect_library"),
                           Message("Add the effect to the effect_library"));
  addEffect(found->second, from_s, band, result);
}

}  // namespace

ReferenceWaves hjifWaves(const JsonPlace& file) {
  const std::string version = file.at("version").text();
  const bool draft = version == "1";  // the reference software wrote this before it named the edition
  if (!draft && !version.starts_with("2023") && !version.starts_with("2025"))
    file.at("version").refuse(
        Message("the version is %1, but only the editions of 2023 and 2025 can be read", version),
        Message("Export the file for one of these editions"));
  const double ticks_per_s = file.numberOr("timescale", 1000, 1, 48000);
  ReferenceWaves result;
  if (draft) result.note(Message("the file has the draft version 1; it is played as the edition of 2023"));
  std::size_t channels = 0;
  for (const JsonPlace& perception : file.at("perceptions").elements()) {
    const Library library = libraryOf(perception);
    for (const JsonPlace& channel : perception.at("channels").elements()) {
      ++channels;
      for (const JsonPlace& entry : channel.at("bands").elements()) {
        Band band;
        band.ticks_per_s = ticks_per_s;
        band.gain = channel.numberOr("gain", 1, -strongest, strongest);
        if (!readBand(entry, band, result)) continue;
        for (const JsonPlace& effect : entry.at("effects").elements())
          readEffect(effect, library, band, result);
      }
    }
  }
  if (channels > 1) result.note(Message("%1 channels are played together", channels));
  return result;
}

}  // namespace detent::playback
