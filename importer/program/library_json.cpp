// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/library_json.h"

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/units.h"

namespace detent::importer {
namespace {

using Json = nlohmann::ordered_json;

void addFigures(Json& json, const std::string& before, const KeyFigures& figures) {
  for (const KeyFigureName& name : keyFigureNames()) {
    const auto& value = figures[name.figure];
    json[before + std::string(name.key)] = value ? Json(*value) : Json(nullptr);
  }
}

Json switchJson(const FoundSwitch& each) {
  const LibrarySwitch& entry = each.entry;
  Json json = {{"name", entry.name},
               {"source", entry.source},
               {"part", entry.part},
               {"licence", entry.licence},
               {"credit", entry.credit},
               {"unit", entry.unit},
               {"run", entry.run},
               {"units", each.spread.units},
               {"records", each.spread.records},
               {"kind", nameOf(kindOf(entry.figures))},
               {"scale_doubtful", entry.scaleDoubtful},
               {"distance_lab_noise", nullptr},
               {"group", nullptr}};
  if (each.distance_labNoise) {
    json["distance_lab_noise"] = *each.distance_labNoise;
    json["group"] = groupOf(*each.distance_labNoise);
  }
  addFigures(json, "", entry.figures);
  addFigures(json, "sigma_", entry.sigmas);
  addFigures(json, "spread_", each.spread.sd);
  json["ratings"] = Json::array();
  for (const Rating& rating : each.ratings) {
    Json scores = Json::object();
    for (const auto& [what, score] : rating.scores) scores[what] = score;
    json["ratings"].push_back({{"name", rating.name},
                               {"credit", rating.credit},
                               {"licence", rating.licence},
                               {"source", rating.source},
                               {"scores", std::move(scores)}});
  }
  json["sha256"] = entry.sha256;
  json["version"] = entry.version;
  return json;
}

Json nearestJson(const std::vector<NearMiss>& nearest) {
  Json list = Json::array();
  for (const auto& [entry, miss] : nearest)
    list.push_back({{"name", entry.name},
                    {"source", entry.source},
                    {"part", entry.part},
                    {"licence", entry.licence},
                    {"credit", entry.credit},
                    {"miss_lab_noise", miss}});
  return list;
}

}  // namespace

std::string foundJson(const FoundSwitches& result) {
  Json found = Json::array();
  for (const FoundSwitch& each : result.found) found.push_back(switchJson(each));
  return jsonText(Json{{"found", std::move(found)},
                       {"nearest", nearestJson(result.nearest)},
                       {"fitting", result.fitting},
                       {"lab_noise_N", labNoise_gf * newtonsPer(ForceUnit::gramForce)}});
}

}  // namespace detent::importer
