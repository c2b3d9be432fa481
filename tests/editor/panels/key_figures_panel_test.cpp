// SPDX-License-Identifier: GPL-3.0-or-later
// The key figures, typed, kept and wanted, judged by the button.
#include "editor/panels/key_figures_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <set>

#include "editor/panels/figure_drawing.h"
#include "editor/panels/key_figures_model.h"
#include "model/edits.h"
#include "tests/editor/workspace_rig.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::editor::tests;

namespace {

constexpr double gramForce_N = 0.00980665;

QModelIndex cell(KeyFiguresModel& model, KeyFigure figure, int column) {
  return model.index(static_cast<int>(figure), column);
}

double valueOf(const WorkspaceRig& rig, KeyFigure figure) {
  return keyFiguresOf(rig.button().states()[0])[figure].value();
}

Button tactile() {
  return require(setResetPoint(require(setOperatingPoint(require(tactileButton()), 0, 1.6)), 0, 1.2));
}

}  // namespace

class KeyFiguresPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void aTypedFigureIsOneStepAndMovesNothingElse();
  void whatIsKeptStays();
  void whatIsWantedIsShownBeforeItIsTaken();
  void contradictionsAreNamed();
  void figuresTheButtonLacksCannotBeTyped();
  void whatIsShownIsWhatCanBeTyped();
  void everyFigureHasItsOwnPicture();
  void undoAndHandsKeepTheTableTrue();
};

void KeyFiguresPanelTest::aTypedFigureIsOneStepAndMovesNothingElse() {
  WorkspaceRig rig(tactile());
  rig.settings.setUnits({LengthUnit::millimetre, ForceUnit::gramForce});
  KeyFiguresPanel panel(rig.document, rig.settings);
  const KeyFigures before = keyFiguresOf(rig.button().states()[0]);
  QVERIFY(panel.model().setData(cell(panel.model(), KeyFigure::peakForce, KeyFiguresModel::now), "+12 gf",
                                Qt::EditRole));
  QCOMPARE(rig.steps(), 1);
  const KeyFigures after = keyFiguresOf(rig.button().states()[0]);
  using enum KeyFigure;
  QVERIFY(std::abs(*after[peakForce] - *before[peakForce] - 12 * gramForce_N) < 1e-6);
  for (const KeyFigure other : {initialForce, peakTravel, valleyForce, valleyTravel, bottomOutForce,
                                bottomOutTravel, totalTravel, endForce, preTravel, resetTravel, resetForce})
    QVERIFY2(std::abs(*after[other] - *before[other]) < 1e-9, qPrintable(termOf(other)));
  rig.document.history().stack().undo();
  QCOMPARE(valueOf(rig, peakForce), *before[peakForce]);
}

void KeyFiguresPanelTest::whatIsKeptStays() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  using enum KeyFigure;
  const double drop_N = valueOf(rig, drop), operating_N = valueOf(rig, operatingForce);
  for (const KeyFigure kept : {drop, operatingForce, preTravel})
    QVERIFY(model.setData(cell(model, kept, KeyFiguresModel::keep), Qt::Checked, Qt::CheckStateRole));
  QVERIFY(model.setData(cell(model, peakForce, KeyFiguresModel::now), "+5 %", Qt::EditRole));
  QVERIFY(std::abs(valueOf(rig, drop) - drop_N) < 1e-5);
  QVERIFY(std::abs(valueOf(rig, operatingForce) - operating_N) < 1e-5);
}

void KeyFiguresPanelTest::whatIsWantedIsShownBeforeItIsTaken() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  QSignalSpy looked(&model, &KeyFiguresModel::previewChanged);
  using enum KeyFigure;
  const Button before = rig.button();
  QVERIFY(model.setData(cell(model, snapRatio, KeyFiguresModel::wanted), "40 %", Qt::EditRole));
  QVERIFY(model.setData(cell(model, totalTravel, KeyFiguresModel::wanted), "3.6 mm", Qt::EditRole));
  QCOMPARE(looked.count(), 2);
  QVERIFY(model.preview());
  QCOMPARE(rig.button(), before);
  QCOMPARE(rig.steps(), 0);
  panel.findChild<QPushButton*>("takeFigures")->click();
  QCOMPARE(rig.steps(), 1);
  QVERIFY(!model.preview());
  QVERIFY(!model.anyWanted());
  QVERIFY(std::abs(valueOf(rig, snapRatio) - 0.4) < 1e-4);
  QVERIFY(std::abs(valueOf(rig, totalTravel) - 3.6) < 1e-4);
  QVERIFY(rig.document.graph().release());
  QCOMPARE(rig.document.graph().release()->end_mm(), rig.press().end_mm());  // both strokes end together
}

void KeyFiguresPanelTest::contradictionsAreNamed() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  using enum KeyFigure;
  QVERIFY(model.setData(cell(model, totalTravel, KeyFiguresModel::wanted), "3.6 mm", Qt::EditRole));
  QVERIFY(model.setData(cell(model, preTravel, KeyFiguresModel::wanted), "3.7 mm", Qt::EditRole));
  QVERIFY(!model.preview());
  QVERIFY2(model.conflict().contains(termOf(totalTravel)) && model.conflict().contains(termOf(preTravel)),
           qPrintable(model.conflict()));
  QVERIFY(!panel.findChild<QPushButton*>("takeFigures")->isEnabled());
  QVERIFY(!panel.findChild<QLabel*>("keyFiguresTrouble")->isHidden());
  panel.findChild<QPushButton*>("giveUpFigures")->click();
  QVERIFY(model.conflict().isEmpty());
  QCOMPARE(rig.steps(), 0);
}

void KeyFiguresPanelTest::figuresTheButtonLacksCannotBeTyped() {
  WorkspaceRig rig(require(linearButton()));
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  const QModelIndex peak = cell(model, KeyFigure::peakForce, KeyFiguresModel::now);
  QVERIFY(!(model.flags(peak) & Qt::ItemIsEditable));
  QVERIFY(!model.setData(peak, "60", Qt::EditRole));
  QCOMPARE(rig.steps(), 0);
}

void KeyFiguresPanelTest::whatIsShownIsWhatCanBeTyped() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  const QLocale before;
  for (const QLocale& locale : {QLocale(QLocale::English), QLocale(QLocale::German)})
    for (const ForceUnit force : {ForceUnit::gramForce, ForceUnit::newton, ForceUnit::ounceForce})
      for (const LengthUnit length : {LengthUnit::millimetre, LengthUnit::mil}) {
        QLocale::setDefault(locale);
        rig.settings.setUnits({length, force});
        for (int row = 0; row < model.rowCount(); ++row) {
          const QModelIndex at = model.index(row, KeyFiguresModel::now);
          const QString text = at.data(Qt::EditRole).toString();
          QVERIFY2(model.refusalOf(at, text).isEmpty(), qPrintable(text));
          // What the cell offers for editing, given back as it is, is no step.
          QVERIFY(model.setData(at, text, Qt::EditRole));
        }
        QCOMPARE(rig.steps(), 0);
      }
  QLocale::setDefault(before);
}

void KeyFiguresPanelTest::everyFigureHasItsOwnPicture() {
  std::set<QByteArray> pictures;
  for (const bool dark : {false, true})
    for (const KeyFigureName& name : keyFigureNames()) {
      const QImage picture = keyFigurePicture({132, 84}, 2, name.figure, graphColors(dark)).toImage();
      QVERIFY2(
          pictures
              .insert(QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes()))
              .second,
          name.term);
    }
}

void KeyFiguresPanelTest::undoAndHandsKeepTheTableTrue() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  const QModelIndex peak = cell(model, KeyFigure::peakForce, KeyFiguresModel::now);
  const QString before = peak.data().toString();
  rig.document.history().apply(require(scaleForce(rig.button(), 2)), "twice");
  QVERIFY(peak.data().toString() != before);
  rig.document.history().stack().undo();
  QCOMPARE(peak.data().toString(), before);
  // While another hand holds the button nothing is typed.
  rig.document.history().beginDrag("drag");
  QVERIFY(!model.setData(peak, "80", Qt::EditRole));
  rig.document.history().cancelDrag();
}

QTEST_MAIN(KeyFiguresPanelTest)
#include "key_figures_panel_test.moc"
