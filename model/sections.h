// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sections and tactile points of a stroke, derived from its curve. Kim & Lee 2013, "Modeling a button with a
// force graph" and Figure 2.

#include <vector>

#include "model/stroke_curve.h"

namespace detent {

enum class SectionKind {
  slope,  ///< displacement follows force continuously
  jump,   ///< from a tactile point to where the force is regained (press), or falls below it again (release)
  bottomOut  ///< the steep rise at the end of the travel
};

/// Press: a local maximum of the press curve. Release: a local minimum of the release curve (Kim & Lee,
/// "Tactile point").
struct TactilePoint {
  double displacement_mm = 0;
  double force_N = 0;
  double prominence_N =
      0;  ///< how far the force turns back, on the shallower side, before it passes this point's force again
};

/// One section of a stroke, in the order travelled (release: from_mm > to_mm).
struct Section {
  SectionKind kind = SectionKind::slope;
  double from_mm = 0, to_mm = 0;
  double fromForce_N = 0, toForce_N = 0;
};

/// Criteria for tactile points and bottom-outs. The defaults fit keyboards and tact switches.
struct SectionSettings {
  double minProminence_N = 0;  ///< absolute limit; >= 0
  double minProminenceOfSpan =
      0.03;  ///< limit as a share of the stroke's force range below the bottom-out; in [0, 1]
  double bottomOutSlopeRatio =
      8;  ///< the last stretch is a bottom-out if steeper than this × the stroke's mean slope; > 1
};

/// Start of the bottom-out.
struct BottomOut {
  double displacement_mm = 0;  ///< start of the bottom-out; the end of the travel if the curve has none
  double force_N = 0;          ///< force there
  bool isSteep = false;        ///< the curve itself has a steep rise (CHERRY's graphs often end before it)
};

/// Finds the bottom-out: it lies in the last half of the travel, reaches its end, gains at least
/// `minProminenceOfSpan` of the force range below it, and is steeper than `bottomOutSlopeRatio` times the
/// mean slope (force range / travel) below it. A rounded start belongs to it from where the slope exceeds
/// that limit. Without such a stretch it is the end of the travel ("a bottom-out occurs when the displacement
/// reaches its maximum travel", Kim & Lee).
BottomOut bottomOutOf(const StrokeCurve& curve, const SectionSettings& settings = {});

/// Returns the tactile points in the order travelled (release: from large to small displacement), without
/// those on the bottom-out.
std::vector<TactilePoint> tactilePoints(const StrokeCurve& curve, Stroke stroke,
                                        const SectionSettings& settings = {});

/// Returns adjacent sections in the order travelled that cover the whole stroke. A steep rise at the *start*
/// of a press is slope. A press ends with a bottomOut section, of zero length if the curve has no steep rise;
/// a release begins with one only if it has. A jump whose force is never regained extends to the end of the
/// stroke (on release: the complete release). Tactile points inside an earlier jump begin no jump, because
/// the force never reaches them.
std::vector<Section> sectionsOf(const StrokeCurve& curve, Stroke stroke,
                                const SectionSettings& settings = {});

/// Area between the curve and the horizontal through the jump's tactile point (N·mm = mJ, >= 0): the paper's
/// measure of a jump's strength ("Jump Feedback Generation"). 0 for a degenerate jump.
double jumpArea_mJ(const StrokeCurve& curve, const Section& jump);

}  // namespace detent
