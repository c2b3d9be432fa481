// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Edits by hand and by script: pure functions from a value to a Result of the same type. Nothing is changed
// in place, so undo is keeping the value before. A Failure (wrongUsage, or the broken rule of the curve)
// names what stood in the way.
//
// Reading order: knots, whole shapes of one stroke, graphs, buttons.
// Knot indices count from 0 in knots(); tactile points and sections are indexed as tactilePoints() and
// sectionsOf() list them, in the order travelled. Any thread.

#include <cstddef>
#include <functional>
#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

// ---- knots

/// Moves a knot; its slopes stay. It must stay between its neighbours.
Result<StrokeCurve> moveKnot(const StrokeCurve& curve, std::size_t index, CurvePoint to);

Result<StrokeCurve> setSlopeBefore(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm);
Result<StrokeCurve> setSlopeAfter(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm);
/// Both sides at once: the knot becomes smooth.
Result<StrokeCurve> setSlope(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm);

/// Turns a knot into a corner whose two sides point along the chords to its neighbours.
Result<StrokeCurve> makeCorner(const StrokeCurve& curve, std::size_t index);
/// Gives both sides one slope: the monotone-safe one between the neighbouring chords (0 at an extremum).
Result<StrokeCurve> makeSmooth(const StrokeCurve& curve, std::size_t index);
bool isCorner(const StrokeCurve& curve, std::size_t index);

/// Adds a knot on the curve without changing its shape. Refused where a knot stands already, and outside.
Result<StrokeCurve> insertKnot(const StrokeCurve& curve, double displacement_mm);
/// Takes a knot away; its neighbours keep their slopes. Two knots must remain, and the travel must not become
/// zero.
Result<StrokeCurve> removeKnot(const StrokeCurve& curve, std::size_t index);

/// Where a knot is put.
struct KnotPlace {
  std::size_t index = 0;
  CurvePoint to;
};
/// Moves several knots at once; their slopes stay. Afterwards all knots must stand in the order they had.
/// Nothing to move gives the curve itself.
Result<StrokeCurve> placeKnots(const StrokeCurve& curve, const std::vector<KnotPlace>& places);
/// Takes several knots away at once, as removeKnot does each. Indices in any order, each once or more often.
Result<StrokeCurve> removeKnots(const StrokeCurve& curve, const std::vector<std::size_t>& indices);

/// The knots of a stretch of a curve, its two ends included; an end where no knot stands gets one, so that
/// the stretch keeps its shape. Refused unless from < to and both lie on the curve.
Result<std::vector<Knot>> stretchOf(const StrokeCurve& curve, double from_mm, double to_mm);
/// Puts a stretch into a curve: what stands between its first and last knot, those two places included, goes.
/// Beyond the ends of the curve it makes it longer. `stretch` by displacement, one knot or more.
Result<StrokeCurve> putStretch(const StrokeCurve& curve, const std::vector<Knot>& stretch);

// ---- shapes of one stroke

/// Moves a tactile point. The flanks on both sides, up to the next extremum (or the end, or the foot of the
/// bottom-out), are stretched with it, each by one affine map, so they stay monotone and the point stays the
/// extremum. It must stay between the two ends of the flanks and beyond their forces.
Result<StrokeCurve> moveTactilePoint(const StrokeCurve& curve, Stroke stroke, std::size_t index,
                                     CurvePoint to, const SectionSettings& settings = {});

/// The same for any local extremum: a valley, a hump, or a turn too small for a tactile point. `turn` is one
/// of localMaxima() or localMinima(), exactly.
Result<StrokeCurve> moveTurn(const StrokeCurve& curve, CurvePoint turn, CurvePoint to,
                             const SectionSettings& settings = {});

/// Moves the valley that follows a tactile point of the press so that
/// (tactile force - valley force) / tactile force == ratio. ratio > 0; the valley must have a flank on both
/// sides.
Result<StrokeCurve> setSnapRatio(const StrokeCurve& press, std::size_t tactileIndex, double ratio,
                                 const SectionSettings& settings = {});

/// Moves a whole section by (by_mm, by_N); the sections beside it are stretched to keep touching it. A
/// section at an end of the stroke moves that end.
Result<StrokeCurve> moveSection(const StrokeCurve& curve, Stroke stroke, std::size_t index, double by_mm,
                                double by_N, const SectionSettings& settings = {});

/// A jump to be added: from a new tactile point at `at_mm` on the curve, `drop_N` deep (press: down; release:
/// up), back on the curve `width_mm` further along the stroke.
struct NewJump {
  double at_mm = 0;
  double width_mm = 0;  ///< > 0
  double drop_N = 0;    ///< > 0
};
/// Before the tactile point the curve keeps its shape; it must rise there (in displacement).
Result<StrokeCurve> addJump(const StrokeCurve& curve, Stroke stroke, NewJump jump);

/// Removes a jump: a straight line from where the force first had the valley's value to where the jump ends.
Result<StrokeCurve> removeJump(const StrokeCurve& curve, Stroke stroke, std::size_t tactileIndex,
                               const SectionSettings& settings = {});

/// A straight line from the start to the foot of the bottom-out (or the end); a wall stays as it is.
Result<StrokeCurve> makeLinear(const StrokeCurve& curve, const SectionSettings& settings = {});

/// Multiplies all forces. factor finite, > 0.
Result<StrokeCurve> scaleForce(const StrokeCurve& curve, double factor);
/// Multiplies all displacements (slopes are divided). factor finite, > 0.
Result<StrokeCurve> scaleTravel(const StrokeCurve& curve, double factor);

// ---- graphs

using CurveEdit = std::function<Result<StrokeCurve>(const StrokeCurve&)>;

/// Applies an edit to one stroke. Refused for the release of a graph that has none.
Result<ForceGraph> editStroke(const ForceGraph& graph, Stroke stroke, const CurveEdit& edit);

/// The release becomes the press curve lowered by `hysteresis_N` (>= 0). Where the press is weaker than twice
/// that, the distance shrinks smoothly with it, so that a force >= 0 stays >= 0.
Result<ForceGraph> mirrorPressToRelease(const ForceGraph& graph, double hysteresis_N);
Result<ForceGraph> removeRelease(const ForceGraph& graph);
Result<ForceGraph> scaleForce(const ForceGraph& graph, double factor);
Result<ForceGraph> scaleTravel(const ForceGraph& graph, double factor);

// ---- buttons

using GraphEdit = std::function<Result<ForceGraph>(const ForceGraph&)>;

/// Applies an edit to one state's graph. Operating and reset points stay where they are; if an edit of the
/// travel leaves one outside, the Failure says so (scaleTravel moves them along). Graphs at other speeds stay as they are.
Result<Button> editGraph(const Button& button, std::size_t state, const GraphEdit& edit);
Result<Button> rename(const Button& button, std::string name);
Result<Button> setOperatingPoint(const Button& button, std::size_t state,
                                 std::optional<double> displacement_mm);
Result<Button> setResetPoint(const Button& button, std::size_t state, std::optional<double> displacement_mm);
Result<Button> setDamping(const Button& button, std::size_t state, std::vector<DampingPoint> damping);
/// A second state as a copy of `of`; a momentary button becomes self-locking. States without a name become
/// "unlocked" and "locked". Refused where there are two already.
Result<Button> addState(const Button& button, std::size_t of);
/// Takes a state away; the button becomes momentary. Refused for the only one.
Result<Button> removeState(const Button& button, std::size_t state);
/// All states and speeds together; damping follows (forces at one speed keep their share of the spring's).
Result<Button> scaleForce(const Button& button, double factor);
/// All states and speeds together, with operating points, reset points and damping.
Result<Button> scaleTravel(const Button& button, double factor);
/// The snap ratio of every tactile point of every press that has one (setSnapRatio). A button without any stays as it is.
Result<Button> scaleSnapRatios(const Button& button, double factor);

}  // namespace detent
