// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/operations.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "model/edits.h"
#include "model/templates.h"

namespace detent::editor {
namespace {

using Values = std::vector<double>;

constexpr int mostPieces = 200;  // limit for shaping by hand

QString tr(const char* text) { return QCoreApplication::translate("Operations", text); }

Stroke strokeOf(double choice) { return choice < 0.5 ? Stroke::press : Stroke::release; }

OperationField numberField(FieldKind kind, const QString& name, double value, double least, double most,
                           const QString& tip = {}) {
  return {name, kind, value, least, most, tip, {}};
}

OperationField strokeField(const OperationTarget& target) {
  OperationField field{tr("Stroke"), FieldKind::choice, 0, 0, 0, tr("Curve that this command changes"),
                       {tr("press")}};
  if (target.graph().release()) {
    field.choices << tr("release");
    if (target.selected && target.selected->stroke == Stroke::release) field.value = 1;
  }
  return field;
}

Result<Button> editOne(const Button& start, std::size_t state, Stroke stroke, const CurveEdit& edit) {
  return editGraph(start, state, [&](const ForceGraph& graph) { return editStroke(graph, stroke, edit); });
}

double highestForce(const OperationTarget& target) { return std::max(target.values.highest_N, 1e-3); }

// Position of the selected mark, else a place that usually works.
double selectedPlace(const OperationTarget& target, double otherwise_mm) {
  if (!target.selected) return otherwise_mm;
  const auto at = placeOf(*target.selected, target.button.states()[target.state], target.values);
  return at ? at->displacement_mm : otherwise_mm;
}

// A list of all tactile points; the value is an index into it.
struct TactileChoice {
  struct Entry {
    Stroke stroke;
    std::size_t index;
  };
  std::vector<Entry> entries;
  OperationField field{tr("Tactile point"), FieldKind::choice, 0, 0, 0, {}, {}};
};

TactileChoice tactileChoice(const OperationTarget& target, bool pressOnly) {
  TactileChoice choice;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && (pressOnly || !target.graph().release())) continue;
    for (std::size_t i = 0; i < target.values.of(stroke).tactile.size(); ++i) {
      const MarkId id{MarkKind::tactilePoint, stroke, i};
      if (target.selected == id) choice.field.value = static_cast<double>(choice.entries.size());
      choice.entries.push_back({stroke, i});
      choice.field.choices << nameOf(id);
    }
  }
  return choice;
}

TactileChoice::Entry entryOf(const std::vector<TactileChoice::Entry>& entries, double value) {
  if (entries.empty()) return {Stroke::press, 0};  // the edit then reports that no such point exists
  return entries[std::min(entries.size() - 1, static_cast<std::size_t>(std::max(0.0, value)))];
}

Result<Button> withGraph(const Button& start, std::size_t state, const Result<Button>& from) {
  if (!from) return from.failure();
  return editGraph(start, state,
                   [&](const ForceGraph&) -> Result<ForceGraph> { return from->states()[0].graph; });
}

// A fitted start may lie before the rest position by less than its error; buttons start at 0.
Result<StrokeCurve> fromRest(const StrokeCurve& fitted, double sigma_mm) {
  const Knot& first = fitted.knots().front();
  if (first.displacement_mm >= 0 || first.displacement_mm < -3 * sigma_mm) return fitted;
  return moveKnot(fitted, 0, {0, first.force_N});
}

Result<StrokeCurve> refitted(const importer::StrokePoints& traced, Stroke stroke, int pieces,
                             importer::PointNoise noise) {
  importer::FitOptions options = importer::fitOptionsFor(importer::FitEffort::draft, noise);
  options.criterion = importer::PieceCriterion::fixed;
  options.maxPieces = mostPieces;
  options.pieces = pieces;
  const auto fitted = importer::fitStroke(traced.points, stroke, options);
  if (!fitted) return fitted.failure();
  return fromRest(fitted->curve, noise.sigma_mm);
}

}  // namespace

Operation addJumpOperation(const OperationTarget& target) {
  const double travel = target.graph().travel_mm();
  Operation op{
      tr("Add jump"),
      tr("Adds a tactile point: from it, the force falls into a valley and then returns to the curve. On the "
         "release stroke, the force rises to a peak instead."),
      {strokeField(target),
       numberField(FieldKind::length, tr("Tactile point at"), selectedPlace(target, 0.35 * travel), 0, travel,
                   tr("Displacement of the tactile point")),
       numberField(FieldKind::length, tr("Width"), 0.15 * travel, 0, travel,
                   tr("Travel from the tactile point to where the jump rejoins the curve")),
       numberField(FieldKind::force, tr("Drop"), 0.2 * highestForce(target), 0, 10 * highestForce(target),
                   tr("Force difference between tactile point and valley"))},
      {}};
  op.edit = [state = target.state](const Button& start, const Values& v) {
    return editOne(start, state, strokeOf(v[0]), [&](const StrokeCurve& curve) {
      return addJump(curve, strokeOf(v[0]), {v[1], v[2], v[3]});
    });
  };
  return op;
}

Operation removeJumpOperation(const OperationTarget& target) {
  TactileChoice choice = tactileChoice(target, false);
  Operation op{
      tr("Remove jump"), tr("The tactile point and its jump become a straight line."), {choice.field}, {}};
  op.edit = [state = target.state, entries = choice.entries](const Button& start, const Values& v) {
    const auto entry = entryOf(entries, v[0]);
    return editOne(start, state, entry.stroke,
                   [&](const StrokeCurve& curve) { return removeJump(curve, entry.stroke, entry.index); });
  };
  return op;
}

Operation makeLinearOperation(const OperationTarget& target) {
  OperationField which = strokeField(target);
  if (which.choices.size() > 1) {
    which.choices << tr("both");
    which.value = 2;
  }
  Operation op{
      tr("Make linear"),
      tr("Replaces the curve by a straight line from the start to the bottom-out. The bottom-out stays."),
      {which},
      {}};
  op.edit = [state = target.state](const Button& start, const Values& v) -> Result<Button> {
    const auto linear = [](const StrokeCurve& curve) { return makeLinear(curve); };
    if (v[0] < 1.5) return editOne(start, state, strokeOf(v[0]), linear);
    const auto press = editOne(start, state, Stroke::press, linear);
    return press ? editOne(*press, state, Stroke::release, linear) : press;
  };
  return op;
}

Operation mirrorOperation(const OperationTarget& target) {
  const double high = highestForce(target);
  Operation op{tr("Mirror press to release"),
               tr("The release becomes a copy of the press curve, lowered by this force. Where the press "
                  "force is below twice of it, the copy is lowered by less."),
               {numberField(FieldKind::force, tr("Release lower by"), 0.15 * high, 0, 10 * high,
                            tr("How far the release lies below the press"))},
               {}};
  op.edit = [state = target.state](const Button& start, const Values& v) {
    return editGraph(start, state,
                     [&](const ForceGraph& graph) { return mirrorPressToRelease(graph, v[0]); });
  };
  return op;
}

Operation removeReleaseOperation(const OperationTarget& target) {
  Operation op{tr("Remove release curve"), tr("The release will follow the press curve."), {}, {}};
  op.edit = [state = target.state](const Button& start, const Values&) {
    return editGraph(start, state, [](const ForceGraph& graph) { return removeRelease(graph); });
  };
  return op;
}

Operation scaleForceOperation(const OperationTarget& target) {
  Operation op{tr("Scale force"),
               tr("Scales all forces of all states, and the damping with them."),
               {numberField(FieldKind::force, tr("Highest force"), target.values.highest_N, 1e-4,
                            100 * highestForce(target), tr("Highest force of this state after scaling"))},
               {}};
  op.edit = [high = target.values.highest_N](const Button& start, const Values& v) -> Result<Button> {
    if (v[0] == high) return start;
    return scaleForce(start, v[0] / high);
  };
  return op;
}

Operation scaleTravelOperation(const OperationTarget& target) {
  const double travel = target.graph().travel_mm();
  Operation op{tr("Scale travel"),
               tr("Scales all displacements of all states, including operating and reset points."),
               {numberField(FieldKind::length, tr("Travel"), travel, 1e-3, 100 * travel,
                            tr("Highest force of this state after scaling"))},
               {}};
  op.edit = [travel](const Button& start, const Values& v) -> Result<Button> {
    if (v[0] == travel) return start;
    return scaleTravel(start, v[0] / travel);
  };
  return op;
}

Operation snapRatioOperation(const OperationTarget& target) {
  TactileChoice choice = tactileChoice(target, true);
  double ratio = 0.3;
  const auto first = entryOf(choice.entries, choice.field.value);
  const auto& tactile = target.values.press.tactile;
  if (first.index < tactile.size() && tactile[first.index].force_N > 0) {
    const double from = tactile[first.index].displacement_mm;
    const double stop = first.index + 1 < tactile.size() ? tactile[first.index + 1].displacement_mm
                                                         : target.graph().travel_mm();
    double valley = tactile[first.index].force_N;
    for (const CurvePoint& p : target.graph().press().localMinima())
      if (p.displacement_mm > from && p.displacement_mm < stop) valley = std::min(valley, p.force_N);
    if (valley < tactile[first.index].force_N) ratio = 1 - valley / tactile[first.index].force_N;
  }
  Operation op{tr("Snap ratio"),
               tr("(Peak force − valley force) / peak force. The tactile point stays, the valley moves."),
               {choice.field, numberField(FieldKind::ratio, tr("Ratio"), ratio, 0.001, 5,
                                          tr("Usual: 20 % for a soft key, 60 % for a snappy dome"))},
               {}};
  op.edit = [state = target.state, entries = choice.entries](const Button& start, const Values& v) {
    const auto entry = entryOf(entries, v[0]);
    return editOne(start, state, Stroke::press,
                   [&](const StrokeCurve& curve) { return setSnapRatio(curve, entry.index, v[1]); });
  };
  return op;
}

Operation refitOperation(const OperationTarget& target) {
  const auto& origin = *target.origin;
  const auto pieces = [](const StrokeCurve& curve) { return static_cast<double>(curve.knots().size() - 1); };
  Operation op{
      tr("Refit curve"),
      tr("Fits the curves to the traced points again, with as many pieces as you choose. Replaces changes "
         "made by hand."),
      {numberField(FieldKind::count, tr("Pieces of the press curve"), pieces(target.graph().press()), 1, 200,
                   tr("More pieces follow the points more closely; fewer are easier to edit"))},
      {}};
  op.slow = true;
  if (origin.strokes.release)
    op.fields.push_back(numberField(
        FieldKind::count, tr("Pieces of the release curve"), pieces(target.graph().curve(Stroke::release)), 1,
        200, tr("More pieces follow the points more closely; fewer are easier to edit")));
  // Noise as in the importer: a third of a pixel, or a thousandth of the span for force logs.
  importer::PointNoise noise{1e-3 * target.graph().travel_mm(), 1e-3 * highestForce(target)};
  if (origin.evidence) {
    const auto& calibration = origin.evidence->axes.calibration.value;
    noise = {0.3 * calibration.mmPerPx(), 0.3 * calibration.newtonPerPx()};
  }
  op.edit = [state = target.state, strokes = origin.strokes, noise](const Button& start,
                                                                    const Values& v) -> Result<Button> {
    const auto press = refitted(strokes.press, Stroke::press, static_cast<int>(v[0]), noise);
    if (!press) return press.failure();
    std::optional<StrokeCurve> release;
    if (strokes.release) {
      auto fitted = refitted(*strokes.release, Stroke::release, static_cast<int>(v[1]), noise);
      if (!fitted) return fitted.failure();
      release = *std::move(fitted);
    }
    return editGraph(start, state,
                     [&](const ForceGraph&) { return ForceGraph::fromCurves(*press, release); });
  };
  return op;
}

Operation contactsOperation(const OperationTarget& target) {
  const ButtonState& state = target.button.states()[target.state];
  const double travel = target.graph().travel_mm();
  const QStringList choices{tr("not set"), tr("set")};
  Operation op{tr("Operating and reset point"),
               tr("Where the contact closes on the press stroke, and where it opens on the release stroke."),
               {{tr("Operating point"), FieldKind::choice, 1, 0, 0, {}, choices},
                numberField(FieldKind::length, tr("Closes at"),
                            state.operatingPoint_mm.value_or(selectedPlace(target, 0.5 * travel)), 0, travel,
                            tr("Displacement on the press stroke")),
                {tr("Reset point"), FieldKind::choice, state.resetPoint_mm ? 1.0 : 0.0, 0, 0, {}, choices},
                numberField(FieldKind::length, tr("Opens at"), state.resetPoint_mm.value_or(0.45 * travel), 0,
                            travel, tr("Displacement on the release stroke"))},
               {}};
  op.edit = [index = target.state](const Button& start, const Values& v) -> Result<Button> {
    const auto known = [](double choice, double at) {
      return choice > 0.5 ? std::optional<double>(at) : std::nullopt;
    };
    const auto operating = setOperatingPoint(start, index, known(v[0], v[1]));
    return operating ? setResetPoint(*operating, index, known(v[2], v[3])) : operating;
  };
  return op;
}

Operation dampingOperation(const OperationTarget& target) {
  const ButtonState& state = target.button.states()[target.state];
  const double travel = target.graph().travel_mm();
  double start = 0.002, end = 0.002;
  if (!state.damping.empty()) {
    start = state.damping.front().damping_Ns_per_mm;
    end = state.damping.back().damping_Ns_per_mm;
  }
  Operation op{
      tr("Damping"),
      tr("Adds a force proportional to velocity, for force feedback devices. Edit it in the damping view."),
      {{tr("Damping"), FieldKind::choice, 1, 0, 0, {}, {tr("off"), tr("on")}},
       numberField(FieldKind::damping, tr("At the start"), start, 0, 1000, tr("Damping in N·s/mm at 0 mm")),
       numberField(FieldKind::damping, tr("At the end"), end, 0, 1000,
                   tr("Damping in N·s/mm at the end of the travel"))},
      {}};
  op.edit = [index = target.state, travel](const Button& before, const Values& v) {
    std::vector<DampingPoint> points;
    if (v[0] > 0.5) {
      // Points between keep their shape.
      points = before.states()[index].damping;
      if (points.size() < 2) points = {{0, v[1]}, {travel, v[2]}};
      points.front().damping_Ns_per_mm = v[1];
      points.back().damping_Ns_per_mm = v[2];
    }
    return setDamping(before, index, std::move(points));
  };
  return op;
}

namespace {

/// A template with scaled travel, and its first state's highest force set to `highest_N`.
Result<Button> stretched(const Button& plain, double travelFactor, double highest_N) {
  auto longer = scaleTravel(plain, travelFactor);
  if (!longer) return longer;
  return scaleForce(*longer, highest_N / longer->states()[0].graph.press().forceRange_N().second);
}

}  // namespace

Operation twoLevelOperation(const OperationTarget& target) {
  const double travel = target.graph().travel_mm(), high = highestForce(target);
  Operation op{tr("Two-level button"),
               tr("Replaces the curves of this state by a button with two tactile points. The second one is "
                  "stronger, as on a camera's shutter button."),
               {numberField(FieldKind::length, tr("Travel"), travel, 1e-3, 100 * travel),
                numberField(FieldKind::force, tr("Highest force"), high, 1e-3, 100 * high)},
               {}};
  op.edit = [state = target.state](const Button& start, const Values& v) -> Result<Button> {
    auto plain = twoLevelButton();
    if (!plain) return plain;
    auto scaled = stretched(*plain, v[0] / plain->states()[0].graph.travel_mm(), v[1]);
    if (!scaled) return scaled;
    // Contacts and damping of the old curves do not apply to the new ones.
    auto bare = setOperatingPoint(start, state, {});
    if (bare) bare = setResetPoint(*bare, state, {});
    if (bare) bare = setDamping(*bare, state, {});
    return bare ? withGraph(*bare, state, scaled) : bare;
  };
  return op;
}

Operation selfLockingOperation(const OperationTarget& target) {
  const double travel = target.graph().travel_mm(), high = highestForce(target);
  Operation op{
      tr("Self-locking button"),
      tr("Replaces the button by one with two states: one press locks it down, the next press releases it."),
      {numberField(FieldKind::length, tr("Travel"), travel, 1e-3, 100 * travel),
       numberField(FieldKind::length, tr("Lock at"), 0.625 * travel, 0, 100 * travel,
                   tr("Where the locked button rests; between its valley and the end of the travel")),
       numberField(FieldKind::force, tr("Highest force"), high, 1e-3, 100 * high)},
      {}};
  op.edit = [name = target.button.name(), provenance = target.button.provenance()](
                const Button&, const Values& v) -> Result<Button> {
    SelfLockingTemplate values;
    values.lock_mm = v[1] * values.travel_mm / v[0];
    auto plain = selfLockingButton(values);
    if (!plain) return plain;
    auto scaled = stretched(*plain, v[0] / values.travel_mm, v[2]);
    if (!scaled) return scaled;
    return Button::fromStates(name, scaled->states(), provenance);
  };
  return op;
}

Operation addStateOperation(const OperationTarget& target) {
  Operation op{
      tr("Add state"),
      tr("The button becomes self-locking: its two states alternate at each actuation. The new state "
         "starts as a copy of this one."),
      {},
      {}};
  op.edit = [state = target.state](const Button& start, const Values&) { return addState(start, state); };
  return op;
}

Operation removeStateOperation(const OperationTarget& target) {
  Operation op{tr("Remove state"),
               tr("Removes this state. The button keeps its other state and becomes momentary."),
               {},
               {}};
  op.edit = [state = target.state](const Button& start, const Values&) { return removeState(start, state); };
  return op;
}

}  // namespace detent::editor
