// SPDX-License-Identifier: GPL-3.0-or-later
// Apple's AHAP. Missing values are its defaults, values out of range are clamped, unknown keys are left alone, as Core Haptics does.

#include <algorithm>
#include <cmath>

#include "playback/interchange/reference_signal.h"
#include "playback/interchange/reference_waves.h"

namespace detent::playback {

namespace {

constexpr double anyNumber = 1e9;
constexpr double longestEvent_s = 30;    // of a continuous one
constexpr std::size_t curvePoints = 16;  // of a parameter curve: Core Haptics leaves out what follows
constexpr double course_s = 0.002;       // between points of a course that is no straight line

/// A value over time: what it is before the first point, straight between points, and kept after the last.
class Control {
 public:
  explicit Control(double before) : before_(before) {}

  bool silent() const { return points_.empty(); }
  /// Points of one curve; what follows in time takes over where it begins.
  void add(std::vector<std::pair<double, double>> curve) {
    points_.insert(points_.end(), curve.begin(), curve.end());
  }
  void settle() {
    std::stable_sort(points_.begin(), points_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  double at(double time_s) const {
    const auto next = std::upper_bound(points_.begin(), points_.end(), time_s,
                                       [](double t, const auto& point) { return t < point.first; });
    if (next == points_.begin()) return before_;
    const auto& [from_s, from] = *(next - 1);
    if (next == points_.end()) return from;
    return from + (next->second - from) * (time_s - from_s) / (next->first - from_s);
  }
  void collectTimes(double from_s, double to_s, std::vector<double>& times) const {
    for (const auto& [time_s, value] : points_)
      if (time_s > from_s && time_s < to_s) times.push_back(time_s);
  }

 private:
  double before_;
  std::vector<std::pair<double, double>> points_;
};

struct Controls {
  Control intensity{1}, sharpness{0};

  Control* named(const std::string& parameter) {
    if (parameter == "HapticIntensityControl") return &intensity;
    return parameter == "HapticSharpnessControl" ? &sharpness : nullptr;
  }
};

double timeOf(const JsonPlace& entry) { return entry.numberOr("Time", 0, 0, longestReference_s); }

void readCurve(const JsonPlace& curve, Controls& controls, ReferenceWaves& result) {
  const std::string parameter = curve.textOr("ParameterID", "");
  Control* const control = controls.named(parameter);
  if (control == nullptr) return result.note(Message("the parameter curve %1 is left out", parameter));
  const double from_s = timeOf(curve);
  std::vector<std::pair<double, double>> points;
  const std::vector<JsonPlace> entries = curve.at("ParameterCurveControlPoints").elements();
  // Times are the curve's own, from 0; Lofelt's and Meta's converters write the pattern's.
  const bool patternTimes = from_s > 0 && !entries.empty() && timeOf(entries.front()) >= from_s;
  for (const JsonPlace& point : entries) {
    if (points.size() == curvePoints) {
      result.note(Message("control points behind the %1th of a curve are left out, as Core Haptics does",
                          curvePoints));
      break;
    }
    const double time_s = timeOf(point) + (patternTimes ? 0 : from_s);
    if (!points.empty() && time_s < points.back().first)
      point.refuse(Message("lies before the control point it follows"),
                   Message("Sort the curve's points by time"));
    points.emplace_back(time_s, point.numberOr("ParameterValue", 0, -anyNumber, anyNumber));
  }
  control->add(std::move(points));
}

/// A dynamic parameter: another value from its time on.
void readParameter(const JsonPlace& entry, Controls& controls, ReferenceWaves& result) {
  const std::string parameter = entry.textOr("ParameterID", "");
  Control* const control = controls.named(parameter);
  if (control == nullptr) return result.note(Message("the parameter %1 is left out", parameter));
  const double value = entry.numberOr("ParameterValue", 0, -anyNumber, anyNumber);
  control->add({{timeOf(entry), control->at(timeOf(entry))}, {timeOf(entry), value}});
}

struct ReadAhapEvent {
  bool transient = false;
  double from_s = 0, to_s = 0, intensity = 1, sharpness = 0.5;
};

void readEvent(const JsonPlace& entry, std::vector<ReadAhapEvent>& events, ReferenceWaves& result) {
  const std::string type = entry.at("EventType").text();
  ReadAhapEvent event;
  event.transient = type == "HapticTransient";
  if (!event.transient && type != "HapticContinuous")
    return result.note(Message("events of the type %1 are left out", type));
  event.from_s = timeOf(entry);
  event.to_s =
      event.from_s + (event.transient ? transient_s : entry.numberOr("EventDuration", 0, 0, longestEvent_s));
  if (entry.has("EventParameters")) {
    for (const JsonPlace& parameter : entry.at("EventParameters").elements()) {
      const std::string id = parameter.textOr("ParameterID", "");
      const double value = parameter.numberOr("ParameterValue", 0, -anyNumber, anyNumber);
      if (id == "HapticIntensity")
        event.intensity = std::clamp(value, 0.0, 1.0);
      else if (id == "HapticSharpness")
        event.sharpness = std::clamp(value, 0.0, 1.0);
      else if (value != (id == "Sustained" ? 1 : 0))
        result.note(Message("the event parameter %1 is left out", id));
    }
  }
  events.push_back(event);
}

WavePoint pointAt(const ReadAhapEvent& event, const Controls& controls, double time_s) {
  const double intensity = event.intensity * std::clamp(controls.intensity.at(time_s), 0.0, 1.0);
  const double sharpness = event.sharpness + std::clamp(controls.sharpness.at(time_s), -1.0, 1.0);
  const double falls = event.transient ? (event.to_s - time_s) / transient_s : 1;
  return {time_s, intensity * intensity * std::clamp(falls, 0.0, 1.0),
          frequencyOf(std::clamp(sharpness, 0.0, 1.0))};
}

PlayedWave waveOf(const ReadAhapEvent& event, const Controls& controls) {
  PlayedWave wave;
  if (event.transient) {
    // What a transient is, it is from its beginning.
    const WavePoint first = pointAt(event, controls, event.from_s);
    wave.points = {first, {event.to_s, 0, first.frequency_Hz}};
    return wave;
  }
  std::vector<double> times{event.from_s, event.to_s};
  controls.intensity.collectTimes(event.from_s, event.to_s, times);
  controls.sharpness.collectTimes(event.from_s, event.to_s, times);
  // The amplitude is the square of a straight line.
  if (!controls.intensity.silent())
    for (double t = event.from_s + course_s; t < event.to_s; t += course_s) times.push_back(t);
  std::sort(times.begin(), times.end());
  for (const double time_s : times) wave.points.push_back(pointAt(event, controls, time_s));
  return wave;
}

}  // namespace

ReferenceWaves ahapWaves(const JsonPlace& file) {
  const double version = file.at("Version").number(0, anyNumber);
  if (!(version >= 1 && version < 2))
    file.at("Version").refuse(Message("is %1: another version of AHAP than 1", version),
                              Message("Export it as version 1"));
  ReferenceWaves result;
  Controls controls;
  std::vector<ReadAhapEvent> events;
  for (const JsonPlace& entry : file.at("Pattern").elements()) {
    if (entry.has("Event")) readEvent(entry.at("Event"), events, result);
    if (entry.has("ParameterCurve")) readCurve(entry.at("ParameterCurve"), controls, result);
    if (entry.has("Parameter")) readParameter(entry.at("Parameter"), controls, result);
  }
  controls.intensity.settle();
  controls.sharpness.settle();
  for (const ReadAhapEvent& event : events) result.waves.push_back(waveOf(event, controls));
  result.events = events.size();
  return result;
}

}  // namespace detent::playback
