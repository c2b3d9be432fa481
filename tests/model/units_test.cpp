// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/units.h"

#include <catch2/catch.hpp>

using namespace detent;

TEST_CASE("units are exact where their definition is") {
  CHECK(newtonsPer(ForceUnit::gramForce) == 0.00980665);
  CHECK(newtonsPer(ForceUnit::poundForce) == 4.4482216152605);
  CHECK(newtonsPer(ForceUnit::ounceForce) * 16 == newtonsPer(ForceUnit::poundForce));
  CHECK(millimetresPer(LengthUnit::inch) == 25.4);
  CHECK(millimetresPer(LengthUnit::mil) == Approx(0.0254).epsilon(1e-15));
}

TEST_CASE("every printed symbol reads back as its unit") {
  for (ForceUnit unit :
       {ForceUnit::newton, ForceUnit::millinewton, ForceUnit::centinewton, ForceUnit::gramForce,
        ForceUnit::kilogramForce, ForceUnit::ounceForce, ForceUnit::poundForce, ForceUnit::decinewton,
        ForceUnit::kilonewton, ForceUnit::dyne, ForceUnit::micronewton, ForceUnit::meganewton})
    CHECK(forceUnitFrom(symbolOf(unit)) == unit);
  for (LengthUnit unit : {LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::micrometre,
                          LengthUnit::inch, LengthUnit::mil, LengthUnit::metre, LengthUnit::nanometre})
    CHECK(lengthUnitFrom(symbolOf(unit)) == unit);
}

TEST_CASE("units are read as datasheets print them") {
  CHECK(forceUnitFrom(" g ") == ForceUnit::gramForce);
  CHECK(forceUnitFrom("Grams") == ForceUnit::gramForce);
  CHECK(forceUnitFrom("OZ") == ForceUnit::ounceForce);
  CHECK(forceUnitFrom("CN") == ForceUnit::centinewton);
  CHECK(lengthUnitFrom("MM") == LengthUnit::millimetre);
  CHECK(lengthUnitFrom("\xCE\xBCm") == LengthUnit::micrometre);
}

TEST_CASE("mega is not milli, and nonsense is no unit") {
  CHECK(forceUnitFrom("mN") == ForceUnit::millinewton);
  CHECK(forceUnitFrom("MN") == ForceUnit::meganewton);
  CHECK_FALSE(forceUnitFrom("Mn").has_value());
  CHECK(lengthUnitFrom("m") == LengthUnit::metre);
  CHECK_FALSE(lengthUnitFrom("M").has_value());
  for (const char* text : {"", "  ", "furlong", "Nm", "N/mm"}) {
    CHECK_FALSE(forceUnitFrom(text).has_value());
    CHECK_FALSE(lengthUnitFrom(text).has_value());
  }
}
