// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/interchange/fuzzed_exports.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <nlohmann/json.hpp>

#include "playback/interchange/reduction.h"
#include "playback/offline/standard_press.h"
#include "playback/prepare/prepare_program.h"

namespace detent::test {

namespace {

using playback::ExportFormat;
using playback::PressTrace;
using Json = nlohmann::json;

/// Draws that are the same with every standard library: its distributions are not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  double share() { return static_cast<double>(bits_() >> 11U) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * share(); }
  double byDecades(double low, double high) {
    return std::pow(10, between(std::log10(low), std::log10(high)));
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }
  bool oneIn(std::size_t count) { return below(count) == 0; }

 private:
  std::mt19937_64 bits_;
};

std::optional<StrokeCurve> curve(Dice& dice, double travel_mm, double strongest_N) {
  const std::size_t count = 2 + dice.below(12);
  std::vector<CurvePoint> points{{0, strongest_N * dice.between(0, 0.5)}};
  for (std::size_t i = 1; i < count; ++i) {
    const double left = travel_mm - points.back().displacement_mm;
    const double x =
        i + 1 == count ? travel_mm : points.back().displacement_mm + left * dice.between(0.01, 0.6);
    points.push_back({x, strongest_N * dice.share()});
  }
  Result<StrokeCurve> made = StrokeCurve::throughPoints(points);
  if (!made) return std::nullopt;
  return *std::move(made);
}

std::optional<ButtonState> state(Dice& dice, const std::string& name, double travel_mm, double strongest_N) {
  std::optional<StrokeCurve> press = curve(dice, travel_mm, strongest_N);
  if (!press) return std::nullopt;
  std::optional<StrokeCurve> release;
  if (!dice.oneIn(4)) release = curve(dice, travel_mm, strongest_N * dice.between(0.1, 1));
  Result<ForceGraph> graph = ForceGraph::fromCurves(*std::move(press), std::move(release));
  if (!graph) return std::nullopt;
  ButtonState made{name, *std::move(graph), {}, {}, {}};
  if (dice.oneIn(2)) made.operatingPoint_mm = travel_mm * dice.between(0.2, 0.9);
  if (dice.oneIn(2)) made.resetPoint_mm = travel_mm * dice.between(0.1, 0.8);
  return made;
}

Button button(Dice& dice) {
  while (true) {
    const double travel_mm = dice.byDecades(0.05, 60), strongest_N = dice.byDecades(0.01, 300);
    std::vector<ButtonState> states;
    const std::size_t count = dice.oneIn(6) ? 2 : 1;
    for (std::size_t i = 0; i < count; ++i)
      if (std::optional<ButtonState> made = state(dice, i == 0 ? "up" : "down", travel_mm, strongest_N))
        states.push_back(*std::move(made));
    Result<Button> made =
        Button::fromStates(dice.oneIn(20) ? "*/ \" </script> \n \xFF" : "drawn", std::move(states));
    if (made) return *std::move(made);
  }
}

playback::PlaybackSettings feel(Dice& dice) {
  playback::PlaybackSettings settings = playback::usualSettings();
  if (dice.oneIn(3)) settings.feel = playback::Feel::paper;
  if (!dice.oneIn(3)) return settings;
  settings.grainsPerMm = dice.oneIn(4) ? 0 : dice.byDecades(0.5, 1000);
  settings.grainFrequency_Hz = dice.byDecades(1, 2000);
  settings.grainDuration_s = dice.byDecades(1e-4, 1);
  settings.grainAmplitude = dice.share();
  settings.pressJumpFrequency_Hz = dice.byDecades(1, 2000);
  settings.releaseJumpFrequency_Hz = dice.byDecades(1, 2000);
  settings.jumpDurationPerTravel_s_per_mm = dice.byDecades(1e-4, 1);
  settings.longestJump_s = dice.between(0.005, 1);
  settings.jumpAmplitudePerArea_per_mJ = dice.byDecades(1e-3, 1000);
  settings.bottomOutFrequency_Hz = dice.byDecades(1, 2000);
  settings.bottomOutDuration_s = dice.byDecades(1e-3, 1);
  settings.bottomOutAmplitude = dice.share();
  settings.burstSpacing_s = dice.oneIn(3) ? 0 : dice.between(0, 0.1);
  return settings;
}

/// Readings to and fro, seldom long: a draw has to be cheap.
PressTrace wobble(Dice& dice, const playback::HapticProgram& program, const Button& pressed) {
  PressTrace trace;
  const bool force = dice.oneIn(2);
  trace.quantity = force ? PressTrace::Quantity::force_N : PressTrace::Quantity::displacement_mm;
  const StrokeCurve& press = pressed.states().front().graph.press();
  const double full = force ? 1.5 * playback::strongestForce_N(program) : 1.2 * press.end_mm();
  const double lasts_s = dice.oneIn(2000) ? dice.between(5, 31) : dice.byDecades(0.005, 0.3);
  const std::size_t count = 2 + dice.below(dice.oneIn(20) ? 400 : 40);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    double value = full * dice.share();
    if (dice.oneIn(50)) value = dice.oneIn(2) ? -full : 1e6 * full;
    trace.readings.push_back({lasts_s * share, i == 0 || i + 1 == count ? 0 : value});
  }
  return trace;
}

// ---- limits

class Limits {
 public:
  void within(const char* what, const Json& value, double low, double high) {
    if (!value.is_number()) {
      found.push_back(std::string(what) + " is no number");
      return;
    }
    within(what, value.get<double>(), low, high);
  }
  void within(const char* what, double value, double low, double high) {
    if (!(value >= low && value <= high)) found.push_back(std::string(what) + " is " + std::to_string(value));
  }
  void holds(const char* what, bool ok) {
    if (!ok) found.emplace_back(what);
  }
  std::vector<std::string> found;
};

std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  while (*at != '\0') {
    if ((*at >= '0' && *at <= '9') || (*at == '-' && at[1] >= '0' && at[1] <= '9')) {
      char* end = nullptr;
      numbers.push_back(at[0] == '0' && at[1] == 'x' ? static_cast<double>(std::strtol(at, &end, 16))
                                                     : std::strtod(at, &end));
      at = end;
    } else {
      ++at;
    }
  }
  return numbers;
}

/// Text between the first `from` at or behind `begin` and the next `to`; empty if there is none.
std::string between(const std::string& text, const std::string& from, const std::string& to,
                    std::size_t begin = 0) {
  const std::size_t at = text.find(from, begin);
  if (at == std::string::npos) return {};
  const std::size_t start = at + from.size();
  const std::size_t end = text.find(to, start);
  return end == std::string::npos ? std::string() : text.substr(start, end - start);
}

void checkAhap(const Json& file, Limits& limits) {
  limits.within("Version", file["Version"], 1, 1);
  for (const Json& entry : file["Pattern"]) {
    limits.holds("a parameter curve", entry.contains("Event"));
    const Json& event = entry["Event"];
    limits.within("Time", event["Time"], 0, 30);
    if (event["EventType"] == "HapticContinuous") {
      limits.within("EventDuration", event["EventDuration"], 1e-6, 30);
      limits.within("end", event["Time"].get<double>() + event["EventDuration"].get<double>(), 0, 30.1);
    }
    for (const Json& parameter : event["EventParameters"])
      limits.within("ParameterValue", parameter["ParameterValue"], 0, 1);
  }
}

void checkHaptic(const Json& file, Limits& limits) {
  for (const char* name : {"amplitude", "frequency"}) {
    double last_s = 0;
    for (const Json& point : file["signals"]["continuous"]["envelopes"][name]) {
      limits.within("time", point["time"], last_s, 31);
      if (point["time"].is_number()) last_s = point["time"];
      limits.within(name, point[name], 0, 1);
    }
  }
}

void checkHjif(const Json& file, Limits& limits) {
  limits.within("timescale", file["timescale"], 1, 48000);
  limits.within("level", file["level"], 1, 2);
  limits.holds("a date as ISO 8601 has it",
               file["date"].is_string() && file["date"].get<std::string>().size() == 10);
  for (const Json& avatar : file["avatars"]) limits.within("avatar's id", avatar["id"], 1, 1e9);
  for (const Json& channel : file["perceptions"][0]["channels"]) {
    limits.within("gain", channel["gain"], 1e-6, 1e6);
    limits.within("mixing_coefficient", channel["mixing_coefficient"], 0, 1);
    limits.within("bands", static_cast<double>(channel["bands"].size()), 1, file["level"] == 1 ? 7 : 65536);
    for (const Json& band : channel["bands"]) {
      double end = -1;
      for (const Json& effect : band["effects"]) {
        limits.holds("a position that is no whole number", effect["position"].is_number_integer());
        limits.within("position", effect["position"], end + 1, 1e9);
        limits.within("phase", effect["phase"], -100, 100);
        double place = -1;
        for (const Json& key : effect["keyframes"]) {
          limits.within("relative_position", key["relative_position"], place + 1, 1e9);
          limits.within("amplitude_modulation", key["amplitude_modulation"], -1, 1);
          // One frequency of an effect, on its first keyframe: the reference software mistakes the phase of
          // several.
          limits.holds("a frequency on a later keyframe",
                       key.contains("frequency_modulation") == (place < 0));
          if (place < 0) {
            limits.within("frequency_modulation", key["frequency_modulation"], band["lower_frequency_limit"],
                          band["upper_frequency_limit"]);
            limits.holds("a frequency that is no whole number",
                         key["frequency_modulation"].is_number_integer());
          }
          if (key["relative_position"].is_number()) place = key["relative_position"];
        }
        limits.within("last amplitude", effect["keyframes"].back()["amplitude_modulation"], 0, 0);
        if (effect["position"].is_number()) end = effect["position"].get<double>() + place;
      }
    }
  }
}

void checkOpenxr(const Json& file, Limits& limits) {
  for (const char* name : {"amplitudePoint", "frequencyPoint"}) {
    const Json& points = file[std::string(name) + "s"];
    limits.within("points", static_cast<double>(points.size()), 1, 500);
    limits.holds("a count that is not the list's", file[std::string(name) + "Count"] == points.size());
    double last_ns = -1;
    for (const Json& point : points) {
      limits.holds("a time that is no whole number", point["time"].is_number_integer());
      limits.within("time", point["time"], last_ns + 1, 31e9);
      limits.within("value", point["value"], 0, 1);
      if (point["time"].is_number()) last_ns = point["time"];
    }
  }
  limits.within("minFrequencyHz", file["minFrequencyHz"], 1, 1000);
  limits.within("maxFrequencyHz", file["maxFrequencyHz"], 1, 1000);
}

void checkAndroid(const std::string& text, Limits& limits) {
  const std::size_t begin = text.find("object DetentButton");
  for (std::size_t at = begin; (at = text.find("createWaveform(", at)) != std::string::npos; ++at) {
    const std::vector<double> times = numbersIn(between(text, "longArrayOf(", ")", at));
    const std::vector<double> levels = numbersIn(between(text, "intArrayOf(", ")", at));
    limits.holds("timings and amplitudes of two lengths", times.size() == levels.size() && !times.empty());
    for (const double time : times) limits.within("timing", time, 1, 31000);
    for (const double level : levels) limits.within("amplitude", level, 0, 255);
  }
  for (std::size_t at = begin; (at = text.find("WaveformEnvelopeBuilder()", at)) != std::string::npos; ++at) {
    const std::string chain = between(text, "WaveformEnvelopeBuilder()", ".build()", at);
    std::size_t points = 0;
    double last = 1;
    for (std::size_t p = 0; (p = chain.find("addControlPoint(", p)) != std::string::npos; ++p, ++points) {
      const std::vector<double> values = numbersIn(between(chain, "addControlPoint(", ")", p));
      if (values.size() != 3) {
        limits.holds("a control point of three numbers", false);
        continue;
      }
      limits.within("control point's amplitude", values[0], 0, 1);
      limits.within("control point's frequency", values[1], 1e-3, 1e4);
      limits.within("control point's time", values[2], 20, 1000);
      last = values[0];
    }
    limits.within("control points", static_cast<double>(points), 1, 16);
    limits.within("last amplitude", last, 0, 0);
  }
}

std::string array(const std::string& text, const std::string& name) {
  const std::string body = between(text, name, "};");
  return body.substr(std::min(body.size(), body.find('{') + 1));
}

void checkBos1921(const std::string& text, Limits& limits) {
  const std::vector<double> slices = numbersIn(array(text, "detent_slices[] ="));
  limits.holds("slices of three numbers", !slices.empty() && slices.size() % 3 == 0);
  bool sounds = false;
  for (std::size_t i = 0; i + 2 < slices.size(); i += 3) {
    limits.within("amplitude", slices[i], 0, 4095);
    limits.within("frequency", slices[i + 1], 1, 255);
    limits.within("cycles", slices[i + 2], 1, 255);
    sounds = sounds || slices[i] > 0;
  }
  limits.holds("silence", sounds);
}

void checkDa728x(const std::string& text, Limits& limits) {
  const std::vector<double> memory = numbersIn(array(text, "detent_da728x_memory[100] ="));
  limits.holds("100 bytes", memory.size() == 100);
  if (memory.size() != 100) return;
  for (const double byte : memory) limits.within("byte", byte, 0, 255);
  const double snippets = memory[0], sequences = memory[1];
  limits.within("snippets", snippets, 1, 15);
  limits.within("sequences", sequences, 1, 16);
  double last = 1 + snippets + sequences;
  for (std::size_t i = 0; i < static_cast<std::size_t>(snippets + sequences); ++i) {
    limits.within("end pointer", memory[2 + i], last + 1, 99);
    last = memory[2 + i];
  }
}

void checkDrv2605(const std::string& text, Limits& limits) {
  bool sounds = false;
  for (const char* name : {"detent_press[] =", "detent_release[] ="}) {
    const std::vector<double> steps = numbersIn(array(text, name));
    limits.holds("steps of two numbers", !steps.empty() && steps.size() % 2 == 0);
    for (std::size_t i = 0; i + 1 < steps.size(); i += 2) {
      limits.within("amplitude", steps[i], 0, 127);
      limits.within("ms", steps[i + 1], 5, 255);
      sounds = sounds || steps[i] > 0;
    }
  }
  limits.holds("silence", sounds);
}

void checkPcm(const std::string& text, Limits& limits) {
  const bool wide16 = text.find("int16_t detent_samples") != std::string::npos;
  const std::string head = between(text, "detent_samples[", "]");
  const std::vector<double> samples = numbersIn(array(text, "detent_samples["));
  limits.holds("as many samples as the array says", std::to_string(samples.size()) == head);
  const double full = wide16 ? 32767 : 127;
  for (const double sample : samples) limits.within("sample", sample, -full, full);
  limits.holds("silence", std::any_of(samples.begin(), samples.end(), [](double s) { return s != 0; }));
}

void checkTouchpad(const Json& file, Limits& limits) {
  limits.within("press_threshold_g", file["press_threshold_g"], 110, 190);
  limits.within("release_ratio", file["release_ratio"], 1e-6, 1);
  limits.within("intensity", file["intensity"]["press"], 0, 4);
  limits.within("intensity", file["intensity"]["release"], 0, 4);
}

/// NaN and infinity are written as null or nan.
void checkPackage(const Json& value, Limits& limits) {
  if (value.is_number()) limits.holds("a number that is none", std::isfinite(value.get<double>()));
  if (value.is_object() && value.contains("wave")) {
    const Json& wave = value["wave"];
    limits.within("frequency_Hz", wave["frequency_Hz"], 1e-3, 2000);
    // A second, as settings go; a bottom-out ends with a whole half wave.
    const double halfWave_ms =
        wave["frequency_Hz"].is_number() ? 500 / wave["frequency_Hz"].get<double>() : 0;
    limits.within("duration_ms", wave["duration_ms"], 1e-6, 1000.001 + halfWave_ms);
    limits.within("amplitude", wave["amplitude"], 0, 1);
  }
  if (value.is_structured())
    for (const Json& part : value) checkPackage(part, limits);
}

void checkHeader(const std::string& text, Limits& limits) {
  const std::string code = text.substr(std::min(text.size(), text.find("#ifndef")));
  limits.holds("nan or inf", code.find("nan") == std::string::npos && code.find("inff") == std::string::npos);
}

}  // namespace

FuzzedExport fuzzedExport(std::uint64_t seed) {
  Dice dice(seed);
  FuzzedExport drawn{button(dice), feel(dice), nullptr, {}, {}, {}};
  const auto& formats = playback::exportFormats.all;
  drawn.settings.format = formats[dice.below(std::size(formats))].value;
  drawn.settings.bits = dice.oneIn(2) ? 8 : 16;
  drawn.settings.sampleRate_Hz = dice.oneIn(2) ? 48000 : dice.byDecades(8000, 48000);
  drawn.settings.feel = drawn.feel.feel;
  drawn.settings.pressName = "drawn";
  auto prepared = playback::prepareProgram(drawn.button, {}, drawn.feel);
  if (!prepared) {
    drawn.refusal = prepared.failure().sentence();
    return drawn;
  }
  drawn.program = std::make_shared<const playback::HapticProgram>(prepared->program);
  if (dice.oneIn(2)) {
    playback::StandardPress press;
    press.press_s = dice.byDecades(0.01, dice.oneIn(300) ? 10 : 0.15);
    press.hold_s = dice.between(0, 0.02);
    press.release_s = dice.byDecades(0.01, 0.1);
    drawn.trace = playback::standardPress(*drawn.program, press);
  } else {
    drawn.trace = wobble(dice, *drawn.program, drawn.button);
  }
  return drawn;
}

std::vector<std::string> violationsOf(ExportFormat format, const std::vector<playback::ExportedFile>& files) {
  Limits limits;
  limits.holds("a file", !files.empty());
  for (const playback::ExportedFile& file : files) {
    const bool json = !file.text.empty() && file.text.front() == '{';
    const Json read = json ? Json::parse(file.text, nullptr, false) : Json();
    if (read.is_discarded()) {
      limits.holds("text that is JSON", false);
      continue;
    }
    switch (format) {
      case ExportFormat::package:
        checkPackage(read, limits);
        break;
      case ExportFormat::cHeader:
        checkHeader(file.text, limits);
        break;
      case ExportFormat::ahap:
        checkAhap(read, limits);
        break;
      case ExportFormat::haptic:
        checkHaptic(read, limits);
        break;
      case ExportFormat::android:
        checkAndroid(file.text, limits);
        break;
      case ExportFormat::openxr:
        if (json) checkOpenxr(read, limits);
        break;
      case ExportFormat::hjif:
        checkHjif(read, limits);
        break;
      case ExportFormat::bos1921:
        checkBos1921(file.text, limits);
        break;
      case ExportFormat::da728x:
        checkDa728x(file.text, limits);
        break;
      case ExportFormat::drv2605:
        checkDrv2605(file.text, limits);
        break;
      case ExportFormat::pcm:
        checkPcm(file.text, limits);
        break;
      case ExportFormat::touchpad:
        checkTouchpad(read, limits);
        break;
    }
  }
  return limits.found;
}

namespace {

ExportVerdict verdictOn(ExportFormat format, const std::vector<playback::ExportedFile>& files,
                        const playback::ExportLoss& loss) {
  ExportVerdict verdict{{}, violationsOf(format, files)};
  const auto reports = [&](const char* what, double value) {
    if (!std::isfinite(value) || value < 0) verdict.violations.push_back(std::string("loss: ") + what);
  };
  for (const auto& kept : loss.energyKept) reports("energy_kept", kept.value_or(0));
  reports("worst_timing_error_ms", loss.worstTimingError_ms);
  reports("frequency_moved_Hz", loss.frequencyMoved_Hz);
  return verdict;
}

}  // namespace

ExportVerdict judged(const FuzzedExport& drawn) {
  if (!drawn.program) return {drawn.refusal, {}};
  const auto exported = playback::exportPress(drawn.button, *drawn.program, drawn.trace, drawn.settings);
  if (!exported) return {exported.failure().sentence(), {}};
  return verdictOn(drawn.settings.format, exported->files, exported->loss);
}

ExportVerdict judgedByLimits(const FuzzedExport& drawn) {
  if (!drawn.program) return {drawn.refusal, {}};
  const auto plan =
      playback::planPress(drawn.button, *drawn.program, drawn.trace, drawn.settings.pressName, {});
  if (!plan) return {plan.failure().sentence(), {}};
  const auto reduction = playback::reductionOf({drawn.button, *drawn.program, *plan}, drawn.settings);
  if (!reduction) return {reduction.failure().sentence(), {}};
  return verdictOn(drawn.settings.format, reduction->write(reduction->loss), reduction->loss);
}

}  // namespace detent::test
