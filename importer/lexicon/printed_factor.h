// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A factor that a title prints beside its unit, by which the tick labels are to be multiplied.

#include <optional>
#include <string>
#include <string_view>

namespace detent::importer {

struct PrintedFactor {
  double factor = 1;
  std::string title;  ///< the title without the factor: "Load [gf]"
};

/// A power of ten other than 1 behind a sign of multiplication ("Load [x10 gf]", "Force ×10³ (N)",
/// "(kgf · 100)"), or in front of the unit where only units stand ("Force in 0.1 N", "F / 10 mN",
/// "[10^-3 N]"). nullopt without one, and in a text that is nothing else: "Force (60 gf)" prints none, and in
/// "speed (10 mm/min)" no unit follows.
std::optional<PrintedFactor> printedFactorIn(std::string_view title);

}  // namespace detent::importer
