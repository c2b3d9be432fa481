// SPDX-License-Identifier: GPL-3.0-or-later
// The writer's files obey button.schema.json: a checker of just the keywords that schema uses.
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "model/file/button_file.h"
#include "model/templates.h"

using namespace detent;
using nlohmann::json;

namespace {

json readJson(const std::string& path) {
  std::ifstream file(std::string(DETENT_SOURCE_DIR) + "/" + path);
  REQUIRE(file.good());
  return json::parse(file);
}

class SchemaChecker {
 public:
  explicit SchemaChecker(json schema) : root_(std::move(schema)) {}

  /// All violations, each with its place.
  std::vector<std::string> check(const json& value) {
    faults_.clear();
    check(value, root_, "");
    return faults_;
  }

 private:
  void fault(const std::string& place, const std::string& what) { faults_.push_back(place + ": " + what); }

  static bool hasType(const json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "integer") return value.is_number_integer();
    return type == "number" && value.is_number();
  }

  void check(const json& value, const json& schema, const std::string& place) {
    static const std::set<std::string> known = {"$schema",
                                                "title",
                                                "description",
                                                "$defs",
                                                "$ref",
                                                "type",
                                                "const",
                                                "enum",
                                                "required",
                                                "properties",
                                                "patternProperties",
                                                "additionalProperties",
                                                "items",
                                                "minItems",
                                                "maxItems",
                                                "minimum",
                                                "maximum"};
    for (const auto& [keyword, unused] : schema.items())
      if (!known.count(keyword))
        fault(place, "schema keyword \"" + keyword + "\" is not understood by this test");
    if (schema.contains("$ref")) {
      const std::string reference = schema["$ref"];
      check(value, root_.at(json::json_pointer(reference.substr(1))), place);
    }
    if (schema.contains("type") && !hasType(value, schema["type"])) return fault(place, "has the wrong type");
    if (schema.contains("const") && value != schema["const"]) fault(place, "is not the constant");
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
      fault(place, "is none of the words");
    if (schema.contains("minimum") && value.get<double>() < schema["minimum"]) fault(place, "is too small");
    if (schema.contains("maximum") && value.get<double>() > schema["maximum"]) fault(place, "is too large");
    if (value.is_object()) checkObject(value, schema, place);
    if (value.is_array()) checkArray(value, schema, place);
  }

  void checkObject(const json& value, const json& schema, const std::string& place) {
    if (schema.contains("required"))
      for (const auto& key : schema["required"])
        if (!value.contains(key)) fault(place, "lacks " + key.dump());
    for (const auto& [key, element] : value.items()) {
      const std::string at = place + "/" + key;
      if (schema.contains("properties") && schema["properties"].contains(key)) {
        check(element, schema["properties"][key], at);
        continue;
      }
      bool matched = false;
      if (schema.contains("patternProperties"))
        for (const auto& [pattern, sub] : schema["patternProperties"].items())
          if (std::regex_search(key, std::regex(pattern))) {
            matched = true;
            check(element, sub, at);
          }
      if (!matched && schema.value("additionalProperties", true) == false) fault(at, "is not allowed");
    }
  }

  void checkArray(const json& value, const json& schema, const std::string& place) {
    if (schema.contains("minItems") && value.size() < schema["minItems"]) fault(place, "has too few items");
    if (schema.contains("maxItems") && value.size() > schema["maxItems"]) fault(place, "has too many items");
    if (schema.contains("items"))
      for (std::size_t i = 0; i < value.size(); ++i)
        check(value[i], schema["items"], place + "/" + std::to_string(i));
  }

  json root_;
  std::vector<std::string> faults_;
};

}  // namespace

TEST_CASE("what the writer writes obeys the schema, and so does the fixture") {
  SchemaChecker checker(readJson("model/file/button.schema.json"));
  for (const char* version : {"1", "2", "3", "4", "5"}) {
    const json fixture =
        readJson(std::string("tests/model/file/fixtures/version-") + version + ".button.json");
    CHECK(checker.check(fixture) == std::vector<std::string>{});
    const auto file = buttonFileFromJson(fixture.dump(), "fixture");
    REQUIRE(file.ok());
    CHECK(checker.check(json::parse(jsonFrom(file->button, file->cutout, file->annotations))) ==
          std::vector<std::string>{});
  }
  for (const auto& made : {linearButton(), tactileButton(), selfLockingButton()})
    CHECK(checker.check(json::parse(jsonFrom(*made))) == std::vector<std::string>{});
}

TEST_CASE("the schema names every key the writer writes: reader and schema refuse the same faults") {
  SchemaChecker checker(readJson("model/file/button.schema.json"));
  const json good = readJson("tests/model/file/fixtures/version-5.button.json");
  const std::vector<std::string> pointers = {"/format",
                                             "/version",
                                             "/states",
                                             "/states/0/press",
                                             "/states/0/press/1/force_N",
                                             "/states/0/press/1/slopeAfter_N_per_mm",
                                             "/states/0/damping/1/damping_Ns_per_mm",
                                             "/states/0/otherSpeeds/1/speed_mm_per_s",
                                             "/states/0/otherSpeeds/1/press",
                                             "/states/1/otherSpeeds/0/press/0/force_N",
                                             "/provenance/xAxis/min",
                                             "/provenance/yAxis/max",
                                             "/cutout/png",
                                             "/cutout/pixelToAxes",
                                             "/notes/0/displacement_mm",
                                             "/notes/1/text",
                                             "/versions/0/name",
                                             "/versions/0/states",
                                             "/links/pinned/0/displacement_mm"};
  for (const std::string& text : pointers) {
    const json::json_pointer pointer(text);
    INFO(text);
    json missing = good;
    missing[pointer.parent_pointer()].erase(pointer.back());
    CHECK_FALSE(checker.check(missing).empty());
    CHECK_FALSE(buttonFromJson(missing.dump(), "b").ok());
    json wrong = good;
    wrong[pointer] = true;
    CHECK_FALSE(checker.check(wrong).empty());
    CHECK_FALSE(buttonFromJson(wrong.dump(), "b").ok());
    json unknown = good;
    unknown[pointer.parent_pointer()] = good[pointer.parent_pointer()];
    if (!unknown[pointer.parent_pointer()].is_object()) continue;
    unknown[pointer.parent_pointer()]["misspelt"] = 1;
    CHECK_FALSE(checker.check(unknown).empty());
    CHECK_FALSE(buttonFromJson(unknown.dump(), "b").ok());
  }
}
