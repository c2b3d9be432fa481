// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/view_settings.h"

#include "model/check.h"

namespace detent::editor {

void ViewSettings::setUnits(const DisplayUnits& units) {
  if (units == units_) return;
  units_ = units;
  emit changed();
}

void ViewSettings::setSnap(const SnapSettings& snap) {
  DETENT_CHECK(snap.gridLength_mm > 0 && snap.gridForce_N > 0 && snap.within_px > 0,
               "a snap grid has steps above 0");
  if (snap == snap_) return;
  snap_ = snap;
  emit changed();
}

void ViewSettings::setUnderlayOpacity(double opacity) {
  DETENT_CHECK(opacity >= 0 && opacity <= 1, "an opacity is a share");
  if (opacity == underlayOpacity_) return;
  underlayOpacity_ = opacity;
  emit changed();
}

void ViewSettings::setResidualsShown(bool shown) {
  if (shown == residualsShown_) return;
  residualsShown_ = shown;
  emit changed();
}

void ViewSettings::setAppearance(Appearance appearance) {
  if (appearance == appearance_) return;
  appearance_ = appearance;
  emit changed();
}

}  // namespace detent::editor
