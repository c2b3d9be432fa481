// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Units as titles and labels print them, in the languages of datasheets.

#include <optional>
#include <string>
#include <string_view>

#include "importer/lexicon/lexicon.h"
#include "model/units.h"

namespace detent::importer {

/// A unit seen in a title. `sure` 0..1: brackets around it, or a word for the quantity beside it, make surer.
template <class Unit>
struct PrintedUnit {
  Unit unit{};
  double sure = 0;
};

/// The unit of force in a title: "Force [cN]", "Kraft / cN", "Kraft in cN", "F (gf)", "力(gf)". If a title has
/// brackets, the whole text in them must be the unit: "[dN]", "(x10 gf)" and "(N/mm)" do not contain N, gf or
/// mm. A unit beside a word or letter of another quantity does not count: "Inductance [H]" and "U [N]" name
/// no force. In exact text no unit counts beside a word that the lexicon does not know. Misread letters are
/// considered only in recognised text.
std::optional<PrintedUnit<ForceUnit>> forceUnitIn(std::string_view title,
                                                  TextSource source = TextSource::recognised);
std::optional<PrintedUnit<LengthUnit>> lengthUnitIn(std::string_view title,
                                                    TextSource source = TextSource::recognised);

/// The units that a page's heading names for both axes.
struct HeadingUnits {
  ForceUnit force{};
  LengthUnit length{};
};

/// The units of a heading that names exactly one unit of force and one of length, in brackets or behind
/// "in": "Key force vs travel (cN, mm)", "Force in gf against travel in mm". "(N/mm)" counts as two units
/// only in a heading that names both quantities, and otherwise as a stiffness.
std::optional<HeadingUnits> headingUnitsIn(std::string_view heading,
                                           TextSource source = TextSource::recognised);

/// Quantity of a title that is neither a force nor a travel: "pressure (kPa)", "N/mm", "x10 gf",
/// "temperature". Empty if the title names a force or a travel, or no quantity.
std::string otherQuantityIn(std::string_view title, TextSource source = TextSource::recognised);

}  // namespace detent::importer
