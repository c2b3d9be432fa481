// SPDX-License-Identifier: GPL-3.0-or-later
// Writes time lines for phones and headsets: AHAP, .haptic, OpenXR, Android.

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/version.h"
#include "playback/interchange/envelope.h"
#include "playback/interchange/player_conventions.h"
#include "playback/interchange/reduction.h"
#include "playback/measurement/exact_number.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* timelineOnePress = "that a finger's force decides what is felt (the file is one press)";

double rounded(double value, double step) { return std::round(value / step) * step; }

double frequencyMoved_Hz(const PressPlan& plan) {
  double worst = 0;
  for (const PlannedBurst& planned : plan.bursts)
    worst = std::fmax(
        worst, std::fabs(planned.burst.frequency_Hz - frequencyOf(sharpnessOf(planned.burst.frequency_Hz))));
  return worst;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line;
  return text;
}

// ---- AHAP. Jumps up to 40 ms are transients; everything else is a row of short continuous events, each of
// one intensity: a parameter curve would scale every event under it, transients too.

constexpr double longestTransient_s = 0.040;
constexpr double slopeStep_s = 0.010, ahapStep_s = 0.005;

struct AhapEvent {
  bool transient = false;
  std::int64_t from = 0, to = 0;
  double intensity = 0, sharpness = 0;
};

struct AhapPart {
  std::int64_t zero = 0;
  std::vector<AhapEvent> events;
};

bool isJump(const PlannedBurst& planned) {
  return planned.kind == EventKind::pressJump || planned.kind == EventKind::releaseJump;
}

bool isTransient(const PlannedBurst& planned) {
  return isJump(planned) && planned.burst.duration_s <= longestTransient_s;
}

AhapEvent continuous(std::int64_t from, std::int64_t to, double amplitude, double frequency_Hz) {
  return {false, from, to, rounded(std::sqrt(amplitude), 1e-6), rounded(sharpnessOf(frequency_Hz), 1e-6)};
}

/// Adds a burst's own envelope as steps of constant intensity.
void addBurst(const PlannedBurst& planned, double sampleRate_Hz, std::vector<AhapEvent>& events) {
  const double length = planned.burst.duration_s * sampleRate_Hz;
  const auto count = std::max<std::int64_t>(1, std::llround(planned.burst.duration_s / ahapStep_s));
  for (std::int64_t i = 0; i < count; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const auto at = [&](std::int64_t k) {
      return planned.frame + std::llround(length * static_cast<double>(k) / static_cast<double>(count));
    };
    const double level = planned.burst.envelope == Envelope::falling ? 1 - share : share;
    events.push_back(
        continuous(at(i), at(i + 1), planned.burst.amplitude * level, planned.burst.frequency_Hz));
  }
}

AhapPart ahapPart(const PressPlan& plan, const Stretch& stretch) {
  AhapPart part{stretch.from, {}};
  for (const PlannedBurst& planned : plan.bursts) {
    if (planned.frame < stretch.from || planned.frame >= stretch.to || planned.kind == EventKind::grain)
      continue;
    if (isTransient(planned))
      part.events.push_back(
          {true, planned.frame, planned.frame + std::llround(transient_s * plan.sampleRate_Hz),
           rounded(std::sqrt(planned.burst.amplitude), 1e-6), sharpnessOf(planned.burst.frequency_Hz)});
    else
      addBurst(planned, plan.sampleRate_Hz, part.events);
  }
  for (const EnvelopeStep& step : stepsOf(plan, stretch, slopeStep_s, ahapStep_s))
    if (step.strongest == EventKind::grain && step.amplitude >= 1e-3)
      part.events.push_back(continuous(step.from, step.to, step.amplitude, step.frequency_Hz));
  std::stable_sort(part.events.begin(), part.events.end(),
                   [](const AhapEvent& a, const AhapEvent& b) { return a.from < b.from; });
  return part;
}

/// Each event starts its own sine.
std::vector<PlayedWave> wavesOf(const AhapPart& part, double sampleRate_Hz) {
  std::vector<PlayedWave> waves;
  for (const AhapEvent& event : part.events) {
    const double from_s = static_cast<double>(event.from) / sampleRate_Hz;
    const double to_s = static_cast<double>(event.to) / sampleRate_Hz;
    const double amplitude = event.intensity * event.intensity, frequency = frequencyOf(event.sharpness);
    waves.push_back(
        {{{from_s, amplitude, frequency}, {to_s, event.transient ? 0 : amplitude, frequency}}, 0});
  }
  return waves;
}

std::string ahapText(const ExportSource& source, const AhapPart& part, const char* which,
                     const ExportLoss& loss) {
  Json pattern = Json::array();
  const auto seconds = [&](std::int64_t frames) {
    return rounded(static_cast<double>(frames) / source.plan.sampleRate_Hz, 1e-6);
  };
  for (const AhapEvent& event : part.events) {
    const Json parameters =
        Json::array({Json{{"ParameterID", "HapticIntensity"}, {"ParameterValue", event.intensity}},
                     Json{{"ParameterID", "HapticSharpness"}, {"ParameterValue", event.sharpness}}});
    Json entry{{"Time", seconds(event.from - part.zero)},
               {"EventType", event.transient ? "HapticTransient" : "HapticContinuous"}};
    if (!event.transient) entry["EventDuration"] = seconds(event.to - event.from);
    entry["EventParameters"] = parameters;
    pattern.push_back({{"Event", entry}});
  }
  const Json file{{"Version", 1.0},
                  {"Metadata",
                   {{"Project", source.plan.button},
                    {"Created", std::string("Detent ") + version()},
                    {"Description", std::string(which) + ". " + joined(headLines(source, loss))}}},
                  {"Pattern", pattern}};
  return jsonText(file, 1) + "\n";
}

std::vector<std::int64_t> transientOnsets(const AhapPart& part) {
  std::vector<std::int64_t> onsets;
  for (const AhapEvent& event : part.events) onsets.push_back(event.from);
  return onsets;
}

// ---- .haptic and OpenXR: one voice, an envelope and a frequency

constexpr double envelopeStep_s = 0.005;

struct OneVoice {
  std::int64_t zero = 0;
  std::vector<WavePoint> points;  ///< relative to `zero`, as written
};

double clampedAmplitude(double amplitude) { return rounded(std::clamp(amplitude, 0.0, 1.0), 1e-6); }

std::string hapticText(const ExportSource& source, const OneVoice& voice, const ExportLoss& loss) {
  Json amplitude = Json::array(), frequency = Json::array();
  for (const WavePoint& point : voice.points) {
    amplitude.push_back({{"time", point.time_s}, {"amplitude", point.amplitude}});
    // Converters compute the sharpness as its square root (see NiceVibrations' own pairs of .haptic and
    // .ahap).
    const double sharpness = sharpnessOf(point.frequency_Hz);
    frequency.push_back({{"time", point.time_s}, {"frequency", sharpness * sharpness}});
  }
  const Json file{
      {"version", {{"major", 1}, {"minor", 0}, {"patch", 0}}},
      {"metadata",
       {{"editor", std::string("Detent ") + version()},
        {"author", ""},
        {"source", source.plan.press},
        {"project", source.plan.button},
        {"tags", Json::array()},
        {"description", joined(headLines(source, loss))}}},
      {"signals", {{"continuous", {{"envelopes", {{"amplitude", amplitude}, {"frequency", frequency}}}}}}}};
  return jsonText(file, 1) + "\n";
}

constexpr double openxrLowest_Hz = 1, openxrHighest_Hz = 1000;
constexpr std::size_t openxrPoints = 500;
constexpr double openxrStep_s = 0.0025, openxrCoarsest_s = 0.010;

double openxrValue(double frequency_Hz) {
  return std::clamp((frequency_Hz - openxrLowest_Hz) / (openxrHighest_Hz - openxrLowest_Hz), 0.0, 1.0);
}

std::int64_t nanoseconds(double time_s) { return std::llround(time_s * 1e9); }

/// Drops points whose level and frequency lie on the line between their neighbours, so that silence needs no
/// points.
std::vector<WavePoint> withoutMiddles(const std::vector<WavePoint>& points) {
  const auto same = [](const WavePoint& a, const WavePoint& b) {
    return a.amplitude == b.amplitude && a.frequency_Hz == b.frequency_Hz;
  };
  std::vector<WavePoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept.empty() || i + 1 == points.size() || !same(kept.back(), points[i]) ||
        !same(points[i], points[i + 1]))
      kept.push_back(points[i]);
  return kept;
}

/// Frequencies change only at steps; elsewhere a point would add nothing.
std::vector<WavePoint> turningPoints(const std::vector<WavePoint>& points) {
  std::vector<WavePoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool outer = i == 0 || i + 1 == points.size();
    if (outer || points[i - 1].frequency_Hz != points[i].frequency_Hz ||
        points[i + 1].frequency_Hz != points[i].frequency_Hz)
      kept.push_back(points[i]);
  }
  return kept;
}

std::string openxrJson(const ExportSource& source, const OneVoice& voice, const ExportLoss& loss) {
  Json amplitude = Json::array(), frequency = Json::array();
  for (const WavePoint& point : voice.points)
    amplitude.push_back({{"time", nanoseconds(point.time_s)}, {"value", point.amplitude}});
  for (const WavePoint& point : turningPoints(voice.points))
    frequency.push_back({{"time", nanoseconds(point.time_s)}, {"value", openxrValue(point.frequency_Hz)}});
  const Json file{{"type", "XR_TYPE_HAPTIC_PARAMETRIC_VIBRATION_EXT"},
                  {"next", nullptr},
                  {"amplitudePointCount", amplitude.size()},
                  {"amplitudePoints", amplitude},
                  {"frequencyPointCount", frequency.size()},
                  {"frequencyPoints", frequency},
                  {"transientCount", 0},
                  {"transients", Json::array()},
                  {"minFrequencyHz", openxrLowest_Hz},
                  {"maxFrequencyHz", openxrHighest_Hz},
                  {"streamFrameType", "XR_HAPTIC_PARAMETRIC_STREAM_FRAME_TYPE_NONE_EXT"},
                  {"metadata", joined(headLines(source, loss))}};
  return jsonText(file, 1) + "\n";
}

std::string openxrInitializer(const ExportSource& source, const OneVoice& voice, const ExportLoss& loss) {
  const auto list = [](const char* name, const std::vector<WavePoint>& points, auto value) {
    std::string text = "static const XrHapticParametricPointEXT " + std::string(name) + "[] = {\n";
    for (const WavePoint& point : points)
      text += "  {" + std::to_string(nanoseconds(point.time_s)) + ", " + cFloat(value(point)) + "},\n";
    return text + "};\n";
  };
  const std::vector<WavePoint> turns = turningPoints(voice.points);
  return cComment(headLines(source, loss)) + "#include <openxr/openxr.h>\n\n" +
         list("detent_amplitude", voice.points, [](const WavePoint& p) { return p.amplitude; }) +
         list("detent_frequency", turns, [](const WavePoint& p) { return openxrValue(p.frequency_Hz); }) +
         "static const XrHapticParametricVibrationEXT detent_vibration = {\n"
         "  XR_TYPE_HAPTIC_PARAMETRIC_VIBRATION_EXT, NULL,\n  " +
         std::to_string(voice.points.size()) + ", detent_amplitude,\n  " + std::to_string(turns.size()) +
         ", detent_frequency,\n  0, NULL,\n  1.0f, 1000.0f,\n"
         "  XR_HAPTIC_PARAMETRIC_STREAM_FRAME_TYPE_NONE_EXT};\n";
}

/// Moves points apart: steps of frequency need two points, and players require increasing times.
void spread(std::vector<WavePoint>& points, double apart_s) {
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].time_s < points[i - 1].time_s + apart_s) points[i].time_s = points[i - 1].time_s + apart_s;
}

OneVoice voiceOf(const std::vector<EnvelopeStep>& steps, const PressPlan& plan, double timeStep_s,
                 double apart_s) {
  OneVoice voice{steps.empty() ? 0 : steps.front().from, {}};
  voice.points = smoothed(steps, plan.sampleRate_Hz, voice.zero).points;
  for (WavePoint& point : voice.points) {
    point.time_s = rounded(point.time_s, timeStep_s);
    point.amplitude = clampedAmplitude(point.amplitude);
  }
  spread(voice.points, apart_s);
  return voice;
}

Reduction oneVoice(const PressPlan& plan, const std::vector<EnvelopeStep>& steps, const OneVoice& voice,
                   double (*heard_Hz)(double)) {
  Reduction reduction;
  PlayedWave wave{voice.points, 0};
  for (WavePoint& point : wave.points) point.frequency_Hz = heard_Hz(point.frequency_Hz);
  reduction.played = {playedBy({wave}, plan)};
  const Stretch held{0, steps.empty() ? 0 : steps.back().to};
  reduction.loss.worstTimingError_ms = worstTimingError_ms(plan, held, onsetsOf(steps));
  reduction.loss.grainsMerged = grainsWithin(plan, {0, static_cast<std::int64_t>(plan.samples.size())});
  for (const PlannedBurst& planned : plan.bursts)
    reduction.loss.frequencyMoved_Hz =
        std::fmax(reduction.loss.frequencyMoved_Hz,
                  std::fabs(heard_Hz(planned.burst.frequency_Hz) - planned.burst.frequency_Hz));
  reduction.loss.dropped = {timelineOnePress, "all but the strongest where several bursts overlap"};
  return reduction;
}

// ---- Android: an envelope of at most 16 points at least 20 ms apart where it keeps every jump's moment, and
// amplitudes by the millisecond where it does not, or where a device has none

constexpr std::size_t androidPoints = 16;
constexpr int androidStep_ms = 20,
              androidLongest_ms = 1000;  // longest duration between two points that every device accepts
constexpr double androidTiming_ms = 1;   // largest shift of a jump or bottom-out by an envelope

struct AndroidPoint {
  double amplitude = 0, frequency_Hz = 0;
  std::int64_t duration_ms = 0;
};

struct AndroidEnvelope {
  std::int64_t zero = 0;
  std::vector<AndroidPoint> points;
  std::vector<std::int64_t> onsets;
};

struct AndroidPart {
  AndroidEnvelope envelope;  ///< without points if none keeps the times of the onsets
  TimedLevels levels;

  const std::vector<std::int64_t>& onsets() const {
    return envelope.points.empty() ? levels.onsets : envelope.onsets;
  }
};

/// The coarsest steps that fit: 20 ms, or as long as needed to have 15 of them. None if there are too many
/// jumps.
std::vector<EnvelopeStep> androidSteps(const PressPlan& plan, const Stretch& stretch) {
  for (double step_s = androidStep_ms / 1000.0;; step_s *= 1.25) {
    std::vector<EnvelopeStep> steps = stepsOf(plan, stretch, step_s, androidStep_ms / 1000.0);
    if (steps.size() < androidPoints) return steps;
    if (step_s > longestExport_s) return {};
  }
}

AndroidEnvelope androidEnvelope(const PressPlan& plan, const Stretch& all) {
  AndroidEnvelope envelope{firstOnsetWithRoom(plan, all, androidStep_ms / 1000.0), {}, {}};
  const std::int64_t zero = envelope.zero;
  if (zero >= all.to) return envelope;
  std::int64_t last_ms = 0;
  for (const EnvelopeStep& step : androidSteps(plan, {zero, all.to})) {
    const std::int64_t end_ms =
        std::max<std::int64_t>(last_ms + androidStep_ms, std::llround(1000 * plan.time_s(step.to - zero)));
    envelope.points.push_back({clampedAmplitude(step.amplitude), step.frequency_Hz, end_ms - last_ms});
    if (step.onset)
      envelope.onsets.push_back(zero +
                                std::llround(static_cast<double>(last_ms) * plan.sampleRate_Hz / 1000));
    last_ms = end_ms;
  }
  if (!envelope.points.empty())
    envelope.points.back().amplitude = 0;  // the builder refuses an envelope that does not end at rest
  return envelope;
}

AndroidPart androidPart(const PressPlan& plan, const Stretch& all) {
  AndroidPart part{androidEnvelope(plan, all), timedLevels(plan, all, 5, 2, 255)};
  std::vector<AndroidPoint>& points = part.envelope.points;
  const bool tooLong = std::any_of(points.begin(), points.end(),
                                   [](const AndroidPoint& p) { return p.duration_ms > androidLongest_ms; });
  if (tooLong || worstTimingError_ms(plan, all, part.envelope.onsets) > androidTiming_ms) points.clear();
  return part;
}

PlayedWave waveOf(const AndroidPart& part, double sampleRate_Hz) {
  if (part.envelope.points.empty()) return waveOf(part.levels, sampleRate_Hz);
  PlayedWave wave;
  double time_s = static_cast<double>(part.envelope.zero) / sampleRate_Hz;
  wave.points.push_back({time_s, 0, part.envelope.points.front().frequency_Hz});
  for (const AndroidPoint& point : part.envelope.points) {
    time_s += static_cast<double>(point.duration_ms) / 1000;
    wave.points.push_back({time_s, point.amplitude, point.frequency_Hz});
  }
  return wave;
}

/// Joins neighbours with equal level. At a jump the level increases, so none is lost.
std::vector<TimedLevels::Level> withoutRepeats(const std::vector<TimedLevels::Level>& levels) {
  std::vector<TimedLevels::Level> kept;
  for (const TimedLevels::Level& level : levels) {
    if (!kept.empty() && kept.back().level == level.level)
      kept.back().duration_ms += level.duration_ms;
    else
      kept.push_back(level);
  }
  return kept;
}

struct KotlinWaveform {
  std::string functions;  ///< functions that contain a part of a long list each
  std::string call;
};

/// A method of the Java virtual machine has at most 64 KB of code, with 8 bytes for each number in a list.
KotlinWaveform kotlinLevels(const std::string& name, const TimedLevels& timed) {
  constexpr std::size_t mostNumbers = 2000;  // numbers of one list in one function
  const std::vector<TimedLevels::Level> levels = withoutRepeats(timed.levels);
  KotlinWaveform waveform;
  const auto list = [&](const char* what, const char* arrayOf, const auto& numberOf) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (i % mostNumbers == 0) parts.emplace_back();
      parts.back() += (parts.back().empty() ? "" : ", ") + std::to_string(numberOf(levels[i]));
    }
    if (parts.size() == 1) return arrayOf + ("(" + parts.front() + ")");
    std::string sum;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string function = name + what + std::to_string(i + 1);
      waveform.functions += "    private fun " + function + "() = " + arrayOf + "(" + parts[i] + ")\n";
      sum += (i == 0 ? "" : " + ") + function + "()";
    }
    return sum;
  };
  const std::string timings = list("Timings", "longArrayOf", [](const auto& l) { return l.duration_ms; });
  const std::string amplitudes = list("Amplitudes", "intArrayOf", [](const auto& l) { return l.level; });
  waveform.call =
      "VibrationEffect.createWaveform(\n            " + timings + ",\n            " + amplitudes + ", -1)\n";
  return waveform;
}

std::string kotlinPart(const char* name, const AndroidPart& part) {
  const std::string function = "    fun " + std::string(name) + "(vibrator: Vibrator): VibrationEffect? =\n";
  if (part.levels.levels.empty()) return function + "        null  // nothing is felt here\n";
  const KotlinWaveform waveform = kotlinLevels(name, part.levels);
  const std::vector<AndroidPoint>& points = part.envelope.points;
  if (points.empty())
    return function +
           "      // No envelope: its 16 points, 20 ms to 1 s apart, would move a jump or the bottom-out.\n  "
           "      " +
           waveform.call + waveform.functions;
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(),
      [](const AndroidPoint& a, const AndroidPoint& b) { return a.frequency_Hz < b.frequency_Hz; });
  std::string text =
      function + "      if (holds(vibrator, " + cFloat(low->frequency_Hz) + ", " +
      cFloat(high->frequency_Hz) + "))\n" +
      "        VibrationEffect.WaveformEnvelopeBuilder()\n            .setInitialFrequencyHz(" +
      cFloat(points.front().frequency_Hz) + ")\n";
  for (const AndroidPoint& point : points)
    text += "            .addControlPoint(" + cFloat(point.amplitude) + ", " + cFloat(point.frequency_Hz) +
            ", " + std::to_string(point.duration_ms) + "L)\n";
  return text + "            .build()\n      else\n        " + waveform.call + waveform.functions;
}

std::string kotlinComment(std::string text) {
  for (std::size_t at = 0; (at = text.find("*/", at)) != std::string::npos;) text.replace(at, 2, "* /");
  for (std::size_t at = 0; (at = text.find("/*", at)) != std::string::npos;) text.replace(at, 2, "/ *");
  return text;
}

std::string kotlinText(const ExportSource& source, const AndroidPart& press, const AndroidPart& release,
                       const ExportLoss& loss) {
  std::string head = "/*\n";
  for (const std::string& line : headLines(source, loss)) {
    std::string clean;
    for (const char c : line)
      if (static_cast<unsigned char>(c) >= ' ') clean += c;
    head += " * " + kotlinComment(clean) + "\n";
  }
  return head +
         " * VibrationEffect.Builder (newer systems) puts press and release on one time line; test for the "
         "class, not for a version.\n"
         " */\n"
         "import android.os.Build\nimport android.os.VibrationEffect\nimport android.os.Vibrator\n\nobject "
         "DetentButton {\n"
         "    // An envelope with a frequency out of the device's range is not played at all: the framework "
         "neither moves nor replaces it.\n"
         "    private fun holds(vibrator: Vibrator, low: Float, high: Float): Boolean {\n"
         "        if (Build.VERSION.SDK_INT < 36 || !vibrator.areEnvelopeEffectsSupported()) return false\n"
         "        val profile = vibrator.frequencyProfile ?: return false\n"
         "        return profile.minFrequencyHz <= low && profile.maxFrequencyHz >= high\n"
         "    }\n\n" +
         kotlinPart("press", press) + "\n" + kotlinPart("release", release) + "}\n";
}

}  // namespace

Reduction ahapOf(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  const AhapPart press = ahapPart(plan, pressOf(plan)), release = ahapPart(plan, releaseOf(plan));
  Reduction reduction;
  for (const AhapPart* part : {&press, &release})
    reduction.played.push_back(playedBy(wavesOf(*part, plan.sampleRate_Hz), plan));
  reduction.loss.worstTimingError_ms =
      std::fmax(worstTimingError_ms(plan, pressOf(plan), transientOnsets(press)),
                worstTimingError_ms(plan, releaseOf(plan), transientOnsets(release)));
  reduction.loss.grainsMerged = grainsWithin(plan, {0, static_cast<std::int64_t>(plan.samples.size())});
  reduction.loss.frequencyMoved_Hz = frequencyMoved_Hz(plan);
  reduction.loss.dropped = {timelineOnePress, "frequencies above 230 Hz", "the length of a transient"};
  reduction.write = [source, press, release](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{".press", "", ahapText(source, press, "Press", loss)},
                                     {".release", "", ahapText(source, release, "Release", loss)}};
  };
  return reduction;
}

Reduction hapticOf(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  const std::vector<EnvelopeStep> steps =
      stepsOf(plan, {0, static_cast<std::int64_t>(plan.samples.size())}, envelopeStep_s, 0.001);
  const OneVoice voice = voiceOf(steps, plan, 1e-6, 0);
  Reduction reduction = oneVoice(plan, steps, voice,
                                 [](double frequency_Hz) { return frequencyOf(sharpnessOf(frequency_Hz)); });
  reduction.loss.dropped.emplace_back("frequencies above 230 Hz");
  reduction.write = [source, voice](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", hapticText(source, voice, loss)}};
  };
  return reduction;
}

Reduction openxrOf(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  const Stretch whole{0, static_cast<std::int64_t>(plan.samples.size())};
  std::vector<EnvelopeStep> steps;
  OneVoice voice;
  const auto take = [&] {
    voice = voiceOf(steps, plan, 1e-9, 1e-6);
    voice.points = withoutMiddles(voice.points);
  };
  for (double step_s = openxrStep_s; step_s <= openxrCoarsest_s; step_s *= 1.25) {
    steps = stepsOf(plan, whole, step_s, 0.001);
    take();
    if (voice.points.size() <= openxrPoints) break;
  }
  // If even the coarsest steps need too many points, only the beginning of the press is stored; its jumps
  // keep their times. A step needs at most three points.
  while (voice.points.size() > openxrPoints) {
    steps.resize(steps.size() - (voice.points.size() - openxrPoints + 2) / 3);
    take();
  }
  Reduction reduction = oneVoice(plan, steps, voice, [](double frequency_Hz) {
    return std::clamp(frequency_Hz, openxrLowest_Hz, openxrHighest_Hz);
  });
  reduction.loss.cut = steps.back().to < whole.to;
  if (reduction.loss.cut)
    reduction.loss.dropped.push_back("the press from " +
                                     std::to_string(std::lround(1000 * plan.time_s(steps.back().to))) +
                                     " ms on (" + std::to_string(openxrPoints) + " points are used up)");
  reduction.write = [source, voice](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", openxrJson(source, voice, loss)},
                                     {"", ".h", openxrInitializer(source, voice, loss)}};
  };
  return reduction;
}

Reduction androidOf(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  const AndroidPart press = androidPart(plan, pressOf(plan)), release = androidPart(plan, releaseOf(plan));
  Reduction reduction;
  reduction.played = {playedBy({waveOf(press, plan.sampleRate_Hz)}, plan),
                      playedBy({waveOf(release, plan.sampleRate_Hz)}, plan)};
  reduction.loss.worstTimingError_ms =
      std::fmax(worstTimingError_ms(plan, pressOf(plan), press.onsets()),
                worstTimingError_ms(plan, releaseOf(plan), release.onsets()));
  reduction.loss.grainsMerged = grainsWithin(plan, {0, static_cast<std::int64_t>(plan.samples.size())});
  reduction.loss.dropped = {timelineOnePress};
  const bool envelopes = !press.envelope.points.empty() || !release.envelope.points.empty();
  const bool levels = press.envelope.points.empty() || release.envelope.points.empty();
  if (envelopes) reduction.loss.dropped.emplace_back("rises and falls shorter than 20 ms");
  if (envelopes) reduction.loss.dropped.emplace_back("frequency, on devices without envelopes");
  if (levels) {
    reduction.loss.dropped.emplace_back(
        "every frequency where an envelope would move a jump (the motor plays its own)");
    reduction.loss.frequencyMoved_Hz = furthestFromResonance_Hz(plan);
  }
  reduction.write = [source, press, release](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", kotlinText(source, press, release, loss)}};
  };
  return reduction;
}

}  // namespace detent::playback
