// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/button_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <limits>

#include <nlohmann/json.hpp>

#include "model/file/base64.h"
#include "model/file/json_place.h"
#include "model/file/json_text.h"
#include "model/file/migrations.h"
#include "model/file/text_file.h"

namespace detent {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int maxDepth = 16;  // levels of nesting; the format needs 5, deeper text is hostile

// ---- parsing

// A parse error; does not leave this file.
struct Refusal {
  Failure failure;
};

class Reader {
 public:
  explicit Reader(std::string subject) : subject_(std::move(subject)) {}

  [[noreturn]] void refuse(Message place, Message problem, Remedies remedies) const {
    throw Refusal{
        {FailureCode::unreadableInput, subject_, std::move(place), std::move(problem), std::move(remedies)}};
  }

  void requireObject(const json& value, const std::string& place) const {
    if (!value.is_object())
      refuse(place, "the value is " + kindOf(value) + ", not an object", "See docs/reference/file-format.md");
  }

  void refuseUnknownKeys(const json& object, const std::string& place,
                         std::initializer_list<std::string_view> known) const {
    for (const auto& [key, value] : object.items()) {
      if (key.rfind("x-", 0) == 0) continue;
      if (std::find(known.begin(), known.end(), key) == known.end())
        refuse(join(place, key.substr(0, 60)), Message("this field does not belong to the format"),
               "Remove it, correct its spelling, or begin its name with \"x-\"");
    }
  }

  const json& required(const json& object, const std::string& place, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end())
      refuse(join(place, key), Message("the field is missing"),
             Message("Add the field; see docs/reference/file-format.md"));
    return *found;
  }

  double number(const json& value, const std::string& place) const {
    if (!value.is_number())
      refuse(place, "the value is " + kindOf(value) + ", not a number", "Write a plain number");
    return value.get<double>();
  }

  double number(const json& object, const std::string& place, const char* key) const {
    return number(required(object, place, key), join(place, key));
  }

  double numberOr(const json& object, const std::string& place, const char* key, double otherwise) const {
    return object.contains(key) ? number(object, place, key) : otherwise;
  }

  std::optional<double> optionalNumber(const json& object, const std::string& place, const char* key) const {
    if (!object.contains(key)) return {};
    return number(object, place, key);
  }

  int wholeNumber(const json& object, const std::string& place, const char* key, int otherwise) const {
    if (!object.contains(key)) return otherwise;
    const double value = number(object, place, key);
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
      refuse(join(place, key),
             "the value is " + jsonText(object.at(key)) + ", not a whole number of ordinary size",
             "Write a whole number");
    return static_cast<int>(value);
  }

  std::string text(const json& value, const std::string& place) const {
    if (!value.is_string()) refuse(place, "the value is " + kindOf(value) + ", not text", "Put it in quotes");
    return value.get<std::string>();
  }

  std::string textOr(const json& object, const std::string& place, const char* key,
                     const char* otherwise) const {
    return object.contains(key) ? text(object.at(key), join(place, key)) : otherwise;
  }

  const json& array(const json& value, const std::string& place) const {
    if (!value.is_array())
      refuse(place, "the value is " + kindOf(value) + ", not a list", "See docs/reference/file-format.md");
    return value;
  }

  std::vector<std::string> texts(const json& object, const std::string& place, const char* key) const {
    std::vector<std::string> out;
    if (!object.contains(key)) return out;
    const json& list = array(object.at(key), join(place, key));
    for (std::size_t i = 0; i < list.size(); ++i) out.push_back(text(list[i], at(join(place, key), i)));
    return out;
  }

  // Adds file and place to the Failure of a value.
  template <class T>
  T accepted(Result<T> result, const std::string& place) const {
    if (!result) {
      const Failure& inner = result.failure();
      const Message where = place.empty()         ? inner.place
                            : inner.place.empty() ? Message(place)
                                                  : Message("%1, %2", place, inner.place);
      refuse(where, inner.problem, inner.remedies);
    }
    return *std::move(result);
  }

  static std::string join(const std::string& place, const std::string& key) {
    return place.empty() ? key : place + "." + key;
  }
  static std::string at(const std::string& place, std::size_t index) {
    return place + "[" + std::to_string(index) + "]";
  }

 private:
  static std::string kindOf(const json& value) {
    if (value.is_null()) return "null";
    if (value.is_number()) return "a number";
    if (value.is_string()) return "text";
    if (value.is_boolean()) return "true or false";
    return value.is_array() ? "a list" : "an object";
  }
  std::string subject_;
};

// Refuses unlimited nesting and duplicate keys, which the library's own handler accepts. A parser callback
// would do so, too, but copies every key.
class StrictHandler : public nlohmann::detail::json_sax_dom_parser<json> {
 public:
  StrictHandler(json& document, const Reader& reader) : json_sax_dom_parser(document), reader_(reader) {}

  bool start_object(std::size_t size) {
    enter();
    keys_.emplace_back();
    return json_sax_dom_parser::start_object(size);
  }
  bool key(std::string& name) {
    keys_.back().push_back(name);
    return json_sax_dom_parser::key(name);
  }
  bool end_object() {
    std::vector<std::string>& keys = keys_.back();
    std::sort(keys.begin(), keys.end());
    if (const auto twice = std::adjacent_find(keys.begin(), keys.end()); twice != keys.end())
      reader_.refuse("key \"" + twice->substr(0, 60) + "\"", "the key is given twice in one object",
                     "Keep one of the two");
    keys_.pop_back();
    --depth_;
    return json_sax_dom_parser::end_object();
  }
  bool start_array(std::size_t size) {
    enter();
    return json_sax_dom_parser::start_array(size);
  }
  bool end_array() {
    --depth_;
    return json_sax_dom_parser::end_array();
  }

 private:
  void enter() {
    if (++depth_ > maxDepth)
      reader_.refuse("", "the file is nested deeper than " + std::to_string(maxDepth) + " levels",
                     "Give a button file");
  }

  const Reader& reader_;
  int depth_ = 0;
  std::vector<std::vector<std::string>> keys_;  // keys of the objects that are open
};

json parsedJson(std::string_view text, const Reader& reader) {
  try {
    json document;
    StrictHandler handler(document, reader);
    json::sax_parse(text.begin(), text.end(), &handler);
    return document;
  } catch (const json::parse_error& error) {
    reader.refuse(placeOfByte(text, error.byte), notJson(text, error.byte),
                  Message("Correct the file at this place, or export the button again"));
  } catch (const json::out_of_range& error) {
    reader.refuse("", Message("holds a number that is too large: %1", numberIn(error.what())),
                  "Correct the number");
  }
}

Knot knotFrom(const Reader& in, const json& value, const std::string& place) {
  in.requireObject(value, place);
  in.refuseUnknownKeys(value, place,
                       {"displacement_mm", "force_N", "slopeBefore_N_per_mm", "slopeAfter_N_per_mm"});
  return {in.number(value, place, "displacement_mm"), in.number(value, place, "force_N"),
          in.number(value, place, "slopeBefore_N_per_mm"), in.number(value, place, "slopeAfter_N_per_mm")};
}

StrokeCurve curveFrom(const Reader& in, const json& value, const std::string& place) {
  in.array(value, place);
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < value.size(); ++i)
    knots.push_back(knotFrom(in, value[i], Reader::at(place, i)));
  return in.accepted(StrokeCurve::fromKnots(std::move(knots)), place);
}

std::vector<DampingPoint> dampingFrom(const Reader& in, const json& state, const std::string& place) {
  std::vector<DampingPoint> damping;
  if (!state.contains("damping")) return damping;
  const std::string listPlace = Reader::join(place, "damping");
  const json& list = in.array(state.at("damping"), listPlace);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string at = Reader::at(listPlace, i);
    in.requireObject(list[i], at);
    in.refuseUnknownKeys(list[i], at, {"displacement_mm", "damping_Ns_per_mm"});
    damping.push_back(
        {in.number(list[i], at, "displacement_mm"), in.number(list[i], at, "damping_Ns_per_mm")});
  }
  return damping;
}

ForceGraph graphFrom(const Reader& in, const json& value, const std::string& place) {
  StrokeCurve press = curveFrom(in, in.required(value, place, "press"), Reader::join(place, "press"));
  std::optional<StrokeCurve> release;
  if (value.contains("release")) release = curveFrom(in, value.at("release"), Reader::join(place, "release"));
  return in.accepted(ForceGraph::fromCurves(std::move(press), std::move(release)), place);
}

std::vector<SpeedGraph> otherSpeedsFrom(const Reader& in, const json& state, const std::string& place) {
  std::vector<SpeedGraph> graphs;
  if (!state.contains("otherSpeeds")) return graphs;
  const std::string listPlace = Reader::join(place, "otherSpeeds");
  const json& list = in.array(state.at("otherSpeeds"), listPlace);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string at = Reader::at(listPlace, i);
    in.requireObject(list[i], at);
    in.refuseUnknownKeys(list[i], at, {"speed_mm_per_s", "press", "release"});
    graphs.push_back({in.number(list[i], at, "speed_mm_per_s"), graphFrom(in, list[i], at)});
  }
  return graphs;
}

ButtonState stateFrom(const Reader& in, const json& value, const std::string& place) {
  in.requireObject(value, place);
  in.refuseUnknownKeys(value, place,
                       {"name", "press", "release", "operatingPoint_mm", "resetPoint_mm", "damping",
                        "speed_mm_per_s", "otherSpeeds"});
  ForceGraph graph = graphFrom(in, value, place);
  return {in.textOr(value, place, "name", ""),
          std::move(graph),
          in.optionalNumber(value, place, "operatingPoint_mm"),
          in.optionalNumber(value, place, "resetPoint_mm"),
          dampingFrom(in, value, place),
          in.optionalNumber(value, place, "speed_mm_per_s"),
          otherSpeedsFrom(in, value, place)};
}

std::optional<AxisProvenance> axisFrom(const Reader& in, const json& object, const char* key) {
  if (!object.contains(key)) return {};
  const std::string place = Reader::join("provenance", key);
  const json& value = object.at(key);
  in.requireObject(value, place);
  in.refuseUnknownKeys(value, place, {"unit", "min", "max", "residual_px", "by"});
  AxisProvenance axis;
  axis.unit = in.textOr(value, place, "unit", "");
  axis.min = in.number(value, place, "min");
  axis.max = in.number(value, place, "max");
  axis.residual_px = in.numberOr(value, place, "residual_px", 0);
  const std::string by = in.textOr(value, place, "by", "found");
  if (by != "found" && by != "given")
    in.refuse(Reader::join(place, "by"), "the value is \"" + by.substr(0, 40) + "\"",
              "Write \"found\" or \"given\"");
  axis.by = by == "found" ? DecidedBy::found : DecidedBy::given;
  return axis;
}

std::vector<RecordedWarning> warningsFrom(const Reader& in, const json& value, const std::string& place) {
  const auto texts = in.texts(value, place, "warnings"), codes = in.texts(value, place, "warningCodes");
  if (!codes.empty() && codes.size() != texts.size())
    in.refuse(Reader::join(place, "warningCodes"),
              Message("the list has %1 codes for %2 warnings", codes.size(), texts.size()),
              "Give one code for each warning, or none at all");
  std::vector<RecordedWarning> warnings;
  for (std::size_t i = 0; i < texts.size(); ++i)
    warnings.push_back({codes.empty() ? "" : codes[i], texts[i]});
  return warnings;
}

Provenance provenanceFrom(const Reader& in, const json& value) {
  const std::string place = "provenance";
  in.requireObject(value, place);
  in.refuseUnknownKeys(value, place,
                       {"sourceFile", "sourceSha256", "page", "graph", "frame", "xAxis", "yAxis", "quality",
                        "pressRms_px", "releaseRms_px", "confidence", "given", "warnings", "warningCodes"});
  Provenance p;
  p.sourceFile = in.textOr(value, place, "sourceFile", "");
  p.sourceSha256 = in.textOr(value, place, "sourceSha256", "");
  p.page = in.wholeNumber(value, place, "page", 1);
  p.graph = in.wholeNumber(value, place, "graph", 1);
  if (value.contains("frame")) {
    const json& frame = in.array(value.at("frame"), "provenance.frame");
    for (std::size_t i = 0; i < frame.size(); ++i)
      p.frame.push_back(in.number(frame[i], Reader::at("provenance.frame", i)));
  }
  p.xAxis = axisFrom(in, value, "xAxis");
  p.yAxis = axisFrom(in, value, "yAxis");
  p.quality = in.textOr(value, place, "quality", "");
  p.pressRms_px = in.numberOr(value, place, "pressRms_px", 0);
  p.releaseRms_px = in.numberOr(value, place, "releaseRms_px", 0);
  p.confidence = in.numberOr(value, place, "confidence", 0);
  p.given = in.texts(value, place, "given");
  p.warnings = warningsFrom(in, value, place);
  return p;
}

std::optional<PageCutout> cutoutFrom(const Reader& in, const json& document) {
  if (!document.contains("cutout")) return {};
  const json& value = document.at("cutout");
  in.requireObject(value, "cutout");
  in.refuseUnknownKeys(value, "cutout", {"png", "pixelToAxes"});
  const auto png = bytesFromBase64(in.text(in.required(value, "cutout", "png"), "cutout.png"));
  const Message without = "Remove the cut-out: the button does not need it";
  if (!png || !png->starts_with("\x89PNG\r\n\x1a\n"))
    in.refuse("cutout.png", "the field is not a PNG picture written in base64", without);
  if (png->size() > largestCutout_bytes)
    in.refuse("cutout.png",
              Message("the picture has %1 bytes; the limit is %2", png->size(), largestCutout_bytes),
              without);
  PageCutout cutout{*png, {}};
  const json& numbers = in.array(in.required(value, "cutout", "pixelToAxes"), "cutout.pixelToAxes");
  if (numbers.size() != cutout.pixelToAxes.size())
    in.refuse("cutout.pixelToAxes", Message("the list has %1 numbers, but it needs nine", numbers.size()),
              without);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    cutout.pixelToAxes[i] = in.number(numbers[i], Reader::at("cutout.pixelToAxes", i));
  return cutout;
}

std::vector<ButtonState> statesFrom(const Reader& in, const json& object, const std::string& place) {
  const std::string listPlace = Reader::join(place, "states");
  const json& list = in.array(in.required(object, place, "states"), listPlace);
  std::vector<ButtonState> states;
  for (std::size_t i = 0; i < list.size(); ++i)
    states.push_back(stateFrom(in, list[i], Reader::at(listPlace, i)));
  return states;
}

// Visits the objects of an optional list with their places.
template <class Take>
void forEachObject(const Reader& in, const json& object, const std::string& place, const char* key,
                   Take take) {
  if (!object.contains(key)) return;
  const std::string listPlace = Reader::join(place, key);
  const json& list = in.array(object.at(key), listPlace);
  for (std::size_t i = 0; i < list.size(); ++i) {
    in.requireObject(list[i], Reader::at(listPlace, i));
    take(list[i], Reader::at(listPlace, i));
  }
}

std::string filledText(const Reader& in, const json& object, const std::string& place, const char* key) {
  std::string text = in.text(in.required(object, place, key), Reader::join(place, key));
  if (text.empty())
    in.refuse(Reader::join(place, key), Message("the text is empty"), "Write a few words, or remove it");
  return text;
}

// Reads the place of a note or pin: state, stroke, displacement.
template <class At>
void takePlace(const Reader& in, const json& value, const std::string& place, At& at) {
  const int state = in.wholeNumber(value, place, "state", 0);
  if (state < 0) in.refuse(Reader::join(place, "state"), "the value is negative", "States count from 0");
  at.state = static_cast<std::size_t>(state);
  const std::string stroke = in.textOr(value, place, "stroke", "press");
  if (stroke != "press" && stroke != "release")
    in.refuse(Reader::join(place, "stroke"), "the value is \"" + stroke.substr(0, 40) + "\"",
              "Write \"press\" or \"release\"");
  at.stroke = stroke == "press" ? Stroke::press : Stroke::release;
  at.displacement_mm = in.number(value, place, "displacement_mm");
}

EditLinks linksFrom(const Reader& in, const json& document) {
  EditLinks links;
  if (!document.contains("links")) return links;
  const json& value = document.at("links");
  in.requireObject(value, "links");
  in.refuseUnknownKeys(value, "links", {"oneTravelEnd", "releaseBelowPress_N", "pinned"});
  if (value.contains("oneTravelEnd")) {
    if (!value.at("oneTravelEnd").is_boolean())
      in.refuse("links.oneTravelEnd", "the value is neither true nor false", "Write true or false");
    links.oneTravelEnd = value.at("oneTravelEnd").get<bool>();
  }
  links.releaseBelowPress_N = in.optionalNumber(value, "links", "releaseBelowPress_N");
  if (links.releaseBelowPress_N && *links.releaseBelowPress_N < 0)
    in.refuse("links.releaseBelowPress_N", "the value is negative",
              "Write how far the release lies below the press");
  forEachObject(in, value, "links", "pinned", [&](const json& pin, const std::string& place) {
    in.refuseUnknownKeys(pin, place, {"state", "stroke", "displacement_mm"});
    takePlace(in, pin, place, links.pinned.emplace_back());
  });
  return links;
}

Annotations annotationsFrom(const Reader& in, const json& document) {
  Annotations out;
  forEachObject(in, document, "", "notes", [&](const json& note, const std::string& place) {
    in.refuseUnknownKeys(note, place, {"state", "stroke", "displacement_mm", "text"});
    takePlace(in, note, place, out.notes.emplace_back());
    out.notes.back().text = filledText(in, note, place, "text");
  });
  forEachObject(in, document, "", "versions", [&](const json& version, const std::string& place) {
    in.refuseUnknownKeys(version, place, {"name", "saved", "states"});
    std::string name = filledText(in, version, place, "name");
    for (const NamedVersion& other : out.versions)
      if (other.name == name)
        in.refuse(Reader::join(place, "name"), "another version has this name", "Give each its own name");
    Button button = in.accepted(Button::fromStates("", statesFrom(in, version, place)), place);
    out.versions.push_back({std::move(name), in.textOr(version, place, "saved", ""), button.states()});
  });
  out.links = linksFrom(in, document);
  return out;
}

ButtonFile fileFrom(const Reader& in, std::string_view text, const std::string& subject) {
  json document = parsedJson(text, in);
  in.requireObject(document, "");
  const json& format = in.required(document, "", "format");
  if (format != "detent-button")
    in.refuse("format", Message("the format is not \"detent-button\""),
              Message("Give a *.button.json written by Detent"));
  document = in.accepted(migrated(std::move(document), buttonMigrations(), subject), "");
  in.refuseUnknownKeys(
      document, "",
      {"format", "version", "name", "states", "provenance", "cutout", "notes", "versions", "links"});
  std::vector<ButtonState> states = statesFrom(in, document, "");
  std::optional<Provenance> provenance;
  if (document.contains("provenance")) provenance = provenanceFrom(in, document.at("provenance"));
  Button button = in.accepted(
      Button::fromStates(in.textOr(document, "", "name", ""), std::move(states), std::move(provenance)), "");
  return {std::move(button), cutoutFrom(in, document), annotationsFrom(in, document)};
}

// ---- writing

ordered_json jsonOf(const StrokeCurve& curve) {
  ordered_json knots = ordered_json::array();
  for (const Knot& k : curve.knots())
    knots.push_back({{"displacement_mm", k.displacement_mm},
                     {"force_N", k.force_N},
                     {"slopeBefore_N_per_mm", k.slopeBefore_N_per_mm},
                     {"slopeAfter_N_per_mm", k.slopeAfter_N_per_mm}});
  return knots;
}

ordered_json jsonOf(const ButtonState& state) {
  ordered_json out;
  out["name"] = state.name;
  out["press"] = jsonOf(state.graph.press());
  if (state.graph.release()) out["release"] = jsonOf(*state.graph.release());
  if (state.operatingPoint_mm) out["operatingPoint_mm"] = *state.operatingPoint_mm;
  if (state.resetPoint_mm) out["resetPoint_mm"] = *state.resetPoint_mm;
  if (!state.damping.empty()) {
    out["damping"] = ordered_json::array();
    for (const DampingPoint& p : state.damping)
      out["damping"].push_back(
          {{"displacement_mm", p.displacement_mm}, {"damping_Ns_per_mm", p.damping_Ns_per_mm}});
  }
  if (state.speed_mm_per_s) out["speed_mm_per_s"] = *state.speed_mm_per_s;
  for (const SpeedGraph& other : state.otherSpeeds) {
    ordered_json entry{{"speed_mm_per_s", other.speed_mm_per_s}, {"press", jsonOf(other.graph.press())}};
    if (other.graph.release()) entry["release"] = jsonOf(*other.graph.release());
    out["otherSpeeds"].push_back(std::move(entry));
  }
  return out;
}

ordered_json jsonOf(const AxisProvenance& axis) {
  return {{"unit", axis.unit},
          {"min", axis.min},
          {"max", axis.max},
          {"residual_px", axis.residual_px},
          {"by", axis.by == DecidedBy::found ? "found" : "given"}};
}

ordered_json jsonOf(const Provenance& p) {
  ordered_json out;
  out["sourceFile"] = p.sourceFile;
  out["sourceSha256"] = p.sourceSha256;
  out["page"] = p.page;
  out["graph"] = p.graph;
  if (!p.frame.empty()) out["frame"] = p.frame;
  if (p.xAxis) out["xAxis"] = jsonOf(*p.xAxis);
  if (p.yAxis) out["yAxis"] = jsonOf(*p.yAxis);
  out["quality"] = p.quality;
  out["pressRms_px"] = p.pressRms_px;
  out["releaseRms_px"] = p.releaseRms_px;
  out["confidence"] = p.confidence;
  out["given"] = p.given;
  out["warnings"] = ordered_json::array();
  out["warningCodes"] = ordered_json::array();
  for (const RecordedWarning& warning : p.warnings) {
    out["warnings"].push_back(warning.text);
    out["warningCodes"].push_back(warning.code);
  }
  return out;
}

ordered_json jsonOf(const std::vector<ButtonState>& states) {
  ordered_json out = ordered_json::array();
  for (const ButtonState& state : states) out.push_back(jsonOf(state));
  return out;
}

template <class At>
ordered_json placeJson(const At& at) {
  return {{"state", at.state},
          {"stroke", at.stroke == Stroke::press ? "press" : "release"},
          {"displacement_mm", at.displacement_mm}};
}

ordered_json jsonOf(const EditLinks& links) {
  ordered_json out = ordered_json::object();
  if (links.oneTravelEnd) out["oneTravelEnd"] = true;
  if (links.releaseBelowPress_N) out["releaseBelowPress_N"] = *links.releaseBelowPress_N;
  for (const PinnedPoint& pin : links.pinned) out["pinned"].push_back(placeJson(pin));
  return out;
}

void append(ordered_json& document, const Annotations& annotations) {
  for (const Note& note : annotations.notes) {
    document["notes"].push_back(placeJson(note));
    document["notes"].back()["text"] = note.text;
  }
  for (const NamedVersion& version : annotations.versions) {
    ordered_json entry{{"name", version.name}};
    if (!version.saved.empty()) entry["saved"] = version.saved;
    entry["states"] = jsonOf(version.states);
    document["versions"].push_back(std::move(entry));
  }
  if (!annotations.links.empty()) document["links"] = jsonOf(annotations.links);
}

// Returns the oldest version that holds the content.
int versionFor(const Button& button, const std::optional<PageCutout>& cutout,
               const Annotations& annotations) {
  const auto atSpeeds = [](const std::vector<ButtonState>& states) {
    return std::ranges::any_of(states, [](const ButtonState& s) { return s.speed_mm_per_s.has_value(); });
  };
  if (atSpeeds(button.states()) ||
      std::ranges::any_of(annotations.versions, [&](const NamedVersion& v) { return atSpeeds(v.states); }))
    return 5;
  if (!annotations.empty()) return 4;
  return cutout ? 3 : 2;
}

bool holdsOnlyScalars(const ordered_json& value) {
  return std::none_of(value.begin(), value.end(), [](const ordered_json& v) { return v.is_structured(); });
}

// Indents by two, but keeps a knot on one line.
void print(std::string& out, const ordered_json& value, const std::string& indent) {
  const bool scalarRow = value.is_structured() && !indent.empty() && holdsOnlyScalars(value);
  if (!value.is_structured() || value.empty() || (scalarRow && value.is_array())) {
    out += jsonText(value);
    return;
  }
  const char* separator = "";
  const bool object = value.is_object();
  out += object ? '{' : '[';
  const std::string inner = indent + "  ";
  for (const auto& [key, element] : value.items()) {
    out += separator;
    if (!scalarRow) out += "\n" + inner;
    if (object) out += jsonText(ordered_json(key)) + ": ";
    print(out, element, inner);
    separator = scalarRow ? ", " : ",";
  }
  if (!scalarRow) out += "\n" + indent;
  out += object ? '}' : ']';
}

Result<Button> buttonOf(Result<ButtonFile> file) {
  if (!file) return file.failure();
  return std::move(file->button);
}

}  // namespace

Result<ButtonFile> buttonFileFromJson(std::string_view text, const std::string& subject) {
  try {
    return fileFrom(Reader(subject), text, subject);
  } catch (const Refusal& refusal) {
    return refusal.failure;
  } catch (const json::exception&) {
    return Failure{FailureCode::unreadableInput, subject, "", "the content of the file is broken",
                   "Give a *.button.json written by Detent"};
  }
}

Result<Button> buttonFromJson(std::string_view text, const std::string& subject) {
  return buttonOf(buttonFileFromJson(text, subject));
}

std::string jsonFrom(const Button& button, const std::optional<PageCutout>& cutout,
                     const Annotations& annotations) {
  ordered_json document;
  document["format"] = "detent-button";
  document["version"] = versionFor(button, cutout, annotations);
  document["name"] = button.name();
  document["states"] = jsonOf(button.states());
  if (button.provenance()) document["provenance"] = jsonOf(*button.provenance());
  if (cutout) document["cutout"] = {{"png", base64From(cutout->png)}, {"pixelToAxes", cutout->pixelToAxes}};
  append(document, annotations);
  std::string text;
  print(text, document, "");
  return text + "\n";
}

Result<ButtonFile> readWholeButtonFile(const std::string& path) {
  auto text = readTextFile(path);
  if (!text) return text.failure();
  return buttonFileFromJson(*text, path);
}

Result<Button> readButtonFile(const std::string& path) { return buttonOf(readWholeButtonFile(path)); }

Result<Done> writeButtonFile(const std::string& path, const Button& button) {
  return writeTextFileAtomically(path, jsonFrom(button));
}

}  // namespace detent
