// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The only place that converts units of force and length. Internally: newton and millimetre, as double.

#include <optional>
#include <string_view>

namespace detent {

enum class ForceUnit {
  newton,
  millinewton,
  centinewton,
  gramForce,
  kilogramForce,
  ounceForce,
  poundForce,
  decinewton,
  kilonewton,
  dyne,
  micronewton,
  meganewton
};
enum class LengthUnit { millimetre, centimetre, micrometre, inch, mil, metre, nanometre };

/// Newtons in one unit (exact where the definition is: 1 gf = 0.00980665 N, 1 lbf = 4.4482216152605 N).
double newtonsPer(ForceUnit unit);
/// Millimetres in one unit (1 in = 25.4 mm).
double millimetresPer(LengthUnit unit);

/// "cN", "gf", "mm", "µm" ...: the printed symbol.
std::string_view symbolOf(ForceUnit unit);
std::string_view symbolOf(LengthUnit unit);

/// Parses a printed or typed symbol or word, Latin, Cyrillic or CJK: "gf", "g", "gram", "cN", "mN", "N",
/// "ozf", "oz", "lbf", "kgf", "гс", "牛"...; case matters only where needed ("mN" and "MN", "m" and "M").
/// nullopt for an unknown unit.
std::optional<ForceUnit> forceUnitFrom(std::string_view text);
std::optional<LengthUnit> lengthUnitFrom(std::string_view text);

}  // namespace detent
