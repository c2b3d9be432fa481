// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/stored_view.h"

#include <cmath>
#include <optional>

namespace detent::editor {
namespace {

/// Units that the user had chosen; nullopt: none.
std::optional<DisplayUnits> storedUnits(const QSettings& settings) {
  const auto length = lengthUnitFrom(settings.value("view/lengthUnit").toString().toStdString());
  const auto force = forceUnitFrom(settings.value("view/forceUnit").toString().toStdString());
  if (!length && !force) return {};
  const DisplayUnits usual;
  return DisplayUnits{length.value_or(usual.length), force.value_or(usual.force)};
}

// `fallback` unless the stored number is finite and within the range.
double number(const QSettings& settings, const char* key, double fallback, double from, double to) {
  bool isNumber = false;
  const double value = settings.value(QLatin1String(key)).toDouble(&isNumber);
  return isNumber && value >= from && value <= to ? value : fallback;
}

Appearance storedAppearance(const QSettings& settings) {
  const QString name = settings.value("view/appearance").toString();
  return name == "light" ? Appearance::light : name == "dark" ? Appearance::dark : Appearance::system;
}

}  // namespace

void restoreView(ViewSettings& view, const QSettings& settings) {
  if (const auto units = storedUnits(settings)) view.setUnits(*units);
  SnapSettings snap;
  snap.toGrid = settings.value("snap/toGrid", snap.toGrid).toBool();
  snap.toTracedPoints = settings.value("snap/toTracedPoints", snap.toTracedPoints).toBool();
  snap.toOtherStroke = settings.value("snap/toOtherStroke", snap.toOtherStroke).toBool();
  snap.gridLength_mm = number(settings, "snap/gridLength_mm", snap.gridLength_mm, 1e-6, 1e3);
  snap.gridForce_N = number(settings, "snap/gridForce_N", snap.gridForce_N, 1e-6, 1e3);
  snap.within_px = number(settings, "snap/within_px", snap.within_px, 1, 64);
  view.setSnap(snap);
  view.setUnderlayOpacity(number(settings, "view/underlayOpacity", view.underlayOpacity(), 0, 1));
  view.setResidualsShown(settings.value("view/residuals", view.residualsShown()).toBool());
  view.setAppearance(storedAppearance(settings));
}

void storeView(const ViewSettings& view, QSettings& settings) {
  const bool chosen = view.unitsChosen();
  settings.setValue("view/lengthUnit", chosen ? view.units().lengthSymbol() : QString());
  settings.setValue("view/forceUnit", chosen ? view.units().forceSymbol() : QString());
  const SnapSettings& snap = view.snap();
  settings.setValue("snap/toGrid", snap.toGrid);
  settings.setValue("snap/toTracedPoints", snap.toTracedPoints);
  settings.setValue("snap/toOtherStroke", snap.toOtherStroke);
  settings.setValue("snap/gridLength_mm", snap.gridLength_mm);
  settings.setValue("snap/gridForce_N", snap.gridForce_N);
  settings.setValue("snap/within_px", snap.within_px);
  settings.setValue("view/underlayOpacity", view.underlayOpacity());
  settings.setValue("view/residuals", view.residualsShown());
  settings.setValue("view/appearance", view.appearance() == Appearance::light  ? "light"
                                       : view.appearance() == Appearance::dark ? "dark"
                                                                               : "system");
}

}  // namespace detent::editor
