// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A factor that a title prints beside its unit, by which the tick labels are to be multiplied.

#include <optional>
#include <string>
#include <string_view>

namespace detent::importer {

struct PrintedFactor {
  std::optional<double> factor;  ///< nullopt: one is printed, but what it is cannot be read
  std::string title;             ///< the title without the factor: "Load [gf]"
};

/// A power of ten other than 1 behind a sign of multiplication ("Load [x10 gf]", "Force ×10³ (N)",
/// "(kgf · 100)"), in front of the unit where only units stand ("Force in 0.1 N", "F / 10 mN", "[10^-3 N]"),
/// or between the name of the quantity and its unit ("Force, 10 mN", and "Key force - 10 (cN)", as recognisers
/// read a dot). nullopt without one, and in a text that is nothing else: "Force (60 gf)" prints none, and in
/// "speed (10 mm/min)" no unit follows. A ten behind a sign with something else directly behind it is a factor
/// with an exponent that was misread: "x10?mN", "x107!N".
std::optional<PrintedFactor> printedFactorIn(std::string_view title);

}  // namespace detent::importer
