// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/switch_spread.h"

#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace detent::importer {
namespace {

double meanValue(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> sdOf(const std::vector<double>& values) {
  if (values.size() < 2) return {};
  const double mean = meanValue(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace

SwitchSpread spreadOf(const std::vector<UnitRecord>& records) {
  std::map<std::string, std::vector<const KeyFigures*>> units;
  for (const UnitRecord& record : records) units[record.unit].push_back(&record.figures);
  SwitchSpread spread;
  spread.records = records.size();
  spread.units = units.size();
  for (const KeyFigureName& name : keyFigureNames()) {
    std::vector<double> means, single;
    for (const auto& [unit, all] : units) {
      std::vector<double> values;
      for (const KeyFigures* figures : all)
        if (const auto& value = (*figures)[name.figure]) values.push_back(*value);
      if (!values.empty()) means.push_back(meanValue(values));
      single = std::move(values);
    }
    spread.sd[name.figure] = sdOf(units.size() > 1 ? means : single);
  }
  return spread;
}

}  // namespace detent::importer
