// SPDX-License-Identifier: GPL-3.0-or-later
// Every field for a quantity that the windows have, whatever it is called: what is typed means the same in
// every language, with every unit typed and every unit shown; what cannot be read leaves the value alone.

#include <algorithm>
#include <cmath>
#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QMap>
#include <QScopeGuard>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <random>

#include "editor/importing/import_dialog.h"
#include "editor/panels/grid_dialog.h"
#include "editor/panels/operation_dialog.h"
#include "editor/quantity/quantity_field.h"
#include "editor/study/study_maker.h"
#include "editor/window/main_window.h"
#include "editor/window/stored_view.h"
#include "editor/window/tab_area.h"
#include "editor/window/welcome_page.h"
#include "model/templates.h"
#include "tests/editor/window/scripted_prompts.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;
using detent::editor::tests::ScriptedPrompts;

namespace {

struct TypedUnit {
  const char* word;
  double size;  ///< mm, N, N/mm or N·s/mm in one unit; otherwise 1
};

std::vector<TypedUnit> unitsOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return {{"mm", 1}, {"cm", 10}, {"\u00b5m", 1e-3}, {"in", 25.4}, {"mil", 0.0254}};
    case Quantity::force:
      return {{"N", 1},
              {"cN", 0.01},
              {"mN", 0.001},
              {"gf", 0.00980665},
              {"kgf", 9.80665},
              {"ozf", 0.278013850953781},
              {"lbf", 4.4482216152605}};
    case Quantity::slope:
      return {{"N/mm", 1}, {"cN/mm", 0.01}, {"gf/mm", 0.00980665}, {"lbf/in", 4.4482216152605 / 25.4}};
    case Quantity::damping:
      return {{"N*s/mm", 1}, {"mN*s/mm", 0.001}};
    case Quantity::share:
      return {{"%", 0.01}};
    default:
      return {};
  }
}

const DisplayUnits shownUnits[] = {{LengthUnit::millimetre, ForceUnit::centinewton},
                                   {LengthUnit::micrometre, ForceUnit::gramForce},
                                   {LengthUnit::mil, ForceUnit::newton},
                                   {LengthUnit::inch, ForceUnit::poundForce}};

bool isWhole(Quantity quantity) { return quantity == Quantity::count || quantity == Quantity::resolution; }

/// Values of the field's range, and its ends.
std::vector<double> valuesFor(const QuantityField& field, std::mt19937& random) {
  const auto [low, high] = field.range();
  const double top = std::min(high, std::max(low + 1, 1e3)), bottom = std::max(low, -1e3);
  std::uniform_real_distribution<double> between(bottom, top);
  std::vector<double> values{bottom, top};
  for (int i = 0; i < 3; ++i) values.push_back(between(random));
  const bool whole = isWhole(field.quantity());
  for (double& value : values)
    if (whole) value = std::clamp(std::round(value), low, high);
  return values;
}

bool near(double a, double b, double range) {
  return std::abs(a - b) <= 1e-9 * std::max({std::abs(a), std::abs(b), range});
}

}  // namespace

class FieldsTest : public QObject {
  Q_OBJECT

  void type(QuantityField& field, const QString& text) {
    auto* edit = field.findChild<QLineEdit*>();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    ++typed_;
  }

  /// Each value in each unit, with both decimal signs.
  void takesEveryUnit(QuantityField& field, const char* where) {
    const QString named = QString("%1 in %2, %3").arg(field.accessibleName(), where, QLocale().name());
    for (const double value : valuesFor(field, random_)) {
      std::vector<TypedUnit> units = unitsOf(field.quantity());
      if (units.empty()) units = {{"", 1}};
      for (const TypedUnit& unit : units)
        for (const char sign : {'.', ','}) {
          QString text = QString::number(value / unit.size, 'f', 12);
          if (isWhole(field.quantity())) text = QString::number(value, 'f', 0);
          text.replace('.', sign);
          type(field, (text + ' ' + QString::fromUtf8(unit.word)).trimmed());
          const double reach = std::max(std::abs(field.range().lowest), std::abs(field.range().highest));
          const double expected = text.replace(',', '.').toDouble() * unit.size;
          const bool inside = expected >= field.range().lowest - 1e-9 * reach &&
                              expected <= field.range().highest + 1e-9 * reach;
          QVERIFY2(!inside || near(field.value(), expected, std::abs(unit.size) * 1e-3),
                   qPrintable(QString("%1: \"%2 %3\" became %4 (%5)")
                                  .arg(named, text, unit.word)
                                  .arg(field.value(), 0, 'g', 15)
                                  .arg(field.refusal())));
        }
    }
  }

  /// The shown text, typed back, gives the value.
  void showsWhatItReads(QuantityField& field, const char* where) {
    for (const double value : valuesFor(field, random_)) {
      field.setValue(value);
      const double shown = field.value();
      const QString text = field.text();
      if (text.isEmpty() || !text.front().isDigit()) continue;  // a word for the lowest value
      type(field, text);
      QVERIFY2(field.value() == shown,
               qPrintable(QString("%1 in %2 shows \"%3\"").arg(field.accessibleName(), where, text)));
    }
  }

  void refusesWhatItCannotRead(QuantityField& field, const char* where) {
    field.setValue(valuesFor(field, random_).back());
    const double before = field.value();
    QStringList refused{"1,250.5", "1 250", "1'250", "about two", "5 +", "nan", "5 apples"};
    refused << (field.quantity() == Quantity::length ? "5 gf" : "5 mm");
    for (const QString& text : refused) {
      // Pasted, because typed text is read letter by letter, and "1,250" on the way to "1,250.5" is a
      // number.
      auto* edit = field.findChild<QLineEdit*>();
      edit->setText(text);
      emit edit->textEdited(text);
      QVERIFY2(!field.acceptable() && field.value() == before,
               qPrintable(QString("%1 in %2 took \"%3\"").arg(field.accessibleName(), where, text)));
      field.setValue(before);
    }
  }

  void wheelOver(QWidget& widget) {
    const QPointF at = widget.rect().center();
    QWheelEvent wheel(at, widget.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &wheel);
  }

  /// The user's choices and texts in this window, by widget.
  static QMap<const QWidget*, double> choicesIn(const QWidget& window) {
    QMap<const QWidget*, double> choices;
    for (const auto* box : window.findChildren<QComboBox*>()) choices[box] = box->currentIndex();
    for (const auto* field : window.findChildren<QuantityField*>()) choices[field] = field->value();
    for (const auto* tabs : window.findChildren<QTabBar*>()) choices[tabs] = tabs->currentIndex();
    for (const auto* slider : window.findChildren<QAbstractSlider*>())
      if (!qobject_cast<const QScrollBar*>(slider)) choices[slider] = slider->value();
    return choices;
  }

  /// The wheel turns over everything that can be seen, and nothing was clicked.
  void wheelChangesNothing(QWidget& window, const char* where) {
    const auto before = choicesIn(window);
    for (auto* widget : window.findChildren<QWidget*>()) {
      if (!widget->isEnabled() || qobject_cast<QScrollBar*>(widget)) continue;
      wheelOver(*widget);
      ++wheeled_;
      const auto now = choicesIn(window);
      for (auto [control, value] : before.asKeyValueRange())
        QVERIFY2(now.value(control) == value,
                 qPrintable(QString("the wheel over %1 changes %2 in %3")
                                .arg(widget->objectName(), control->objectName(), where)));
    }
  }

  void check(QWidget& window, const char* where) {
    wheelChangesNothing(window, where);
    const auto restored = qScopeGuard([] { QLocale::setDefault(QLocale::c()); });
    for (const auto* box : window.findChildren<QAbstractSpinBox*>())
      QVERIFY2(qobject_cast<const QuantityField*>(box),
               qPrintable(QString("%1 in %2 is a field of another kind").arg(box->objectName(), where)));
    for (auto* field : window.findChildren<QuantityField*>()) {
      if (!field->isEnabledTo(&window)) continue;  // the offset of a release that does not follow
      ++fields_;
      for (const char* language : {"de_DE", "en_US", "fr_FR"}) {
        QLocale::setDefault(QLocale(language));
        for (const DisplayUnits& units : shownUnits) {
          if (!unitsOf(field->quantity()).empty() && field->quantity() != Quantity::share)
            field->setUnits(units);
          takesEveryUnit(*field, where);
          showsWhatItReads(*field, where);
          refusesWhatItCannotRead(*field, where);
          if (QTest::currentTestFailed()) return;
        }
      }
    }
  }

 private slots:
  void initTestCase() {
    window_ = std::make_unique<MainWindow>(WindowContext{view_, settings_, prompts_, recovery_});
    window_->show();
    window_->files().open({QStringLiteral(DETENT_SOURCE_DIR "/samples/buttons/B.button.json")});
  }

  void operations() {
    GraphWorkspace& workspace = window_->tabs().current()->workspace();
    int opened = 0;
    for (QAction* action : workspace.editActions() + workspace.viewActions()) {
      if (!action->isEnabled() || !action->text().contains(QStringLiteral("…"))) continue;
      action->trigger();
      auto* dialog = workspace.findChild<OperationDialog*>();
      if (dialog == nullptr) continue;
      ++opened;
      check(*dialog, qPrintable(action->objectName()));
      dialog->reject();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY2(opened >= 9, qPrintable(QString::number(opened)));
  }

  void feelIt() {
    for (QAction* action : window_->allActions())
      if (action->objectName() == "feel") action->trigger();
    auto* dock = window_->findChild<QScrollArea*>("feelArea");
    QVERIFY(dock->widget()->findChildren<QuantityField*>().size() >= 3);
    check(*dock->widget(), "the feel panel");
  }

  void grid() {
    GridDialog dialog(view_);
    QCOMPARE(dialog.findChildren<QuantityField*>().size(), 2);
    check(dialog, "the grid's steps");
    auto* length = dialog.findChild<QuantityField*>("gridLength");
    view_.setUnits({LengthUnit::micrometre, ForceUnit::gramForce});
    type(*length, "20");
    QCOMPARE(view_.snap().gridLength_mm, 0.02);
    type(*length, "0");  // no grid has such a step
    QVERIFY(view_.snap().gridLength_mm > 0);
    type(*dialog.findChild<QuantityField*>("gridForce"), "0.05 N");
    QCOMPARE(view_.snap().gridForce_N, 0.05);
    view_.setUnits({});
  }

  void importing() {
    ImportDialog dialog(view_);
    QVERIFY(dialog.findChildren<QuantityField*>().size() >= 1);
    check(dialog, "the import dialogue");
  }

  void studies() {
    StudyMaker maker(window_->tabs().documents(), {});
    QVERIFY(maker.findChildren<QuantityField*>().size() >= 2);
    check(maker, "the study maker");
  }

  void windowsAreNoLargerThanTheScreen() {
    QDialog dialog;
    dialog.resize(5000, 5000);
    dialog.show();
    const QSize screen_px = dialog.screen()->availableSize();
    QVERIFY(dialog.width() < screen_px.width() && dialog.height() < screen_px.height());
    QDialog small;
    small.resize(200, 150);
    small.show();
    QCOMPARE(small.size(), QSize(200, 150));
  }

  void namesOfPanelsAreWholeInTheirTabs() {
    int seen = 0;
    for (const auto* tabs : window_->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
      if (!tabs->isVisible()) continue;
      ++seen;
      QCOMPARE(tabs->elideMode(), Qt::ElideNone);
      QVERIFY(tabs->usesScrollButtons());
    }
    QVERIFY(seen > 0);
  }

  // With many buttons the tabs scroll, and each keeps a readable name.
  void namesOfButtonsAreReadInTheirTabs() {
    ViewSettings settings;
    TabArea area(new WelcomePage({}), settings);
    const Button button = *tactileButton();
    for (int i = 0; i < 7; ++i)
      area.add(std::make_unique<ButtonDocument>(
          *Button::fromStates("CPG151101D283 Polia Switch " + std::to_string(i), button.states())));
    area.QStackedWidget::show();
    area.resize(2400, 250);  // with room, whole names
    const auto& tabs = *area.findChild<QTabBar*>("tabBar");
    const auto name_px = [&](int i) { return tabs.fontMetrics().horizontalAdvance(tabs.tabText(i)); };
    QTRY_VERIFY(tabs.tabRect(3).width() >= name_px(3));
    const int besideName_px =
        tabs.tabRect(3).width() - name_px(3);  // width of the close button and the margins
    area.resize(390, 250);
    QTRY_VERIFY(tabs.tabRect(3).width() - besideName_px < name_px(3));
    for (int i = 0; i < tabs.count(); ++i)
      QVERIFY2(tabs.tabRect(i).width() - besideName_px >= 9 * tabs.fontMetrics().averageCharWidth(),
               qPrintable(QString::number(tabs.tabRect(i).width() - besideName_px)));
  }

  void wheelOverAHeadScrollsItsTable() {
    QTableWidget table(200, 2);
    table.resize(300, 200);
    table.show();
    wheelOver(*table.horizontalHeader()->viewport());
    const int once = table.verticalScrollBar()->value();
    QVERIFY(once > 0);
    wheelOver(*table.verticalHeader()->viewport());
    QVERIFY(table.verticalScrollBar()->value() > once);
  }

  void wheelTurnsWhatWasClicked() {
    view_.setSnap({});
    GridDialog dialog(view_);
    dialog.show();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    auto* length = dialog.findChild<QuantityField*>("gridLength");
    const double before = length->value();
    auto* edit = length->findChild<QLineEdit*>();
    QTest::mouseClick(edit, Qt::LeftButton);
    wheelOver(*edit);
    wheelOver(*length);
    QVERIFY(length->value() < before);
    // The keyboard went elsewhere: the next turn is a scroll again.
    dialog.findChild<QuantityField*>("gridForce")->setFocus();
    const double turned = length->value();
    wheelOver(*length);
    QCOMPARE(length->value(), turned);
    for (const auto* box : dialog.findChildren<QAbstractSpinBox*>())
      QVERIFY2(!(box->focusPolicy() == Qt::WheelFocus), "the wheel takes the keyboard along");
  }

  void cleanupTestCase() {
    qInfo("%d fields, %d texts typed, %d widgets the wheel was turned over", fields_, typed_, wheeled_);
    check(*window_, "the window");
    window_.reset();
  }

 private:
  QTemporaryDir folder_;
  QSettings settings_{folder_.filePath("settings.ini"), QSettings::IniFormat};
  ViewSettings view_;
  ScriptedPrompts prompts_;
  RecoveryStore recovery_{folder_.filePath("recovery")};
  std::unique_ptr<MainWindow> window_;
  std::mt19937 random_{14};
  int fields_ = 0, typed_ = 0, wheeled_ = 0;
};

DETENT_WINDOW_TEST(FieldsTest)
#include "fields_test.moc"
