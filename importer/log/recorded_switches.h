// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measurements that are kept as what they are: strokes already told apart, contact points beside them, several switches in a file.
// OpenDocument spreadsheets of the Open-Switch curve meter in both layouts (headings in one line or in two), JSON of Geekboards'
// force tester.

#include <optional>
#include <string>
#include <vector>

#include "model/result.h"
#include "model/stroke_curve.h"
#include "model/units.h"

namespace detent::importer {

/// One switch of a file, in the units of the file. CurvePoint's fields stand for these, not for mm and N.
struct RecordedSwitch {
  std::string name;                        ///< as the file calls it; empty where it does not
  std::vector<CurvePoint> press, release;  ///< each as written; release may be empty
  std::vector<CurvePoint> run;  ///< instead of both, where the file keeps the way down and up as one
  std::optional<double> operatingPoint, resetPoint;
  LengthUnit xUnit = LengthUnit::millimetre;
  ForceUnit yUnit = ForceUnit::gramForce;
  bool scaleDoubtful = false;  ///< forces of this kind of file lie well off other laboratories'
};

/// Whether a path ends like a file that this reads: .ods, .json.
bool holdsRecordedSwitches(const std::string& path);

/// In the order of the file, at least one. Failure unreadableInput: missing, damaged, more than 32 MB (unpacked: 64 MB);
/// noForceGraph: no strokes in it. Any thread.
Result<std::vector<RecordedSwitch>> recordedSwitches(const std::string& path);

}  // namespace detent::importer
