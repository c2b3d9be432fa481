// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sections and tactile points of a stroke, derived from its curve; never stored beside it.
// Kim & Lee 2013, "Modeling a button with a force graph" and Figure 2.

#include <vector>

#include "model/stroke_curve.h"

namespace detent {

enum class SectionKind {
  slope,  ///< displacement follows force continuously
  jump,   ///< from a tactile point to where the force regains it (press), or falls below it again (release)
  bottomOut  ///< the wall at the end of the travel
};

/// Press: a local maximum of the press curve. Release: a local minimum of the release curve (Kim & Lee,
/// "Tactile point").
struct TactilePoint {
  double displacement_mm = 0;
  double force_N = 0;
  double prominence_N =
      0;  ///< how far the force turns back, on the shallower side, before it is passed again
};

/// One stretch of a stroke, in the order travelled (release: from_mm > to_mm).
struct Section {
  SectionKind kind = SectionKind::slope;
  double from_mm = 0, to_mm = 0;
  double fromForce_N = 0, toForce_N = 0;
};

/// What counts as a tactile point and as a bottom-out. Defaults hold for keyboards and tact switches alike.
struct SectionSettings {
  double minProminence_N = 0;  ///< absolute bar; >= 0
  double minProminenceOfSpan =
      0.03;  ///< bar as a share of the stroke's force range below the bottom-out; in [0, 1)
  double bottomOutSlopeRatio =
      8;  ///< the last stretch is a wall if steeper than this × the stroke's mean slope; > 1
};

/// Where the bottom-out begins.
struct BottomOut {
  double displacement_mm = 0;  ///< foot of the wall; the end of the travel where the curve has no wall
  double force_N = 0;          ///< force there
  bool wall = false;  ///< the curve itself rises like a wall (CHERRY's graphs often end before it does)
};

/// The wall lies in the last half of the travel, runs to its end, gains at least `minProminenceOfSpan` of the
/// force range below it, and is steeper than `bottomOutSlopeRatio` times the mean slope (force range /
/// travel) below it. A rounded foot belongs to it from where the slope passes that bar. Without such a
/// stretch: the end of the travel
/// ("a bottom-out occurs when the displacement reaches its maximum travel", Kim & Lee).
BottomOut bottomOutOf(const StrokeCurve& curve, const SectionSettings& settings = {});

/// Tactile points in the order travelled (release: from large to small displacement). Points on the
/// bottom-out are none.
std::vector<TactilePoint> tactilePoints(const StrokeCurve& curve, Stroke stroke,
                                        const SectionSettings& settings = {});

/// Sections in the order travelled; they touch and cover the whole stroke. A wall at the *start* of a press
/// is slope. A press ends with a bottomOut section, of zero length where the curve has no wall; a release
/// begins with one only where it has a wall. A jump whose force is never regained runs to the end of the
/// stroke: on release that is the complete release. Tactile points inside an earlier jump begin no jump of
/// their own: force never reaches them.
std::vector<Section> sectionsOf(const StrokeCurve& curve, Stroke stroke,
                                const SectionSettings& settings = {});

/// Area between the curve and the horizontal through the jump's tactile point (N·mm = mJ, >= 0):
/// the paper's measure of a jump's strength ("Jump Feedback Generation"). 0 for a degenerate jump.
double jumpArea_mJ(const StrokeCurve& curve, const Section& jump);

}  // namespace detent
