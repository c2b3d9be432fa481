// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/evidence/evidence.h"

#include <cmath>
#include <cstdio>

namespace detent::importer {

double confidenceOfMargins(const std::vector<double>& margins) {
  double odds = 0;
  for (const double margin : margins) odds += std::exp(-margin);
  return 1 / (1 + odds);
}

std::string explanationTable(const std::vector<ExplainedInterpretation>& best) {
  std::string table;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const ExplainedInterpretation& each = best[i];
    char line[64];
    std::snprintf(line, sizeof line, "%zu. %+7.2f  ", i + 1, each.evidence.total());
    table += line + each.reading + "\n";
    for (const EvidenceTerm& term : each.evidence.terms()) {
      std::snprintf(line, sizeof line, "   %+7.2f  %-14s ", term.logLikelihood, term.name.c_str());
      table += line + term.about + "\n";
    }
  }
  return table;
}

}  // namespace detent::importer
