// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/display_units.h"

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::editor;

TEST_CASE("What is shown and typed in a person's units comes back as mm and N") {
  for (const auto length : {LengthUnit::millimetre, LengthUnit::inch, LengthUnit::micrometre}) {
    for (const auto force :
         {ForceUnit::newton, ForceUnit::centinewton, ForceUnit::gramForce, ForceUnit::poundForce}) {
      const DisplayUnits units{length, force};
      CHECK(units.toMm(units.lengthFrom(1.25)) == Approx(1.25));
      CHECK(units.toN(units.forceFrom(0.55)) == Approx(0.55));
      CHECK(units.toSlope(units.slopeFrom(0.3)) == Approx(0.3));
      // A slope is a force over a length, in whatever units.
      CHECK(units.slopeFrom(0.3) == Approx(units.forceFrom(0.3) / units.lengthFrom(1)));
    }
  }
  const DisplayUnits usual;
  CHECK(usual.forceFrom(0.55) == Approx(55));
  CHECK(usual.slopeSymbol() == "cN/mm");
}
