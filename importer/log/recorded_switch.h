// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A measurement whose file tells its strokes apart.

#include <optional>
#include <string>
#include <vector>

#include "model/stroke_curve.h"
#include "model/units.h"

namespace detent::importer {

/// One switch of a file, in the units of the file. CurvePoint's fields stand for these, not for mm and N.
struct RecordedSwitch {
  std::string name;                        ///< as the file calls it; empty where it does not
  std::vector<CurvePoint> press, release;  ///< each as written; release may be empty
  std::vector<CurvePoint> run;  ///< instead of both, where the file keeps the way down and up as one
  std::optional<double> operatingPoint, resetPoint;
  std::optional<LengthUnit> xUnit = LengthUnit::millimetre;  ///< nullopt: the file does not say
  std::optional<ForceUnit> yUnit = ForceUnit::gramForce;
  bool scaleDoubtful = false;  ///< forces of this kind of file lie well off other laboratories'
};

}  // namespace detent::importer
