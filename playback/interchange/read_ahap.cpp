// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Apple's AHAP. As in Core Haptics, missing values get its defaults, values out of range are clamped,
// and unknown keys are ignored.

#include <algorithm>
#include <cmath>

#include "playback/interchange/reference_signal.h"
#include "playback/interchange/reference_waves.h"

namespace detent::playback {

namespace {

constexpr double anyNumber = 1e9;
constexpr double longestEvent_s = 30;   // longest continuous event
constexpr double curveStep_s = 0.0005;  // distance of interpolated points where the amplitude is not linear

/// Value of a dynamic parameter over time. Each curve or parameter applies from its first point until another
/// one begins: linear between its points, constant after the last one.
class Control {
 public:
  using Segment = std::vector<std::pair<double, double>>;  // time in seconds, value

  explicit Control(double before) : before_(before) {}

  bool silent() const { return segments_.empty(); }
  /// `segment`: at least one point, sorted by time.
  void add(Segment segment) { segments_.push_back(std::move(segment)); }
  /// Sorts the segments by start time; call once, before `at`.
  void settle() {
    std::stable_sort(segments_.begin(), segments_.end(),
                     [](const auto& a, const auto& b) { return a.front().first < b.front().first; });
  }
  double at(double time_s) const {
    const auto later = std::upper_bound(segments_.begin(), segments_.end(), time_s,
                                        [](double t, const auto& c) { return t < c.front().first; });
    if (later == segments_.begin()) return before_;
    const Segment& segment = *(later - 1);
    return within(segment, time_s,
                  std::upper_bound(segment.begin(), segment.end(), time_s,
                                   [](double t, const auto& point) { return t < point.first; }));
  }
  /// Limit from the left: differs from `at` at a step.
  double justBefore(double time_s) const {
    const auto notBefore = std::lower_bound(segments_.begin(), segments_.end(), time_s,
                                            [](const auto& c, double t) { return c.front().first < t; });
    if (notBefore == segments_.begin()) return before_;
    const Segment& segment = *(notBefore - 1);
    return within(segment, time_s,
                  std::lower_bound(segment.begin(), segment.end(), time_s,
                                   [](const auto& point, double t) { return point.first < t; }));
  }
  void collectTimes(double from_s, double to_s, std::vector<double>& times) const {
    for (const auto& segment : segments_)
      for (const auto& [time_s, value] : segment)
        if (time_s > from_s && time_s < to_s) times.push_back(time_s);
  }

 private:
  static double within(const Segment& segment, double time_s, Segment::const_iterator next) {
    const auto& [from_s, from] = *(next - 1);
    if (next == segment.end()) return from;
    return from + (next->second - from) * (time_s - from_s) / (next->first - from_s);
  }

  double before_;
  std::vector<Segment> segments_;
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
  Control::Segment points;
  const std::vector<JsonPlace> entries = curve.at("ParameterCurveControlPoints").elements();
  if (entries.empty()) return;
  if (from_s > 0 && timeOf(entries.front()) >= from_s)
    result.note(
        Message("the times of control points count from the Time of their curve. In the curve at %1 s they "
                "seem to count from the beginning of the pattern instead, so it is played too late",
                from_s));
  for (const JsonPlace& point : entries) {
    const double time_s = timeOf(point) + from_s;
    if (!points.empty() && time_s < points.back().first)
      point.refuse(Message("this control point lies before the previous one"),
                   Message("Sort the curve's points by time"));
    points.emplace_back(time_s, point.numberOr("ParameterValue", 0, -anyNumber, anyNumber));
  }
  control->add(std::move(points));
}

/// Reads a dynamic parameter: a new value from its time on.
void readParameter(const JsonPlace& entry, Controls& controls, ReferenceWaves& result) {
  const std::string parameter = entry.textOr("ParameterID", "");
  Control* const control = controls.named(parameter);
  if (control == nullptr) return result.note(Message("the parameter %1 is left out", parameter));
  const double value = entry.numberOr("ParameterValue", 0, -anyNumber, anyNumber);
  control->add({{timeOf(entry), value}});
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

WavePoint pointOf(const ReadAhapEvent& event, double time_s, double intensityControl,
                  double sharpnessControl) {
  const double intensity = event.intensity * std::clamp(intensityControl, 0.0, 1.0);
  const double sharpness = event.sharpness + std::clamp(sharpnessControl, -1.0, 1.0);
  return {time_s, intensity * intensity, frequencyOf(std::clamp(sharpness, 0.0, 1.0))};
}

WavePoint pointAt(const ReadAhapEvent& event, const Controls& controls, double time_s) {
  return pointOf(event, time_s, controls.intensity.at(time_s), controls.sharpness.at(time_s));
}

WavePoint pointBefore(const ReadAhapEvent& event, const Controls& controls, double time_s) {
  return pointOf(event, time_s, controls.intensity.justBefore(time_s), controls.sharpness.justBefore(time_s));
}

PlayedWave waveOf(const ReadAhapEvent& event, const Controls& controls) {
  PlayedWave wave;
  if (event.transient) {
    // Controls act on a transient only at its start.
    const WavePoint first = pointAt(event, controls, event.from_s);
    wave.points = {first, {event.to_s, 0, first.frequency_Hz}};
    return wave;
  }
  std::vector<double> times;
  controls.intensity.collectTimes(event.from_s, event.to_s, times);
  controls.sharpness.collectTimes(event.from_s, event.to_s, times);
  // The amplitude is the square of a linear function, so further points are needed.
  if (!controls.intensity.silent())
    for (double t = event.from_s + curveStep_s; t < event.to_s; t += curveStep_s) times.push_back(t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  wave.points.push_back(pointAt(event, controls, event.from_s));
  for (const double time_s : times) {
    const WavePoint before = pointBefore(event, controls, time_s), from = pointAt(event, controls, time_s);
    const bool step = before.amplitude != from.amplitude || before.frequency_Hz != from.frequency_Hz;
    if (step) wave.points.push_back(before);
    wave.points.push_back(from);
  }
  wave.points.push_back(pointBefore(event, controls, event.to_s));
  return wave;
}

}  // namespace

ReferenceWaves ahapWaves(const JsonPlace& file) {
  const double version = file.numberOr("Version", 1, 0, anyNumber);
  if (!(version >= 1 && version < 2))
    file.at("Version").refuse(Message("the version is %1, but only version 1 of AHAP can be read", version),
                              Message("Export the file as version 1"));
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
