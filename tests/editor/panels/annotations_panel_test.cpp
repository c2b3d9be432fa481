// SPDX-License-Identifier: GPL-3.0-or-later
// Pins, notes, versions and links, judged by the button.
#include "editor/panels/annotations_panel.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include "editor/quantity/quantity_field.h"
#include "model/edits.h"
#include "model/sections.h"
#include "tests/editor/window_tests.h"
#include "tests/editor/workspace_rig.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::editor::tests;

namespace {

constexpr MarkId tactile{MarkKind::tactilePoint, Stroke::press, 0};

void type(QWidget* into, const QString& text) {
  QTest::keyClick(into, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(into, text);
}

TactilePoint peakOf(const WorkspaceRig& rig) {
  return tactilePoints(rig.document.graph().press(), Stroke::press).front();
}

double meanDistance_N(const WorkspaceRig& rig) {
  const StrokeCurve &press = rig.document.graph().press(), &release = *rig.document.graph().release();
  const double from_mm = std::max(press.start_mm(), release.start_mm()),
               to_mm = std::min(press.end_mm(), release.end_mm());
  return (press.area_mJ(from_mm, to_mm) - release.area_mJ(from_mm, to_mm)) / (to_mm - from_mm);
}

}  // namespace

class AnnotationsPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void aPinnedPointIsMovedByNothing();
  void notesStandOnTheCurveAndVersionsComeBack();
  void linksActOnLaterEditsOnly();
  void theOffsetOfferedIsThatOfTheStrokes();
  void undoInAnEmptyFieldIsTheButtons();
};

void AnnotationsPanelTest::aPinnedPointIsMovedByNothing() {
  WorkspaceRig rig(require(tactileButton()));
  rig.canvas().setSelected(tactile);
  rig.key(Qt::Key_P);
  QCOMPARE(rig.document.annotations().links.pinned.size(), std::size_t(1));
  const Button before = rig.button();
  rig.key(Qt::Key_Up);
  QVERIFY(rig.button() == before);
  rig.drag(rig.pixel(tactile), rig.pixel(tactile) + QPointF(0, -40));
  QVERIFY(rig.button() == before);
  rig.document.history().apply(require(scaleForce(before, 1.1)), "Scale force");
  QVERIFY(rig.button() == before);
  rig.canvas().setSelected(tactile);
  rig.key(Qt::Key_P);
  rig.key(Qt::Key_Up);
  QVERIFY(!(rig.button() == before));
}

void AnnotationsPanelTest::notesStandOnTheCurveAndVersionsComeBack() {
  WorkspaceRig rig(require(tactileButton()));
  AnnotationsPanel panel(rig.document, rig.settings, rig.canvas());
  const Button first = rig.button();
  rig.canvas().setSelected(tactile);
  auto* text = panel.findChild<QLineEdit*>("noteText");
  const QImage before = rig.canvas().grab().toImage();
  QTest::keyClicks(text, "unit 7: 57 cN");
  QTest::keyClick(text, Qt::Key_Return);
  QCOMPARE(rig.document.annotations().notes.size(), std::size_t(1));
  QCOMPARE(rig.document.annotations().notes[0].displacement_mm, 1.3);
  QVERIFY(!(rig.canvas().grab().toImage() == before));  // the note is drawn
  auto* name = panel.findChild<QLineEdit*>("versionName");
  QTest::keyClicks(name, "first");
  QTest::keyClick(name, Qt::Key_Return);
  rig.document.history().apply(require(scaleForce(first, 1.5)), "Scale force");
  auto* versions = panel.findChild<QTreeWidget*>("versionsList");
  versions->setCurrentItem(versions->topLevelItem(0));
  panel.findChild<QPushButton*>("versionGoBack")->click();
  QVERIFY(rig.button() == first);
  QTest::keyClicks(name, "first");  // taken
  QTest::keyClick(name, Qt::Key_Return);
  QCOMPARE(rig.document.annotations().versions.size(), std::size_t(1));
  while (rig.document.history().stack().canUndo()) rig.document.history().stack().undo();
  QVERIFY(rig.document.annotations().empty());
}

void AnnotationsPanelTest::linksActOnLaterEditsOnly() {
  const Button measured = require(tactileButton());
  WorkspaceRig rig(measured);
  AnnotationsPanel panel(rig.document, rig.settings, rig.canvas());
  auto* const offset = panel.findChild<QuantityField*>("linkOffset");
  QVERIFY(!offset->isEnabled());
  for (const char* name : {"linkRelease", "linkOneEnd"}) {
    auto* const box = panel.findChild<QCheckBox*>(name);
    box->click();
    QVERIFY(rig.button() == measured);
    box->click();
    QVERIFY(rig.button() == measured);
    QVERIFY(rig.document.annotations().empty());
  }
  rig.document.history().stack().setIndex(0);
  panel.findChild<QCheckBox*>("linkRelease")->click();
  QCOMPARE(rig.steps(), 1);
  QVERIFY(offset->isEnabled());
  // Typing the shown value again changes nothing.
  type(offset, qPrintable(offset->text()));
  QTest::keyClick(offset, Qt::Key_Return);
  QVERIFY(rig.button() == measured);
  // Another distance is an edit of its own: the whole release goes down by the difference.
  const double now_N = meanDistance_N(rig), by_N = 0.12 - now_N;
  type(offset, "0.12 N");
  QTest::keyClick(offset, Qt::Key_Return);
  QCOMPARE(rig.steps(), 2);
  const auto release_N = [&](double at_mm) { return rig.document.graph().release()->force_N(at_mm); };
  QVERIFY(std::abs(release_N(2) - measured.states()[0].graph.release()->force_N(2) + by_N) < 1e-9);
  QVERIFY(std::abs(meanDistance_N(rig) - 0.12) < 1e-9);
  QVERIFY(rig.press() == measured.states()[0].graph.press());
  const StrokeCurve before = *rig.document.graph().release();
  rig.drag(rig.pixel(tactile), rig.pixel(tactile) + QPointF(10, -30));
  QVERIFY(peakOf(rig).force_N > 0.56);
  QVERIFY(!(*rig.document.graph().release() == before));
  QCOMPARE(rig.document.graph().release()->knots().size(), before.knots().size());
  while (rig.document.history().stack().canUndo()) rig.document.history().stack().undo();
  QVERIFY(rig.button() == measured && rig.document.annotations().empty());
  QVERIFY(!panel.findChild<QCheckBox*>("linkRelease")->isChecked());
}

// Offered is how far the release lies below the press as it is, in the person's unit with two digits.
void AnnotationsPanelTest::theOffsetOfferedIsThatOfTheStrokes() {
  WorkspaceRig rig(require(tactileButton()));
  rig.settings.setUnits({LengthUnit::millimetre, ForceUnit::gramForce});
  const AnnotationsPanel panel(rig.document, rig.settings, rig.canvas());
  auto* const offset = panel.findChild<QuantityField*>("linkOffset");
  const double offered_N = offset->value();
  QVERIFY2(std::abs(offered_N - meanDistance_N(rig)) < 1e-3 * offered_N,
           qPrintable(QString::number(offered_N)));
  const double offered_gf = offered_N / 0.00980665, step = offered_gf < 10 ? 0.001 : 0.01;
  QVERIFY(std::abs(offered_gf / step - std::round(offered_gf / step)) < 1e-6);

  rig.canvas().setSelected(tactile);
  for (int i = 0; i < 40; ++i) rig.key(Qt::Key_Up);
  QVERIFY(offset->value() > offered_N);  // the offset of the present strokes
  panel.findChild<QCheckBox*>("linkRelease")->click();
  const double linked_N = offset->value();
  rig.document.history().apply(
      require(editGraph(rig.button(), 0,
                        [](const ForceGraph& graph) {
                          return editStroke(graph, Stroke::release,
                                            [](const StrokeCurve& curve) { return scaleForce(curve, 0.9); });
                        })),
      "Scale");
  QVERIFY(offset->value() > linked_N);  // an edit of the release itself shows, too
}

// Undo in a field that holds nothing to take back is meant for the button.
void AnnotationsPanelTest::undoInAnEmptyFieldIsTheButtons() {
  WorkspaceRig rig(require(tactileButton()));
  rig.canvas().setSelected(tactile);  // displacement of the note
  AnnotationsPanel panel(rig.document, rig.settings, rig.canvas());
  const auto takes = [](QLineEdit& field, Qt::Key key) {
    QKeyEvent shortcut(QEvent::ShortcutOverride, key, Qt::ControlModifier);
    shortcut.ignore();
    QCoreApplication::sendEvent(&field, &shortcut);
    return shortcut.isAccepted();
  };
  for (const char* name : {"noteText", "versionName"}) {
    auto& field = *panel.findChild<QLineEdit*>(name);
    QVERIFY(!takes(field, Qt::Key_Z));
    QTest::keyClicks(&field, "ab");
    QVERIFY(takes(field, Qt::Key_Z));
    QTest::keyClick(&field, Qt::Key_Return);
    QVERIFY(!takes(field, Qt::Key_Z));
    QVERIFY(takes(field, Qt::Key_A));
  }
}

DETENT_WINDOW_TEST(AnnotationsPanelTest)
#include "annotations_panel_test.moc"
