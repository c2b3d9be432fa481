// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Settings of display and snapping, shared by all parts of a window; not part of any button.

#include <optional>
#include <QObject>

#include "editor/document/display_units.h"

namespace detent::editor {

/// Snap targets of a dragged point. Distances are screen pixels, so they mean the same at every zoom.
struct SnapSettings {
  bool toGrid = false;
  bool toTracedPoints = false;
  bool toOtherStroke = false;
  double gridLength_mm = 0.05;  ///< > 0
  double gridForce_N = 0.01;    ///< > 0
  double within_px = 8;         ///< (0, 64]
  friend bool operator==(const SnapSettings&, const SnapSettings&) = default;
};

enum class Appearance { system, light, dark };

/// Settings of the view; one object per program, stored between runs by the window. GUI thread.
class ViewSettings : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Units of everything shown: those the user has chosen; else those of the page that the shown button was
  /// read from; else mm and cN.
  const DisplayUnits& units() const { return pageUnits_ && !unitsChosen_ ? *pageUnits_ : units_; }
  /// The user chooses units.
  void setUnits(const DisplayUnits& units);
  bool unitsChosen() const { return unitsChosen_; }
  /// Shows each button in the units of its page again.
  void followPages();
  /// Units of the page of the button that is shown now; nullopt if it has none.
  void setPageUnits(const std::optional<DisplayUnits>& units);
  const SnapSettings& snap() const { return snap_; }
  void setSnap(const SnapSettings& snap);
  /// 0 hides the datasheet page.
  double underlayOpacity() const { return underlayOpacity_; }
  void setUnderlayOpacity(double opacity);  ///< 0..1
  bool residualsShown() const { return residualsShown_; }
  void setResidualsShown(bool shown);
  Appearance appearance() const { return appearance_; }
  void setAppearance(Appearance appearance);

 signals:
  void changed();

 private:
  template <class Change>
  void changeUnits(const Change& change);

  DisplayUnits units_;
  SnapSettings snap_;
  double underlayOpacity_ = 0.5;
  bool residualsShown_ = false;
  Appearance appearance_ = Appearance::system;
  std::optional<DisplayUnits> pageUnits_;
  bool unitsChosen_ = false;
};

}  // namespace detent::editor
