// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures, lists, templates, differences.

#include <algorithm>
#include <array>
#include <cmath>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "editor/document/graph_colors.h"
#include "editor/document/series_colors.h"
#include "editor/files/document_files.h"
#include "editor/library/compare_panel.h"
#include "editor/library/compare_plot.h"
#include "editor/library/difference_rows.h"
#include "editor/library/graph_picture.h"
#include "editor/library/library_panel.h"
#include "editor/library/morph_dialog.h"
#include "editor/library/template_dialog.h"
#include "editor/quantity/quantity.h"
#include "model/edits.h"
#include "model/key_figures.h"
#include "model/templates.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;

namespace {

int pixelsLike(const QImage& image, const QColor& color) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor at = image.pixelColor(x, y);
      if (std::abs(at.red() - color.red()) + std::abs(at.green() - color.green()) +
              std::abs(at.blue() - color.blue()) <
          60)
        ++count;
    }
  return count;
}

const DifferenceRow* rowNamed(const std::vector<DifferenceRow>& rows, const QString& name) {
  for (const DifferenceRow& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

/// CIELAB of a colour as seen with all cones (0), or without the long, middle or short ones (Machado,
/// Oliveira and Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency", 2009,
/// severity 1).
std::array<double, 3> seenAs(const QColor& color, int cones) {
  static constexpr double mixed[4][3][3] = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}},
      {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}},
      {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};
  static constexpr double toXyz[3][3] = {
      {0.4339, 0.3762, 0.1899}, {0.2127, 0.7152, 0.0722}, {0.0178, 0.1095, 0.8728}};
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double rgb[3] = {linear(color.redF()), linear(color.greenF()), linear(color.blueF())};
  double seen[3] = {}, f[3] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) seen[i] += mixed[cones][i][j] * rgb[j];
    seen[i] = std::clamp(seen[i], 0.0, 1.0);
  }
  for (int i = 0; i < 3; ++i) {
    double share = 0;  // of white
    for (int j = 0; j < 3; ++j) share += toXyz[i][j] * seen[j];
    f[i] = share > 0.008856 ? std::cbrt(share) : 7.787 * share + 16.0 / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double differenceOf(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

class LibraryTest : public QObject {
  Q_OBJECT

 private slots:
  void picturesShowBothStrokes() {
    const GraphColors colors = graphColors(false);
    const QImage bothStrokes = graphPicture(*tactileButton(), {84, 60}, 2, colors);
    QCOMPARE(bothStrokes.size(), QSize(168, 120));
    QVERIFY(pixelsLike(bothStrokes, colors.press) > 80);
    QVERIFY(pixelsLike(bothStrokes, colors.release) > 40);
    const Button pressOnly =
        *editGraph(*tactileButton(), 0, [](const ForceGraph& g) { return removeRelease(g); });
    QCOMPARE(pixelsLike(graphPicture(pressOnly, {84, 60}, 2, colors), colors.release), 0);
  }

  void picturesOfOddButtonsAreDrawn() {
    const auto flat = StrokeCurve::fromKnots({{0, 0, 0, 0}, {1, 0, 0, 0}});
    const auto graph = ForceGraph::fromCurves(*flat, {});
    const Button nothing = *Button::fromStates("flat", {ButtonState{"", *graph, {}, {}, {}}});
    QVERIFY(!graphPicture(nothing, {84, 60}, 1, graphColors(true)).isNull());
    QVERIFY(!graphPicture(*scaleForce(*selfLockingButton(), 1e5), {84, 60}, 1, graphColors(true)).isNull());
  }

  void aFolderIsListedWithPicturesAndFollowed() {
    QTemporaryDir folder;
    ButtonDocument document(*tactileButton());
    QVERIFY(saveDocument(document, folder.filePath("one.button.json")).ok());
    QFile broken(folder.filePath("broken.button.json"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("{");
    broken.close();

    PictureCache pictures({84, 60});
    FolderModel model(pictures);
    model.setFolder(folder.path());
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(model.index(1).data().toString(), QString("one"));
    QSignalSpy ready(&pictures, &PictureCache::ready);
    model.index(0).data(Qt::DecorationRole);
    model.index(1).data(Qt::DecorationRole);
    QTRY_COMPARE(ready.count(), 2);
    QVERIFY(!pictures.ofFile(folder.filePath("one.button.json")).isNull());
    QVERIFY(pictures.ofFile(folder.filePath("broken.button.json")).isNull());
    QVERIFY(model.index(0).data(Qt::ToolTipRole).toString().contains("broken.button.json"));

    QVERIFY(saveDocument(document, folder.filePath("two.button.json")).ok());
    QTRY_COMPARE(model.rowCount(), 3);
    model.setFilter("TWO");
    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(model.pathAt(model.index(0)), folder.filePath("two.button.json"));
  }

  void openButtonsShowTheirState() {
    PictureCache pictures({84, 60});
    OpenButtonsModel model(pictures);
    ButtonDocument a(*tactileButton());
    auto b = std::make_unique<ButtonDocument>(*linearButton());
    model.setDocuments({&a, b.get()});
    QSignalSpy ready(&pictures, &PictureCache::ready);
    QTRY_COMPARE(ready.count(), 2);
    QCOMPARE(model.index(0).data().toString(), QString("tactile"));
    a.history().apply(*scaleForce(a.button(), 2), "Scale force");
    QCOMPARE(model.index(0).data().toString(), QString("tactile *"));
    QTRY_COMPARE(ready.count(), 3);
    model.setDocuments({&a});
    b.reset();
    QCOMPARE(model.rowCount(), 1);
  }

  void thePanelReportsTheChoice() {
    QTemporaryDir folder;
    ButtonDocument document(*tactileButton());
    QVERIFY(saveDocument(document, folder.filePath("one.button.json")).ok());
    LibraryPanel panel;
    panel.setDocuments({&document}, &document);
    panel.setFolder(folder.path());
    panel.show();
    QSignalSpy documents(&panel, &LibraryPanel::documentChosen), files(&panel, &LibraryPanel::fileChosen);
    auto* open = panel.findChild<QListView*>("libraryOpenButtons");
    emit open->clicked(open->model()->index(0, 0));
    QCOMPARE(documents.count(), 1);
    auto* list = panel.findChild<QListView*>("libraryFolderButtons");
    emit list->activated(list->model()->index(0, 0));
    QCOMPARE(files.at(0).at(0).toString(), folder.filePath("one.button.json"));
  }

  void templatesAreValidAndDifferent() {
    const auto templates = buttonTemplates();
    QCOMPARE(templates.size(), std::size_t{5});
    for (std::size_t i = 1; i < templates.size(); ++i) {
      QVERIFY(!(templates[i].button.states() == templates[i - 1].button.states()));
      QVERIFY(templates[i].id != templates[i - 1].id);
      QCOMPARE(QString::fromStdString(templates[i].button.name()), templates[i].name);
    }
    TemplateDialog dialog;
    dialog.choose("clicky");
    QCOMPARE(dialog.chosen().id, QString("clicky"));
  }

  void differencesAreThoseOfTheButtons() {
    const Button a = *tactileButton(), b = *scaleForce(a, 2);
    const auto rows = differencesOf({&a.states()[0], &b.states()[0]});
    // Every figure that the panel of key figures has as well has its name and value.
    const KeyFigures figures = keyFiguresOf(a.states()[0]);
    for (const auto& [figure, name] : std::initializer_list<std::pair<KeyFigure, const char*>>{
             {KeyFigure::totalTravel, "Total travel"},
             {KeyFigure::preTravel, "Pre-travel"},
             {KeyFigure::resetTravel, "Reset point"},
             {KeyFigure::bottomOutTravel, "Bottom-out travel"},
             {KeyFigure::initialForce, "Initial force"},
             {KeyFigure::hysteresis, "Hysteresis"}}) {
      const DifferenceRow* row = rowNamed(rows, name);
      if (figures[figure].has_value()) QVERIFY2(row && row->values[0] == figures[figure], name);
    }
    const DifferenceRow* travel = rowNamed(rows, "Total travel");
    QVERIFY(travel && *travel->values[0] == *travel->values[1]);
    const DifferenceRow* force = rowNamed(rows, "Press: peak force");
    QVERIFY(force);
    QCOMPARE(*force->values[1], 2 * *force->values[0]);
    const DisplayUnits units;
    QCOMPARE(shownValue(force->values[0], detent::editor::Measure::force, units), QString("55.00"));
    QCOMPARE(shownDifference(*force, 1, units), QString("+55.0"));
    // A difference has no more decimals than the values beside it: 4.000 and 4.000 differ by 0.
    const DifferenceRow close{"", detent::editor::Measure::length, {4.00021, 4.00004, 3.9981}};
    QCOMPARE(shownValue(close.values[0], close.measure, units), QString("4.000"));
    QCOMPARE(shownDifference(close, 1, units), QString("0"));
    QCOMPARE(shownDifference(close, 2, units), QString("\u22120.002"));
    QCOMPARE(shownUnit(detent::editor::Measure::force, units), QString("cN"));
    DisplayUnits inches;
    inches.length = LengthUnit::inch;
    QCOMPARE(shownValue(travel->values[0], detent::editor::Measure::length, inches), QString("0.1575"));
  }

  void whatOneHasAndTheOtherNotIsADash() {
    const Button linear = *linearButton(), twoLevel = *twoLevelButton();
    const auto rows = differencesOf({&linear.states()[0], &twoLevel.states()[0]});
    const DifferenceRow* second = rowNamed(rows, "Press 2: peak force");
    QVERIFY(second && !second->values[0] && second->values[1]);
    QCOMPARE(shownDifference(*second, 1, {}), QString("\u2013"));
  }

  void everyoneDistinguishesTheColoursOfAComparison() {
    constexpr double plainlyDifferent = 20;
    for (const bool dark : {false, true})
      for (std::size_t a = 0; a < seriesColors; ++a)
        for (std::size_t b = 0; b < a; ++b)
          for (int cones = 0; cones < 4; ++cones) {
            const double apart =
                differenceOf(seenAs(seriesColor(a, dark), cones), seenAs(seriesColor(b, dark), cones));
            QVERIFY2(apart > plainlyDifferent, qPrintable(QString("%1 colours %2 and %3, eye %4: %5")
                                                              .arg(dark ? "dark" : "light")
                                                              .arg(b + 1)
                                                              .arg(a + 1)
                                                              .arg(cones)
                                                              .arg(apart)));
          }
  }

  void severalAreComparedAndReadOff() {
    ViewSettings settings;
    ButtonDocument a(*tactileButton()), b(*linearButton()), c(*scaleForce(*tactileButton(), 2));
    ComparePanel dialog(settings);
    dialog.setDocuments({&a, &b, &c});
    dialog.compare(&a, &b);
    dialog.show();
    auto* table = dialog.findChild<QTableWidget*>("compareTable");
    QCOMPARE(table->columnCount(), 5);
    dialog.findChild<QPushButton*>("compareAdd")->click();
    QCOMPARE(dialog.findChild<QComboBox*>("compareButtonC")->currentIndex(), 2);  // the one not there yet
    QCOMPARE(table->columnCount(), 7);
    QVERIFY(
        dialog.tableText().startsWith("figure,\"tactile (not saved, 1)\",\"linear\",\"tactile (not saved, "
                                      "2)\",\"linear - tactile (not saved, "
                                      "1)\",\"tactile (not saved, 2) - tactile (not saved, 1)\",unit\n"));
    // The largest force of C is twice that of A, so what it has more is A's own.
    for (int row = 0; row < table->rowCount(); ++row)
      if (table->item(row, 0)->text() == "Press: largest force")
        QCOMPARE(table->item(row, 5)->text(), '+' + table->item(row, 1)->text());

    auto* plot = dialog.findChild<ComparePlot*>();
    auto* reading = dialog.findChild<QLabel*>("compareReading");
    const auto at = [&](double mm) {
      return QPoint(qRound(plot->xAxis->coordToPixel(mm)), plot->axisRect()->center().y());
    };
    QTest::mouseMove(plot, at(1));
    const double shown_mm = plot->xAxis->pixelToCoord(at(1).x());
    const double force_cN = 100 * a.graph().press().force_N(shown_mm);
    QTRY_VERIFY(reading->text().contains("tactile (not saved, 1) press " + numberText(force_cN, 4)));
    QTest::mouseClick(plot, Qt::LeftButton, {}, at(1));
    QTest::mouseMove(plot, at(2));
    QTRY_VERIFY(reading->text().contains("Difference from the pinned cursor"));
    QTest::keyClick(plot, Qt::Key_Escape);
    QVERIFY(!reading->text().contains("Difference from the pinned cursor"));
    dialog.findChild<QPushButton*>("compareRemove")->click();
    QCOMPARE(table->columnCount(), 5);
    QVERIFY(!dialog.findChild<QPushButton*>("compareRemove")->isEnabled());
    c.history().apply(*linearButton(), "Linear");  // no longer compared: nothing dangles
    QTest::qWait(80);
  }

  // The names follow the order of the tabs, whichever side a button is on.
  void buttonsOfOneTitleAreDistinguished() {
    ViewSettings settings;
    ButtonDocument original(*tactileButton()), copy(*scaleForce(*tactileButton(), 2)), other(*linearButton());
    original.setPath("/buttons/old/tactile.button.json");
    ComparePanel panel(settings);
    panel.setDocuments({&original, &copy, &other});
    panel.compare(&copy, &original);
    panel.show();
    const auto heads = [&] { return panel.tableText().section('\n', 0, 0).section(',', 1, 2); };
    QCOMPARE(heads(), QString("\"tactile (not saved)\",\"tactile (tactile.button.json)\""));
    QCOMPARE(panel.findChild<QComboBox*>("compareButtonB")->currentText(), "tactile (tactile.button.json)");
    copy.setPath("/buttons/new/tactile.button.json");
    QTRY_COMPARE(heads(),
                 QString("\"tactile (new/tactile.button.json)\",\"tactile (old/tactile.button.json)\""));
    copy.setPath("/buttons/new/softer.button.json");
    QTRY_COMPARE(heads(), QString("\"softer\",\"tactile\""));
  }

  /// 1366 x 768 at scale 2: six buttons scroll, and their controls stay visible.
  void sixAreComparedOnASmallScreen() {
    ViewSettings settings;
    ButtonDocument a(*tactileButton()), b(*linearButton());
    ComparePanel dialog(settings);
    dialog.setDocuments({&a, &b});
    dialog.compare(&a, &b);
    while (dialog.findChild<QPushButton*>("compareAdd")->isEnabled()) dialog.add(&b);
    const QSize small(675, 345);
    dialog.resize(small);
    dialog.show();
    QCOMPARE(dialog.size(), small);
    auto* reached = dialog.findChild<QScrollArea*>("compareScroll");
    for (const char* name : {"compareAdd", "compareRemove", "compareExchange", "compareCopy"}) {
      reached->ensureWidgetVisible(dialog.findChild<QPushButton*>(name));
      const auto* button = dialog.findChild<QPushButton*>(name);
      const QRect place(button->mapTo(&dialog, QPoint()), button->size());
      QVERIFY2(dialog.rect().contains(place), name);
      QVERIFY2(button->width() >= button->sizeHint().width(), name);
    }
    auto* scroll = dialog.findChild<QScrollArea*>("compareScroll");
    QVERIFY(scroll->verticalScrollBar()->maximum() > 0);
    QVERIFY(dialog.findChild<QWidget*>("comparePlot")->height() >= 100);
  }

  /// With little room long names are shortened, the first two buttons stand side by side, and numbers of
  /// axes keep their distance.
  void aSmallScreenShowsBothSidesByTheirNames() {
    ViewSettings settings;
    const auto named = [](const Button& button, const char* name) {
      return *Button::fromStates(name, button.states());
    };
    ButtonDocument a(named(*tactileButton(), "CPG151101D283_Polia_Switch_with_a_long_name")),
        b(named(*scaleForce(*tactileButton(), 2), "CPG142501D03_another_long_name_of_a_switch"));
    ComparePanel dialog(settings);
    dialog.setDocuments({&a, &b});
    dialog.compare(&a, &b);
    dialog.resize(675, 345);
    dialog.show();
    auto* table = dialog.findChild<QTableWidget*>("compareTable");
    QTRY_VERIFY(table->verticalHeader()->isVisible());
    QVERIFY(table->columnViewportPosition(2) + table->columnWidth(2) <= table->viewport()->width());
    QCOMPARE(table->verticalHeaderItem(0)->text(), table->item(0, 0)->text());
    QVERIFY(table->horizontalHeaderItem(1)->toolTip().startsWith("CPG151101D283_Polia_Switch_with"));

    auto* plot = dialog.findChild<ComparePlot*>();
    dialog.findChild<QToolButton*>("compareDifference")->click();
    const QFontMetrics metrics(plot->legend->font());
    for (int i = 0; i < plot->legend->itemCount(); ++i) {
      auto* item = qobject_cast<QCPPlottableLegendItem*>(plot->legend->item(i));
      QVERIFY(item && item->plottable()->name().contains(QChar(0x2026)));
      const int needed_px = plot->legend->iconSize().width() + plot->legend->iconTextPadding() +
                            metrics.horizontalAdvance(item->plottable()->name());
      QTRY_VERIFY(item->rect().width() >= needed_px);
    }
    const double line_px = QFontMetricsF(plot->yAxis->tickLabelFont()).height();
    for (const QCPAxisRect* rect : plot->axisRects()) {
      QCPAxis* axis = rect->axis(QCPAxis::atLeft);
      const auto apart = [&] {
        const QVector<double> ticks = axis->tickVector();
        return ticks.size() > 1 ? std::abs(axis->coordToPixel(ticks[1]) - axis->coordToPixel(ticks[0])) : 1e9;
      };
      QTRY_VERIFY2(apart() >= line_px, qPrintable(QString::number(apart())));
    }
    dialog.resize(1600, 900);  // a wide window shows whole names
    QTRY_VERIFY(plot->plottable(0)->name() == "CPG151101D283_Polia_Switch_with_a_long_name");
  }

  /// In a window of 1366 x 768: the table fits with other units, too, and shows the names of its buttons.
  void theTableOfAComparisonHasItsRoom() {
    ViewSettings settings;
    const auto named = [](const Button& button, const char* name) {
      return *Button::fromStates(name, button.states());
    };
    ButtonDocument a(named(*tactileButton(), "black-red-curve")),
        b(named(*scaleForce(*tactileButton(), 2), "brown-german"));
    ComparePanel panel(settings);
    panel.resize(1366, 684);
    panel.setDocuments({&a, &b});
    panel.compare(&a, &b);
    panel.show();
    auto* table = panel.findChild<QTableWidget*>("compareTable");
    for (const DisplayUnits& units : {DisplayUnits{LengthUnit::millimetre, ForceUnit::newton},
                                      {LengthUnit::millimetre, ForceUnit::gramForce},
                                      {LengthUnit::micrometre, ForceUnit::millinewton}}) {
      settings.setUnits(units);
      QTRY_VERIFY(panel.tableText().contains(units.forceSymbol() + '"'));
      QTest::qWait(20);
      QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
      QVERIFY(table->verticalHeader()->isHidden());
      for (const int column : {1, 2})
        QVERIFY2(table->columnWidth(column) >= table->horizontalHeader()->sectionSizeHint(column),
                 qPrintable(QString("%1, column %2: %3 px")
                                .arg(units.forceSymbol())
                                .arg(column)
                                .arg(table->columnWidth(column))));
    }
    QVERIFY(panel.findChild<QWidget*>("comparePlot")->width() > 1366 / 2);
  }

  /// 1366 x 768 at scale 2: the graphs have the height of the window.
  void theWayBetweenTwoIsSeenOnASmallScreen() {
    MorphDialog dialog({*tactileButton(), *linearButton()}, 0, {});
    dialog.show();
    const auto* plot = dialog.findChild<QWidget*>("morphPlot");
    dialog.resize(675, 344);
    QTRY_VERIFY2(plot->height() > 250, qPrintable(QString::number(plot->height())));
    QVERIFY(plot->width() > 300);
    dialog.resize(720, 700);
    QTRY_VERIFY(plot->width() > 650);
    QVERIFY(plot->height() > 300);
  }

  void severalComeAtOnceAndTheirDifferencesAreDrawn() {
    ViewSettings settings;
    ButtonDocument a(*tactileButton()), b(*linearButton()), c(*scaleForce(*tactileButton(), 2));
    ComparePanel panel(settings);
    panel.setDocuments({&a, &b, &c});
    panel.compare({&a, &b, &c});
    QCOMPARE(panel.findChild<QTableWidget*>("compareTable")->columnCount(), 7);
    auto* plot = panel.findChild<ComparePlot*>();
    const int curves = plot->plottableCount();
    panel.findChild<QToolButton*>("compareDifference")->click();
    QCOMPARE(plot->plottableCount(), curves + 4);  // press and release differences of both other buttons
    const auto* of = qobject_cast<QCPGraph*>(plot->plottable(curves + 2));
    QVERIFY(of && of->data()->size() > 100);
    for (const QCPGraphData& point : *of->data())  // c is twice a, so the difference is a's own force
      QVERIFY(std::abs(point.value - 100 * a.graph().press().force_N(point.key)) < 1e-6);
    panel.findChild<QToolButton*>("compareDifference")->click();
    QCOMPARE(plot->plottableCount(), curves);
    panel.compare({&b, &c});
    QCOMPARE(panel.findChild<QTableWidget*>("compareTable")->columnCount(), 5);
    QCOMPARE(panel.findChild<QComboBox*>("compareButtonA")->currentText(), QString("linear"));
  }

  void theDialogueComparesAndFollows() {
    ViewSettings settings;
    ButtonDocument a(*tactileButton()), b(*selfLockingButton());
    ComparePanel dialog(settings);
    dialog.setDocuments({&a, &b});
    dialog.compare(&a, &b);
    dialog.show();
    auto* table = dialog.findChild<QTableWidget*>("compareTable");
    QVERIFY(table->rowCount() > 8);
    QVERIFY(dialog.findChild<QComboBox*>("compareStateB")->isVisible());
    QVERIFY(!dialog.findChild<QComboBox*>("compareStateA")->isVisible());
    const QString before = dialog.tableText();
    a.history().apply(*scaleTravel(a.button(), 0.5), "Scale travel");
    QTRY_VERIFY(dialog.tableText() != before);
    DisplayUnits units;
    units.force = ForceUnit::gramForce;
    settings.setUnits(units);
    QTRY_VERIFY(dialog.tableText().contains("gf"));
    dialog.findChild<QPushButton*>("compareCopy")->click();
    QCOMPARE(QApplication::clipboard()->text(), dialog.tableText());
    dialog.findChild<QPushButton*>("compareExchange")->click();
    QVERIFY(dialog.findChild<QComboBox*>("compareStateA")->isVisible());
    a.history().stack().undo();
    // In a narrow window names give way to numbers.
    dialog.resize(420, 700);
    QTRY_COMPARE(table->horizontalScrollBar()->maximum(), 0);
    dialog.resize(1200, 1200);  // the table stands below the graph
    QTRY_VERIFY(table->columnWidth(0) > 150);
    dialog.setDocuments({&a});
    dialog.setDocuments({});
    QCOMPARE(table->rowCount(), 0);
  }
};

DETENT_WINDOW_TEST(LibraryTest)
#include "library_test.moc"
