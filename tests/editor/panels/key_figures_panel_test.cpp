// SPDX-License-Identifier: GPL-3.0-or-later
// The key figures, typed, kept and wanted, judged by the button.
#include "editor/panels/key_figures_panel.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QVBoxLayout>
#include <set>

#include "editor/document/message_words.h"
#include "editor/panels/figure_drawing.h"
#include "editor/panels/key_figures_model.h"
#include "model/edits.h"
#include "tests/editor/window_tests.h"
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

// Types into a cell and waits until what is typed is solved.
bool typed(KeyFiguresModel& model, KeyFigure figure, int column, const QString& text) {
  return model.setData(cell(model, figure, column), text, Qt::EditRole) &&
         QTest::qWaitFor([&] { return !model.solving(); }, 60'000);
}

Button tactile() {
  return require(setResetPoint(require(setOperatingPoint(require(tactileButton()), 0, 1.6)), 0, 1.2));
}

// The same press with many more knots.
Button finely(const Button& button, int knots) {
  return require(editGraph(button, 0, [&](const ForceGraph& graph) {
    StrokeCurve press = graph.press();
    for (int i = 0; i < knots; ++i) {
      const auto next =
          insertKnot(press, press.start_mm() + (i + 0.5) / knots * (press.end_mm() - press.start_mm()));
      if (next) press = *next;
    }
    return ForceGraph::fromCurves(press, graph.release());
  }));
}

}  // namespace

class KeyFiguresPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void aTypedFigureIsOneStepAndMovesNothingElse();
  void whatIsKeptStays();
  void whatIsWantedIsShownBeforeItIsTaken();
  void whatMovesIsSaidBeforeItIsTaken();
  void locksAreVisibleBesideTargets();
  void theEditorOfACellShowsTheBeginningOfItsNumber();
  void contradictionsAreNamed();
  void aLimitIsNamedWithWhatStandsInTheWay();
  void whereASolveEndsIsTheSameEverywhere();
  void theWindowLivesWhileItSolves();
  void whatIsTypedWaitsForTheHandAndItsTurn();
  void figuresTheButtonLacksCannotBeTyped();
  void typingAfterAClickChangesThatCellOrNothing();
  void whatIsShownIsWhatCanBeTyped();
  void everyFigureHasItsOwnPicture();
  void undoAndHandsKeepTheTableTrue();
  void inALowPanelTheFiguresComeFirst();
  void eightFiguresComeFirst();
  void namesStayBesideWhatIsKept();
};

// In a narrow panel the name of a ticked figure stays visible.
void KeyFiguresPanelTest::namesStayBesideWhatIsKept() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  panel.show();
  auto* table = panel.findChild<QTableView*>();
  const QHeaderView& names = *table->verticalHeader();
  panel.findChild<QCheckBox*>("allFigures")->click();  // the longest names and units
  rig.settings.setUnits({LengthUnit::micrometre, ForceUnit::millinewton});
  panel.resize(200, 400);
  QTRY_VERIFY(names.isVisible() && table->isColumnHidden(KeyFiguresModel::figure));
  QVERIFY(table->horizontalScrollBar()->maximum() > 0);
  table->horizontalScrollBar()->setValue(table->horizontalScrollBar()->maximum());
  const int row = static_cast<int>(KeyFigure::valleyForce);
  QCOMPARE(panel.model().headerData(row, Qt::Vertical, Qt::DisplayRole).toString(),
           termOf(KeyFigure::valleyForce));
  QVERIFY(names.width() >= 90);
  for (const int column : {KeyFiguresModel::wanted, KeyFiguresModel::keep}) {
    const int left = table->columnViewportPosition(column);
    QVERIFY2(left >= 0 && left + table->columnWidth(column) <= table->viewport()->width() + 1,
             qPrintable(QString::number(left)));
  }
  panel.resize(700, 400);
  QTRY_VERIFY(names.isHidden() && !table->isColumnHidden(KeyFiguresModel::figure));
  QTRY_COMPARE(table->horizontalScrollBar()->maximum(), 0);
}

void KeyFiguresPanelTest::inALowPanelTheFiguresComeFirst() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  panel.show();
  const auto* meaning = panel.findChild<QLabel*>("keyFigureMeaning");
  const auto* table = panel.findChild<QTableView*>();
  panel.resize(280, 215);
  QTRY_VERIFY(!meaning->isVisible());
  QTRY_VERIFY(table->height() > 140);
  panel.resize(280, 500);
  QTRY_VERIFY(meaning->isVisible());
}

void KeyFiguresPanelTest::aTypedFigureIsOneStepAndMovesNothingElse() {
  WorkspaceRig rig(tactile());
  rig.settings.setUnits({LengthUnit::millimetre, ForceUnit::gramForce});
  KeyFiguresPanel panel(rig.document, rig.settings);
  const KeyFigures before = keyFiguresOf(rig.button().states()[0]);
  QVERIFY(typed(panel.model(), KeyFigure::peakForce, KeyFiguresModel::now, "+12 gf"));
  QCOMPARE(rig.steps(), 1);
  const double raised_gf = *before.values[static_cast<std::size_t>(KeyFigure::peakForce)] / gramForce_N + 12;
  QCOMPARE(
      rig.document.history().stack().undoText(),
      "Set: Peak force " + quantityWithUnit(raised_gf * gramForce_N, Quantity::force, rig.settings.units()));
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
  QVERIFY(typed(model, peakForce, KeyFiguresModel::now, "+5 %"));
  QVERIFY(std::abs(valueOf(rig, drop) - drop_N) < 1e-5);
  QVERIFY(std::abs(valueOf(rig, operatingForce) - operating_N) < 1e-5);
}

void KeyFiguresPanelTest::whatIsWantedIsShownBeforeItIsTaken() {
  WorkspaceRig rig(tactile());
  QWidget window;  // a second field, to which the keyboard focus could move
  auto* column = new QVBoxLayout(&window);
  auto* held = new KeyFiguresPanel(rig.document, rig.settings);
  column->addWidget(held);
  column->addWidget(new QLineEdit);
  KeyFiguresPanel& panel = *held;
  KeyFiguresModel& model = panel.model();
  QSignalSpy looked(&model, &KeyFiguresModel::previewChanged);
  using enum KeyFigure;
  const Button before = rig.button();
  QVERIFY(typed(model, snapRatio, KeyFiguresModel::wanted, "40"));  // percent are shown
  QVERIFY(typed(model, totalTravel, KeyFiguresModel::wanted, "3.6 mm"));
  QVERIFY(looked.count() >= 2);
  QVERIFY(model.preview());
  QCOMPARE(rig.button(), before);
  QCOMPARE(rig.steps(), 0);
  // The button greys out when it is pressed: the keyboard stays with the figures.
  window.show();
  QVERIFY(QTest::qWaitForWindowActive(&window));
  auto* take = panel.findChild<QPushButton*>("takeFigures");
  take->setFocus();
  QTest::keyClick(take, Qt::Key_Space);
  QVERIFY(!take->isEnabled());
  QCOMPARE(QApplication::focusWidget(), panel.findChild<QTableView*>());
  QCOMPARE(rig.steps(), 1);
  QCOMPARE(rig.document.history().stack().undoText(), "Set: Snap ratio 40 %, Total travel 3.6 mm");
  QVERIFY(!model.preview());
  QVERIFY(!model.anyWanted());
  QVERIFY(std::abs(valueOf(rig, snapRatio) - 0.4) < 1e-4);
  QVERIFY(std::abs(valueOf(rig, totalTravel) - 3.6) < 1e-4);
  QVERIFY(rig.document.graph().release());
  QCOMPARE(rig.document.graph().release()->end_mm(), rig.press().end_mm());  // both strokes end together
}

// A drop moves peak and valley, and with the valley the curve up to the bottom-out.
void KeyFiguresPanelTest::whatMovesIsSaidBeforeItIsTaken() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  panel.show();
  KeyFiguresModel& model = panel.model();
  const auto* said = panel.findChild<QLabel*>("keyFiguresMoves");
  QVERIFY(!said->isVisible());
  const Button before = rig.button();
  QVERIFY(typed(model, KeyFigure::drop, KeyFiguresModel::wanted, "20"));
  QVERIFY(rig.button() == before);
  QVERIFY2(said->isVisible() && said->text().startsWith("Moves the press between"), qPrintable(said->text()));
  QVERIFY2(said->text().contains("Also changes: ") && said->text().contains("Valley force") &&
               !said->text().contains("Tactile drop") && !said->text().contains("the release"),
           qPrintable(said->text()));
  // The stretch that is named is the one that moves.
  const QStringList ends = said->text().section("between ", 1).section(" mm", 0, 0).split(" and ");
  const StrokeCurve &was = before.states()[0].graph.press(), &is = model.preview()->graph.press();
  for (double at_mm = 0; at_mm <= was.end_mm(); at_mm += 0.01)
    if (at_mm < ends[0].toDouble() - 0.02 || at_mm > ends[1].toDouble() + 0.02)
      QVERIFY2(std::abs(was.force_N(at_mm) - is.force_N(at_mm)) < 2e-4, qPrintable(QString::number(at_mm)));
  model.giveUp();
  QVERIFY(!said->isVisible());
  // A figure that applies at once says it, too; a contact moves no curve.
  QVERIFY(typed(model, KeyFigure::preTravel, KeyFiguresModel::now, "1.7"));
  QVERIFY2(said->isVisible() && said->text().startsWith("Also changes: ") &&
               said->text().contains("Operating force"),
           qPrintable(said->text()));
  // A value that is refused leaves no text about the one before.
  QVERIFY(typed(model, KeyFigure::differentialTravel, KeyFiguresModel::now, "-1 mm"));
  QCOMPARE(rig.steps(), 1);
  QVERIFY2(!said->isVisible(), qPrintable(said->text()));
  auto* table = panel.findChild<QTableView*>();
  table->setCurrentIndex(cell(model, KeyFigure::drop, KeyFiguresModel::now));
  QVERIFY2(!said->isVisible(), qPrintable(said->text()));
  rig.document.history().stack().undo();
  QVERIFY(!said->isVisible());
  // Beside a preview it comes back when the refused text is given up, because the preview still stands.
  QVERIFY(typed(model, KeyFigure::drop, KeyFiguresModel::wanted, "20"));
  QVERIFY(said->isVisible());
  QVERIFY(!model.setData(cell(model, KeyFigure::peakForce, KeyFiguresModel::wanted), "x", Qt::EditRole));
  QVERIFY(!said->isVisible());
  table->setCurrentIndex(cell(model, KeyFigure::peakForce, KeyFiguresModel::now));
  QVERIFY(said->isVisible());
}

// In the width that the panel has in a window of 1366 x 768, whatever the units and targets.
void KeyFiguresPanelTest::locksAreVisibleBesideTargets() {
  using enum ForceUnit;
  constexpr int inspector_px = 310;
  for (const DisplayUnits& units : {DisplayUnits{LengthUnit::millimetre, centinewton},
                                    {LengthUnit::millimetre, newton},
                                    {LengthUnit::millimetre, gramForce},
                                    {LengthUnit::micrometre, millinewton}}) {
    WorkspaceRig rig(require(scaleForce(tactile(), 1.01234567)));
    rig.settings.setUnits(units);
    KeyFiguresPanel panel(rig.document, rig.settings);
    panel.resize(inspector_px, 400);
    panel.show();
    const auto* table = panel.findChild<QTableView*>();
    for (const bool all : {false, true}) {
      panel.findChild<QCheckBox*>("allFigures")->setChecked(all);
      QVERIFY(typed(panel.model(), KeyFigure::peakForce, KeyFiguresModel::wanted, "+11.37 %"));
      QTest::qWait(20);
      const int right_px =
          table->columnViewportPosition(KeyFiguresModel::keep) + table->columnWidth(KeyFiguresModel::keep);
      QVERIFY2(right_px <= table->viewport()->width() && table->horizontalScrollBar()->maximum() == 0,
               qPrintable(QString("%1, all %2: %3 of %4")
                              .arg(units.forceSymbol())
                              .arg(all)
                              .arg(right_px)
                              .arg(table->viewport()->width())));
      panel.model().giveUp();
    }
  }
}

// A number with more digits than its cell has space for is edited as it is shown, from its beginning on.
void KeyFiguresPanelTest::theEditorOfACellShowsTheBeginningOfItsNumber() {
  using enum KeyFigure;
  WorkspaceRig rig(require(scaleForce(tactile(), 0.987654321)));
  rig.settings.setUnits({LengthUnit::millimetre, ForceUnit::newton});
  KeyFiguresPanel panel(rig.document, rig.settings);
  panel.resize(310, 600);
  panel.show();
  QVERIFY(QTest::qWaitForWindowActive(&panel));
  auto* table = panel.findChild<QTableView*>();
  KeyFiguresModel& model = panel.model();
  const Button before = rig.button();
  const auto editor = [&](KeyFigure figure) {
    const QModelIndex at = cell(model, figure, KeyFiguresModel::now);
    const QPoint place = table->visualRect(at).center();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, place);
    return table->viewport()->findChild<QLineEdit*>("valueEditor");
  };
  for (const KeyFigure figure : {peakForce, snapRatio, totalTravel}) {
    const QModelIndex at = cell(model, figure, KeyFiguresModel::now);
    QLineEdit* line = editor(figure);
    QVERIFY(line);
    QCOMPARE(line->text(), at.data().toString());
    QVERIFY(line->fontMetrics().horizontalAdvance(line->text()) < line->width());
    QTest::keyClick(line, Qt::Key_Return);
    QTest::qWait(20);
    QVERIFY2(!model.solving() && rig.steps() == 0 && rig.button() == before, qPrintable(termOf(figure)));
  }
  // The same digits typed again round nothing; one more digit is a new value.
  const QModelIndex peak = cell(model, peakForce, KeyFiguresModel::now);
  const QString shown = peak.data().toString();
  const auto type = [&](const QString& text) {
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(peak).center());
    for (const QChar digit : text) QTest::keyClick(QApplication::focusWidget(), digit.toLatin1());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  };
  type(shown);
  QTest::qWait(20);
  QVERIFY(!model.solving() && rig.steps() == 0 && rig.button() == before);
  type(shown + u'5');
  QTRY_COMPARE_WITH_TIMEOUT(rig.steps(), 1, 60'000);
  QVERIFY(std::abs(valueOf(rig, peakForce) - (shown + u'5').toDouble()) < 1e-6);
}

void KeyFiguresPanelTest::contradictionsAreNamed() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  using enum KeyFigure;
  QVERIFY(typed(model, totalTravel, KeyFiguresModel::wanted, "3.6 mm"));
  QVERIFY(typed(model, preTravel, KeyFiguresModel::wanted, "3.7 mm"));
  QVERIFY(!model.preview());
  QVERIFY2(model.conflict().contains(termOf(totalTravel)) && model.conflict().contains(termOf(preTravel)),
           qPrintable(model.conflict()));
  QVERIFY(!panel.findChild<QPushButton*>("takeFigures")->isEnabled());
  QVERIFY(!panel.findChild<QLabel*>("keyFiguresTrouble")->isHidden());
  panel.findChild<QPushButton*>("giveUpFigures")->click();
  QVERIFY(model.conflict().isEmpty());
  QCOMPARE(rig.steps(), 0);
}

void KeyFiguresPanelTest::aLimitIsNamedWithWhatStandsInTheWay() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  rig.settings.setUnits({LengthUnit::millimetre, ForceUnit::gramForce});
  QVERIFY(typed(panel.model(), KeyFigure::differentialTravel, KeyFiguresModel::wanted, "-1 mm"));
  const QString why = panel.model().conflict();
  const TargetOutcome outcome = bentToTargets(rig.button(), 0, {{KeyFigure::differentialTravel, -1}});
  QVERIFY(outcome.conflict && outcome.conflict->reachable);
  QVERIFY2(why.contains(numberText(*outcome.conflict->reachable, 6) + " mm"), qPrintable(why));
}

// A contradiction on a curve of many knots is reported before the solve's bound is used up.
void KeyFiguresPanelTest::whereASolveEndsIsTheSameEverywhere() {
  using enum KeyFigure;
  WorkspaceRig rig(finely(tactile(), 500));
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  // In the order of the table.
  const std::vector<FigureTarget> wanted = {{preTravel, 3.7}, {peakForce, 2.5},   {peakTravel, 0.3},
                                            {valleyForce, 2}, {totalTravel, 3.6}, {endForce, 0.2}};
  for (const FigureTarget& target : wanted) {
    const bool force = quantityOf(target.figure) == Quantity::force;
    const QString text = QString::number(target.value) + (force ? " N" : " mm");
    QVERIFY(model.setData(cell(model, target.figure, KeyFiguresModel::wanted), text, Qt::EditRole));
  }
  QVERIFY(QTest::qWaitFor([&] { return !model.solving(); }, 60'000));
  QVERIFY(!model.preview());
  const TargetOutcome outcome =
      bentToTargets(rig.button(), 0, wanted, {}, {}, {{}, KeyFiguresModel::mostKnots});
  QVERIFY(outcome.conflict && outcome.conflict->undecided);
  QCOMPARE(model.conflict(), sentenceOf(outcome.conflict->failure, rig.settings.units()));
}

void KeyFiguresPanelTest::theWindowLivesWhileItSolves() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  panel.show();
  KeyFiguresModel& model = panel.model();
  QVERIFY(model.setData(cell(model, KeyFigure::peakForce, KeyFiguresModel::now), "+5 %", Qt::EditRole));
  QVERIFY(model.solving());  // the call returns before the request is solved
  QCOMPARE(rig.steps(), 0);
  QVERIFY(
      model.setData(cell(model, KeyFigure::totalTravel, KeyFiguresModel::wanted), "3.6 mm", Qt::EditRole));
  QVERIFY(!panel.findChild<QPushButton*>("takeFigures")->isEnabled());
  // A panel that goes while it solves takes its solve with it.
  {
    KeyFiguresPanel other(rig.document, rig.settings);
    QVERIFY(other.model().setData(cell(other.model(), KeyFigure::peakForce, KeyFiguresModel::now), "+9 %",
                                  Qt::EditRole));
  }
  QTRY_VERIFY_WITH_TIMEOUT(!model.solving(), 60'000);
  QCOMPARE(rig.steps(), 1);
  QVERIFY(model.preview());
  QVERIFY(panel.findChild<QLabel*>("keyFiguresSolving")->isHidden());
}

void KeyFiguresPanelTest::whatIsTypedWaitsForTheHandAndItsTurn() {
  WorkspaceRig rig(tactile());
  KeyFiguresPanel panel(rig.document, rig.settings);
  KeyFiguresModel& model = panel.model();
  const double peak_N = valueOf(rig, KeyFigure::peakForce), travel_mm = valueOf(rig, KeyFigure::totalTravel);
  const auto type = [&](KeyFigure figure, const char* text) {
    QVERIFY(model.setData(cell(model, figure, KeyFiguresModel::now), text, Qt::EditRole));
  };
  type(KeyFigure::peakForce, "+5 %");
  type(KeyFigure::totalTravel, "+0.2 mm");
  // Another edit comes between the request and its answer: it stays.
  rig.document.history().apply(require(scaleForce(rig.button(), 1.02)), "harder");
  rig.document.history().beginDrag("drag");
  QTest::qWait(50);
  rig.document.history().cancelDrag();
  QTRY_VERIFY_WITH_TIMEOUT(!model.solving(), 60'000);
  QCOMPARE(rig.steps(), 3);
  QVERIFY(std::abs(valueOf(rig, KeyFigure::peakForce) - 1.05 * peak_N) < 1e-4);
  QVERIFY(std::abs(valueOf(rig, KeyFigure::totalTravel) - travel_mm - 0.2) < 1e-4);
  QVERIFY(valueOf(rig, KeyFigure::endForce) >
          1.01 * *keyFiguresOf(tactile().states()[0])[KeyFigure::endForce]);
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

// The others are shown by request, or where they are locked.
void KeyFiguresPanelTest::eightFiguresComeFirst() {
  WorkspaceRig rig(require(setOperatingPoint(require(tactileButton()), 0, {})));
  KeyFiguresPanel panel(rig.document, rig.settings);
  panel.resize(400, 700);
  panel.show();
  const auto* table = panel.findChild<QTableView*>();
  const auto shown = [&] {
    int rows = 0;
    for (int row = 0; row < panel.model().rowCount(); ++row) rows += !table->isRowHidden(row);
    return rows;
  };
  QCOMPARE(shown(), 8);
  auto* all = panel.findChild<QCheckBox*>("allFigures");
  all->click();
  QCOMPARE(shown(), panel.model().rowCount());
  const QModelIndex work = cell(panel.model(), KeyFigure::pressWork, KeyFiguresModel::keep);
  QVERIFY(panel.model().setData(work, Qt::Checked, Qt::CheckStateRole));
  all->click();
  QCOMPARE(shown(), 9);
  // A missing operating point is requested where its figure stands.
  const QModelIndex missing = cell(panel.model(), KeyFigure::preTravel, KeyFiguresModel::now);
  QCOMPARE(missing.data().toString(), QString("Set…"));
  QSignalSpy requested(&panel, &KeyFiguresPanel::contactsRequested);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(missing).center());
  QCOMPARE(requested.size(), 1);
}

// Clicks and types digits in every cell: only the figure of that row may change, and a refused value says
// why.
void KeyFiguresPanelTest::typingAfterAClickChangesThatCellOrNothing() {
  using enum KeyFigure;
  WorkspaceRig rig(
      require(setResetPoint(require(setOperatingPoint(require(tactileButton()), 0, {})), 0, {})));
  KeyFiguresPanel panel(rig.document, rig.settings);
  panel.resize(700, 1000);
  panel.show();
  QVERIFY(QTest::qWaitForWindowActive(&panel));
  panel.findChild<QCheckBox*>("allFigures")->click();
  auto* table = panel.findChild<QTableView*>();
  const auto* trouble = panel.findChild<QLabel*>("keyFiguresTrouble");
  const auto* meaning = panel.findChild<QLabel*>("keyFigureMeaning");
  KeyFiguresModel& model = panel.model();
  const Button before = rig.button();
  int absent = 0;
  for (int row = 0; row < model.rowCount(); ++row)
    for (int column = 0; column < KeyFiguresModel::columns; ++column) {
      const QModelIndex at = model.index(row, column);
      if (model.flags(at) & Qt::ItemIsEditable) continue;
      const auto figure = static_cast<KeyFigure>(row);
      table->setCurrentIndex(cell(model, peakForce, KeyFiguresModel::now));
      for (const bool twice : {false, true}) {
        table->scrollTo(at);
        const QPoint place = table->visualRect(at).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, place);
        if (twice) QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, place);
        QCOMPARE(table->currentIndex(), at);
        for (const char digit : {'2', '5'}) QTest::keyClick(QApplication::focusWidget(), digit);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(table->currentIndex(), at);
        QVERIFY(!model.solving());
        QVERIFY2(rig.button() == before && !model.anyWanted(), qPrintable(termOf(figure)));
        if (keyFiguresOf(before.states()[0])[figure]) continue;
        ++absent;
        QVERIFY2(trouble->isVisible() && !trouble->text().isEmpty(), qPrintable(termOf(figure)));
        QVERIFY(meaning->text().contains(model.absenceOf(at).toHtmlEscaped()));
      }
    }
  // Pre-travel, operating force, over-travel, reset point, reset force, differential travel.
  QCOMPARE(absent, 6 * KeyFiguresModel::columns * 2);
  QVERIFY(model.absenceOf(cell(model, preTravel, KeyFiguresModel::now)).contains("Ctrl+Shift+O"));
  rig.document.history().apply(require(setOperatingPoint(rig.button(), 0, 1.6)), "operating point");
  QVERIFY(model.absenceOf(cell(model, preTravel, KeyFiguresModel::now)).isEmpty());
  // Both columns have the same rules: a value that one refuses, the other refuses, too.
  for (const char* text : {"-1 cN", "2 cN", "70 cN"}) {
    WorkspaceRig same(require(tactileButton()));
    KeyFiguresPanel bothStates(same.document, same.settings);
    QVERIFY(typed(bothStates.model(), peakForce, KeyFiguresModel::wanted, text));
    const std::optional<ButtonState> wanted = bothStates.model().preview();
    bothStates.model().giveUp();
    QVERIFY(typed(bothStates.model(), peakForce, KeyFiguresModel::now, text));
    QCOMPARE(same.steps() == 1, wanted.has_value());
    if (wanted) QVERIFY(same.button().states()[0] == *wanted);
  }
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
          // Returning the offered text unchanged makes no undo step.
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

DETENT_WINDOW_TEST(KeyFiguresPanelTest)
#include "key_figures_panel_test.moc"
