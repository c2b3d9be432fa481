// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "importer/log/form_records.h"
#include "importer/log/recorded_switches.h"
#include "importer/log/table.h"
#include "model/text.h"

namespace detent::importer {
namespace {

using Json = nlohmann::json;

/// One data set on xy axes, its points in the order they were set.
struct TracedSet {
  std::string name, axes;
  std::vector<CurvePoint> points;
};

const Json* listAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? &*found : nullptr;
}

std::string textAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<double> numberAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  double value = std::nan("");
  if (found->is_number()) value = found->get<double>();
  if (found->is_string()) {
    const std::string& text = found->get_ref<const std::string&>();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};
  }
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool flagAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

/// Linear axes by the four points that calibrate them: two of one displacement axis, two of one force axis.
class Calibration {
 public:
  static std::optional<Calibration> of(const Json& axes) {
    const Json* list = listAt(axes, axes.contains("calibrationPoints") ? "calibrationPoints" : "calibration");
    const Json& scale = axes.contains("axesParameters") ? axes["axesParameters"] : axes;
    if (!list || list->size() < 4 || flagAt(scale, "isLogX") || flagAt(scale, "isLogY")) return {};
    Calibration is;
    for (std::size_t i = 0; i < 4; ++i) {
      const Json& point = (*list)[i];
      if (!point.is_object()) return {};
      const auto x_px = numberAt(point, "px"), y_px = numberAt(point, "py"),
                 value = numberAt(point, i < 2 ? "dx" : "dy");
      if (!x_px || !y_px || !value) return {};
      is.at_[i] = {*x_px, *y_px};
      is.value_[i] = *value;
    }
    if (flagAt(axes, "noRotation")) is.at_[1].y_px = is.at_[0].y_px, is.at_[3].x_px = is.at_[2].x_px;
    return is.area() != 0 ? std::optional(is) : std::nullopt;
  }

  CurvePoint valueAt(double x_px, double y_px) const {
    const Place along = less(at_[1], at_[0]), up = less(at_[3], at_[2]), p{x_px, y_px};
    return {value_[0] + cross(less(p, at_[0]), up) / area() * (value_[1] - value_[0]),
            value_[2] + cross(along, less(p, at_[2])) / area() * (value_[3] - value_[2])};
  }

 private:
  struct Place {
    double x_px = 0, y_px = 0;
  };
  static Place less(Place a, Place b) { return {a.x_px - b.x_px, a.y_px - b.y_px}; }
  static double cross(Place a, Place b) { return a.x_px * b.y_px - a.y_px * b.x_px; }
  double area() const { return cross(less(at_[1], at_[0]), less(at_[3], at_[2])); }

  std::array<Place, 4> at_;
  std::array<double, 4> value_{};
};

/// The value of a point as the project states it. Other programs leave it out; then it is computed from the
/// point's place on the page.
std::optional<CurvePoint> pointOf(const Json& each, const std::optional<Calibration>& calibration) {
  if (!each.is_object()) return {};
  const Json* value = listAt(each, "value");
  if (value && value->size() >= 2 && (*value)[0].is_number() && (*value)[1].is_number())
    return CurvePoint{(*value)[0].get<double>(), (*value)[1].get<double>()};
  const auto x_px = numberAt(each, "x"), y_px = numberAt(each, "y");
  if (!calibration || !x_px || !y_px) return {};
  return calibration->valueAt(*x_px, *y_px);
}

void addSet(const Json& set, const std::string& axes, const std::optional<Calibration>& calibration,
            std::vector<TracedSet>& sets) {
  const Json* list = set.is_object() ? listAt(set, "data") : nullptr;
  if (!list) return;
  TracedSet traced{textAt(set, "name"), axes, {}};
  for (const Json& each : *list) {
    const std::optional<CurvePoint> point = pointOf(each, calibration);
    if (point && std::isfinite(point->displacement_mm) && std::isfinite(point->force_N))
      traced.points.push_back(*point);
  }
  if (traced.points.size() >= 2) sets.push_back(std::move(traced));
}

std::vector<TracedSet> setsOf(const Json& document) {
  std::vector<TracedSet> sets;
  const auto older = document.find("wpd");
  if (older != document.end()) {
    const Json* series = textAt(*older, "axesType") == "XYAxes" ? listAt(*older, "dataSeries") : nullptr;
    if (series)
      for (const Json& set : *series) addSet(set, "", Calibration::of(*older), sets);
    return sets;
  }
  std::map<std::string, std::optional<Calibration>> xyAxes;
  if (const Json* all = listAt(document, "axesColl"))
    for (const Json& axes : *all)
      if (axes.is_object() && textAt(axes, "type") == "XYAxes")
        xyAxes.emplace(textAt(axes, "name"), Calibration::of(axes));
  if (const Json* all = listAt(document, "datasetColl"))
    for (const Json& set : *all) {
      const std::string axes = set.is_object() ? textAt(set, "axesName") : "";
      const auto known = xyAxes.find(axes);
      if (known != xyAxes.end()) addSet(set, axes, known->second, sets);
    }
  return sets;
}

bool isWordByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
}

double meanForce(const std::vector<CurvePoint>& points) {
  double sum = 0;
  for (const CurvePoint& p : points) sum += p.force_N;
  return sum / static_cast<double>(points.size());
}

template <typename Unit>
std::optional<Unit> unitIn(const std::string& text, std::optional<Unit> (*from)(std::string_view)) {
  std::optional<Unit> found;
  std::string word;
  for (const char c : text + " ")
    if (isWordByte(static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c))) {
      word += c;
    } else if (!word.empty()) {
      if (const auto unit = from(word)) found = unit;
      word.clear();
    }
  return found;
}

RecordedSwitch switchOf(const TracedSet& press, const TracedSet* release) {
  RecordedSwitch one;
  one.name = lowered(strokeNameOf(press.name).rest);
  const std::string said = press.axes + " " + press.name;
  one.xUnit = unitIn<LengthUnit>(said, lengthUnitFrom);
  one.yUnit = unitIn<ForceUnit>(said, forceUnitFrom);
  if (!release && !strokeNameOf(press.name).stroke) {
    one.run = press.points;
    return one;
  }
  one.press = press.points;
  if (release) one.release = release->points;
  return one;
}

/// For two sets whose names say no stroke: the lower one is the release, because a button returns less force
/// than it takes.
std::vector<RecordedSwitch> pairOfUnnamed(const std::vector<TracedSet>& sets) {
  const bool inOrder = meanForce(sets[0].points) >= meanForce(sets[1].points);
  RecordedSwitch one = switchOf(sets[inOrder ? 0 : 1], &sets[inOrder ? 1 : 0]);
  one.name.clear();
  return {std::move(one)};
}

std::vector<RecordedSwitch> byName(const std::vector<TracedSet>& sets) {
  std::vector<RecordedSwitch> switches;
  std::set<const TracedSet*> taken;
  for (const TracedSet& set : sets) {
    const StrokeName name = strokeNameOf(set.name);
    if (name.stroke == Stroke::release) continue;
    const auto release = std::ranges::find_if(sets, [&](const TracedSet& other) {
      const StrokeName otherName = strokeNameOf(other.name);
      return otherName.stroke == Stroke::release && lowered(otherName.rest) == lowered(name.rest) &&
             other.axes == set.axes;
    });
    const TracedSet* partner = release != sets.end() && !taken.contains(&*release) ? &*release : nullptr;
    if (partner) taken.insert(partner);
    switches.push_back(switchOf(set, partner));
  }
  return switches;
}

bool saysNoStroke(const TracedSet& set) { return !strokeNameOf(set.name).stroke; }

constexpr std::size_t tarBlock_bytes = 512;

std::optional<std::size_t> octalIn(std::string_view field) {
  field = trimmed(field.substr(0, field.find('\0')));
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value, 8);
  if (error != std::errc() || end != field.data() + field.size()) return {};
  return value;
}

}  // namespace

bool isDigitizerProject(const Json& document) {
  return document.is_object() &&
         (document.contains("axesColl") || (document.contains("wpd") && document["wpd"].is_object()));
}

Result<std::vector<RecordedSwitch>> switchesOfProject(const Json& document, const std::string& subject) {
  const Json* version = listAt(document.contains("wpd") ? document["wpd"] : document, "version");
  const int major =
      version && !version->empty() && (*version)[0].is_number_integer() ? (*version)[0].get<int>() : 0;
  if (major != 3 && major != 4)
    return unreadableFile(subject,
                          Message("the file is a WebPlotDigitizer project of an unknown version; only the "
                                  "versions 3 and 4 can be read"),
                          Message("Export the data sets as CSV"));
  const std::vector<TracedSet> sets = setsOf(document);
  if (sets.empty())
    return noForceLog(subject, Message("no data set on xy axes has two points or more"),
                      Message("Trace each stroke as a data set, then save the project"));
  for (const TracedSet& set : sets)
    if (holdsSortedLoop(set.points))
      return Failure{FailureCode::notCertain, subject, Message("data set \"%1\"", set.name),
                     Message("the points jump between two curves"),
                     Message("Use one data set for the press and one for the release, and name them "
                             "\"press\" and \"release\"")};
  if (sets.size() == 2 && sets[0].axes == sets[1].axes && std::ranges::all_of(sets, saysNoStroke))
    return pairOfUnnamed(sets);
  std::vector<RecordedSwitch> switches = byName(sets);
  if (switches.empty())
    return noForceLog(subject, Message("all data sets are named as releases"),
                      Message("Name the data set of the press \"press\""));
  return switches;
}

Result<std::string> projectInArchive(std::string_view bytes, const std::string& subject) {
  const auto unreadable = [&](Message problem) {
    return unreadableFile(subject, std::move(problem),
                          Message("Save the project once more in WebPlotDigitizer"));
  };
  for (std::size_t at = 0; at + tarBlock_bytes <= bytes.size();) {
    const std::string_view header = bytes.substr(at, tarBlock_bytes);
    if (header[0] == '\0') break;
    if (header.substr(257, 5) != "ustar") return unreadable(Message("the file is not a TAR archive"));
    const std::optional<std::size_t> size = octalIn(header.substr(124, 12));
    if (!size || *size > bytes.size() - at - tarBlock_bytes)
      return unreadable(Message("the archive is damaged"));
    const std::string_view path = header.substr(0, 100);
    const std::string_view name = path.substr(0, path.find('\0'));
    if (name == "wpd.json" || name.ends_with("/wpd.json"))
      return std::string(bytes.substr(at + tarBlock_bytes, *size));
    at += tarBlock_bytes * (1 + (*size + tarBlock_bytes - 1) / tarBlock_bytes);
  }
  return unreadable(Message("the archive holds no project (wpd.json)"));
}

}  // namespace detent::importer
