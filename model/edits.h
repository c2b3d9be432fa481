// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Edits by hand and by script: pure functions from a value to a Result of the same type. Nothing is changed
// in place, so undo keeps the value before. A Failure (wrongUsage, or a broken rule of the curve) says what
// prevented the edit.
// Reading order: knots, shapes of one stroke, graphs, buttons.
// Knot indices count from 0 in knots(). Tactile points and sections are indexed as in tactilePoints() and
// sectionsOf(), in the order travelled. Any thread.

#include <cstddef>
#include <functional>
#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

// ---- knots

/// Moves a knot between its neighbours. Where a piece would begin to turn, its slopes are limited.
Result<StrokeCurve> moveKnot(const StrokeCurve& curve, std::size_t index, CurvePoint to);

Result<StrokeCurve> setSlopeBefore(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm);
Result<StrokeCurve> setSlopeAfter(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm);
/// Sets the slope on both sides: the knot becomes smooth.
Result<StrokeCurve> setSlope(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm);

/// Turns a knot into a corner whose sides point to its neighbours.
Result<StrokeCurve> makeCorner(const StrokeCurve& curve, std::size_t index);
/// Gives both sides one slope: the monotone one between the neighbouring chords (0 at an extremum).
Result<StrokeCurve> makeSmooth(const StrokeCurve& curve, std::size_t index);
bool isCorner(const StrokeCurve& curve, std::size_t index);

/// Adds a knot on the curve without changing its shape. Refused outside the curve and where a knot exists.
Result<StrokeCurve> insertKnot(const StrokeCurve& curve, double displacement_mm);
/// Removes a knot; its neighbours keep their slopes. Two knots must remain, with a travel above zero.
Result<StrokeCurve> removeKnot(const StrokeCurve& curve, std::size_t index);

/// New place of a knot.
struct KnotPlace {
  std::size_t index = 0;
  CurvePoint to;
};
/// Moves several knots at once, as moveKnot does. The order of knots must not change. Without places,
/// returns the curve itself.
Result<StrokeCurve> placeKnots(const StrokeCurve& curve, const std::vector<KnotPlace>& positions);
/// Removes several knots at once, as removeKnot does. Indices in any order; duplicates are allowed.
Result<StrokeCurve> removeKnots(const StrokeCurve& curve, const std::vector<std::size_t>& indices);

/// Returns the knots of a stretch including its two ends. An end without a knot gets one, so that the shape
/// is kept. Refused unless from < to and both lie on the curve.
Result<std::vector<Knot>> stretchOf(const StrokeCurve& curve, double from_mm, double to_mm);
/// Inserts a stretch and removes the knots between its first and last knot, both places included. May extend
/// the curve. `stretch`: by displacement, one knot or more.
Result<StrokeCurve> putStretch(const StrokeCurve& curve, const std::vector<Knot>& stretch);

// ---- shapes of one stroke

/// Moves a tactile point. Each flank, up to the next extremum (or the end, or the start of the bottom-out),
/// is stretched by one affine map, so that it stays monotone and the point stays the extremum. The point must
/// stay between the ends of its flanks and beyond their forces.
Result<StrokeCurve> moveTactilePoint(const StrokeCurve& curve, Stroke stroke, std::size_t index,
                                     CurvePoint to, const SectionSettings& settings = {});

/// Like moveTactilePoint, for any local extremum. `turn` must be an element of localMaxima() or
/// localMinima().
Result<StrokeCurve> moveTurn(const StrokeCurve& curve, CurvePoint turn, CurvePoint to,
                             const SectionSettings& settings = {});

/// Moves the valley after a tactile point of the press so that (tactile force - valley force) / tactile force
/// == ratio. ratio > 0; the valley needs a flank on both sides.
Result<StrokeCurve> setSnapRatio(const StrokeCurve& press, std::size_t tactileIndex, double ratio,
                                 const SectionSettings& settings = {});

/// Moves a section by (by_mm, by_N); adjacent sections are stretched to keep touching it. A section at an end
/// of the stroke moves that end.
Result<StrokeCurve> moveSection(const StrokeCurve& curve, Stroke stroke, std::size_t index, double by_mm,
                                double by_N, const SectionSettings& settings = {});

/// A jump to add: from a new tactile point at `at_mm`, `drop_N` deep (press: down; release: up), back on the
/// curve `width_mm` further along the stroke.
struct NewJump {
  double at_mm = 0;
  double width_mm = 0;  ///< > 0
  double drop_N = 0;    ///< > 0
};
/// Adds a jump. Before the tactile point the curve keeps its shape; it must rise there (in displacement).
Result<StrokeCurve> addJump(const StrokeCurve& curve, Stroke stroke, NewJump jump);

/// Replaces a jump by a straight line, from where the force first had the valley's value to the end of the
/// jump.
Result<StrokeCurve> removeJump(const StrokeCurve& curve, Stroke stroke, std::size_t tactileIndex,
                               const SectionSettings& settings = {});

/// Replaces the curve by a straight line from the start to the bottom-out (or the end); the bottom-out stays.
Result<StrokeCurve> makeLinear(const StrokeCurve& curve, const SectionSettings& settings = {});

/// Multiplies all forces. factor: finite, > 0.
Result<StrokeCurve> scaleForce(const StrokeCurve& curve, double factor);
/// Multiplies all displacements; slopes are divided. factor: finite, > 0.
Result<StrokeCurve> scaleTravel(const StrokeCurve& curve, double factor);

// ---- graphs

using CurveEdit = std::function<Result<StrokeCurve>(const StrokeCurve&)>;

/// Applies an edit to one stroke. Refused for a missing release.
Result<ForceGraph> editStroke(const ForceGraph& graph, Stroke stroke, const CurveEdit& edit);

/// Makes the release the press curve lowered by `hysteresis_N` (>= 0). Where the press is weaker than twice
/// that, the distance decreases smoothly, so that a force >= 0 stays >= 0.
Result<ForceGraph> mirrorPressToRelease(const ForceGraph& graph, double hysteresis_N);
Result<ForceGraph> removeRelease(const ForceGraph& graph);
Result<ForceGraph> scaleForce(const ForceGraph& graph, double factor);
Result<ForceGraph> scaleTravel(const ForceGraph& graph, double factor);

// ---- buttons

using GraphEdit = std::function<Result<ForceGraph>(const ForceGraph&)>;

/// Applies an edit to the graph of one state. Operating and reset points stay; if one would lie outside the
/// travel, the edit is refused (scaleTravel moves them). Graphs at other speeds do not change.
Result<Button> editGraph(const Button& button, std::size_t state, const GraphEdit& edit);
Result<Button> rename(const Button& button, std::string name);
Result<Button> setOperatingPoint(const Button& button, std::size_t state,
                                 std::optional<double> displacement_mm);
Result<Button> setResetPoint(const Button& button, std::size_t state, std::optional<double> displacement_mm);
Result<Button> setDamping(const Button& button, std::size_t state, std::vector<DampingPoint> damping);
/// Adds a second state as a copy of state `of`; a momentary button becomes self-locking. Unnamed states
/// become "unlocked" and "locked". Refused if there are two already.
Result<Button> addState(const Button& button, std::size_t of);
/// Removes a state; the button becomes momentary. Refused for the only state.
Result<Button> removeState(const Button& button, std::size_t state);
/// Scales the forces of all states and speeds, and damping with them.
Result<Button> scaleForce(const Button& button, double factor);
/// Scales the travel of all states and speeds, with contact points and damping.
Result<Button> scaleTravel(const Button& button, double factor);
/// Scales the snap ratio of every tactile point of every press (setSnapRatio). A button without tactile
/// points does not change.
Result<Button> scaleSnapRatios(const Button& button, double factor);

}  // namespace detent
