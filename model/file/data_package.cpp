// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/data_package.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "model/csv_field.h"
#include "model/file/curve_csv.h"
#include "model/file/json_text.h"
#include "model/file/staged_text.h"
#include "model/key_figures.h"
#include "model/number_table.h"
#include "model/sha256.h"
#include "model/version.h"

namespace detent {

namespace {

using Json = nlohmann::ordered_json;

Json field(const char* name, const char* type, const char* description, const char* unit = nullptr) {
  Json is = {{"name", name}, {"type", type}, {"description", description}};
  if (unit) is["unit"] = unit;
  return is;
}

Json curveFields() {
  Json stroke = field("stroke", "string", "press: on the way down; release: on the way up");
  stroke["constraints"] = {{"required", true}, {"enum", {"press", "release"}}};
  return {stroke, field("displacement_mm", "number", "Travel from rest, in the order travelled", "mm"),
          field("force_N", "number", "Force of the button against the finger", "N")};
}

Json figureFields() {
  return {field("state", "string", "State of a self-locking button; empty: the only one"),
          field("figure", "string", "Key figure; the end of its name is its unit, a share has none"),
          field("value", "number", "Value in that unit")};
}

Json resource(const std::string& name, const std::string& title, const PackageTable& table, Json fields) {
  return {{"name", name},
          {"title", title},
          {"path", table.file},
          {"profile", "tabular-data-resource"},
          {"format", "csv"},
          {"mediatype", "text/csv"},
          {"encoding", "utf-8"},
          {"bytes", table.csv.size()},
          {"hash", "sha256:" + sha256Hex(table.csv)},
          {"schema", {{"fields", std::move(fields)}, {"missingValues", {""}}}}};
}

std::string figuresCsv(const Button& button) {
  std::string csv = "state,figure,value\n";
  for (const ButtonState& state : button.states()) {
    const KeyFigures figures = keyFiguresOf(state);
    for (const KeyFigureName& name : keyFigureNames())
      if (const auto& value = figures[name.figure])
        csv += csvField(state.name) + ',' + std::string(name.key) + ',' + shortestText(*value) + '\n';
  }
  return csv;
}

/// Returns a valid package name: lower-case Latin letters, digits, '-', '_', '.'.
std::string packageName(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const char small = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool stays = (small >= 'a' && small <= 'z') || (small >= '0' && small <= '9') || small == '.';
    if (stays)
      name += small;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "button" : name;
}

Json sourcesOf(const Button& button) {
  const auto& from = button.provenance();
  if (!from || from->sourceFile.empty()) return Json::array();
  Json source = {{"title", from->sourceFile}};
  if (!from->sourceSha256.empty()) source["hash"] = "sha256:" + from->sourceSha256;
  source["page"] = from->page;
  return Json::array({source});
}

}  // namespace

DataPackage dataPackageFrom(const Button& button) {
  DataPackage package;
  Json resources = Json::array();
  for (std::size_t i = 0; i < button.states().size(); ++i) {
    const ButtonState& state = button.states()[i];
    const std::string name = button.selfLocking() ? "curve-" + std::to_string(i + 1) : "curve";
    package.tables.push_back({name + ".csv", csvFrom(state.graph)});
    const std::string title = "Force over displacement" + (state.name.empty() ? "" : ", " + state.name);
    resources.push_back(resource(name, title, package.tables.back(), curveFields()));
  }
  package.tables.push_back({"figures.csv", figuresCsv(button)});
  resources.push_back(resource("figures", "Key figures", package.tables.back(), figureFields()));
  Json description = {
      {"profile", "tabular-data-package"},
      {"name", packageName(button.name())},
      {"title", button.name().empty() ? "Button" : button.name()},
      {"description", "Force graph of a push button, written by Detent " + std::string(version())},
      {"resources", std::move(resources)}};
  if (Json sources = sourcesOf(button); !sources.empty()) description["sources"] = std::move(sources);
  package.description = jsonText(description, 2) + '\n';
  return package;
}

Result<Done> writeDataPackage(const Button& button, const std::string& description) {
  const DataPackage package = dataPackageFrom(button);
  std::vector<NamedText> files;
  for (const PackageTable& table : package.tables)
    files.push_back({(std::filesystem::path(description).parent_path() / table.file).string(), table.csv});
  files.push_back({description, package.description});
  return writeTextFilesAtomically(files);
}

}  // namespace detent
