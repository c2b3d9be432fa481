// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Values that the page prints in words: "Pressure point force 55 ± 25 cN", "Pretravel 2 ± 0.6 mm", "总行程
// 4.0±0.4 mm". Read from the document's own text, then compared with the imported graph.

#include <optional>
#include <string>
#include <vector>

#include "importer/page/page.h"
#include "model/button.h"

namespace detent::importer {

enum class SpecQuantity { totalTravel, preTravel, operatingForce, tactileForce, endForce };

/// One printed value with its tolerance, in mm or N. "min." leaves `largest` open, "max." `smallest`.
struct PrintedSpec {
  SpecQuantity quantity = SpecQuantity::totalTravel;
  double nominal = 0;
  std::optional<double> smallest, largest;
  std::string text;  ///< the row as printed
  int page = 1;
  bool isForce() const;  ///< in N; else in mm
};

/// A printed value beside the one that was read from the graph.
struct SpecCheck {
  PrintedSpec spec;
  double read = 0;      ///< mm or N
  bool agrees = false;  ///< inside the tolerance, or within 3 % of the nominal where none is printed
};

/// "total travel differs from the page: 3.9 mm read, 4 mm printed (page 1: "...")".
Message messageOf(const SpecCheck& check);

/// All specs of a page; rows are put together from text boxes at one height. Values without a unit are left
/// out. A row with a value for each variant of the product gives one spec for each.
std::vector<PrintedSpec> readPrintedSpecs(const Page& page);

/// Compares the specs with the button. If a row has values for several variants, the nearest one counts.
/// Specs of quantities that the button does not have (no operating point known) give no check.
std::vector<SpecCheck> checkAgainst(const std::vector<PrintedSpec>& specs, const Button& button);

}  // namespace detent::importer
