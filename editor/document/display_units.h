// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Units for reading and typing; internally everything is mm and N.

#include <QString>

#include "model/units.h"

namespace detent::editor {

/// Chosen units of axes, tables and status bar. Plain value.
struct DisplayUnits {
  LengthUnit length = LengthUnit::millimetre;
  ForceUnit force = ForceUnit::centinewton;

  double lengthFrom(double mm) const { return mm / millimetresPer(length); }
  double forceFrom(double N) const { return N / newtonsPer(force); }
  double toMm(double shown) const { return shown * millimetresPer(length); }
  double toN(double shown) const { return shown * newtonsPer(force); }
  /// Slopes are shown as force unit per length unit.
  double slopeFrom(double N_per_mm) const { return N_per_mm * millimetresPer(length) / newtonsPer(force); }
  double toSlope(double shown) const { return shown * newtonsPer(force) / millimetresPer(length); }

  QString lengthSymbol() const;
  QString forceSymbol() const;
  QString slopeSymbol() const { return forceSymbol() + "/" + lengthSymbol(); }

  friend bool operator==(const DisplayUnits&, const DisplayUnits&) = default;
};

/// The units of all files.
inline constexpr DisplayUnits modelUnits{LengthUnit::millimetre, ForceUnit::newton};

}  // namespace detent::editor
