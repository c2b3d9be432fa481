// SPDX-License-Identifier: GPL-3.0-or-later
// Every tool by real events on the workspace, judged by the button that comes out.
#include <cmath>
#include <QClipboard>
#include <QLocale>

#include "editor/tools/knot_text.h"
#include "editor/tools/mark_edits.h"
#include "editor/tools/selection_edits.h"
#include "model/edits.h"
#include "tests/editor/window_tests.h"
#include "tests/editor/workspace_rig.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::editor::tests;

namespace {

constexpr MarkId tactile{MarkKind::tactilePoint, Stroke::press, 0};
constexpr MarkId valley{MarkKind::turn, Stroke::press, 0};
constexpr MarkId operating{MarkKind::operatingPoint, Stroke::press, 0};

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

}  // namespace

class ToolsTest : public QObject {
  Q_OBJECT

 private slots:
  void dragOfTactilePointIsOneExactStep();
  void aLabelMovesItsPoint();
  void aDimensionMovesItsContact();
  void theHintOfAHandleNamesNoSnapping();
  void aDragShowsWhatItChanges();
  void measuresBetweenPoints();
  void measuresTheCurveBesideASlopeHandle();
  void aMeasurementEndsWithItsGraph();
  void escapeCancelsADragExactly();
  void refusedMoveStopsAtTheLimit();
  void undoInTheMiddleOfADragEndsIt();
  void changeOfStateInTheMiddleOfADragEndsIt();
  void clickSelectsAndASecondClickTakesWhatLiesBeneath();
  void valleyFollowsTheHand();
  void slopeHandleTurnsBothSidesOfASmoothKnot();
  void aDragOnASegmentBendsItBetweenItsKnots();
  void nudgingTheCurveAddsNoPoint();
  void contactPointsKeepToTheTravel();
  void shiftKeepsToOneAxis();
  void snapsToGridAndShowsIt();
  void snapsToTheOtherStroke();
  void controlLetsGoOfTheGrid();
  void arrowKeysNudgeInOneStep();
  void arrowKeysWithShiftAndAlt();
  void tabSelectsEachPointInTurn();
  void deleteRemovesKnotAndJump();
  void insertAddsAKnotHalfway();
  void slopeHandlesByKeys();
  void cornerToggles();
  void addKnotKeepsTheShape();
  void addKnotDragsOn();
  void addJumpByClickAndByDrag();
  void addJumpIsRefusedOnAFall();
  void doubleClickAddsAKnot();
  void panMovesTheViewAlone();
  void wheelZoomsAtThePointer();
  void aRectangleBecomesTheView();
  void dragOnEmptySpaceSelectsThePointsInside();
  void aJumpAddedElsewhereLeavesTheSelectionAlone();
  void undoKeepsTheSelectionOnItsKnot();
  void shiftAddsAndTakesAway();
  void undoUnderARectangleKeepsTheSelectionTrue();
  void manyMoveAsOneStep();
  void manyAreNudgedAndRemovedAsOneStep();
  void alignAndDistribute();
  void aStretchGoesThroughTheClipboardAsText();
  void textThatIsNoStretchIsNone();
  void lostReleaseEndsTheDrag();
};

void ToolsTest::dragOfTactilePointIsOneExactStep() {
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  const QPointF from = rig.pixel(tactile), to = from + QPointF(25, -30);
  const QPointF wanted = rig.canvas().mapping().toPlot(to);
  rig.drag(from, to);
  QCOMPARE(rig.steps(), 1);
  const TactilePoint moved = rig.canvas().values().press.tactile.at(0);
  QVERIFY(near(moved.displacement_mm, wanted.x(), 1e-9));
  QVERIFY(near(moved.force_N, wanted.y(), 1e-9));
  QVERIFY(rig.document.history().stack().undoText().contains("Tactile point 1"));
  const Button after = rig.button();
  rig.document.history().stack().undo();
  QVERIFY(rig.button() == before);
  rig.document.history().stack().redo();
  QVERIFY(rig.button() == after);
}

// The label of a point is a handle of the point, which does not jump to the pointer.
void ToolsTest::aLabelMovesItsPoint() {
  WorkspaceRig rig(require(tactileButton()));
  rig.canvas().grab();  // labels stand where they were drawn last
  const MarkId peak{MarkKind::tactilePoint, Stroke::press, 0};
  constexpr double away_px = 20;  // label above the point
  const QPointF label = rig.pixel(peak) - QPointF(0, away_px);
  QVERIFY(rig.canvas().flagAt(label) && *rig.canvas().flagAt(label) == peak);
  rig.mouse(QEvent::MouseButtonPress, label, Qt::RightButton);  // the menu is about it
  rig.mouse(QEvent::MouseButtonRelease, label, Qt::RightButton);
  QVERIFY(rig.canvas().selected() == peak);
  const TactilePoint before = tactilePoints(rig.press(), Stroke::press).front();
  const double pxPerN = std::abs(rig.canvas().mapping().pxPerY);
  rig.drag(label, label - QPointF(0, 12), Qt::ControlModifier);
  const TactilePoint after = tactilePoints(rig.press(), Stroke::press).front();
  QVERIFY(std::abs(after.force_N - before.force_N - 12 / pxPerN) < 1e-6);
  QVERIFY(std::abs(after.displacement_mm - before.displacement_mm) < 1e-6);
  QCOMPARE(rig.steps(), 1);
}

// The arrow of a dimension line moves its contact along the travel, whatever the pointer does with the force.
void ToolsTest::aDimensionMovesItsContact() {
  WorkspaceRig rig(require(tactileButton()));
  rig.canvas().grab();
  const double before_mm = *rig.canvas().state().operatingPoint_mm;
  const StrokeCurve press = rig.press();
  constexpr double aboveAxis_px = 52;
  const QPointF arrow(rig.pixel(before_mm, 0).x(), rig.canvas().mapping().clip_px.bottom() - aboveAxis_px);
  QVERIFY(rig.canvas().flagAt(arrow) && *rig.canvas().flagAt(arrow) == operating);
  rig.drag(arrow, arrow + QPointF(20, -15), Qt::ControlModifier);
  QVERIFY(
      near(*rig.canvas().state().operatingPoint_mm, before_mm + 20 / rig.canvas().mapping().pxPerX, 1e-6));
  QVERIFY(rig.press() == press);
  QCOMPARE(rig.steps(), 1);
  rig.action("viewHandles")->trigger();
  rig.canvas().grab();
  QVERIFY(!rig.canvas().flagAt({rig.pixel(*rig.canvas().state().operatingPoint_mm, 0).x(), arrow.y()}));
}

// The hint of a drag names no key that has no effect: a slope handle snaps to nothing.
void ToolsTest::theHintOfAHandleNamesNoSnapping() {
  WorkspaceRig rig(require(tactileButton()));
  QSignalSpy said(&rig.workspace, &GraphWorkspace::statusMessage);
  rig.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, 0});
  const auto handle = slopeHandlesOf(rig.press(), 0, rig.canvas().mapping()).after_px;
  QVERIFY(handle);
  rig.press(*handle);
  rig.move(*handle + QPointF(6, -6));
  QVERIFY(rig.canvas().feedback().dragged.has_value());
  QVERIFY(said.last().front().toString().contains("Esc"));
  QVERIFY(!said.last().front().toString().contains("snapping"));
  rig.release(*handle + QPointF(6, -6));
}

// During a drag the previous curve stays visible, and the status bar explains the keys.
void ToolsTest::aDragShowsWhatItChanges() {
  WorkspaceRig rig(require(tactileButton()));
  QSignalSpy said(&rig.workspace, &GraphWorkspace::statusMessage);
  const QPointF from = rig.pixel(tactile);
  const CurvePoint start{rig.canvas().values().press.tactile.at(0).displacement_mm,
                         rig.canvas().values().press.tactile.at(0).force_N};
  const QImage still = rig.canvas().grab().toImage();
  rig.press(from);
  rig.move(from + QPointF(4, -4));
  QVERIFY(said.last().front().toString().contains("Esc"));
  QVERIFY(said.last().front().toString().contains("no snapping"));
  rig.move(from + QPointF(60, -90));
  QVERIFY(rig.canvas().feedback().draggedFrom == start);
  const auto blue = [&](const QImage& picture, QPointF at) {
    int most = 0;
    for (int y = -3; y <= 3; ++y) {
      const QColor seen = picture.pixelColor((at + QPointF(0, y)).toPoint());
      most = std::max(most, seen.blue() - seen.red());
    }
    return most;
  };
  // Left of the diamond, where the curve is seen.
  const double beside_mm = start.displacement_mm - 0.12;
  const Button& before = rig.document.history().committed();
  const QPointF old = rig.pixel(beside_mm, before.states()[0].graph.press().force_N(beside_mm));
  QVERIFY(std::abs(old.y() - rig.pixel(beside_mm, rig.press().force_N(beside_mm)).y()) > 12);
  QVERIFY(blue(still, old) > 80);
  const QImage dragged = rig.canvas().grab().toImage();
  QVERIFY2(blue(dragged, old) > 40, qPrintable(QString::number(blue(dragged, old))));
  rig.release(from + QPointF(60, -90));
  QVERIFY(!rig.canvas().feedback().draggedFrom);
  QVERIFY(blue(rig.canvas().grab().toImage(), old) < 30);
}

void ToolsTest::measuresBetweenPoints() {
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  rig.action("toolMeasure")->trigger();
  rig.drag(rig.pixel(tactile) + QPointF(3, 2), rig.pixel(valley) + QPointF(-3, 3));
  const auto peak = placeOf(tactile, rig.canvas().state(), rig.canvas().values());
  const auto low = placeOf(valley, rig.canvas().state(), rig.canvas().values());
  QVERIFY((rig.canvas().feedback().measured == Measurement{*peak, *low}));
  const QPointF free = rig.pixel(1, 0.9);
  rig.drag(free, free + QPointF(30, 0), Qt::ControlModifier);
  QVERIFY(near(rig.canvas().feedback().measured->to.displacement_mm -
                   rig.canvas().feedback().measured->from.displacement_mm,
               30 / rig.canvas().mapping().pxPerX, 1e-9));
  rig.click(rig.pixel(tactile));  // two clicks do the same
  rig.click(rig.pixel(valley));
  QVERIFY((rig.canvas().feedback().measured == Measurement{*peak, *low}));
  rig.move(free);
  QVERIFY((rig.canvas().feedback().measured == Measurement{*peak, *low}));
  QVERIFY(rig.button() == before);
  rig.action("toolSelect")->trigger();
  QVERIFY(!rig.canvas().feedback().measured);
}

// The handle of a selected knot lies on the tangent: its end is no place of the curve.
void ToolsTest::measuresTheCurveBesideASlopeHandle() {
  WorkspaceRig rig(require(tactileButton()));
  const PlotMapping map = rig.canvas().mapping();
  std::optional<QPointF> place;
  for (std::size_t i = 0; i < rig.press().knots().size() && !place; ++i) {
    const auto end = slopeHandlesOf(rig.press(), i, map).after_px;
    if (!end) continue;
    const double at_mm = map.toPlot(*end).x();
    const QPointF onCurve = map.toPixel(at_mm, rig.press().force_N(at_mm));
    const double away_px = std::abs(onCurve.y() - end->y());
    if (away_px < 1 || away_px > 6) continue;
    rig.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, i});
    place = onCurve;
  }
  QVERIFY(place);
  rig.action("toolMeasure")->trigger();
  rig.drag(*place, *place + QPointF(0, -120));
  const CurvePoint from = rig.canvas().feedback().measured->from;
  QVERIFY(near(from.force_N, rig.press().force_N(from.displacement_mm), 1e-6));
}

void ToolsTest::aMeasurementEndsWithItsGraph() {
  WorkspaceRig rig(require(selfLockingButton()));
  rig.action("toolMeasure")->trigger();
  const auto measured = [&] { return rig.canvas().feedback().measured.has_value(); };
  rig.drag({200, 200}, {260, 250}, Qt::ControlModifier);
  QVERIFY(measured());
  rig.document.setActiveState(1);
  QVERIFY(!measured());
  rig.drag({200, 200}, {260, 250}, Qt::ControlModifier);
  QVERIFY(measured());
  rig.document.history().apply(require(scaleForce(rig.button(), 2)), "twice");
  QVERIFY(!measured());
}

void ToolsTest::escapeCancelsADragExactly() {
  WorkspaceRig rig(require(clickyButton()));
  const Button before = rig.button();
  const QPointF from = rig.pixel(tactile);
  rig.press(from);
  rig.move(from + QPointF(12, -20));
  QVERIFY(!(rig.button() == before));
  QVERIFY(rig.canvas().feedback().dragged.has_value());
  rig.key(Qt::Key_Escape);
  QVERIFY(rig.button() == before);
  QCOMPARE(rig.steps(), 0);
  QVERIFY(!rig.canvas().feedback().dragged.has_value());
  rig.move(from + QPointF(40, -40));  // the button is still down: nothing more happens
  rig.release(from + QPointF(40, -40));
  QVERIFY(rig.button() == before);
  QCOMPARE(rig.steps(), 0);
}

void ToolsTest::refusedMoveStopsAtTheLimit() {
  WorkspaceRig rig(require(tactileButton()));
  QSignalSpy said(&rig.workspace, &GraphWorkspace::statusMessage);
  const QPointF from = rig.pixel(tactile);
  rig.press(from);
  rig.move(from + QPointF(10, -10));
  const double valley_mm = rig.canvas().values().press.turns[0].displacement_mm;
  rig.move(rig.pixel(3.99, 0.7));  // past the valley
  const Button limit = rig.button();
  QVERIFY(rig.canvas().values().press.tactile[0].displacement_mm < valley_mm);
  // A little before it: a flank that is left is no step.
  const double left_px =
      rig.pixel(valley_mm, 0).x() - rig.pixel(rig.canvas().values().press.tactile[0].displacement_mm, 0).x();
  QVERIFY2(left_px > 3 && left_px < 9, qPrintable(QString::number(left_px)));
  QVERIFY(near(rig.canvas().values().press.tactile[0].force_N, 0.7, 1e-3));
  QVERIFY(rig.canvas().feedback().refused->why.contains("70"));  // in the units shown, cN
  rig.move(from + QPointF(5, 10));
  rig.move(rig.pixel(3.99, 0.7));  // another path to the same place
  QVERIFY(rig.button() == limit);
  QVERIFY(rig.canvas().feedback().refused.has_value());
  QVERIFY(rig.canvas().feedback().refused->why.contains("it must stay between"));
  QVERIFY(said.last().at(0).toString().contains("it must stay between"));
  rig.move(from + QPointF(14, -14));  // back to an allowed place
  QVERIFY(!rig.canvas().feedback().refused.has_value());
  QVERIFY(said.last().at(0).toString().contains("Esc"));  // the hint of the drag
  rig.release(from + QPointF(14, -14));
  QCOMPARE(rig.steps(), 1);
  // The message names the point's new place, not the place before the drag.
  const TactilePoint moved = rig.canvas().values().press.tactile[0];
  const Mark now{{MarkKind::tactilePoint, Stroke::press, 0}, {moved.displacement_mm, moved.force_N}};
  QCOMPARE(said.last().at(0).toString(), describe(now, rig.settings.units()));
  // A step from elsewhere, such as a typed force, is reported, too.
  rig.document.history().stack().undo();
  const TactilePoint back = rig.canvas().values().press.tactile[0];
  const Mark before{now.id, {back.displacement_mm, back.force_N}};
  QCOMPARE(said.last().at(0).toString(), describe(before, rig.settings.units()));
}

void ToolsTest::undoInTheMiddleOfADragEndsIt() {
  WorkspaceRig rig(require(tactileButton()));
  const Button first = rig.button();
  rig.drag(rig.pixel(tactile), rig.pixel(tactile) + QPointF(10, -10));
  rig.press(rig.pixel(tactile));
  rig.move(rig.pixel(tactile) + QPointF(20, -20));
  rig.document.history().stack().undo();
  QVERIFY(!rig.workspace.tools().dragging());
  QVERIFY(rig.button() == first);
  rig.move(rig.pixel(tactile) + QPointF(30, -30));
  rig.release(rig.pixel(tactile));
  QVERIFY(rig.button() == first);
}

void ToolsTest::changeOfStateInTheMiddleOfADragEndsIt() {
  WorkspaceRig rig(require(selfLockingButton()));
  const Button first = rig.button();
  const QPointF from = rig.pixel(tactile);
  rig.press(from);
  rig.move(from + QPointF(6, -12));
  QVERIFY(rig.workspace.tools().dragging());
  rig.document.setActiveState(1);
  QVERIFY(!rig.workspace.tools().dragging());
  QVERIFY(rig.button() == first);
}

void ToolsTest::clickSelectsAndASecondClickTakesWhatLiesBeneath() {
  WorkspaceRig rig(require(tactileButton()));
  rig.click(rig.pixel(tactile));
  QCOMPARE(rig.canvas().selected(), std::optional(tactile));
  rig.click(rig.pixel(tactile));
  QCOMPARE(rig.canvas().selected()->kind, MarkKind::knot);
  rig.click(rig.pixel(0.2, 1.1));  // empty background
  QVERIFY(!rig.canvas().selected());
  QCOMPARE(rig.steps(), 0);
}

void ToolsTest::valleyFollowsTheHand() {
  WorkspaceRig rig(require(tactileButton()));
  const auto peak = rig.canvas().values().press.tactile.at(0);
  rig.drag(rig.pixel(valley), rig.pixel(valley) + QPointF(15, 20));
  QCOMPARE(rig.steps(), 1);
  QVERIFY(rig.canvas().values().press.turns.at(0).force_N < 0.42);
  QCOMPARE(rig.canvas().values().press.tactile.at(0).force_N, peak.force_N);
  QCOMPARE(rig.canvas().values().press.tactile.at(0).displacement_mm, peak.displacement_mm);
}

void ToolsTest::slopeHandleTurnsBothSidesOfASmoothKnot() {
  WorkspaceRig rig(require(tactileButton()));
  const MarkId knot{MarkKind::knot, Stroke::press, 2};  // the valley: level on both sides
  rig.canvas().setSelected(knot);
  const auto handles = slopeHandlesOf(rig.press(), 2, rig.canvas().mapping());
  QVERIFY(handles.after_px.has_value() && handles.before_px.has_value());
  rig.drag(*handles.after_px, *handles.after_px + QPointF(0, -12));
  QCOMPARE(rig.steps(), 1);
  const Knot now = rig.press().knots()[2];
  QVERIFY(now.slopeAfter_N_per_mm > 0);
  QCOMPARE(now.slopeBefore_N_per_mm, now.slopeAfter_N_per_mm);
  // A handle dragged past its knot has no slope to give.
  const auto turned = slopeHandlesOf(rig.press(), 2, rig.canvas().mapping());
  const Button before = rig.button();
  rig.press(*turned.after_px);
  rig.move(*turned.after_px - QPointF(120, 0));
  QVERIFY(rig.canvas().feedback().refused.has_value());
  rig.release(*turned.after_px - QPointF(120, 0));
  QVERIFY(rig.button() == before);
}

// On every segment of both strokes, in all directions: the pointer's curve passes through it or stops, and
// all knots and every other segment stay.
void ToolsTest::aDragOnASegmentBendsItBetweenItsKnots() {
  const Button before = require(tactileButton());
  WorkspaceRig rig(before);
  rig.settings.setSnap({});
  int bent = 0;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    const StrokeCurve curve = before.states()[0].graph.curve(stroke);
    for (std::size_t i = 0; i + 1 < curve.knots().size(); ++i) {
      const Knot &from = curve.knots()[i], &to = curve.knots()[i + 1];
      const double at_mm = 0.5 * (from.displacement_mm + to.displacement_mm);
      const QPointF grab = rig.pixel(at_mm, curve.force_N(at_mm));
      for (const QPointF by : {QPointF(15, 33), QPointF(-15, -33), QPointF(0, 4), QPointF(0, -4)}) {
        rig.canvas().setSelected({});
        rig.press(grab);
        const auto held = rig.canvas().selected();
        if (!held || held->kind != MarkKind::section ||
            held->stroke != stroke) {  // a mark covers the section here
          rig.release(grab);
          continue;
        }
        rig.move(grab + by);
        const StrokeCurve& now = rig.document.graph().curve(stroke);
        QCOMPARE(now.knots().size(), curve.knots().size());
        for (std::size_t k = 0; k < now.knots().size(); ++k) {
          QCOMPARE(now.knots()[k].displacement_mm, curve.knots()[k].displacement_mm);
          QCOMPARE(now.knots()[k].force_N, curve.knots()[k].force_N);
          if (k != i) QCOMPARE(now.knots()[k].slopeAfter_N_per_mm, curve.knots()[k].slopeAfter_N_per_mm);
          if (k != i + 1)
            QCOMPARE(now.knots()[k].slopeBefore_N_per_mm, curve.knots()[k].slopeBefore_N_per_mm);
        }
        QCOMPARE(now.localMaxima().size() + now.localMinima().size(),
                 curve.localMaxima().size() + curve.localMinima().size());
        if (!rig.canvas().feedback().refused) {
          ++bent;
          const double by_N = -by.y() / rig.canvas().mapping().pxPerY;
          // The grabbed place is the nearest on the curve, not exactly the one below the pointer.
          QVERIFY2(near(now.force_N(at_mm), curve.force_N(at_mm) + by_N, 0.1 * std::abs(by_N)),
                   qPrintable(QString("%1 mm: %2 N, not %3 N more")
                                  .arg(at_mm)
                                  .arg(now.force_N(at_mm) - curve.force_N(at_mm))
                                  .arg(by_N)));
        }
        rig.release(grab + by);
        rig.document.history().stack().setIndex(0);
        QVERIFY(rig.button() == before);
      }
    }
  }
  QVERIFY2(bent >= 6, qPrintable(QString::number(bent)));
}

void ToolsTest::nudgingTheCurveAddsNoPoint() {
  WorkspaceRig rig(require(tactileButton()));
  const std::size_t knots = rig.press().knots().size();
  const double end_mm = rig.press().end_mm(), peak_N = rig.canvas().values().press.tactile.at(0).force_N;
  for (std::size_t section = 0; section < rig.canvas().values().press.sections.size(); ++section) {
    rig.canvas().setSelected(MarkId{MarkKind::section, Stroke::press, section});
    for (const int key : {Qt::Key_Up, Qt::Key_Right, Qt::Key_Down, Qt::Key_Left})
      for (int i = 0; i < 15; ++i) rig.key(key, Qt::ShiftModifier);
  }
  QCOMPARE(rig.press().knots().size(), knots);
  QCOMPARE(rig.press().start_mm(), 0.0);
  QCOMPARE(rig.press().end_mm(), end_mm);
  QCOMPARE(rig.canvas().values().press.tactile.size(), std::size_t(1));
  QCOMPARE(rig.canvas().values().press.tactile[0].force_N, peak_N);
}

void ToolsTest::contactPointsKeepToTheTravel() {
  WorkspaceRig rig(require(tactileButton()));
  const QPointF from = rig.pixel(operating);
  rig.drag(from, from + QPointF(40, 5));
  QCOMPARE(rig.steps(), 1);
  const double moved = *rig.canvas().state().operatingPoint_mm;
  QVERIFY(moved > 2.0);
  rig.press(rig.pixel(operating));
  rig.move(rig.pixel(5, 0.5));  // beyond the bottom-out
  QVERIFY(rig.canvas().feedback().refused.has_value());
  QVERIFY(*rig.canvas().state().operatingPoint_mm > rig.document.graph().travel_mm() - 0.01);  // at the limit
  QVERIFY(*rig.canvas().state().operatingPoint_mm <= rig.document.graph().travel_mm());
  rig.release(rig.pixel(5, 0.5));
  QCOMPARE(rig.steps(), 2);
}

void ToolsTest::shiftKeepsToOneAxis() {
  WorkspaceRig rig(require(tactileButton()));
  const auto was = rig.canvas().values().press.tactile.at(0);
  rig.drag(rig.pixel(tactile), rig.pixel(tactile) + QPointF(6, -30), Qt::ShiftModifier);
  QCOMPARE(rig.canvas().values().press.tactile.at(0).displacement_mm, was.displacement_mm);
  QVERIFY(rig.canvas().values().press.tactile.at(0).force_N > was.force_N);
}

void ToolsTest::snapsToGridAndShowsIt() {
  WorkspaceRig rig(require(tactileButton()));
  SnapSettings snap;
  snap.toGrid = true;
  snap.gridLength_mm = 0.1;
  snap.gridForce_N = 0.05;
  snap.within_px = 60;
  rig.settings.setSnap(snap);
  const QPointF from = rig.pixel(tactile), to = rig.pixel(1.387, 0.613);
  rig.press(from);
  rig.move(to);
  QVERIFY(rig.canvas().feedback().snap.has_value());
  QCOMPARE(rig.canvas().feedback().snap->kind, SnapKind::grid);
  rig.release(to);
  QVERIFY(near(rig.canvas().values().press.tactile.at(0).displacement_mm, 1.4, 1e-12));
  QVERIFY(near(rig.canvas().values().press.tactile.at(0).force_N, 0.6, 1e-12));
}

void ToolsTest::snapsToTheOtherStroke() {
  WorkspaceRig rig(require(tactileButton()));
  SnapSettings snap;
  snap.toOtherStroke = true;
  rig.settings.setSnap(snap);
  const MarkId hump{MarkKind::turn, Stroke::release, 0};
  const double on_mm = 1.0, on_N = rig.press().force_N(on_mm);
  rig.press(rig.pixel(hump));
  rig.move(rig.pixel(on_mm, on_N) + QPointF(1, 4));
  QVERIFY(rig.canvas().feedback().snap.has_value());
  QCOMPARE(rig.canvas().feedback().snap->kind, SnapKind::otherStroke);
  const CurvePoint at = rig.canvas().feedback().snap->at;
  QVERIFY(near(at.force_N, rig.press().force_N(at.displacement_mm), 1e-12));
  rig.release(rig.pixel(on_mm, on_N));
}

void ToolsTest::controlLetsGoOfTheGrid() {
  WorkspaceRig rig(require(tactileButton()));
  SnapSettings snap;
  snap.toGrid = true;
  snap.within_px = 60;
  rig.settings.setSnap(snap);
  const QPointF to = rig.pixel(1.387, 0.613);
  rig.drag(rig.pixel(tactile), to, Qt::ControlModifier);
  QVERIFY(near(rig.canvas().values().press.tactile.at(0).displacement_mm, 1.387, 1e-9));
}

void ToolsTest::arrowKeysNudgeInOneStep() {
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  const auto was = rig.canvas().values().press.tactile.at(0);
  rig.click(rig.pixel(tactile));
  for (int i = 0; i < 5; ++i) rig.key(Qt::Key_Right);
  rig.key(Qt::Key_Up);
  QCOMPARE(rig.steps(), 1);
  const auto now = rig.canvas().values().press.tactile.at(0);
  QVERIFY(near(now.displacement_mm, was.displacement_mm + 0.05, 1e-12));
  QVERIFY(near(now.force_N, was.force_N + 0.001, 1e-12));
  rig.document.history().stack().undo();
  QVERIFY(rig.button() == before);
}

void ToolsTest::arrowKeysWithShiftAndAlt() {
  WorkspaceRig rig(require(tactileButton()));
  const auto was = rig.canvas().values().press.tactile.at(0);
  rig.click(rig.pixel(tactile));
  rig.key(Qt::Key_Up, Qt::ShiftModifier);
  QVERIFY(near(rig.canvas().values().press.tactile.at(0).force_N, was.force_N + 0.01, 1e-12));
  rig.key(Qt::Key_Left, Qt::AltModifier);
  QVERIFY(
      near(rig.canvas().values().press.tactile.at(0).displacement_mm, was.displacement_mm - 0.001, 1e-12));
}

void ToolsTest::tabSelectsEachPointInTurn() {
  WorkspaceRig rig(require(tactileButton()));
  const std::size_t points = pointMarks(rig.canvas().state(), rig.canvas().values()).size();
  std::vector<MarkId> seen;
  for (std::size_t i = 0; i < points; ++i) {
    rig.key(Qt::Key_Tab);
    QVERIFY(rig.canvas().selected().has_value());
    QVERIFY(std::find(seen.begin(), seen.end(), *rig.canvas().selected()) == seen.end());
    seen.push_back(*rig.canvas().selected());
    QVERIFY(rig.canvas().accessibleName().contains(nameOf(seen.back())));
  }
  rig.key(Qt::Key_Backtab);
  QVERIFY(*rig.canvas().selected() == seen[points - 2]);
}

void ToolsTest::deleteRemovesKnotAndJump() {
  WorkspaceRig rig(require(tactileButton()));
  rig.click(rig.pixel(tactile));
  rig.key(Qt::Key_Delete);
  QVERIFY(rig.canvas().values().press.tactile.empty());
  QCOMPARE(rig.steps(), 1);
  rig.document.history().stack().undo();
  const std::size_t knots = rig.press().knots().size();
  rig.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, 2});
  rig.key(Qt::Key_Delete);
  QCOMPARE(rig.press().knots().size(), knots - 1);
  rig.canvas().setSelected(operating);
  rig.action("editDelete")->trigger();
  QVERIFY(!rig.canvas().state().operatingPoint_mm);
}

void ToolsTest::insertAddsAKnotHalfway() {
  WorkspaceRig rig(require(linearButton()));
  const StrokeCurve before = rig.press();
  rig.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, 0});
  rig.key(Qt::Key_Insert);
  QCOMPARE(rig.press().knots().size(), before.knots().size() + 1);
  QVERIFY(near(rig.press().knots()[1].displacement_mm, 0.5 * before.knots()[1].displacement_mm, 1e-12));
  QCOMPARE(rig.canvas().selected()->index, std::size_t(1));
}

void ToolsTest::slopeHandlesByKeys() {
  WorkspaceRig rig(require(tactileButton()));
  rig.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, 0});
  rig.key(Qt::Key_S);
  QCOMPARE(rig.canvas().selected()->kind, MarkKind::slopeAfter);  // the first knot has no piece before it
  const double was = rig.press().knots()[0].slopeAfter_N_per_mm;
  rig.key(Qt::Key_Up, Qt::ShiftModifier);
  rig.key(Qt::Key_Up, Qt::ShiftModifier);
  QVERIFY(near(rig.press().knots()[0].slopeAfter_N_per_mm, was + 0.02, 1e-12));
  QCOMPARE(rig.steps(), 1);
}

void ToolsTest::cornerToggles() {
  WorkspaceRig rig(require(tactileButton()));
  rig.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, 1});
  QVERIFY(!isCorner(rig.press(), 1));
  rig.key(Qt::Key_C);
  QVERIFY(isCorner(rig.press(), 1));
  rig.key(Qt::Key_C);
  QVERIFY(!isCorner(rig.press(), 1));
  QCOMPARE(rig.steps(), 2);
}

void ToolsTest::addKnotKeepsTheShape() {
  WorkspaceRig rig(require(tactileButton()));
  const StrokeCurve before = rig.press();
  rig.action("toolAddKnot")->trigger();
  QCOMPARE(rig.workspace.tools().tool(), ToolKind::addKnot);
  rig.click(rig.pixel(0.6, before.force_N(0.6)) + QPointF(0, -6));
  QCOMPARE(rig.steps(), 1);
  QCOMPARE(rig.press().knots().size(), before.knots().size() + 1);
  for (double x = 0; x < 4; x += 0.05) QVERIFY(near(rig.press().force_N(x), before.force_N(x), 1e-12));
  QCOMPARE(rig.canvas().selected()->kind, MarkKind::knot);
}

void ToolsTest::addKnotDragsOn() {
  WorkspaceRig rig(require(linearButton()));
  rig.action("toolAddKnot")->trigger();
  const QPointF on = rig.pixel(2, rig.press().force_N(2));
  const double up_N = 30 / rig.canvas().mapping().pxPerY;
  const double was = rig.press().force_N(2);
  rig.drag(on, on + QPointF(0, -30));
  QCOMPARE(rig.steps(), 1);
  QVERIFY(near(rig.press().force_N(2), was + up_N, 2e-3));
}

void ToolsTest::addJumpByClickAndByDrag() {
  WorkspaceRig rig(require(linearButton()));
  const Button before = rig.button();
  rig.action("toolAddJump")->trigger();
  const QPointF on = rig.pixel(1.5, rig.press().force_N(1.5));
  rig.click(on);
  QCOMPARE(rig.canvas().values().press.tactile.size(), std::size_t(1));
  QVERIFY(near(rig.canvas().values().press.tactile[0].displacement_mm, 1.5, 0.02));
  rig.document.history().stack().undo();
  QVERIFY(rig.button() == before);
  const QPointF pulled = rig.pixel(1.9, 0.3);
  rig.drag(on, pulled);
  QCOMPARE(rig.steps(), 1);
  QCOMPARE(rig.canvas().values().press.turns.size(), std::size_t(1));
  QVERIFY(near(rig.canvas().values().press.turns[0].displacement_mm, 1.9, 0.02));
  QVERIFY(near(rig.canvas().values().press.turns[0].force_N, 0.3, 0.01));
}

void ToolsTest::addJumpIsRefusedOnAFall() {
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  rig.action("toolAddJump")->trigger();
  const QPointF on = rig.pixel(1.6, rig.press().force_N(1.6));
  rig.press(on);
  QVERIFY(rig.canvas().feedback().refused.has_value());
  rig.release(on);
  QVERIFY(rig.button() == before);
  QCOMPARE(rig.steps(), 0);
}

void ToolsTest::doubleClickAddsAKnot() {
  WorkspaceRig rig(require(tactileButton()));
  const std::size_t knots = rig.press().knots().size();
  const QPointF on = rig.pixel(3, rig.press().force_N(3));
  rig.click(on);
  rig.mouse(QEvent::MouseButtonDblClick, on, Qt::LeftButton);
  rig.release(on);
  QCOMPARE(rig.press().knots().size(), knots + 1);
  QCOMPARE(rig.steps(), 1);
}

void ToolsTest::panMovesTheViewAlone() {
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  const QRectF shown = rig.canvas().shownRange();
  rig.action("toolPan")->trigger();
  rig.drag(rig.pixel(tactile), rig.pixel(tactile) + QPointF(50, 20));
  QVERIFY(rig.button() == before);
  const double by_mm = 50 / rig.canvas().mapping().pxPerX;
  QVERIFY(near(rig.canvas().shownRange().left(), shown.left() - by_mm, 1e-9));
}

void ToolsTest::wheelZoomsAtThePointer() {
  WorkspaceRig rig(require(tactileButton()));
  const QPointF at = rig.pixel(1.0, 0.5);
  QWheelEvent wheel(at, rig.canvas().mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  const double before = rig.canvas().shownRange().width();
  QCoreApplication::sendEvent(&rig.canvas(), &wheel);
  QVERIFY(near(rig.canvas().shownRange().width(), before / (1.25 * 1.25), 1e-9));
  const QPointF still = rig.canvas().mapping().toPlot(at);
  QVERIFY(near(still.x(), 1.0, 1e-9) && near(still.y(), 0.5, 1e-9));
  rig.action("viewFit")->trigger();
  QVERIFY(near(rig.canvas().shownRange().width(), before, 1e-9));
}

void ToolsTest::dragOnEmptySpaceSelectsThePointsInside() {
  WorkspaceRig rig(require(tactileButton()));
  const QRectF shown = rig.canvas().shownRange();
  const QRectF range = rig.canvas().mapping().clip_px;
  rig.drag(range.topLeft() + QPointF(3, 3), range.bottomRight() - QPointF(3, 3));
  QCOMPARE(rig.canvas().shownRange(), shown);
  QCOMPARE(rig.canvas().selection().size(), allPoints(rig.canvas().state()).size());
  QCOMPARE(rig.steps(), 0);
  const QPointF knot = rig.pixel(rig.press().knots()[1].displacement_mm, rig.press().knots()[1].force_N);
  // From below: above the point stands its label, which takes a drag.
  rig.drag(knot + QPointF(-14, 14), knot + QPointF(14, -14));
  QVERIFY(rig.canvas().isSelected({MarkKind::knot, Stroke::press, 1}));
  QVERIFY(rig.canvas().selection().size() < allPoints(rig.canvas().state()).size());
}

// The selection is a knot, not a number in a list.
void ToolsTest::aJumpAddedElsewhereLeavesTheSelectionAlone() {
  WorkspaceRig rig(require(linearButton()));
  rig.document.history().apply(require(addKnot(rig.button(), 0, Stroke::press, 3.1)), "Add curve point");
  const auto index = knotAt(rig.press(), 3.1);
  QVERIFY(index.has_value());
  rig.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, *index});
  rig.document.history().apply(require(addJumpAt(rig.button(), 0, Stroke::press, {1.0, 0.5, 0.1})),
                               "Add jump");
  QVERIFY(rig.canvas().selected().has_value());
  QVERIFY(rig.canvas().selected()->index > *index);
  QCOMPARE(rig.press().knots()[rig.canvas().selected()->index].displacement_mm, 3.1);
  rig.document.history().stack().undo();
  QCOMPARE(rig.press().knots()[rig.canvas().selected()->index].displacement_mm, 3.1);
  rig.document.history().apply(
      require(removeMark(rig.button(), 0, MarkId{MarkKind::knot, Stroke::press, *knotAt(rig.press(), 3.1)})),
      "Remove");
  QVERIFY(!rig.canvas().selected());
}

void ToolsTest::undoKeepsTheSelectionOnItsKnot() {
  WorkspaceRig rig(require(tactileButton()));
  const std::size_t last = rig.press().knots().size() - 2;
  const double at = rig.press().knots()[last].displacement_mm;
  rig.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, last});
  rig.document.history().apply(require(addKnot(rig.button(), 0, Stroke::press, 0.1)), "Add curve point");
  QCOMPARE(rig.press().knots()[rig.canvas().selected()->index].displacement_mm, at);
  rig.document.history().stack().undo();
  QCOMPARE(rig.canvas().selected()->index, last);
}

void ToolsTest::shiftAddsAndTakesAway() {
  WorkspaceRig rig(require(tactileButton()));
  const MarkId first{MarkKind::knot, Stroke::press, 0};
  const auto shiftClick = [&](const MarkId& mark) {
    rig.press(rig.pixel(mark), Qt::ShiftModifier);
    rig.release(rig.pixel(mark));
  };
  rig.canvas().setSelected(first);
  shiftClick(tactile);
  QCOMPARE(rig.canvas().selection().size(), std::size_t(2));
  QCOMPARE(rig.canvas().selected()->kind, MarkKind::knot);  // the one under the tactile point
  shiftClick(tactile);
  QCOMPARE(rig.canvas().selection(), std::vector{first});
  rig.key(Qt::Key_Escape);
  QVERIFY(rig.canvas().selection().empty());
}

// With the mouse held on the empty background the keys still work: the rectangle adds to the same knots
// afterwards.
void ToolsTest::undoUnderARectangleKeepsTheSelectionTrue() {
  WorkspaceRig rig(require(tactileButton()));
  const std::size_t knots = rig.press().knots().size();
  const Button more = require(editGraph(rig.button(), 0, [](const ForceGraph& graph) {
    return editStroke(graph, Stroke::press, [](const StrokeCurve& curve) { return insertKnot(curve, 0.05); });
  }));
  rig.document.history().apply(more, "Add curve point");
  const MarkId added{MarkKind::knot, Stroke::press, 1}, last{MarkKind::knot, Stroke::press, knots};
  rig.canvas().setSelection({added, last});
  const QPointF emptySpot(60, 60);
  rig.press(emptySpot, Qt::ShiftModifier);
  rig.document.history().stack().undo();
  rig.move(emptySpot + QPointF(12, 9), Qt::ShiftModifier);
  QCOMPARE(rig.canvas().selection(), (std::vector{MarkId{MarkKind::knot, Stroke::press, knots - 1}}));
  rig.release(emptySpot + QPointF(12, 9));
  // Marks that name nothing are not selected, and no edit takes them for something.
  rig.canvas().setSelection({last, {MarkKind::knot, Stroke::press, 0}});
  QCOMPARE(rig.canvas().selection().size(), std::size_t{1});
  for (const auto& refused :
       {moveSelection(rig.button(), 0, {last}, 0.1, 0.1), removeSelection(rig.button(), 0, {last}),
        alignSelection(rig.button(), 0, {last, last}, GraphDirection::force)})
    QVERIFY(!refused.ok());
}

void ToolsTest::manyMoveAsOneStep() {
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  const std::vector<Knot> knots = rig.press().knots();
  rig.canvas().setSelection({{MarkKind::knot, Stroke::press, 1}, {MarkKind::knot, Stroke::press, 2}});
  const QPointF from = rig.pixel(knots[2].displacement_mm, knots[2].force_N), to = from + QPointF(0, -40);
  const double by_N = 40 / rig.canvas().mapping().pxPerY;
  rig.drag(from, to, Qt::ShiftModifier);
  QCOMPARE(rig.steps(), 1);
  QCOMPARE(rig.canvas().selection().size(), std::size_t(2));
  for (const std::size_t i : {1u, 2u}) {
    QVERIFY(near(rig.press().knots()[i].force_N, knots[i].force_N + by_N, 1e-9));
    QCOMPARE(rig.press().knots()[i].displacement_mm, knots[i].displacement_mm);
  }
  QVERIFY(rig.press().knots()[0] == knots[0]);
  rig.document.history().stack().undo();
  QVERIFY(rig.button() == before);
}

void ToolsTest::manyAreNudgedAndRemovedAsOneStep() {
  WorkspaceRig rig(require(tactileButton()));
  const std::vector<Knot> knots = rig.press().knots();
  rig.canvas().setSelection({{MarkKind::knot, Stroke::press, 1}, {MarkKind::knot, Stroke::press, 2}});
  for (int i = 0; i < 3; ++i) rig.key(Qt::Key_Up);
  QCOMPARE(rig.steps(), 1);
  for (const std::size_t i : {1u, 2u})
    QVERIFY(near(rig.press().knots()[i].force_N, knots[i].force_N + 0.003, 1e-9));
  rig.key(Qt::Key_Delete);
  QCOMPARE(rig.steps(), 2);
  QCOMPARE(rig.press().knots().size(), knots.size() - 2);
  QVERIFY(rig.canvas().selection().empty());
  // Not all knots can be removed: nothing changes, and a message says so.
  rig.action("editSelectAll")->trigger();
  const Button left = rig.button();
  rig.key(Qt::Key_Delete);
  QVERIFY(rig.button() == left);
}

void ToolsTest::aRectangleBecomesTheView() {
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  const QRectF all = rig.canvas().shownRange();
  rig.action("toolZoom")->trigger();
  const QPointF from = rig.pixel(1.0, 0.6), to = rig.pixel(2.0, 0.2);
  rig.press(from);
  rig.move(0.5 * (from + to));
  QVERIFY(rig.canvas().feedback().band_px.has_value());
  rig.move(to);
  rig.release(to);
  QVERIFY(!rig.canvas().feedback().band_px);
  const QRectF near_ = rig.canvas().shownRange();
  QVERIFY(near(near_.left(), 1, 1e-9) && near(near_.right(), 2, 1e-9));
  QVERIFY(near(near_.top(), 0.2, 1e-9) && near(near_.bottom(), 0.6, 1e-9));
  rig.press(rig.pixel(1.2, 0.3));
  QTest::keyClick(&rig.canvas(), Qt::Key_V);  // the tool is left in the middle of a drag
  rig.release(rig.pixel(1.8, 0.5));
  QCOMPARE(rig.canvas().shownRange(), near_);
  rig.action("toolZoom")->trigger();
  rig.click(rig.canvas().mapping().clip_px.center());
  QVERIFY(near(rig.canvas().shownRange().width(), 0.5 * near_.width(), 1e-9));
  rig.press(rig.canvas().mapping().clip_px.center(), Qt::ShiftModifier);
  rig.mouse(QEvent::MouseButtonRelease, rig.canvas().mapping().clip_px.center(), Qt::LeftButton,
            Qt::ShiftModifier);
  QVERIFY(near(rig.canvas().shownRange().width(), near_.width(), 1e-9));
  rig.action("viewFit")->trigger();
  QCOMPARE(rig.canvas().shownRange(), all);
  QVERIFY(rig.button() == before);
}

void ToolsTest::alignAndDistribute() {
  WorkspaceRig rig(require(linearButton()));
  for (const double x : {0.5, 0.7, 2.0})
    rig.document.history().apply(require(addKnot(rig.button(), 0, Stroke::press, x)), "Add");
  std::vector<MarkId> marks;
  for (const double x : {0.5, 0.7, 2.0})
    marks.push_back({MarkKind::knot, Stroke::press, *knotAt(rig.press(), x)});
  rig.canvas().setSelection(marks);
  QVERIFY(rig.action("editDistributeDisplacement")->isEnabled());
  rig.action("editDistributeDisplacement")->trigger();
  QVERIFY(near(rig.press().knots()[marks[1].index].displacement_mm, 1.25, 1e-12));
  const double level = rig.press().knots()[marks[2].index].force_N;
  rig.action("editAlignForce")->trigger();
  for (const MarkId& mark : marks) QCOMPARE(rig.press().knots()[mark.index].force_N, level);
  const Button aligned = rig.button();
  rig.action("editAlignDisplacement")->trigger();  // three knots at one displacement: refused or a rise
  QVERIFY(rig.press().knots().size() == aligned.states()[0].graph.press().knots().size());
  rig.canvas().setSelected(marks[0]);
  QVERIFY(!rig.action("editAlignForce")->isEnabled());
}

void ToolsTest::aStretchGoesThroughTheClipboardAsText() {
  QLocale::setDefault(QLocale("de_DE"));
  WorkspaceRig from(require(tactileButton())), to(require(linearButton()));
  from.canvas().setSelected(MarkId{MarkKind::section, Stroke::press, 1});
  const GraphStretch stretch =
      stretchOfMarks(from.canvas().selection(), from.canvas().state(), from.canvas().values());
  QVERIFY(stretch.press.size() >= 2 && stretch.release.empty());
  const auto back = stretchFrom(textOf(stretch));
  QVERIFY(back.has_value());
  QVERIFY(*back == stretch);  // bit for bit
  from.action("editCopy")->trigger();
  QVERIFY(stretchFrom(QApplication::clipboard()->text()) == stretch);
  to.workspace.paste(stretch);
  QCOMPARE(to.steps(), 2 - 1);
  for (double x = stretch.press.front().displacement_mm; x <= stretch.press.back().displacement_mm; x += 0.01)
    QVERIFY(near(to.press().force_N(x), from.press().force_N(x), 1e-9));
  QCOMPARE(to.canvas().selection().size(), stretch.press.size());
  // Cut is copy and remove.
  from.canvas().setSelected(MarkId{MarkKind::knot, Stroke::press, 1});
  const std::size_t knots = from.press().knots().size();
  from.action("editCut")->trigger();
  QCOMPARE(from.press().knots().size(), knots - 1);
  QVERIFY(stretchFrom(QApplication::clipboard()->text()).has_value());
  QLocale::setDefault(QLocale::c());
}

void ToolsTest::textThatIsNoStretchIsNone() {
  const QString header = textOf({{Knot{1, 1, 0, 0}}, {}}).section('\n', 0, 0);
  for (const QString& text :
       {QString(), QString("words"), header, header + "\npress,1,2,3", header + "\npress,1,2,3,nan",
        header + "\npress,1,2,3,4,5", header + "\nsideways,1,2,3,4",
        QString("stroke,displacement_mm,force_N\npress,1,2")})
    QVERIFY2(!stretchFrom(text), qPrintable(text));
  QVERIFY(stretchFrom(header + "\r\npress,1,2,3,4\r\n").has_value());
}

void ToolsTest::lostReleaseEndsTheDrag() {
  WorkspaceRig rig(require(tactileButton()));
  const QPointF from = rig.pixel(tactile);
  rig.press(from);
  rig.move(from + QPointF(10, -10));
  const Button dragged = rig.button();
  rig.down = Qt::NoButton;  // the mouse is released outside the canvas
  rig.move(from + QPointF(60, -60));
  QVERIFY(!rig.workspace.tools().dragging());
  QVERIFY(rig.button() == dragged);
  QCOMPARE(rig.steps(), 1);
}

DETENT_WINDOW_TEST(ToolsTest)
#include "tools_test.moc"
