// SPDX-License-Identifier: GPL-3.0-or-later
// Writes ISO/IEC 23090-31, interchange form (JSON), profile Main. Each jump and bottom-out is a vectorial
// wave with exact time (timescale 48000), frequency and envelope. Filtered grains, and everything else that
// the engine adds, are two waves a quarter turn apart. Curve and Transient bands are not used, because
// players disagree about them.

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "playback/interchange/envelope.h"
#include "playback/interchange/quadrature_wave.h"
#include "playback/interchange/reduction.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

constexpr double tolerance = 3e-4;  // share of full scale
constexpr std::size_t mostBandsOfLevel1 = 7;
constexpr const char* noDate =
    "1970-01-01";  // a date is required; a fixed one makes files of equal presses equal

struct Effect {
  std::int64_t from = 0, to = 0;  ///< samples, both included
  double phase_rad = 0, frequency_Hz = 0;
  std::vector<std::pair<std::int64_t, double>> amplitudes;  ///< samples after `from`, share of full scale
};

PlayedWave waveOf(const Effect& effect, double sampleRate_Hz) {
  PlayedWave wave;
  wave.phase_cycles = effect.phase_rad / (2 * std::numbers::pi);
  for (const auto& [frame, amplitude] : effect.amplitudes)
    wave.points.push_back(
        {static_cast<double>(effect.from + frame) / sampleRate_Hz, amplitude, effect.frequency_Hz});
  // The sample of the last keyframe sounds too.
  WavePoint after = wave.points.back();
  after.time_s += 0.5 / sampleRate_Hz;
  wave.points.push_back(after);
  return wave;
}

/// A silent keyframe follows the last one, because players compute sample positions with rounding and would
/// leave the last sample out. The first keyframe is silent.
Effect effectOf(const PlannedBurst& planned, double gain, double sampleRate_Hz) {
  const double length = planned.burst.duration_s * sampleRate_Hz;
  const auto last = static_cast<std::int64_t>(std::ceil(length - 1e-9)) - 1;
  const auto level = [&](std::int64_t frame) {
    const double share = static_cast<double>(frame) / length;
    return gain * planned.burst.amplitude * (planned.burst.envelope == Envelope::falling ? 1 - share : share);
  };
  Effect effect{
      planned.frame, planned.frame + last + 1, 0, std::round(planned.burst.frequency_Hz), {{0, level(0)}}};
  if (last > 0) effect.amplitudes.emplace_back(last, level(last));
  effect.amplitudes.emplace_back(last + 1, 0);
  return effect;
}

/// Two effects, with the amplitudes of sine and cosine of one piece between silent keyframes.
std::pair<Effect, Effect> effectsOf(const QuadraturePiece& piece, double frequency_Hz, double sampleRate_Hz) {
  const std::int64_t guard = piece.front().frame > 0 ? 1 : 0;
  const std::int64_t from = piece.front().frame - guard;
  const double turned = std::fmod(frequency_Hz * static_cast<double>(from) / sampleRate_Hz, 1);
  Effect sine{from, piece.back().frame + 1, 2 * std::numbers::pi * turned, frequency_Hz, {}};
  if (guard > 0) sine.amplitudes.emplace_back(0, 0);
  Effect cosine = sine;
  cosine.phase_rad += std::numbers::pi / 2;
  for (const QuadraturePoint& point : piece) {
    sine.amplitudes.emplace_back(point.frame - from, point.sine);
    cosine.amplitudes.emplace_back(point.frame - from, point.cosine);
  }
  for (Effect* effect : {&sine, &cosine}) effect->amplitudes.emplace_back(effect->to - from, 0);
  return {sine, cosine};
}

/// A band plays one effect at a time, so overlapping effects get separate bands.
void place(std::vector<std::vector<Effect>>& bands, Effect effect) {
  for (std::vector<Effect>& band : bands) {
    if (band.back().to >= effect.from) continue;
    band.push_back(std::move(effect));
    return;
  }
  bands.push_back({std::move(effect)});
}

/// Gain of the channel, at least 1. Amplitudes are within -1 and 1, and players limit the sum to full scale
/// after each band, before the channel's gain: louder effects are therefore written smaller, with a larger
/// gain.
double gainFor(const std::vector<std::vector<Effect>>& bands, const PressPlan& plan) {
  std::vector<double> sum(plan.samples.size(), 0);
  double peak = 1;
  for (const std::vector<Effect>& band : bands) {
    std::vector<PlayedWave> waves;
    for (const Effect& effect : band) {
      waves.push_back(waveOf(effect, plan.sampleRate_Hz));
      for (const auto& [frame, amplitude] : effect.amplitudes) peak = std::fmax(peak, std::fabs(amplitude));
    }
    addTo(sum, waves, plan.sampleRate_Hz);
    for (const double sample : sum) peak = std::fmax(peak, std::fabs(sample));
  }
  return std::ceil(peak - 1e-9);
}

Json jsonOf(const Effect& effect, double gain) {
  Json keyframes = Json::array();
  for (const auto& [frame, amplitude] : effect.amplitudes)
    keyframes.push_back({{"relative_position", frame}, {"amplitude_modulation", amplitude / gain}});
  // Only in the first keyframe: with several the reference software computes the phase in milliseconds,
  // whatever the timescale.
  keyframes.front()["frequency_modulation"] = static_cast<int>(effect.frequency_Hz);
  return {{"effect_type", "Basis"},
          {"position", effect.from},
          {"phase", effect.phase_rad},
          {"base_signal", "Sine"},
          {"keyframes", keyframes}};
}

Json jsonOf(const std::vector<std::vector<Effect>>& bands, double gain) {
  Json list = Json::array();
  for (const std::vector<Effect>& band : bands) {
    Json effects = Json::array();
    for (const Effect& effect : band) effects.push_back(jsonOf(effect, gain));
    list.push_back({{"band_type", "VectorialWave"},
                    {"lower_frequency_limit", 0},
                    {"upper_frequency_limit", 2000},
                    {"effects", effects}});
  }
  return list;
}

std::string textOf(const ExportSource& source, const std::vector<std::vector<Effect>>& bands, double gain,
                   const ExportLoss& loss) {
  std::string description;
  for (const std::string& line : headLines(source, loss))
    description += (description.empty() ? "" : "; ") + line;
  const Json channel{{"id", 0},
                     {"description", "button"},
                     {"gain", gain},
                     {"mixing_coefficient", 1},
                     {"body_part_mask", 0},
                     {"vertices", Json::array()},
                     {"bands", jsonOf(bands, gain)}};
  const Json perception{{"id", 0},
                        {"avatar_id", 0},
                        {"description", source.plan.button},
                        {"perception_modality", "Vibrotactile"},
                        {"unit_exponent", 0},
                        {"perception_unit_exponent", 0},
                        {"effect_library", Json::array()},
                        {"reference_devices", Json::array()},
                        {"channels", Json::array({channel})}};
  const Json file{{"version", "2023"},
                  {"profile", "Main"},
                  {"level", bands.size() <= mostBandsOfLevel1 ? 1 : 2},
                  {"date", noDate},
                  {"description", description},
                  {"timescale", 48000},
                  {"avatars", Json::array()},
                  {"perceptions", Json::array({perception})},
                  {"syncs", Json::array()}};
  return jsonText(file, 1) + "\n";
}

/// Returns true if bursts are not filtered and can be written exactly; with an equalizer, or a low-pass over
/// everything, none can.
bool burstsPassUnfiltered(const HapticProgram& program) {
  return program.equalizerBandCount == 0 && program.lowPass.placement != LowPassPlacement::wholeChain;
}

}  // namespace

Reduction hjifOf(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  Reduction reduction;
  std::vector<std::vector<Effect>> bands;
  std::vector<double> sum;  // sum of all bands
  if (burstsPassUnfiltered(source.program)) {
    for (const PlannedBurst& planned : plan.bursts) {
      if (planned.kind == EventKind::grain) continue;
      Effect effect = effectOf(planned, source.program.gain, plan.sampleRate_Hz);
      reduction.loss.frequencyMoved_Hz = std::fmax(
          reduction.loss.frequencyMoved_Hz, std::fabs(effect.frequency_Hz - planned.burst.frequency_Hz));
      place(bands, std::move(effect));
    }
  }
  std::vector<PlayedWave> waves;
  for (const std::vector<Effect>& band : bands)
    for (const Effect& effect : band) waves.push_back(waveOf(effect, plan.sampleRate_Hz));
  sum = playedBy(waves, plan);
  std::vector<double> rest(plan.samples.size());
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = static_cast<double>(plan.samples[i]) - sum[i];
  const double carrier_Hz =
      std::round(source.program.grain.frequency_Hz > 0 ? source.program.grain.frequency_Hz
                                                       : plan.bursts.front().burst.frequency_Hz);
  std::vector<PlayedWave> pieces;
  for (const QuadraturePiece& piece : quadraturePieces(rest, plan.sampleRate_Hz, carrier_Hz, tolerance)) {
    auto [sine, cosine] = effectsOf(piece, carrier_Hz, plan.sampleRate_Hz);
    pieces.push_back(waveOf(sine, plan.sampleRate_Hz));
    pieces.push_back(waveOf(cosine, plan.sampleRate_Hz));
    place(bands, std::move(sine));
    place(bands, std::move(cosine));
  }
  addTo(sum, pieces, plan.sampleRate_Hz);
  reduction.played = {std::move(sum)};
  reduction.loss.dropped = {"that a finger's force decides what is felt (the file is one press)"};
  const double gain = gainFor(bands, plan);
  reduction.write = [source, bands, gain](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", textOf(source, bands, gain, loss)}};
  };
  return reduction;
}

}  // namespace detent::playback
