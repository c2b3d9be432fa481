// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/view_settings.h"

#include "model/check.h"

namespace detent::editor {

template <class Change>
void ViewSettings::changeUnits(const Change& change) {
  const DisplayUnits before = units();
  const bool chosenBefore = unitsChosen_;
  change();
  if (units() != before || unitsChosen_ != chosenBefore) emit changed();
}

void ViewSettings::setUnits(const DisplayUnits& units) {
  changeUnits([&] {
    units_ = units;
    unitsChosen_ = true;
  });
}

void ViewSettings::followPages() {
  changeUnits([&] {
    units_ = {};
    unitsChosen_ = false;
  });
}

void ViewSettings::setPageUnits(const std::optional<DisplayUnits>& units) {
  changeUnits([&] { pageUnits_ = units; });
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
