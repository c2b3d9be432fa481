// SPDX-License-Identifier: GPL-3.0-or-later
// Writes tables for driver chips, and plain samples, as C. Assumptions where a data sheet is silent are
// stated in the file.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/units.h"
#include "model/version.h"
#include "playback/interchange/envelope.h"
#include "playback/interchange/export_loss_json.h"
#include "playback/interchange/player_conventions.h"
#include "playback/interchange/reduction.h"
#include "playback/interchange/snippets.h"
#include "playback/offline/resample.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* chipOnePress = "that a finger's force decides what is felt (the table is one press)";

Stretch wholeOf(const PressPlan& plan) { return {0, static_cast<std::int64_t>(plan.samples.size())}; }

// ---- BOS1921: slices of whole cycles

constexpr double slice_Hz = 3.9;
constexpr int highestAmplitude = 4095, highestByte = 255;

struct Slice {
  int amplitude = 0, frequency = 1, cycles = 1;
  double lasts_s() const { return cycles / (slice_Hz * frequency); }
};

int frequencyCode(double frequency_Hz) {
  return std::clamp(static_cast<int>(std::lround(frequency_Hz / slice_Hz)), 1, highestByte);
}

/// Silence of about this duration: the frequency and number of cycles that come nearest.
Slice pause(double time_s) {
  Slice best{0, highestByte, 1};
  double least = std::fabs(best.lasts_s() - time_s);
  for (int cycles = 1; cycles <= highestByte; ++cycles) {
    const Slice slice{0, frequencyCode(cycles / time_s), cycles};
    const double error = std::fabs(slice.lasts_s() - time_s);
    if (error >= least) continue;
    least = error;
    best = slice;
  }
  return best;
}

class SliceWriter {
 public:
  SliceWriter(const PressPlan& plan, const std::vector<EnvelopeStep>& steps)
      : plan_(plan), rate_Hz_(plan.sampleRate_Hz), steps_(steps), levels_(smoothed(steps, rate_Hz_, 0)) {}

  void write() {
    const double end_s = static_cast<double>(steps_.back().to) / rate_Hz_;
    while (now_s_ < end_s) {
      const double next_s = nextOnset_s();
      const EnvelopeStep& step = stepAt(now_s_);
      const Slice cycle{amplitudeCode(step), frequencyCode(frequency_Hz(step)), 1};
      const double left_s = std::fmin(next_s, end_s) - now_s_;
      if (left_s < shortestPause_s) {
        now_s_ += left_s;
        owed_s_ += left_s;
      } else if (cycle.amplitude == 0) {
        put(pause(std::fmin(left_s, static_cast<double>(step.to) / rate_Hz_ - now_s_ + owed_s_)));
      } else if (cycle.lasts_s() <= left_s + (step.onset ? latestOnset_s : 0)) {
        put(cycle);
      } else {
        put(pause(left_s));  // the next jump begins before the cycle would end
      }
    }
  }

  std::vector<Slice> slices;
  std::vector<PlayedWave> waves;
  std::vector<std::int64_t> onsets;

 private:
  static constexpr double latestOnset_s =
      0.001;  // longest delay of a jump that is accepted so that the jump before it is felt
  static constexpr double shortestPause_s = 1.0 / (slice_Hz * highestByte) / 2;

  double nextOnset_s() const {
    for (const EnvelopeStep& step : steps_) {
      const double from_s = static_cast<double>(step.from) / rate_Hz_;
      if (step.onset && from_s > now_s_ + shortestPause_s) return from_s;
    }
    return 1e9;
  }
  const EnvelopeStep& stepAt(double time_s) const {
    // An event within the shortest pause begins now.
    const double frame = (time_s + shortestPause_s) * rate_Hz_;
    for (const EnvelopeStep& step : steps_)
      if (frame < static_cast<double>(step.to)) return step;
    return steps_.back();
  }
  /// An onset within a step sets its frequency, even if the slope is stronger, because the slope's longer
  /// cycle might not end before the next onset.
  double frequency_Hz(const EnvelopeStep& step) const {
    if (step.onset)
      for (const PlannedBurst& planned : plan_.bursts)
        if (planned.kind != EventKind::grain && planned.frame == step.from) return planned.burst.frequency_Hz;
    return step.frequency_Hz;
  }
  int amplitudeCode(const EnvelopeStep& step) const {
    const double amplitude = step.onset ? firstAmplitude(step) : step.amplitude;
    return std::clamp(static_cast<int>(std::lround(amplitude * highestAmplitude)), 0, highestAmplitude);
  }
  /// Amplitude of the envelope where a jump begins.
  double firstAmplitude(const EnvelopeStep& step) const {
    const double from_s = static_cast<double>(step.from) / rate_Hz_;
    double amplitude = step.amplitude;
    for (const WavePoint& point : levels_.points)
      if (std::fabs(point.time_s - from_s) < 1e-9) amplitude = std::fmax(step.amplitude, point.amplitude);
    return amplitude;
  }
  void put(const Slice& slice) {
    if (slice.amplitude > 0) {
      const double amplitude = static_cast<double>(slice.amplitude) / highestAmplitude;
      const double frequency_Hz = slice_Hz * slice.frequency;
      const double from_s = now_s_ - owed_s_;
      waves.push_back(
          {{{from_s, amplitude, frequency_Hz}, {from_s + slice.lasts_s(), amplitude, frequency_Hz}}, 0});
      if (stepAt(now_s_).onset) onsets.push_back(std::llround(from_s * rate_Hz_));
    }
    slices.push_back(slice);
    now_s_ += slice.lasts_s();
  }

  const PressPlan& plan_;
  double rate_Hz_;
  const std::vector<EnvelopeStep>& steps_;
  PlayedWave levels_;
  double now_s_ = 0;   // time within the press
  double owed_s_ = 0;  // time by which the slices are ahead of it, because of pauses too short to be written
};

std::string bos1921Text(const ExportSource& source, const std::vector<Slice>& slices,
                        const ExportLoss& loss) {
  std::vector<std::string> head = headLines(source, loss);
  head.emplace_back(
      "BOS1921 slices {amplitude, frequency, cycles}: amplitude of 4095 = 190 V peak to peak, frequency in "
      "3.9 Hz,");
  head.emplace_back(
      "whole cycles. An amplitude of 0 waits. Full scale here is the chip's: scale it to what your actuator "
      "bears.");
  head.emplace_back(
      "Not certain from the data sheet, and therefore not used: the times behind the rise and fall nibbles "
      "(shape fields 0).");
  std::string text = cComment(head) +
                     "#include <stdint.h>\n\ntypedef struct { uint16_t amplitude; uint8_t frequency, cycles; "
                     "} detent_bos1921_slice;\n\n"
                     "static const detent_bos1921_slice detent_slices[] = {\n";
  for (const Slice& slice : slices)
    text += "  {" + std::to_string(slice.amplitude) + ", " + std::to_string(slice.frequency) + ", " +
            std::to_string(slice.cycles) + "},\n";
  return text + "};\nstatic const unsigned detent_slice_count = " + std::to_string(slices.size()) + "u;\n";
}

// ---- DA728x: two sequences of straight lines in 100 bytes

struct DaPart {
  std::int64_t zero = 0;
  LevelPath path;
  SnippetRow row;
  std::vector<std::int64_t> onsets;
  std::int64_t end = 0;  ///< sample up to which the envelope is stored
};

/// Levels in the middles of the cells, and the cells of jumps and bottom-outs.
DaPart daPart(const PressPlan& plan, const Stretch& all) {
  const double cell = snippetCell_s * plan.sampleRate_Hz;
  DaPart part;
  part.zero = firstOnsetOnGrid(plan, all, snippetCell_s);
  if (part.zero >= all.to) return part;
  const PlayedWave wave = smoothed(stepsOf(plan, {part.zero, all.to}, 0.005, 0.001), plan.sampleRate_Hz, 0);
  std::vector<double>& levels = part.path.levels;
  std::size_t at = 0;
  for (double frame = static_cast<double>(part.zero); frame < static_cast<double>(all.to); frame += cell) {
    const double time_s = (frame + cell / 2) / plan.sampleRate_Hz;
    while (at + 2 < wave.points.size() && wave.points[at + 1].time_s <= time_s) ++at;
    const WavePoint& a = wave.points[at];
    const WavePoint& b = wave.points[at + 1];
    const double share =
        b.time_s > a.time_s ? std::clamp((time_s - a.time_s) / (b.time_s - a.time_s), 0.0, 1.0) : 1;
    levels.push_back(snippetLevels * (a.amplitude + share * (b.amplitude - a.amplitude)));
  }
  for (const PlannedBurst& planned : plan.bursts)
    if (planned.kind != EventKind::grain && planned.frame >= part.zero && planned.frame < all.to)
      part.path.onsets.push_back(
          static_cast<std::size_t>(std::lround(static_cast<double>(planned.frame - part.zero) / cell)));
  const std::size_t kept = part.path.onsets.empty() ? 0 : part.path.onsets.back() + 1;
  while (levels.size() > kept && levels.back() < 0.5) levels.pop_back();
  levels.resize(std::max(levels.size(), kept), 0);
  return part;
}

void hold(DaPart& part, SnippetRow row, double sampleRate_Hz) {
  const auto frameOf = [&](std::size_t cells) {
    return part.zero + std::llround(static_cast<double>(cells) * snippetCell_s * sampleRate_Hz);
  };
  part.row = std::move(row);
  part.end = frameOf(part.row.held);
  for (const std::size_t onset : part.path.onsets)
    if (onset < part.row.held) part.onsets.push_back(frameOf(onset));
}

std::array<DaPart, 2> daParts(const PressPlan& plan) {
  std::array<DaPart, 2> parts{daPart(plan, pressOf(plan)), daPart(plan, releaseOf(plan))};
  std::array<SnippetRow, 2> rows = snippetsOf({parts[0].path, parts[1].path});
  for (std::size_t i = 0; i < parts.size(); ++i) hold(parts[i], std::move(rows[i]), plan.sampleRate_Hz);
  return parts;
}

PlayedWave waveOf(const DaPart& part, double sampleRate_Hz) {
  PlayedWave wave;
  double time_s = static_cast<double>(part.zero) / sampleRate_Hz, before = 0;
  for (const Snippet& snippet : part.row.snippets) {
    for (const SnippetPoint& point : snippet.points) {
      const double amplitude = static_cast<double>(point.level) / snippetLevels;
      wave.points.push_back({time_s, point.ramp ? before : amplitude, assumedResonance_Hz});
      time_s += point.units * snippetUnits[snippet.timebase] * snippetCell_s;
      wave.points.push_back({time_s, amplitude, assumedResonance_Hz});
      before = amplitude;
    }
  }
  return wave;
}

std::string byteText(int value) {
  constexpr const char* digits = "0123456789ABCDEF";
  return std::string("0x") + digits[value >> 4 & 15] + digits[value & 15];
}

std::string da728xText(const ExportSource& source, const std::array<int, snippetMemoryBytes>& memory,
                       const ExportLoss& loss) {
  std::vector<std::string> head = headLines(source, loss);
  head.emplace_back(
      "DA7280/2 waveform memory, 100 bytes (device tree: dlg,mem-array): sequence 0 is the press, sequence 1 "
      "the release.");
  head.emplace_back(
      "Set ACCELERATION_EN = 1 (amplitudes 0..15) and FREQ_WAVEFORM_TIMEBASE = 1 (1.36 ms). The motor plays "
      "at its own");
  head.emplace_back(
      "resonance, for the loss taken as 205 Hz. Verify the full scale: what a driver gives may differ from "
      "its data sheet.");
  head.emplace_back(
      "Not certain from the data sheet, and therefore not used: where a ramp begins that is a snippet's "
      "first point, and how");
  head.emplace_back(
      "long the built-in silence (snippet 0) lasts. Bytes behind the last frame of sequence 1 are 0 and not "
      "read.");
  return cComment(head) + "#include <stdint.h>\n\nstatic const uint8_t detent_da728x_memory[100] = {" +
         rows(memory, byteText) + "};\n";
}

// ---- DRV2605: amplitudes that last 5 ms at least

constexpr int rtp_ms = 5, rtpFull = 127;

std::string drv2605Text(const ExportSource& source, const TimedLevels& press, const TimedLevels& release,
                        const ExportLoss& loss) {
  std::vector<std::string> head = headLines(source, loss);
  head.emplace_back(
      "DRV2605(L), real-time playback: write each amplitude to RTP_INPUT (signed format, 0..127) and hold it "
      "for its ms, 5 at least.");
  head.emplace_back(
      "The motor plays at its own resonance, for the loss taken as 205 Hz. Set rated voltage and overdrive "
      "clamp for your motor first.");
  const auto array = [](const char* name, const TimedLevels& part) {
    return "static const detent_drv2605_step " + std::string(name) + "[] = {" +
           rows(part.levels,
                [](const TimedLevels::Level& level) {
                  return "{" + std::to_string(level.level) + ", " + std::to_string(level.duration_ms) + "}";
                }) +
           "};\nstatic const unsigned " + name + "_count = " + std::to_string(part.levels.size()) + "u;\n";
  };
  return cComment(head) +
         "#include <stdint.h>\n\ntypedef struct { uint8_t amplitude, ms; } detent_drv2605_step;\n\n" +
         array("detent_press", press) + array("detent_release", release);
}

// ---- the losses chips share

ExportLoss lraLoss(const PressPlan& plan, double worstTimingError_ms) {
  ExportLoss loss;
  loss.worstTimingError_ms = worstTimingError_ms;
  loss.grainsMerged = grainsWithin(plan, wholeOf(plan));
  loss.frequencyMoved_Hz = furthestFromResonance_Hz(plan);
  loss.dropped = {chipOnePress, "every frequency (the motor plays its own)"};
  return loss;
}

// ---- touchpad

constexpr double lowestThreshold_g = 110, highestThreshold_g = 190;

struct Touchpad {
  std::optional<double> requested_g;
  double threshold_g = lowestThreshold_g;
  double releaseRatio = 0.9;  // default of players for files that state none
  bool releaseKnown = false;
  int pressIntensity = 0, releaseIntensity = 0;
};

int intensityOf(const StrokeTable& table) {
  double strongest = 0;
  for (std::uint32_t i = 0; i < table.jumpCount; ++i)
    strongest = std::fmax(strongest, table.jumps[i].burst.amplitude);
  return strongest > 0 ? std::clamp(static_cast<int>(std::lround(4 * strongest)), 1, 4) : 0;
}

Touchpad touchpadFrom(const ExportSource& source) {
  Touchpad pad;
  const ButtonState& state = source.button.states().front();
  const StateProgram& program = source.program.states[0];
  const auto jumpForce = [](const StrokeTable& table, const StrokeCurve& curve) -> std::optional<double> {
    if (table.jumpCount == 0) return {};
    return curve.force_N(table.jumps[0].from_mm);
  };
  std::optional<double> press_N = jumpForce(program.press, state.graph.press());
  if (!press_N && program.hasOperatingPoint) press_N = state.graph.press().force_N(program.operating_mm);
  if (!press_N && program.hasBottomOut) press_N = state.graph.press().force_N(program.bottomOut_mm);
  if (press_N) {
    pad.requested_g = *press_N / newtonsPer(ForceUnit::gramForce);
    pad.threshold_g = std::clamp(*pad.requested_g, lowestThreshold_g, highestThreshold_g);
  }
  if (state.graph.release()) {
    std::optional<double> release_N = jumpForce(program.release, *state.graph.release());
    if (!release_N && program.hasResetPoint) release_N = state.graph.release()->force_N(program.reset_mm);
    if (release_N && press_N && *release_N > 0 && *press_N > 0) {
      pad.releaseRatio = std::clamp(*release_N / *press_N, 0.05, 1.0);
      pad.releaseKnown = true;
    }
  }
  pad.pressIntensity = intensityOf(program.press);
  pad.releaseIntensity = intensityOf(program.release);
  return pad;
}

std::string touchpadText(const ExportSource& source, const Touchpad& pad, const ExportLoss& loss) {
  const double perGram = newtonsPer(ForceUnit::gramForce);
  const Json file{
      {"format", "detent-touchpad"},
      {"version", 1},
      {"made_by", std::string("Detent ") + version()},
      {"button", source.plan.button},
      {"feel", feels.word(source.plan.feel)},
      {"press_threshold_g", pad.threshold_g},
      {"press_threshold_N", pad.threshold_g * perGram},
      {"press_threshold_of_button_g", pad.requested_g ? Json(*pad.requested_g) : Json(nullptr)},
      {"release_ratio", pad.releaseRatio},
      {"release_ratio_known", pad.releaseKnown},
      {"release_threshold_g", pad.threshold_g * pad.releaseRatio},
      {"intensity", {{"press", pad.pressIntensity}, {"release", pad.releaseIntensity}, {"range", {0, 4}}}},
      {"waveforms", {{"press", "0x1006"}, {"release", "0x1007"}}},
      {"loss", jsonOf(loss)}};
  return jsonText(file, 1) + "\n";
}

}  // namespace

Reduction bos1921Of(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  const std::vector<EnvelopeStep> steps = stepsOf(plan, wholeOf(plan), 0.0025, 0.001);
  SliceWriter writer(plan, steps);
  writer.write();
  Reduction reduction;
  reduction.played = {playedBy(writer.waves, plan)};
  reduction.loss.worstTimingError_ms = worstTimingError_ms(plan, wholeOf(plan), writer.onsets);
  reduction.loss.grainsMerged = grainsWithin(plan, wholeOf(plan));
  for (const PlannedBurst& planned : plan.bursts)
    reduction.loss.frequencyMoved_Hz = std::fmax(
        reduction.loss.frequencyMoved_Hz,
        std::fabs(slice_Hz * frequencyCode(planned.burst.frequency_Hz) - planned.burst.frequency_Hz));
  reduction.loss.dropped = {chipOnePress, "all but the strongest where several bursts overlap"};
  reduction.write = [source, slices = writer.slices](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", bos1921Text(source, slices, loss)}};
  };
  return reduction;
}

Reduction da728xOf(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  const std::array<DaPart, 2> parts = daParts(plan);
  const std::array<Stretch, 2> halves{pressOf(plan), releaseOf(plan)};
  Reduction reduction;
  double worst_ms = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const DaPart& part = parts[i];
    reduction.played.push_back(playedBy({waveOf(part, plan.sampleRate_Hz)}, plan));
    // Only the stored part counts; the cut part is reported separately. A burst half a cell before the end
    // would begin there.
    Stretch held = halves[i];
    if (part.row.cut)
      held.to =
          std::min<std::int64_t>(held.to, part.end - std::llround(snippetCell_s / 2 * plan.sampleRate_Hz));
    worst_ms = std::fmax(worst_ms, worstTimingError_ms(plan, held, part.onsets));
  }
  reduction.loss = lraLoss(plan, worst_ms);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].row.cut) continue;
    reduction.loss.cut = true;
    reduction.loss.dropped.push_back(
        std::string("the ") + (i == 0 ? "press" : "release") + " from " +
        std::to_string(std::lround(1000 * static_cast<double>(parts[i].row.held) * snippetCell_s)) +
        " ms after its first burst on (the memory is full)");
  }
  reduction.write = [source, memory = memoryOf({parts[0].row, parts[1].row})](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", da728xText(source, memory, loss)}};
  };
  return reduction;
}

Reduction drv2605Of(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  TimedLevels press = timedLevels(plan, pressOf(plan), rtp_ms, rtp_ms, rtpFull);
  TimedLevels release = timedLevels(plan, releaseOf(plan), rtp_ms, rtp_ms, rtpFull);
  for (TimedLevels* part : {&press, &release})
    if (part->levels.empty()) part->levels.push_back({rtp_ms, 0});  // C has no empty arrays
  Reduction reduction;
  reduction.played = {playedBy({waveOf(press, plan.sampleRate_Hz)}, plan),
                      playedBy({waveOf(release, plan.sampleRate_Hz)}, plan)};
  reduction.loss = lraLoss(plan, std::fmax(worstTimingError_ms(plan, pressOf(plan), press.onsets),
                                           worstTimingError_ms(plan, releaseOf(plan), release.onsets)));
  reduction.write = [source, press, release](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", drv2605Text(source, press, release, loss)}};
  };
  return reduction;
}

Reduction pcmOf(const ExportSource& source, unsigned bits, double requested_Hz) {
  const PressPlan& plan = source.plan;
  const double sampleRate_Hz = std::round(requested_Hz);  // rounded as in the file
  const int full = bits == 8 ? 127 : 32767;
  std::vector<int> samples;
  std::vector<float> heard;
  for (const float sample : resampled(plan.samples, plan.sampleRate_Hz, sampleRate_Hz)) {
    samples.push_back(
        static_cast<int>(std::lround(std::clamp(static_cast<double>(sample), -1.0, 1.0) * full)));
    heard.push_back(static_cast<float>(samples.back()) / static_cast<float>(full));
  }
  heard = resampled(heard, sampleRate_Hz, plan.sampleRate_Hz);
  heard.resize(plan.samples.size());
  Reduction reduction;
  reduction.played.emplace_back(heard.begin(), heard.end());
  reduction.loss.dropped = {chipOnePress};
  if (sampleRate_Hz < plan.sampleRate_Hz)
    reduction.loss.dropped.push_back("frequencies above " +
                                     std::to_string(std::lround(keptBand * sampleRate_Hz)) + " Hz");
  reduction.write = [source, samples, bits, full, sampleRate_Hz](const ExportLoss& loss) {
    std::vector<std::string> head = headLines(source, loss);
    head.push_back("Samples of " + std::to_string(bits) + " bits, full scale " + std::to_string(full));
    const std::string type = bits == 8 ? "int8_t" : "int16_t";
    return std::vector<ExportedFile>{
        {"", "",
         cComment(head) + "#include <stdint.h>\n\nstatic const unsigned detent_sample_rate_Hz = " +
             std::to_string(std::lround(sampleRate_Hz)) + "u;\nstatic const " + type + " detent_samples[" +
             std::to_string(samples.size()) + "] = {" +
             rows(samples, [](int sample) { return std::to_string(sample); }) + "};\n"}};
  };
  return reduction;
}

Reduction touchpadOf(const ExportSource& source) {
  const Touchpad pad = touchpadFrom(source);
  Reduction reduction;
  reduction.loss.grainsMerged = grainsWithin(source.plan, wholeOf(source.plan));
  reduction.loss.dropped = {"the shape of every wave (the pad plays its own Press and Release)",
                            "the bottom-out", "the slope"};
  if (pad.requested_g && *pad.requested_g != pad.threshold_g)
    reduction.loss.dropped.push_back("the button's own press force of " +
                                     std::to_string(std::lround(*pad.requested_g)) +
                                     " g, outside the 110 to 190 g that pads offer");
  if (!pad.requested_g)
    reduction.loss.dropped.emplace_back(
        "a press force: the button has no jump, operating point or bottom-out");
  if (!pad.releaseKnown)
    reduction.loss.dropped.emplace_back("a release force: the button has none; 0.9 is what systems assume");
  reduction.write = [source, pad](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", touchpadText(source, pad, loss)}};
  };
  return reduction;
}

}  // namespace detent::playback
