// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/button_file.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "model/edits.h"
#include "model/file/base64.h"
#include "model/file/migrations.h"
#include "model/file/text_file.h"
#include "model/templates.h"
#include "tests/model/property.h"
#include "tests/model/random_curves.h"

using namespace detent;
using detent::tests::anyCurve;
using detent::tests::holdsAlways;

namespace {

const std::string fixtures = std::string(DETENT_SOURCE_DIR) + "/tests/model/file/fixtures/";
const std::string fixture = fixtures + "version-1.button.json";

Button fixtureButton(const std::string& file = fixture) {
  auto button = readButtonFile(file);
  INFO((button.ok() ? "" : button.failure().sentence()));
  REQUIRE(button.ok());
  return *button;
}

std::string fixtureText() {
  auto text = readTextFile(fixture);
  REQUIRE(text.ok());
  return *text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

void requireRefusal(const std::string& text, const std::string& part) {
  const auto button = buttonFromJson(text, "b.json");
  REQUIRE_FALSE(button.ok());
  const std::string sentence = button.failure().sentence();
  INFO(sentence);
  CHECK(button.failure().exitCode() == 3);
  CHECK(sentence.rfind("b.json", 0) == 0);
  CHECK_THAT(sentence, Catch::Contains(part));
  CHECK_FALSE(button.failure().remedies.empty());
  CHECK(sentence.find('\n') == std::string::npos);
  CHECK(sentence.size() < 400);
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// A button whose free numbers (slopes outside the ends, provenance) may be any double.
Button carrying(double value) {
  auto curve = StrokeCurve::fromKnots({{0, 0.25, value, 0.5}, {1, 0.5, 0, value}});
  REQUIRE(curve.ok());
  Provenance provenance;
  provenance.xAxis = AxisProvenance{"mm", value, 1, 0, DecidedBy::found};
  provenance.frame = {value, 0, 1, 2};
  provenance.confidence = value;
  auto button =
      Button::fromStates("b", {ButtonState{"", *ForceGraph::fromCurves(*curve, {}), {}, {}, {}}}, provenance);
  REQUIRE(button.ok());
  return *button;
}

void requireCarried(double value) {
  const auto back = buttonFromJson(jsonFrom(carrying(value)), "b");
  REQUIRE(back.ok());
  const auto& knots = back->states()[0].graph.press().knots();
  CHECK(sameBits(knots[0].slopeBefore_N_per_mm, value));
  CHECK(sameBits(knots[1].slopeAfter_N_per_mm, value));
  CHECK(sameBits(back->provenance()->xAxis->min, value));
  CHECK(sameBits(back->provenance()->frame[0], value));
  CHECK(sameBits(back->provenance()->confidence, value));
}

}  // namespace

TEST_CASE("the fixture of version 1 reads as it was written, for ever") {
  const Button button = fixtureButton();
  CHECK(button.name() == "fixture of version 1, kept for ever");
  REQUIRE(button.states().size() == 2);
  const ButtonState& state = button.states()[0];
  CHECK(state.name == "unlocked");
  CHECK(state.graph.press().knots()[1] == Knot{1.5, 0.7, 0.0, -0.5});
  CHECK(state.graph.press().knots().size() == 5);
  CHECK(state.graph.release()->start_mm() == 2.5);
  CHECK(*state.operatingPoint_mm == 3.0);
  CHECK(*state.resetPoint_mm == 2.75);
  CHECK(state.damping[1] == DampingPoint{4.0, 0.0025});
  CHECK_FALSE(button.states()[1].graph.release().has_value());
  const Provenance& p = *button.provenance();
  CHECK(p.sourceFile == "datasheet.pdf");
  CHECK(p.page == 3);
  CHECK(p.graph == 2);
  CHECK(p.frame == std::vector<double>{102.5, 40.0, 880.25, 512.0});
  CHECK(p.xAxis->residual_px == 0.21);
  CHECK(p.yAxis->by == DecidedBy::given);
  CHECK(p.confidence == 0.93);
  CHECK(p.given == std::vector<std::string>{"--y-unit cN"});
  REQUIRE(p.warnings.size() == 1);
  CHECK(p.warnings[0].code.empty());  // there were none
  CHECK_FALSE(p.warnings[0].text.empty());
}

TEST_CASE("the fixture of version 2 differs from version 1 by what the version brought") {
  const Button old = fixtureButton(), button = fixtureButton(fixtures + "version-2.button.json");
  CHECK(button.name() == "fixture of version 2, kept for ever");
  CHECK(button.states() == old.states());
  Provenance p = *button.provenance();
  REQUIRE(p.warnings.size() == 2);
  CHECK(p.warnings[0].code == "large-forces-taken-as-gram");
  CHECK(p.warnings[1].code.empty());
  CHECK(p.warnings[1].text == old.provenance()->warnings[0].text);
  p.warnings = old.provenance()->warnings;
  CHECK(p == *old.provenance());
}

TEST_CASE("the fixture of version 3 is version 2 with a cut-out of the page") {
  const auto file = readWholeButtonFile(fixtures + "version-3.button.json");
  REQUIRE(file.ok());
  CHECK(file->button.name() == "fixture of version 3, kept for ever");
  CHECK(file->button.states() == fixtureButton().states());
  REQUIRE(file->cutout);
  CHECK(file->cutout->png.size() == 68);
  CHECK(file->cutout->png.substr(1, 3) == "PNG");
  CHECK(file->cutout->pixelToAxes == std::array<double, 9>{0.0125, 0, -1.25, 0, -0.0025, 1.5, 0, 0.0001, 1});
}

TEST_CASE("a cut-out survives the file, and only then is the version 3") {
  const Button button = *tactileButton();
  PageCutout cutout{"\x89PNG\r\n\x1a\n", {0.1, 0, -0.3, 0, -1.0 / 3, 7, 1e-9, 0, 1}};
  CHECK(nlohmann::json::parse(jsonFrom(button))["version"] == 2);
  for (int extra = 0; extra < 4; ++extra) {  // each length of the last group of base64
    const std::string text = jsonFrom(button, cutout);
    CHECK(nlohmann::json::parse(text)["version"] == 3);
    const auto back = buttonFileFromJson(text, "b");
    REQUIRE(back.ok());
    CHECK(back->cutout == cutout);
    CHECK(back->button == button);
    cutout.png += static_cast<char>(0xf9 + extra);
  }
}

TEST_CASE("a cut-out that is none is refused with its place") {
  const PageCutout cutout{"\x89PNG\r\n\x1a\nrest", {1, 0, 0, 0, 1, 0, 0, 0, 1}};
  const auto good = nlohmann::json::parse(jsonFrom(*tactileButton(), cutout));
  const auto with = [&](const char* key, const nlohmann::json& value) {
    auto changed = good;
    changed["cutout"][key] = value;
    return changed.dump();
  };
  const std::string text = good["cutout"]["png"];
  for (const std::string& wrong : {text.substr(1), text + "=", "!" + text.substr(1), std::string("AAAA"),
                                   text.substr(0, text.size() - 1) + "\n", std::string()})
    requireRefusal(with("png", wrong), "cutout.png");
  requireRefusal(with("png", base64From(cutout.png + std::string(largestCutout_bytes, 'x'))),
                 "the limit is 1048576");
  requireRefusal(with("pixelToAxes", {1, 0, 0, 0, 1, 0, 0, 0}), "cutout.pixelToAxes: the list has 8 numbers");
  requireRefusal(with("pixelToAxes", {1, 0, 0, 0, "1", 0, 0, 0, 1}), "cutout.pixelToAxes[4]");
  requireRefusal(with("picture", ""), "cutout.picture");
}

TEST_CASE("buttons survive the file whole") {
  for (const auto& button :
       {linearButton(), tactileButton(), clickyButton(), twoLevelButton(), selfLockingButton()}) {
    REQUIRE(button.ok());
    const auto back = buttonFromJson(jsonFrom(*button), "b");
    REQUIRE(back.ok());
    CHECK(*back == *button);
    CHECK(jsonFrom(*back) == jsonFrom(*button));
  }
  CHECK(buttonFromJson(jsonFrom(fixtureButton()), "b").value() == fixtureButton());
  holdsAlways("any curve", [] {
    const auto graph = ForceGraph::fromCurves(anyCurve(), {});
    RC_ASSERT(graph.ok());
    const auto button = Button::fromStates("any", {ButtonState{"", *graph, {}, {}, {}}});
    RC_ASSERT(buttonFromJson(jsonFrom(*button), "b").value() == *button);
  });
}

TEST_CASE("every finite double survives the file bit for bit") {
  using Limits = std::numeric_limits<double>;
  for (double value :
       {0.0, -0.0, Limits::denorm_min(), -Limits::denorm_min(), Limits::min(), Limits::max(),
        Limits::lowest(), Limits::epsilon(), 0.1, 1.0 / 3, 5e-324, 9007199254740993.0, 1e22, 1e23})
    requireCarried(value);
  holdsAlways("any bits", [] {
    const auto bits = *rc::gen::resize(1000000, rc::gen::arbitrary<std::uint64_t>());
    const double value = std::bit_cast<double>(bits * 0x9E3779B97F4A7C15u + 0x1234567u);
    if (std::isfinite(value)) requireCarried(value);
  });
}

TEST_CASE("names keep every letter, and bytes that are none do no harm") {
  const Button odd = *rename(fixtureButton(), "quote \" backslash \\ newline \n \xC3\xA4 \xE6\x8C\x89");
  CHECK(buttonFromJson(jsonFrom(odd), "b").value() == odd);
  const Button broken = *rename(fixtureButton(), "broken \xFF byte");
  CHECK(buttonFromJson(jsonFrom(broken), "b").value().name() == "broken \xEF\xBF\xBD byte");
}

TEST_CASE("malformed JSON is refused with line and column") {
  requireRefusal("", "line 1, column 1: the file is not valid JSON");
  requireRefusal("{\n  \"format\": \"detent-button\",\n  oops\n}", "line 3, column 3");
  requireRefusal(fixtureText().substr(0, 700), "is not valid JSON");
  requireRefusal("\xFF\xFE{", "is not valid JSON");
  requireRefusal("{\"a\": 1} trailing", "line 1, column 1");
  requireRefusal(std::string("{\"a\": \"\0\"}", 10), "is not valid JSON");
  const std::string ends = "the file is not valid JSON: it ends too early.";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", ends},
      {"{", ends},
      {"{\"a\": \"b", ends},
      {"{\n\"a\": tru }", "line 2, column 9: the file is not valid JSON: \"\"a\": tru }\" cannot be read."},
      {"{\"a\" 1}", "the file is not valid JSON: \"{\"a\" 1}\" cannot be read."},
      {"{\"a\": 1e999}", "holds a number that is too large: 1e999."}};
  for (const auto& [text, sentence] : cases) {
    requireRefusal(text, sentence);
    const std::string said = buttonFromJson(text, "b").failure().sentence();
    for (const char* word : {"syntax", "literal", "token", "expected", "parse", "exception", "last read"})
      CHECK(said.find(word) == std::string::npos);
  }
}

TEST_CASE("hostile JSON is refused quickly") {
  requireRefusal(std::string(1000000, '['), "nested deeper than 16");
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  requireRefusal(objects, "nested deeper than 16");
  requireRefusal(replaced(fixtureText(), "0.7,", "1e999,"), "number that is too large");
  requireRefusal(replaced(fixtureText(), "0.7,", "NaN,"), "is not valid JSON");
  requireRefusal(replaced(fixtureText(), "0.7,", "-Infinity,"), "is not valid JSON");
  requireRefusal(replaced(fixtureText(), "0.7,", "123456789012345678901234567890,"), "beyond the limit");
  requireRefusal(replaced(fixtureText(), "\"page\": 3", "\"page\": 3, \"page\": 4"),
                 "key \"page\": the key is given twice");
  requireRefusal("{\"" + std::string(5000, 'k') +
                     "\": 1, \"format\": \"detent-button\", \"version\": 1, \"states\": []}",
                 "does not belong to the format");
}

TEST_CASE("wrong types are refused with the path of the value") {
  requireRefusal("[]", "is a list, not an object");
  requireRefusal("null", "is null, not an object");
  requireRefusal(replaced(fixtureText(), "\"detent-button\"", "\"other\""),
                 "format: the format is not \"detent-button\"");
  requireRefusal(replaced(fixtureText(), "\"force_N\": 0.7,", "\"force_N\": \"0.7\","),
                 "states[0].press[1].force_N: the value is text, not a number");
  requireRefusal(replaced(fixtureText(), "\"force_N\": 0.7,", ""),
                 "states[0].press[1].force_N: the field is missing");
  requireRefusal(replaced(fixtureText(), "\"operatingPoint_mm\": 3.0", "\"operatingPoint_mm\": null"),
                 "states[0].operatingPoint_mm: the value is null");
  requireRefusal(replaced(fixtureText(), "[\"--y-unit cN\"]", "[1]"),
                 "provenance.given[0]: the value is a number, not text");
  requireRefusal(replaced(fixtureText(), "\"page\": 3", "\"page\": 3.5"),
                 "provenance.page: the value is 3.5");
  requireRefusal(replaced(fixtureText(), "\"page\": 3", "\"page\": 1e300"),
                 "not a whole number of ordinary size");
  requireRefusal(replaced(fixtureText(), "\"given\"}", "\"guessed\"}"),
                 "provenance.yAxis.by: the value is \"guessed\"");
  requireRefusal("{\"format\": \"detent-button\", \"version\": 1, \"states\": {}}",
                 "states: the value is an object, not a list");
}

TEST_CASE("the model's own rules speak with the path in front") {
  requireRefusal(replaced(fixtureText(), "\"displacement_mm\": 2.0", "\"displacement_mm\": 1.0"),
                 "states[0].press, curve point 3: the displacement 1 mm lies before");
  requireRefusal(replaced(fixtureText(), "\"operatingPoint_mm\": 3.0", "\"operatingPoint_mm\": 30"),
                 "state \"unlocked\": operating point at 30 mm");
  requireRefusal("{\"format\": \"detent-button\", \"version\": 1, \"states\": []}", "has 0 states");
}

TEST_CASE("misspelt keys are refused, keys of others are let be") {
  requireRefusal(replaced(fixtureText(), "operatingPoint_mm", "operatingpoint_mm"),
                 "states[0].operatingpoint_mm: this field does not belong to the format");
  CHECK(buttonFromJson(replaced(fixtureText(), "\"operatingPoint_mm\"",
                                "\"x-note\": {\"any\": []}, \"operatingPoint_mm\""),
                       "b")
            .ok());
}

TEST_CASE("warnings keep their codes, from version 2 on") {
  std::vector<ButtonState> states = fixtureButton().states();
  Provenance provenance = *fixtureButton().provenance();
  provenance.warnings = {{"several-graphs", "2 graphs found"}, {"", "from an older file"}};
  const auto button = Button::fromStates("", std::move(states), provenance);
  REQUIRE(button.ok());
  const std::string text = jsonFrom(*button);
  const auto back = buttonFromJson(text, "b.json");
  REQUIRE(back.ok());
  CHECK(back->provenance()->warnings == provenance.warnings);
  auto withoutOne = nlohmann::json::parse(text);
  withoutOne["provenance"]["warningCodes"].erase(0);
  requireRefusal(withoutOne.dump(), "provenance.warningCodes");
}

TEST_CASE("notes, versions and links come back, and only they make a file version 4") {
  const auto file = readWholeButtonFile(fixtures + "version-4.button.json");
  REQUIRE(file.ok());
  const Annotations& kept = file->annotations;
  REQUIRE(kept.notes.size() == 2);
  CHECK(kept.notes[1] == Note{1, Stroke::release, 3.0, "nobody has felt this yet"});
  REQUIRE(kept.versions.size() == 1);
  CHECK(kept.versions[0].states[0].operatingPoint_mm == 2.0);
  CHECK(kept.links.oneTravelEnd);
  CHECK(kept.links.releaseBelowPress_N == 0.05);
  CHECK(kept.links.pinned == std::vector{PinnedPoint{0, Stroke::press, 1.5}});
  const std::string text = jsonFrom(file->button, file->cutout, kept);
  const auto back = buttonFileFromJson(text, "b");
  REQUIRE(back.ok());
  CHECK(back->annotations == kept);
  CHECK(nlohmann::json::parse(text).at("version") == 4);
  CHECK(nlohmann::json::parse(jsonFrom(file->button, file->cutout)).at("version") == 3);
  CHECK(nlohmann::json::parse(jsonFrom(file->button)).at("version") == 2);
}

TEST_CASE("what is wrong with a note, a version or a link is named by its place") {
  const auto refused = [](const char* pointer, const nlohmann::json& value, const char* part) {
    auto document = nlohmann::json::parse(*readTextFile(fixtures + "version-4.button.json"));
    document[nlohmann::json::json_pointer(pointer)] = value;
    requireRefusal(document.dump(), part);
  };
  refused("/notes/0/text", "", "notes[0].text: the text is empty");
  refused("/notes/0/state", -1, "notes[0].state: the value is negative");
  refused("/notes/0/stroke", "pull", "notes[0].stroke: the value is \"pull\"");
  refused("/versions/0/states/0/operatingPoint_mm", 40, "versions[0], state 1: operating point at 40 mm");
  refused("/links/releaseBelowPress_N", -0.1, "links.releaseBelowPress_N: the value is negative");
  refused("/links/oneTravelEnd", "yes", "links.oneTravelEnd: the value is neither true nor false");
  auto document = nlohmann::json::parse(*readTextFile(fixtures + "version-4.button.json"));
  document["versions"].push_back(document["versions"][0]);
  requireRefusal(document.dump(), "versions[1].name: another version has this name");
}

TEST_CASE("graphs at several speeds come back, and only they make a file version 5") {
  const auto file = readWholeButtonFile(fixtures + "version-5.button.json");
  INFO((file.ok() ? "" : file.failure().sentence()));
  REQUIRE(file.ok());
  CHECK(file->button.name() == "fixture of version 5, kept for ever");
  REQUIRE(file->button.states().size() == 2);
  for (const ButtonState& state : file->button.states()) {
    CHECK(state.speed_mm_per_s == 20.0);
    REQUIRE(state.otherSpeeds.size() == 2);
    CHECK(state.otherSpeeds[0].speed_mm_per_s == 5.5);
    CHECK(state.otherSpeeds[1].speed_mm_per_s == 100);
  }
  CHECK(file->button.states()[0].otherSpeeds[1].graph.release()->start_mm() == 2.6);
  CHECK_FALSE(file->button.states()[1].otherSpeeds[1].graph.release().has_value());
  const std::string text = jsonFrom(file->button, file->cutout, file->annotations);
  CHECK(nlohmann::json::parse(text).at("version") == 5);
  const auto again = buttonFileFromJson(text, "again");
  REQUIRE(again.ok());
  CHECK(again->button == file->button);
  CHECK(nlohmann::json::parse(jsonFrom(file->button)).at("version") == 5);

  // A named version may be the only one that has them.
  const auto old = readWholeButtonFile(fixtures + "version-4.button.json");
  Annotations kept = old->annotations;
  CHECK(nlohmann::json::parse(jsonFrom(old->button, {}, kept)).at("version") == 4);
  kept.versions[0].states = file->button.states();
  CHECK(nlohmann::json::parse(jsonFrom(old->button, {}, kept)).at("version") == 5);
}

TEST_CASE("newer versions are refused, wrong ones named") {
  requireRefusal(replaced(fixtureText(), "\"version\": 1", "\"version\": 6"),
                 "version: the file has version 6; this program reads versions up to");
  requireRefusal(replaced(fixtureText(), "\"version\": 1", "\"version\": 18446744073709551615"),
                 "reads versions up to");
  requireRefusal(replaced(fixtureText(), "\"version\": 1", "\"version\": 0"), "versions count from 1");
  requireRefusal(replaced(fixtureText(), "\"version\": 1", "\"version\": \"1\""), "not a whole number");
  requireRefusal(replaced(fixtureText(), "\"version\": 1,", ""), "version: the field is missing");
}

TEST_CASE("migrations run in order from the file's version to the newest") {
  CHECK(buttonMigrations().size() + 1 == static_cast<std::size_t>(buttonFileVersion));
  const std::vector<Migration> steps = {
      [](nlohmann::json& d) { d["log"] = d.value("log", std::string()) + "1to2 "; },
      [](nlohmann::json& d) { d["log"] = d.value("log", std::string()) + "2to3 "; }};
  const auto from = [&](int version) { return migrated({{"version", version}}, steps, "b"); };
  CHECK(from(1).value().at("log") == "1to2 2to3 ");
  CHECK(from(2).value().at("log") == "2to3 ");
  CHECK(from(2).value().at("version") == 3);
  CHECK_FALSE(from(3).value().contains("log"));
  CHECK_FALSE(from(4).ok());
}

TEST_CASE("1,000 knots are read and written") {
  std::vector<CurvePoint> points;
  for (int i = 0; i < 1000; ++i) points.push_back({i * 0.004, 0.5 + 0.3 * std::sin(i * 0.1)});
  const auto graph = ForceGraph::fromCurves(*StrokeCurve::throughPoints(points), {});
  const auto button = Button::fromStates("many", {ButtonState{"", *graph, {}, {}, {}}});
  CHECK(buttonFromJson(jsonFrom(*button), "b").value() == *button);
}
