// SPDX-License-Identifier: GPL-3.0-or-later
// Workspace, operations, values and history, judged by the button.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>
#include <QTemporaryDir>
#include <QUndoView>

#include "editor/panels/history_panel.h"
#include "editor/panels/operation_dialog.h"
#include "editor/panels/values_model.h"
#include "editor/panels/values_panel.h"
#include "editor/quantity/quantity_field.h"
#include "editor/tools/damping_view.h"
#include "model/edits.h"
#include "model/speed_family.h"
#include "tests/editor/window_tests.h"
#include "tests/editor/workspace_rig.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::editor::tests;

namespace {

bool near(double a, double b, double tolerance = 1e-9) { return std::abs(a - b) <= tolerance; }

OperationDialog* opened(WorkspaceRig& rig, const char* action) {
  rig.action(action)->trigger();
  auto* dialog = rig.workspace.findChild<OperationDialog*>();
  if (!dialog) qFatal("%s opens a dialog", action);
  return dialog;
}

// Result of OK; the dialog is gone afterwards.
void accept(OperationDialog* dialog) {
  dialog->accept();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

void reject(OperationDialog* dialog) {
  dialog->reject();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

QModelIndex cell(ValuesModel& model, MarkId mark, int column) {
  const auto row = model.rowOf(mark);
  if (!row) qFatal("no such row");
  return model.index(*row, column);
}

constexpr MarkId tactile{MarkKind::tactilePoint, Stroke::press, 0};

}  // namespace

class PanelsTest : public QObject {
  Q_OBJECT

 private slots:
  void everyOperationPreviewsCancelsAndIsOneStep_data();
  void everyOperationPreviewsCancelsAndIsOneStep();
  void refusedOperationSaysWhyAndWaits();
  void snapRatioIsReached();
  void scaleTravelMovesContactsAlong();
  void refitFollowsTheTracedPoints();
  void statesAreSwitchedAndTheOtherIsAGhost();
  void graphsOfSeveralSpeedsAreEditedOneByOne();
  void removingTheActiveStateShowsTheOther();
  void dampingViewEditsPoints();
  void dampingIsHiddenWhereThereIsNone();
  void valuesAreTypedInTheUsersUnits();
  void invalidValuesSayWhyAndRestore();
  void sectionEndsAndSlopesAreTyped();
  void typingIntoACellThatCannotBeEditedChangesNothing();
  void nothingInTheTableIsCut();
  void namesTakeWhatTheNumbersLeave();
  void readValuesHaveTheDigitsTheirErrorLeaves();
  void everyFieldReadsTheSameInEveryLocaleAndUnit();
  void aRefusedTextStaysInItsCell();
  void anOddValueIsQuestionedOnce();
  void historyListJumps();
  void contextMenuOffersWhatIsThere();
  void picturesAreDrawn();
  void actionsAreNamedAndExplained();
  void aClosedWorkspaceLeavesTheDocumentClean();
};

void PanelsTest::everyOperationPreviewsCancelsAndIsOneStep_data() {
  QTest::addColumn<QString>("action");
  QTest::addColumn<int>("field");
  QTest::addColumn<double>("value");
  QTest::newRow("add jump") << "operationAddJump" << 1 << 0.7;
  QTest::newRow("remove jump") << "operationRemoveJump" << -1 << 0.0;
  QTest::newRow("snap ratio") << "operationSnapRatio" << 1 << 0.4;
  QTest::newRow("make linear") << "operationMakeLinear" << 0 << 0.0;
  QTest::newRow("mirror") << "operationMirror" << 0 << 0.1;
  QTest::newRow("remove release") << "operationRemoveRelease" << -1 << 0.0;
  QTest::newRow("scale force") << "operationScaleForce" << 0 << 2.0;
  QTest::newRow("scale travel") << "operationScaleTravel" << 0 << 3.0;
  QTest::newRow("contacts") << "operationContacts" << 1 << 2.5;
  QTest::newRow("damping") << "operationDamping" << 1 << 0.01;
  QTest::newRow("two-level") << "operationTwoLevel" << 0 << 3.5;
  QTest::newRow("self-locking") << "operationSelfLocking" << 0 << 3.5;
  QTest::newRow("add state") << "operationAddState" << -1 << 0.0;
}

void PanelsTest::everyOperationPreviewsCancelsAndIsOneStep() {
  QFETCH(QString, action);
  QFETCH(int, field);
  QFETCH(double, value);
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  for (const bool keep : {false, true}) {
    OperationDialog* dialog = opened(rig, qPrintable(action));
    if (field >= 0) dialog->setValue(static_cast<std::size_t>(field), value);
    QVERIFY2(!(rig.button() == before), "the preview shows");
    QVERIFY(rig.document.history().committed() == before);
    if (!keep) {
      reject(dialog);
      QVERIFY(rig.button() == before);
      QCOMPARE(rig.steps(), 0);
      continue;
    }
    const Button shown = rig.button();
    accept(dialog);
    QVERIFY(rig.button() == shown);
    QCOMPARE(rig.steps(), 1);
    QVERIFY(!rig.document.history().stack().undoText().isEmpty());
    rig.document.history().stack().undo();
    QVERIFY(rig.button() == before);
  }
}

void PanelsTest::refusedOperationSaysWhyAndWaits() {
  WorkspaceRig rig(require(tactileButton()));
  const Button before = rig.button();
  OperationDialog* dialog = opened(rig, "operationAddJump");
  dialog->setValue(1, 1.7);  // on the falling flank
  const auto* why = dialog->findChild<QLabel*>("refusal");
  QVERIFY(why->text().contains("does not rise"));
  dialog->accept();
  QVERIFY(dialog->isVisible());  // OK waits
  reject(dialog);
  QVERIFY(rig.button() == before);
}

void PanelsTest::snapRatioIsReached() {
  WorkspaceRig rig(require(tactileButton()));
  OperationDialog* dialog = opened(rig, "operationSnapRatio");
  QVERIFY(near(dialog->values()[1], 1 - 0.42 / 0.55, 1e-3));  // the ratio of the present curve
  dialog->setValue(1, 0.5);
  accept(dialog);
  const auto& press = rig.canvas().values().press;
  QVERIFY(near(press.turns[0].force_N, 0.5 * press.tactile[0].force_N));
}

void PanelsTest::scaleTravelMovesContactsAlong() {
  WorkspaceRig rig(require(tactileButton()));
  OperationDialog* dialog = opened(rig, "operationScaleTravel");
  dialog->setValue(0, 2.0);
  accept(dialog);
  QVERIFY(near(rig.document.graph().travel_mm(), 2));
  QVERIFY(near(*rig.canvas().state().operatingPoint_mm, 1.0));
}

void PanelsTest::refitFollowsTheTracedPoints() {
  const Button drawn = require(tactileButton());
  auto report = std::make_shared<importer::ImportReport>(drawn);
  const StrokeCurve& curve = drawn.states()[0].graph.press();
  for (int i = 0; i <= 400; ++i) {
    const double x = 3.99 * i / 400;
    report->strokes.press.points.push_back({x, curve.force_N(x)});
  }
  WorkspaceRig rig(require(linearButton()));
  QVERIFY(!rig.action("operationRefit")->isEnabled());
  rig.document.setOrigin(report);
  rig.document.history().apply(require(rename(rig.button(), "imported")),
                               "Rename");  // actions follow the button
  QVERIFY(rig.action("operationRefit")->isEnabled());
  OperationDialog* dialog = opened(rig, "operationRefit");
  dialog->setValue(0, 8);
  accept(dialog);
  QVERIFY(rig.press().knots().size() <= 9);
  QCOMPARE(rig.canvas().values().press.tactile.size(), std::size_t(1));
  QVERIFY(near(rig.canvas().values().press.tactile[0].force_N, 0.55, 0.01));
}

void PanelsTest::statesAreSwitchedAndTheOtherIsAGhost() {
  WorkspaceRig rig(require(selfLockingButton()));
  auto* states = rig.workspace.findChild<QComboBox*>("stateSwitcher");
  QVERIFY(states->isVisible());
  QCOMPARE(states->count(), 2);
  const QImage unlocked = rig.workspace.renderImage({400, 300}, 1);
  QTest::keyClick(states, Qt::Key_Down);
  emit states->activated(1);
  QCOMPARE(rig.document.activeState(), std::size_t(1));
  QVERIFY(rig.workspace.renderImage({400, 300}, 1) != unlocked);
}

void PanelsTest::graphsOfSeveralSpeedsAreEditedOneByOne() {
  const Button slow = require(tactileButton()), fast = require(scaleForce(slow, 1.5));
  WorkspaceRig plain(slow);
  QVERIFY(!plain.workspace.findChild<QComboBox*>("speedSwitcher")->isVisible());
  WorkspaceRig rig(require(familyOf({slow, fast}, {10, 100})));
  auto* speeds = rig.workspace.findChild<QComboBox*>("speedSwitcher");
  QVERIFY(speeds->isVisible());
  QCOMPARE(speeds->count(), 2);
  QCOMPARE(speeds->currentText(), QStringLiteral("10 mm/s"));
  QVERIFY(rig.workspace.renderImage({400, 300}, 1) != plain.workspace.renderImage({400, 300}, 1));
  // An edit changes the graph in front alone.
  const auto bent = [&](double by_N) {
    return require(editGraph(rig.button(), 0, [&](const ForceGraph& graph) {
      return editStroke(graph, Stroke::press, [&](const StrokeCurve& curve) {
        const Knot& knot = curve.knots()[1];
        return moveKnot(curve, 1, {knot.displacement_mm, knot.force_N + by_N});
      });
    }));
  };
  rig.document.history().apply(bent(0.01), "bend");
  QVERIFY(rig.button().states()[0].otherSpeeds[0].graph == fast.states()[0].graph);
  const ForceGraph edited = rig.document.graph();
  emit speeds->activated(1);
  QCOMPARE(speeds->currentText(), QStringLiteral("100 mm/s"));
  QVERIFY(rig.document.graph() == fast.states()[0].graph);
  QVERIFY(rig.button().states()[0].otherSpeeds[0].graph == edited);
  rig.document.history().apply(bent(0.02), "bend");
  QVERIFY(rig.button().states()[0].otherSpeeds[0].graph == edited);
  for (int i = 0; i < 3; ++i) rig.document.history().stack().undo();
  QVERIFY(rig.button() == require(familyOf({slow, fast}, {10, 100})));
  QCOMPARE(speeds->currentText(), QStringLiteral("10 mm/s"));
  rig.document.history().stack().redo();
  rig.document.history().stack().redo();
  QCOMPARE(speeds->currentText(), QStringLiteral("100 mm/s"));
}

void PanelsTest::removingTheActiveStateShowsTheOther() {
  WorkspaceRig rig(require(selfLockingButton()));
  rig.document.setActiveState(1);
  const ForceGraph other = rig.button().states()[0].graph;
  accept(opened(rig, "operationRemoveState"));
  QCOMPARE(rig.button().states().size(), std::size_t(1));
  QVERIFY(rig.document.graph() == other);
  QVERIFY(!rig.workspace.findChild<QComboBox*>("stateSwitcher")->isVisible());
}

void PanelsTest::dampingViewEditsPoints() {
  WorkspaceRig rig(require(setDamping(require(tactileButton()), 0, {{0, 0.002}, {2, 0.004}, {4, 0.003}})));
  auto* view = rig.workspace.findChild<DampingView*>();
  QVERIFY(view->isVisible());
  const Button before = rig.button();
  const QPointF at = view->mapping().toPixel(2, 0.004), to = view->mapping().toPixel(2.5, 0.003);
  rig.send(*view, QEvent::MouseButtonPress, at, Qt::LeftButton);
  rig.send(*view, QEvent::MouseMove, to, Qt::LeftButton);
  rig.send(*view, QEvent::MouseButtonRelease, to, Qt::LeftButton);
  QCOMPARE(rig.steps(), 1);
  QVERIFY(near(rig.canvas().state().damping[1].displacement_mm, 2.5));
  QVERIFY(near(rig.canvas().state().damping[1].damping_Ns_per_mm, 0.003));
  // Below zero is refused, and Escape restores.
  rig.send(*view, QEvent::MouseButtonPress, to, Qt::LeftButton);
  rig.send(*view, QEvent::MouseMove, to + QPointF(10, 0), Qt::LeftButton);
  rig.send(*view, QEvent::MouseMove, view->mapping().toPixel(2.5, -0.002), Qt::LeftButton);
  QVERIFY(rig.canvas().state().damping[1].damping_Ns_per_mm > 0);
  QTest::keyClick(view, Qt::Key_Escape);
  QVERIFY(near(rig.canvas().state().damping[1].displacement_mm, 2.5));
  rig.send(*view, QEvent::MouseButtonRelease, to, Qt::LeftButton);
  const QPointF between = view->mapping().toPixel(1, 0.003);
  rig.send(*view, QEvent::MouseButtonDblClick, between, Qt::LeftButton);
  QCOMPARE(rig.canvas().state().damping.size(), std::size_t(4));
  QCOMPARE(view->selected(), std::optional<std::size_t>(1));
  QTest::keyClick(view, Qt::Key_Delete);
  QCOMPARE(rig.canvas().state().damping.size(), std::size_t(3));
  rig.document.history().stack().setIndex(0);
  QVERIFY(rig.button() == before);
}

void PanelsTest::dampingIsHiddenWhereThereIsNone() {
  WorkspaceRig rig(require(tactileButton()));
  QVERIFY(!rig.workspace.findChild<DampingView*>()->isVisible());
  QVERIFY(!rig.action("viewDamping")->isEnabled());
  accept(opened(rig, "operationDamping"));
  QVERIFY(rig.workspace.findChild<DampingView*>()->isVisible());
}

void PanelsTest::valuesAreTypedInTheUsersUnits() {
  WorkspaceRig rig(require(tactileButton()));
  ValuesPanel panel(rig.document, rig.settings);
  ValuesModel& model = panel.model();
  QCOMPARE(model.data(cell(model, tactile, ValuesModel::force), Qt::DisplayRole).toString(), QString("55"));
  QVERIFY(model.setData(cell(model, tactile, ValuesModel::force), "60.5", Qt::EditRole));
  QVERIFY(near(rig.canvas().values().press.tactile[0].force_N, 0.605));
  QCOMPARE(rig.steps(), 1);
  QVERIFY(model.setData(cell(model, tactile, ValuesModel::force), "0,6 N", Qt::EditRole));
  QVERIFY(near(rig.canvas().values().press.tactile[0].force_N, 0.6));
  rig.settings.setUnits({LengthUnit::inch, ForceUnit::gramForce});
  QVERIFY(model.headerData(ValuesModel::force, Qt::Horizontal, Qt::DisplayRole).toString().contains("gf"));
  QVERIFY(model.setData(cell(model, tactile, ValuesModel::displacement), "0.05", Qt::EditRole));
  QVERIFY(near(rig.canvas().values().press.tactile[0].displacement_mm, 1.27));
  const int steps = rig.steps();
  const QModelIndex same = cell(model, tactile, ValuesModel::force);
  QVERIFY(model.setData(same, model.data(same, Qt::EditRole), Qt::EditRole));  // Enter alone is no step
  QCOMPARE(rig.steps(), steps);
}

void PanelsTest::invalidValuesSayWhyAndRestore() {
  WorkspaceRig rig(require(tactileButton()));
  ValuesPanel panel(rig.document, rig.settings);
  panel.resize(400, 400);
  panel.show();
  ValuesModel& model = panel.model();
  const Button before = rig.button();
  const auto* why = panel.findChild<QLabel*>("valuesRefusal");
  QVERIFY(!model.setData(cell(model, tactile, ValuesModel::displacement), "3.99", Qt::EditRole));
  QVERIFY(why->isVisible());
  QVERIFY(why->text().contains("it must stay between"));
  QVERIFY(rig.button() == before);
  QCOMPARE(rig.steps(), 0);
  QVERIFY(!model.setData(cell(model, tactile, ValuesModel::displacement), "about two", Qt::EditRole));
  QVERIFY(why->text().contains("about two"));
  QVERIFY(model.setData(cell(model, tactile, ValuesModel::displacement), "1.4", Qt::EditRole));
  QVERIFY(!why->isVisible());
}

void PanelsTest::sectionEndsAndSlopesAreTyped() {
  WorkspaceRig rig(require(tactileButton()));
  ValuesPanel panel(rig.document, rig.settings);
  ValuesModel& model = panel.model();
  const MarkId first{MarkKind::section, Stroke::press, 0};
  // The first slope ends at the tactile point.
  QVERIFY(model.setData(cell(model, first, ValuesModel::displacement), "1.5", Qt::EditRole));
  QVERIFY(near(rig.canvas().values().press.tactile[0].displacement_mm, 1.5));
  // From 30 cN over 1.5 mm at 20 cN/mm: 60 cN.
  QVERIFY(model.setData(cell(model, first, ValuesModel::slopeAfter), "20", Qt::EditRole));
  QVERIFY(near(rig.canvas().values().press.tactile[0].force_N, 0.60));
  const MarkId knot{MarkKind::knot, Stroke::press, 0};
  QVERIFY(model.setData(cell(model, knot, ValuesModel::slopeAfter), "25", Qt::EditRole));
  QVERIFY(near(rig.press().knots()[0].slopeAfter_N_per_mm, 0.25));
  const MarkId reset{MarkKind::resetPoint, Stroke::release, 0};
  QVERIFY(model.setData(cell(model, reset, ValuesModel::displacement), "1.2", Qt::EditRole));
  QCOMPARE(*rig.canvas().state().resetPoint_mm, 1.2);
  QVERIFY(!(model.flags(cell(model, reset, ValuesModel::force)) & Qt::ItemIsEditable));
}

void PanelsTest::typingIntoACellThatCannotBeEditedChangesNothing() {
  WorkspaceRig rig(require(tactileButton()));
  ValuesPanel panel(rig.document, rig.settings);
  panel.resize(700, 900);
  panel.show();
  QVERIFY(QTest::qWaitForWindowActive(&panel));
  auto* table = panel.findChild<QTableView*>();
  const ValuesModel& model = panel.model();
  const Button before = rig.button();
  int tried = 0;
  for (int row = 0; row < model.rowCount(); ++row)
    for (int column = 0; column < model.columnCount(); ++column) {
      const QModelIndex at = model.index(row, column);
      if ((model.flags(at) & Qt::ItemIsEditable) || table->visualRect(at).isEmpty()) continue;
      table->scrollTo(at);
      QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(at).center());
      const QModelIndex current = table->currentIndex();
      QCOMPARE(current.row(), row);
      for (const char digit : {'2', '5'}) QTest::keyClick(QApplication::focusWidget(), digit);
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
      QCOMPARE(table->currentIndex(), current);
      QVERIFY(rig.button() == before);
      ++tried;
    }
  QVERIFY(tried > 20);
}

// The panel is made before it is shown, as a dock's panel is: names get the width that the numbers leave,
// not that of a hidden table.
void PanelsTest::namesTakeWhatTheNumbersLeave() {
  WorkspaceRig rig(require(twoLevelButton()));
  QWidget dock;
  auto* panel = new ValuesPanel(rig.document, rig.settings, &dock);
  dock.resize(520, 400);
  panel->resize(dock.size());
  dock.show();
  QCoreApplication::processEvents();
  const auto* table = panel->findChild<QTableView*>();
  int all = 0;
  for (int column = 0; column < ValuesModel::columns; ++column) all += table->columnWidth(column);
  constexpr int frame_px = 4;
  QVERIFY2(std::abs(all - table->viewport()->width()) <= frame_px, qPrintable(QString::number(all)));
}

void PanelsTest::nothingInTheTableIsCut() {
  WorkspaceRig rig(require(twoLevelButton()));
  ValuesPanel panel(rig.document, rig.settings);
  panel.show();
  auto* table = panel.findChild<QTableView*>();
  for (const DisplayUnits& units :
       {DisplayUnits{}, DisplayUnits{LengthUnit::micrometre, ForceUnit::millinewton},
        DisplayUnits{LengthUnit::inch, ForceUnit::ounceForce}}) {
    rig.settings.setUnits(units);
    for (const int width : {200, 320, 640}) {
      panel.resize(width, 400);
      QCoreApplication::processEvents();
      const ValuesModel& model = panel.model();
      for (int column = 0; column < ValuesModel::columns; ++column) {
        QVERIFY2(table->horizontalHeader()->sectionSizeHint(column) <= table->columnWidth(column),
                 qPrintable(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()));
        for (int row = 0; row < model.rowCount(); ++row) {
          const QModelIndex at = model.index(row, column);
          if (!model.markOf(at)) continue;
          const QString text = at.data().toString();
          QVERIFY2(table->fontMetrics().horizontalAdvance(text) + 6 <= table->columnWidth(column),
                   qPrintable(text));
        }
      }
    }
  }
}

// An imported graph of 1000 px over 4 mm, read to 0.5 px: 0.002 mm, 0.6 cN.
void PanelsTest::readValuesHaveTheDigitsTheirErrorLeaves() {
  Provenance from;
  from.sourceFile = "sheet.png";
  from.frame = {0, 0, 1000, 100};
  from.xAxis = AxisProvenance{"mm", 0, 4, 0.3, DecidedBy::found};
  from.yAxis = AxisProvenance{"cN", 0, 120, 0.3, DecidedBy::found};
  from.pressRms_px = 0.4;
  const Button drawn = require(tactileButton());
  std::vector<ButtonState> states = drawn.states();
  const Button read = require(scaleForce(require(Button::fromStates("read", states, from)), 1.0123456789));
  WorkspaceRig rig(read);
  ValuesPanel panel(rig.document, rig.settings);
  ValuesModel& model = panel.model();
  const QModelIndex force = cell(model, tactile, ValuesModel::force);
  QCOMPARE(force.data().toString(), QString("55.7"));
  QVERIFY(force.data(Qt::EditRole).toString().size() > 8);  // all digits can be edited
  QVERIFY(model.setData(force, "56.1234", Qt::EditRole));
  QCOMPARE(force.data().toString(), QString("56.12"));  // typed: four digits, as everywhere
  QVERIFY(model.setData(cell(model, tactile, ValuesModel::displacement), "1.23456789", Qt::EditRole));
  QCOMPARE(cell(model, tactile, ValuesModel::displacement).data().toString(), QString("1.235"));
}

// Cells of the table and fields of a dialogue accept their own text, and a number keeps its meaning.
void PanelsTest::everyFieldReadsTheSameInEveryLocaleAndUnit() {
  for (const char* locale : {"C", "de_DE", "fr_FR", "en_IN"})
    for (const LengthUnit length : {LengthUnit::millimetre, LengthUnit::micrometre, LengthUnit::inch})
      for (const ForceUnit force : {ForceUnit::newton, ForceUnit::gramForce, ForceUnit::poundForce}) {
        QLocale::setDefault(QLocale(QLatin1String(locale)));
        WorkspaceRig rig(require(tactileButton()));
        rig.settings.setUnits({length, force});
        ValuesPanel panel(rig.document, rig.settings);
        ValuesModel& model = panel.model();
        const QModelIndex at = cell(model, tactile, ValuesModel::displacement);
        for (const char* typed : {"1,305 mm", "1.305 mm", "1305 µm", "1,3 mm + 5 µm"}) {
          QVERIFY(model.setData(at, QString::fromUtf8(typed), Qt::EditRole));
          QVERIFY(near(rig.canvas().values().press.tactile[0].displacement_mm, 1.305));
          QVERIFY(model.setData(at, model.data(at, Qt::EditRole).toString() + " + 0", Qt::EditRole));
          QVERIFY(near(rig.canvas().values().press.tactile[0].displacement_mm, 1.305, 1e-8));
        }
        OperationDialog* dialog = opened(rig, "operationScaleForce");
        auto* field = dialog->findChild<QuantityField*>();
        const double before = field->value();
        field->selectAll();
        QTest::keyClicks(field, field->text());
        QVERIFY2(near(dialog->values()[0], before, 1e-5 * before), qPrintable(field->text()));
        field->selectAll();
        QTest::keyClicks(field, "-10 %");
        QVERIFY(near(dialog->values()[0], 0.9 * before, 1e-9));
        field->selectAll();
        QTest::keyClicks(field, "1.200,5");
        QVERIFY(!field->acceptable());
        QVERIFY(!dialog->findChild<QLabel*>("refusal")->text().isEmpty());
        dialog->accept();
        QVERIFY(dialog->isVisible());
        reject(dialog);
        QLocale::setDefault(QLocale::c());
      }
}

void PanelsTest::aRefusedTextStaysInItsCell() {
  WorkspaceRig rig(require(tactileButton()));
  ValuesPanel panel(rig.document, rig.settings);
  panel.resize(500, 400);
  panel.show();
  auto* table = panel.findChild<QTableView*>("valuesTable");
  table->setCurrentIndex(cell(panel.model(), tactile, ValuesModel::displacement));
  table->edit(table->currentIndex());
  auto* editor = table->findChild<QLineEdit*>("valueEditor");
  QVERIFY(editor);
  editor->selectAll();
  QTest::keyClicks(editor, "1.250,5");
  QTest::keyClick(editor, Qt::Key_Return);
  QCOMPARE(editor->text(), QString("1.250,5"));
  QVERIFY(editor->isVisible());
  QVERIFY(panel.findChild<QLabel*>("valuesRefusal")->isVisible());
  QCOMPARE(rig.steps(), 0);
  editor->selectAll();
  QTest::keyClicks(editor, "+0.05");
  const double before = rig.canvas().values().press.tactile[0].displacement_mm;
  QTest::keyClick(editor, Qt::Key_Return);
  QTRY_COMPARE(rig.steps(), 1);
  QVERIFY(near(rig.canvas().values().press.tactile[0].displacement_mm, before + 0.05));
}

void PanelsTest::anOddValueIsQuestionedOnce() {
  WorkspaceRig rig(require(tactileButton()));
  rig.settings.setUnits({LengthUnit::millimetre, ForceUnit::newton});
  ValuesPanel panel(rig.document, rig.settings);
  panel.resize(500, 400);
  panel.show();
  auto* table = panel.findChild<QTableView*>("valuesTable");
  table->setCurrentIndex(cell(panel.model(), tactile, ValuesModel::force));
  table->edit(table->currentIndex());
  auto* editor = table->findChild<QLineEdit*>("valueEditor");
  QVERIFY(editor);
  editor->selectAll();
  QTest::keyClicks(editor, "60");
  QTest::keyClick(editor, Qt::Key_Return);
  QVERIFY(editor->isVisible());
  QVERIFY(panel.findChild<QLabel*>("valuesRefusal")->text().contains("60 gf"));
  QCOMPARE(rig.steps(), 0);
  QTest::keyClick(editor, Qt::Key_Return);
  QTRY_COMPARE(rig.steps(), 1);
  QVERIFY(near(rig.canvas().values().press.tactile[0].force_N, 60));
}

void PanelsTest::historyListJumps() {
  WorkspaceRig rig(require(tactileButton()));
  HistoryPanel panel(rig.document);
  const Button first = rig.button();
  rig.click(rig.pixel(tactile));
  rig.key(Qt::Key_Up);
  rig.key(Qt::Key_C);  // a step of another kind, which does not merge
  const Button last = rig.button();
  auto* view = panel.findChild<QUndoView*>("historyView");
  QCOMPARE(view->model()->rowCount(), rig.steps() + 1);
  const int row = view->currentIndex().row();
  QTest::keyClick(view, Qt::Key_Backtab);  // leaves the list, and jumps nowhere
  QCOMPARE(view->currentIndex().row(), row);
  QVERIFY(rig.button() == last);
  view->setCurrentIndex(view->model()->index(0, 0));
  QVERIFY(rig.button() == first);
  view->setCurrentIndex(view->model()->index(rig.steps(), 0));
  QVERIFY(rig.button() == last);
}

void PanelsTest::contextMenuOffersWhatIsThere() {
  WorkspaceRig rig(require(tactileButton()));
  const QPoint at = rig.pixel(tactile).toPoint();
  rig.mouse(QEvent::MouseButtonPress, at, Qt::RightButton);
  QCOMPARE(rig.canvas().selected(), std::optional(tactile));
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, rig.canvas().mapToGlobal(at));
  QCoreApplication::sendEvent(&rig.canvas(), &event);
  auto* menu = rig.workspace.findChild<QMenu*>();
  QVERIFY(menu && menu->isVisible());
  QVERIFY(menu->actions().contains(rig.action("editDelete")));
  QVERIFY(rig.action("editDelete")->isEnabled());
  menu->close();
}

void PanelsTest::picturesAreDrawn() {
  WorkspaceRig rig(require(tactileButton()));
  const QImage plain = rig.workspace.renderImage({800, 600}, 1),
               fine = rig.workspace.renderImage({1600, 1200}, 2);
  QCOMPARE(plain.size(), QSize(800, 600));
  QCOMPARE(fine.devicePixelRatio(), 2.0);
  // The pixel at the press curve's coordinates has the press colour.
  const QColor pressColor = rig.canvas().colors().press;
  int found = 0;
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 800; ++x) found += plain.pixelColor(x, y) == pressColor;
  QVERIFY(found > 200);
}

void PanelsTest::actionsAreNamedAndExplained() {
  WorkspaceRig rig(require(tactileButton()));
  QSet<QString> names;
  QSet<QKeySequence> keys;
  for (const auto& actions :
       {rig.workspace.toolActions(), rig.workspace.editActions(), rig.workspace.viewActions()})
    for (const QAction* action : actions) {
      if (action->isSeparator()) continue;
      QVERIFY2(!action->objectName().isEmpty() && !names.contains(action->objectName()),
               qPrintable(action->text()));
      names.insert(action->objectName());
      QVERIFY2(action->toolTip() != action->text().remove('&'), qPrintable(action->text()));
      if (action->shortcut().isEmpty()) continue;
      QVERIFY2(!keys.contains(action->shortcut()), qPrintable(action->text()));
      keys.insert(action->shortcut());
    }
}

void PanelsTest::aClosedWorkspaceLeavesTheDocumentClean() {
  const Button button = require(tactileButton());
  ViewSettings settings;
  ButtonDocument document(button);
  {
    GraphWorkspace workspace(document, settings);
    for (QAction* action : workspace.editActions())
      if (action->objectName() == "operationScaleForce") action->trigger();
    auto* dialog = workspace.findChild<OperationDialog*>();
    dialog->setValue(0, 3.0);
    QVERIFY(document.history().dragging());
  }
  QVERIFY(!document.history().dragging());
  QVERIFY(document.button() == button);
}

DETENT_WINDOW_TEST(PanelsTest)
#include "panels_test.moc"
