// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reports of detent-graph, as text and as one JSON object.

#include <string>
#include <vector>

#include "model/button.h"
#include "model/compare.h"
#include "model/unit_spread.h"
#include "model/validation.h"

namespace detent {

/// One report in two forms: text ends in a newline, json is one object on one line with a newline.
struct Report {
  std::string text;
  std::string json;
};

Report showReport(const Button& button, const std::string& path);
Report checkReport(const Button& button, const std::vector<Warning>& warnings, const std::string& path);
Report convertReport(const Button& button, const std::string& inPath, const std::string& outPath,
                     const char* command = "convert");
Report compareReport(const GraphDistance& distance, const std::string& first, const std::string& second);
/// Report on units (their files, in order) that became the button `out`.
Report averageReport(const UnitSpread& spread, const std::vector<std::string>& units, const std::string& out);
Report failureReport(const Failure& failure);

}  // namespace detent
