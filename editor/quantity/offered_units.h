// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The units that combo boxes offer, in their order.

#include <array>
#include <QString>
#include <string_view>

#include "model/units.h"

namespace detent::editor {

inline constexpr std::array offeredLengthUnits{LengthUnit::millimetre, LengthUnit::centimetre,
                                               LengthUnit::micrometre, LengthUnit::inch, LengthUnit::mil};
inline constexpr std::array offeredForceUnits{
    ForceUnit::newton,        ForceUnit::centinewton, ForceUnit::millinewton, ForceUnit::gramForce,
    ForceUnit::kilogramForce, ForceUnit::ounceForce,  ForceUnit::poundForce};

/// A unit's symbol as Qt shows it.
inline QString unitText(std::string_view symbol) {
  return QString::fromUtf8(symbol.data(), static_cast<qsizetype>(symbol.size()));
}

}  // namespace detent::editor
