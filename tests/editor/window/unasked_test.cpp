// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing changes a number unasked: every field, cell, tick box, list and mark of the button editor is
// visited, what it shows is typed again or clicked, and the button is what it was.

#include <algorithm>
#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "editor/canvas/graph_canvas.h"
#include "editor/panels/operation_dialog.h"
#include "editor/panels/value_delegate.h"
#include "editor/quantity/quantity_field.h"
#include "editor/window/main_window.h"
#include "editor/window/stored_view.h"
#include "tests/editor/window/scripted_prompts.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;
using detent::editor::tests::ScriptedPrompts;

namespace {

const DisplayUnits unitsVisited[] = {{LengthUnit::millimetre, ForceUnit::centinewton},
                                     {LengthUnit::mil, ForceUnit::gramForce}};

QString placeOfCell(const QModelIndex& index) {
  return QStringLiteral("row %1, column %2").arg(index.row() + 1).arg(index.column() + 1);
}

bool isInDock(const QWidget& widget, const QString& name) {
  for (const QWidget* above = &widget; above; above = above->parentWidget())
    if (above->objectName() == name) return true;
  return false;
}

}  // namespace

class UnaskedTest : public QObject {
  Q_OBJECT

  ButtonDocument& document() { return window_->tabs().current()->document(); }
  GraphCanvas& canvas() { return window_->tabs().current()->workspace().canvas(); }

  /// The button, and the steps that led to it.
  struct Seen {
    Button button;
    Annotations annotations;
    int step;
  };
  Seen seen() {
    return {document().button(), document().annotations(), document().history().stack().index()};
  }
  void isUnchanged(const Seen& before, const QString& what) {
    ++visited_;
    QVERIFY2(document().button() == before.button, qPrintable(what + " changes the button"));
    QVERIFY2(document().annotations() == before.annotations, qPrintable(what + " changes what is noted"));
    QVERIFY2(document().history().stack().index() == before.step, qPrintable(what + " makes a step"));
  }

  void open(const char* name) {
    window_->files().open({QStringLiteral(DETENT_SOURCE_DIR "/samples/buttons/") + name});
    QCoreApplication::processEvents();
  }

  /// Types a field's shown text into it again and presses Enter.
  void typeAgain(QLineEdit& edit) {
    const QString text = edit.text();
    edit.setFocus();
    edit.selectAll();
    if (text.isEmpty())
      QTest::keyClick(&edit, Qt::Key_Delete);
    else
      QTest::keyClicks(&edit, text);
    QTest::keyClick(&edit, Qt::Key_Return);
    QCoreApplication::processEvents();
  }

  void visitFields() {
    const Seen before = seen();
    QList<QPointer<QLineEdit>> edits;
    for (auto* edit : window_->findChildren<QLineEdit*>())
      if (edit->isVisible() && edit->isEnabled() && !edit->isReadOnly() && !isInDock(*edit, "feelArea"))
        edits << edit;
    for (const auto& edit : edits) {
      if (!edit || !edit->isVisible()) continue;
      const QString name =
          edit->objectName().isEmpty() ? edit->parentWidget()->objectName() : edit->objectName();
      typeAgain(*edit);
      isUnchanged(before, "the field " + name);
      if (QTest::currentTestFailed()) return;
    }
  }

  /// Cells that can be edited get their own text; the others are clicked, and a digit and Enter are typed.
  void visitCell(QTableView& table, const QModelIndex& index) {
    table.setFocus();
    table.scrollTo(index);
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(index).center());
    table.setCurrentIndex(index);
    if (index.flags() & Qt::ItemIsEditable) {
      table.edit(index);
      auto* editor = table.viewport()->findChild<QLineEdit*>();
      if (editor) typeAgain(*editor);
    } else if (!(index.flags() & Qt::ItemIsUserCheckable)) {
      QTest::keyClick(&table, Qt::Key_7);
      QTest::keyClick(&table, Qt::Key_Return);
    }
    if (auto* editor = table.viewport()->findChild<QLineEdit*>()) QTest::keyClick(editor, Qt::Key_Escape);
    QCoreApplication::processEvents();
  }

  void visitCells() {
    const Seen before = seen();
    for (auto* table : window_->findChildren<ValueTable*>()) {
      if (!table->isVisible()) continue;
      ++tables_;
      for (int row = 0; row < table->model()->rowCount(); ++row)
        for (int column = 0; column < table->model()->columnCount(); ++column) {
          const QPersistentModelIndex index = table->model()->index(row, column);
          if (table->isColumnHidden(column) || table->isRowHidden(row)) continue;
          const QVariant tick = index.data(Qt::CheckStateRole);
          visitCell(*table, index);
          isUnchanged(before, QStringLiteral("%1 of %2").arg(placeOfCell(index), table->objectName()));
          if (QTest::currentTestFailed()) return;
          if (tick.isValid() && index.data(Qt::CheckStateRole) != tick)
            table->model()->setData(index, tick, Qt::CheckStateRole);
        }
    }
    QTest::qWait(50);  // waits for key figures, which are solved on another thread
    isUnchanged(before, "a cell, a moment later,");
  }

  /// Ticks and unticks every box: neither changes the button, and the second restores the first state.
  void visitTicks() {
    for (auto* box : window_->findChildren<QCheckBox*>()) {
      if (!box->isVisible() || !box->isEnabled() || isInDock(*box, "feelArea")) continue;
      const Button before = document().button();
      const Annotations noted = document().annotations();
      const int step = document().history().stack().index();
      for (int i = 0; i < 2; ++i) {
        box->click();
        QCoreApplication::processEvents();
        ++visited_;
        QVERIFY2(document().button() == before, qPrintable(box->objectName() + " changes the button"));
      }
      QVERIFY2(document().annotations() == noted, qPrintable(box->objectName() + " leaves a note"));
      document().history().stack().setIndex(step);
    }
  }

  /// Selects every entry of every list, and the first choice again.
  void visitChoices() {
    const Seen before = seen();
    for (auto* box : window_->findChildren<QComboBox*>()) {
      if (!box->isVisible() || !box->isEnabled() || isInDock(*box, "feelArea")) continue;
      const int now = box->currentIndex();
      for (int i = 0; i < box->count(); ++i) {
        box->setCurrentIndex(i);
        emit box->activated(i);
        QCoreApplication::processEvents();
      }
      box->setCurrentIndex(now);
      emit box->activated(now);
      isUnchanged(before, "the list " + box->objectName());
    }
  }

  void mouse(QEvent::Type type, QPointF at, Qt::KeyboardModifiers modifiers = {}) {
    const bool moves = type == QEvent::MouseMove, down = type != QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, canvas().mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                      down ? Qt::LeftButton : Qt::NoButton, modifiers);
    QCoreApplication::sendEvent(&canvas(), &event);
  }
  void tremble(QPointF at, QPointF by, Qt::KeyboardModifiers modifiers = {}) {
    mouse(QEvent::MouseButtonPress, at, modifiers);
    if (!by.isNull()) mouse(QEvent::MouseMove, at + by, modifiers);
    mouse(QEvent::MouseButtonRelease, at + by, modifiers);
    QCoreApplication::processEvents();
  }

  /// Every mark, and the curve between marks: clicked, held with a trembling hand, dragged there and back,
  /// opened and closed with Enter.
  void visitMarks() {
    const Seen before = seen();
    std::vector<CurvePoint> clicked;
    for (const Mark& mark : pointMarks(canvas().state(), canvas().values())) clicked.push_back(mark.at);
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const StrokeCurve& curve = document().graph().curve(stroke);
      for (std::size_t i = 0; i + 1 < curve.knots().size(); ++i) {
        const double mm = 0.5 * (curve.knots()[i].displacement_mm + curve.knots()[i + 1].displacement_mm);
        clicked.push_back({mm, curve.force_N(mm)});
      }
    }
    for (const CurvePoint& place : clicked) {
      const QPointF at = canvas().mapping().toPixel(place.displacement_mm, place.force_N);
      const QString where = QStringLiteral("%1 mm, %2 N").arg(place.displacement_mm).arg(place.force_N);
      for (const Qt::KeyboardModifier modifier : {Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier})
        for (const QPointF by : {QPointF(), QPointF(2, 1), QPointF(-1, -2)}) {
          tremble(at, by, modifier);
          isUnchanged(before, "a click at " + where);
        }
      canvas().setSelected({});
      tremble(at, {});
      if (!canvas().selected()) continue;
      canvas().setFocus();
      for (int i = 0; i < 2; ++i) {
        QWidget* focused = QApplication::focusWidget();
        QTest::keyClick(focused ? focused : &canvas(), Qt::Key_Return);
        QCoreApplication::processEvents();
        isUnchanged(before, "Enter at " + where);
      }
      if (QWidget* focused = QApplication::focusWidget()) QTest::keyClick(focused, Qt::Key_Escape);
      mouse(QEvent::MouseButtonPress, at);
      for (const QPointF by : {QPointF(12, -25), QPointF(-8, 20), QPointF(0, 0)})
        mouse(QEvent::MouseMove, at + by);
      mouse(QEvent::MouseButtonRelease, at);
      QCoreApplication::processEvents();
      isUnchanged(before, "a drag there and back at " + where);
      mouse(QEvent::MouseButtonPress, at);
      mouse(QEvent::MouseMove, at + QPointF(10, -25));
      QTest::keyClick(&canvas(), Qt::Key_Escape);
      mouse(QEvent::MouseButtonRelease, at + QPointF(10, -25));
      isUnchanged(before, "a drag given up at " + where);
      if (QTest::currentTestFailed()) return;
    }
    canvas().setSelected({});
  }

  /// Opens and cancels every operation: previews must leave nothing behind.
  void visitOperations() {
    GraphWorkspace& workspace = window_->tabs().current()->workspace();
    const Seen before = seen();
    for (QAction* action : workspace.editActions() + workspace.viewActions()) {
      if (!action->isEnabled() || !action->text().contains(QStringLiteral("…"))) continue;
      action->trigger();
      auto* dialog = workspace.findChild<OperationDialog*>();
      if (!dialog) continue;
      for (auto* edit : dialog->findChildren<QLineEdit*>())
        if (edit->isVisible() && edit->isEnabled()) {
          edit->selectAll();
          QTest::keyClicks(edit, edit->text());
        }
      QCoreApplication::processEvents();
      dialog->reject();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      isUnchanged(before, action->objectName() + ", given up,");
    }
  }

 private slots:
  void initTestCase() {
    window_ = std::make_unique<MainWindow>(WindowContext{view_, settings_, prompts_, recovery_});
    view_.setSnap({});
    window_->resize(1600, 1100);
    window_->show();
    open("B.button.json");
    for (auto* dock : window_->findChildren<QDockWidget*>()) dock->show();
    QCoreApplication::processEvents();
  }

  void nothingIsChanged_data() {
    QTest::addColumn<QString>("button");
    for (const char* name : {"B", "C", "D", "latch"}) QTest::newRow(name) << name;
  }
  void nothingIsChanged() {
    QFETCH(const QString, button);
    open(qPrintable(button + ".button.json"));
    for (const DisplayUnits& units : unitsVisited) {
      view_.setUnits(units);
      // Panels that share one place are seen one after the other.
      for (const char* name : {"annotationsDock", "checksDock", "valuesDock", "inspectorDock"}) {
        auto* dock = window_->findChild<QDockWidget*>(name);
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
        for (const auto visit :
             {&UnaskedTest::visitFields, &UnaskedTest::visitCells, &UnaskedTest::visitTicks}) {
          (this->*visit)();
          if (QTest::currentTestFailed()) return;
        }
      }
      visitMarks();
      if (QTest::currentTestFailed()) return;
    }
    visitChoices();
    if (!QTest::currentTestFailed()) visitOperations();
  }

  void cleanupTestCase() {
    qInfo("%d visits, %d tables", visited_, tables_);
    QVERIFY(tables_ >= 8 && visited_ > 2000);
    window_.reset();
  }

 private:
  QTemporaryDir folder_;
  QSettings settings_{folder_.filePath("settings.ini"), QSettings::IniFormat};
  ViewSettings view_;
  ScriptedPrompts prompts_;
  RecoveryStore recovery_{folder_.filePath("recovery")};
  std::unique_ptr<MainWindow> window_;
  int visited_ = 0, tables_ = 0;
};

DETENT_WINDOW_TEST(UnaskedTest)
#include "unasked_test.moc"
