// SPDX-License-Identifier: GPL-3.0-or-later
// The window of measured switches: table, filter, map, overlay, what feels like a button.

#include <cmath>
#include <fstream>
#include <QAction>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "editor/measured/filter_bar.h"
#include "editor/measured/measured_window.h"
#include "editor/measured/measured_words.h"
#include "model/templates.h"
#include "model/units.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;

namespace {

constexpr int patience_ms = 60000;

importer::LibrarySwitch switchOf(const std::string& name, double start_N, double bump_N, double travel_mm) {
  importer::LibrarySwitch entry;
  entry.name = name;
  entry.source = "/measured/" + name + ".csv";
  entry.licence = name < "m" ? "MIT" : importer::noLicenceStated;
  entry.credit = name < "m" ? "someone/curves" : "";
  entry.shape.travel_mm = travel_mm;
  for (std::size_t i = 0; i < importer::FeltShape::samples; ++i) {
    const double share = static_cast<double>(i) / importer::FeltShape::samples;
    const double force_N = start_N + 0.2 * share + bump_N * std::exp(-50 * (share - 0.3) * (share - 0.3));
    entry.shape.press_N.push_back(static_cast<float>(force_N));
    entry.shape.release_N.push_back(static_cast<float>(force_N - 0.05));
  }
  if (bump_N > 0) {
    entry.figures[KeyFigure::peakForce] = start_N + bump_N;
    entry.figures[KeyFigure::drop] = bump_N;
  }
  entry.figures[KeyFigure::totalTravel] = travel_mm;
  return entry;
}

std::shared_ptr<const MeasuredSwitches> madeUp(std::size_t count) {
  auto all = std::make_shared<MeasuredSwitches>();
  for (std::size_t i = 0; i < count; ++i)
    all->switches.push_back(switchOf(std::string(1, static_cast<char>('a' + i % 26)) + std::to_string(i),
                                     0.3 + 0.01 * static_cast<double>(i % 37), i % 3 == 0 ? 0 : 0.2,
                                     3.2 + 0.01 * static_cast<double>(i % 91)));
  all->map = importer::feelMapOf(all->switches);
  return all;
}

std::string csvOf(double start_gf, double bump_gf) {
  std::string text = "force,displacement,judge,name\n";
  const auto force_gf = [&](double x) {
    return std::min(start_gf, 300 * x) + 8 * x + bump_gf * std::exp(-(x - 1.2) * (x - 1.2) / 0.08) +
           (x > 3.6 ? 400 * (x - 3.6) : 0);
  };
  const auto row = [&](double f, double x) {
    text += std::to_string(f) + "," + std::to_string(x) + ",0,switch\n";
  };
  for (int i = 0; i <= 380; ++i) row(force_gf(0.01 * i), 0.01 * i);
  for (int i = 380; i >= 0; --i) row(std::max(0.0, force_gf(0.01 * i) - 6), 0.01 * i);
  return text;
}

}  // namespace

class MeasuredTest : public QObject {
  Q_OBJECT

 private slots:
  void aTableIsFilteredSortedAndRanked() {
    MeasuredTable table;
    table.setSwitches(madeUp(90));
    QCOMPARE(table.rowCount(), 90);
    SwitchFilter filter;
    filter.words = "SOMEONE a";
    filter.kind = importer::SwitchKind::tactile;
    filter.ranges = {{KeyFigure::peakForce, 0.6, 0.8}};
    table.setFilter(filter);
    QVERIFY(table.rowCount() > 0 && table.rowCount() < 90);
    for (const SwitchIndex each : table.shown()) {
      const importer::LibrarySwitch& entry = table.switches()[each];
      QCOMPARE(entry.credit, std::string("someone/curves"));
      QVERIFY(*entry.figures[KeyFigure::peakForce] >= 0.6 && *entry.figures[KeyFigure::peakForce] <= 0.8);
    }
    table.setFilter({});
    const int peak = MeasuredTable::firstFigureColumn + static_cast<int>(KeyFigure::peakForce);
    for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
      table.sort(peak, order);
      const auto first = table.switches()[table.shown()[0]].figures[KeyFigure::peakForce];
      const auto second = table.switches()[table.shown()[40]].figures[KeyFigure::peakForce];
      QVERIFY(order == Qt::AscendingOrder ? *first < *second : *first > *second);
      QVERIFY(!table.switches()[table.shown().back()]
                   .figures[KeyFigure::peakForce]);  // switches without the figure come last in either order
    }
    table.sort(-1);
    table.rankBy(table.switches()[17].shape);
    QCOMPARE(table.shown()[0], SwitchIndex(17));
    QCOMPARE(*table.distanceOf(17), 0.0);
    QVERIFY(*table.distanceOf(table.shown()[89]) > *table.distanceOf(table.shown()[1]));
  }

  // A limit is a force or a length: another unit shows it with another number, and back again with the first.
  void limitsOfAFilterStayWhenTheUnitChanges() {
    const DisplayUnits cN, gf{LengthUnit::millimetre, ForceUnit::gramForce};
    FilterBar bar(cN);
    bar.show();
    bar.findChild<QPushButton*>("measuredAddRange")->click();
    auto* least = bar.findChild<QLineEdit*>("measuredLeast");
    QTest::keyClicks(least, "24");
    bar.setUnits(gf);
    QVERIFY2(least->text().startsWith("24.473"), qPrintable(least->text()));
    QVERIFY(std::abs(bar.filter().ranges.at(0).low - 0.24) < 1e-9);
    bar.setUnits(cN);
    QCOMPARE(least->text(), QString("24"));
  }

  void fiveThousandAreShownWithoutAWait() {
    MeasuredTable table;
    table.setSwitches(madeUp(5000));
    SwitchMap map(table);
    map.setScales({{}, 0}, {{}, 1});
    map.resize(500, 400);
    constexpr qint64 most_ms = 500;  // ten times the bar: machines are busy, instrumented
    QElapsedTimer clock;
    clock.start();
    table.setFilter({"a", {}, {}});
    QVERIFY(clock.restart() < most_ms);
    table.setFilter({});
    clock.restart();
    table.sort(MeasuredTable::firstFigureColumn + static_cast<int>(KeyFigure::totalTravel));
    QVERIFY(clock.restart() < most_ms);
    map.redraw();
    QVERIFY(map.placeOf(4999).has_value());
  }

  void aFigureStandsWithItsErrorAndASwitchWithItsUnits() {
    auto all = std::make_shared<MeasuredSwitches>();
    for (const double start_N : {0.50, 0.53}) {
      all->switches.push_back(switchOf("dome", start_N, 0.2, 3.6));
      all->switches.back().unit = start_N < 0.51 ? "1" : "2";
      all->switches.back().sigmas[KeyFigure::peakForce] = 0.012;
      all->switches.back().sigmas[KeyFigure::drop] = 1e-7;  // error below the shown digits
    }
    all->map = importer::feelMapOf(all->switches);
    MeasuredTable table;
    table.setSwitches(all);
    const auto shown = [&](KeyFigure figure) {
      const int column = MeasuredTable::firstFigureColumn + static_cast<int>(figure);
      return table.data(table.index(0, column), Qt::DisplayRole).toString();
    };
    DisplayUnits units;
    QCOMPARE(shown(KeyFigure::peakForce), figureText(0.7, KeyFigure::peakForce, units) +
                                              QString::fromUtf8(" ± ") +
                                              figureText(0.012, KeyFigure::peakForce, units));
    QCOMPARE(shown(KeyFigure::drop), figureText(0.2, KeyFigure::drop, units));
    const importer::SwitchSpread spread = table.spreadOf(0);
    QCOMPARE(spread.units, std::size_t(2));
    const QString words = spreadWords(spread, units);
    QVERIFY2(words.contains("2 measurements of 2 specimens of this switch"), qPrintable(words));
    QVERIFY2(words.contains(figureText(0.03 / std::sqrt(2.0), KeyFigure::peakForce, units)),
             qPrintable(words));
    QVERIFY(spreadWords({}, units).isEmpty());
  }

  void theMapSeparatesWhatDiffers() {
    std::vector<importer::LibrarySwitch> switches;
    for (int i = 0; i < 30; ++i)
      switches.push_back(switchOf("x" + std::to_string(i), 0.3 + 0.02 * i, 0, i % 2 == 0 ? 3.4 : 3.6));
    const importer::FeelMap map = importer::feelMapOf(switches);
    QVERIFY(map.axes[0].share > 0.8 && map.axes[0].share + map.axes[1].share > 0.999);
    QVERIFY(map.positions[29][0] > map.positions[0][0]);  // forces grow to the right
    QVERIFY(map.positions[1][1] > map.positions[0][1]);   // travel grows upwards
    QCOMPARE(map.axes[1].likest, std::optional(KeyFigure::totalTravel));
    QVERIFY(importer::feelMapOf({}).positions.empty());
  }

  void theBandIsTheScatterOfAllChosen() {
    const auto a = switchOf("a", 0.4, 0, 3.0), b = switchOf("b", 0.6, 0, 3.5);
    QVERIFY(scatterOf({&a.shape}).empty());
    const auto scatter = scatterOf({&a.shape, &b.shape});
    QCOMPARE(scatter.back().displacement_mm, 3.0);  // the range that both records have
    QVERIFY(std::abs(scatter.front().mean_N - 0.5) < 1e-6);
    QVERIFY(std::abs(scatter.front().sd_N - 0.2 / std::sqrt(2.0)) < 1e-6);
  }

  void everyNameOfTheLegendHasItsRoom_data() {
    QTest::addColumn<int>("width_px");
    QTest::addColumn<int>("columns");
    QTest::newRow("wide") << 1400 << 2;
    QTest::newRow("narrow") << 420 << 1;
  }

  void everyNameOfTheLegendHasItsRoom() {
    QFETCH(int, width_px);
    const auto a = switchOf("a", 0.4, 0, 3.0), b = switchOf("b", 0.6, 0, 3.5);
    OverlayPlot plot;
    plot.resize(900, 400);
    plot.setVisible(true);
    QVERIFY(QTest::qWaitForWindowExposed(&plot));
    plot.show({{"a switch with a long name", &a.shape}, {"another of the same maker", &b.shape}}, a.shape,
              {});
    QTRY_COMPARE(plot.legend->columnCount(), 2);
    plot.resize(width_px, 400);
    QCOMPARE(plot.legend->itemCount(), 4);  // the band, the reference, two switches
    QFETCH(int, columns);
    QTRY_COMPARE(plot.legend->columnCount(), columns);
    const auto narrowest_px = [&] {
      int room_px = plot.width();
      for (int i = 0; i < plot.legend->itemCount(); ++i)
        if (const QCPAbstractLegendItem* item = plot.legend->item(i))
          room_px = std::min(room_px, item->outerRect().width() - item->minimumOuterSizeHint().width());
      return room_px;
    };
    QTRY_VERIFY(narrowest_px() >= 0);
  }

  void theMapIsDrawnOnceForAllThatChangedAndAnswersBefore() {
    MeasuredTable table;
    table.setSwitches(madeUp(60));
    SwitchMap map(table);
    map.resize(400, 300);
    map.setScales({{}, 0}, {{}, 1});
    map.show();
    QVERIFY(QTest::qWaitForWindowExposed(&map));
    QTRY_VERIFY(map.placeOf(1));
    QCoreApplication::processEvents();
    QSignalSpy drawn(&map, &QCustomPlot::afterReplot);
    for (int i = 0; i < 5; ++i) {
      table.setFilter({QString::number(i), {}, {}});
      map.redraw();
      map.setChosen({static_cast<SwitchIndex>(i)});
    }
    QCOMPARE(drawn.count(), 0);
    QTRY_COMPARE(drawn.count(), 1);
    table.setFilter({"no such switch", {}, {}});
    map.redraw();
    QVERIFY(!map.placeOf(4));  // called before it is painted, of the present entries
    table.setFilter({});
    map.redraw();
    QVERIFY(map.placeOf(4));
  }

  void aFolderBecomesALibraryAfterAQuestion() {
    QTemporaryDir folder;
    QDir().mkpath(folder.filePath("m"));
    const auto write = [&](const char* name, const std::string& text) {
      std::ofstream(folder.filePath(QString("m/") + name).toStdString()) << text;
    };
    write("Soft.csv", csvOf(30, 0));
    write("Firm.csv", csvOf(60, 0));
    write("Click.csv", csvOf(45, 30));
    write("LICENSE", "MIT License");
    write("broken.csv", "force,displacement\nnone,none\n");
    write("scores.csv", "Rank,Switch Name,Manufacturer,Push Feel,Sound\n1,Firm,Somebody,31,7\n");
    ViewSettings view;
    QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
    settings.setValue("measured/library", folder.filePath("l.db"));
    std::vector<Button> opened, compared;
    ButtonDocument document(*tactileButton());
    MeasuredContext context{view, settings, {}, {}, {}, {}, {}, {}};
    context.documents = [&] { return std::vector<ButtonDocument*>{&document}; };
    context.open = [&](const std::vector<Button>& buttons) { opened = buttons; };
    context.compare = [&](const std::vector<Button>& buttons) { compared = buttons; };
    context.page = [&](QWidget*, const QString&) { return folder.filePath("page.html"); };
    MeasuredWindow window(std::move(context));
    QSignalSpy shown(&window, &MeasuredWindow::shown);
    window.show();
    const int empty_px = window.width();  // no larger than its two lines of text need
    window.addFolder(folder.filePath("m"));
    QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 1, patience_ms);
    auto* view_ = window.findChild<QTableView*>("measuredTable");
    auto* credits = window.findChild<QLabel*>("measuredCredits");
    QCOMPARE(view_->model()->rowCount(), 3);
    QVERIFY(window.width() > empty_px);
    QVERIFY(window.findChild<QPushButton*>("measuredRefused")->isVisible());
    QVERIFY2(credits->text().contains("MIT"), qPrintable(credits->text()));
    QVERIFY(view_->isColumnHidden(MeasuredTable::distanceColumn));

    view_->selectRow(1);  // by name: Click, Firm, Soft
    QVERIFY2(credits->text().startsWith("Firm"), qPrintable(credits->text()));
    QVERIFY2(credits->text().contains(
                 "Rated by credit unknown of \"Firm\": Push Feel 31, Sound 7 (licence: MIT)."),
             qPrintable(credits->text()));
    // A name is clicked anywhere, on its row's edges too.
    QHeaderView* const names = view_->verticalHeader();
    for (const int row : {2, 1}) {
      const int edge = row == 1 ? 0 : names->sectionSize(row) - 1;
      QTest::mouseClick(names->viewport(), Qt::LeftButton, {},
                        QPoint(10, names->sectionViewportPosition(row) + edge));
      QCOMPARE(view_->selectionModel()->selectedRows().size(), 1);
      QCOMPARE(view_->selectionModel()->selectedRows().front().row(), row);
    }
    window.findChild<QLineEdit*>("measuredWords")->setText("soft");  // what is chosen is out of view
    QVERIFY2(credits->text().contains("MIT"), qPrintable(credits->text()));
    window.findChild<QLineEdit*>("measuredWords")->clear();
    QVERIFY2(credits->text().startsWith("Firm"), qPrintable(credits->text()));
    view_->sortByColumn(MeasuredTable::kindColumn, Qt::DescendingOrder);
    QTest::mouseClick(window.findChild<QPushButton*>("measuredLikeThis"), Qt::LeftButton);
    QVERIFY(!view_->isColumnHidden(MeasuredTable::distanceColumn));
    QCOMPARE(view_->model()->headerData(0, Qt::Vertical, Qt::DisplayRole).toString(), QString("Firm"));
    QTest::mouseClick(window.findChild<QPushButton*>("measuredOpen"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(opened.size(), std::size_t(1), patience_ms);
    QCOMPARE(opened[0].name(), std::string("Firm"));

    view_->selectAll();
    QTest::mouseClick(window.findChild<QPushButton*>("measuredCompare"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(compared.size(), std::size_t(3), patience_ms);

    window.askFor(document);
    QVERIFY(window.findChild<QComboBox*>("measuredLike")->currentIndex() == 1);
    QTest::mouseClick(window.findChild<QPushButton*>("measuredReport"), Qt::LeftButton);
    QVERIFY(QFile(folder.filePath("page.html")).size() > 1000);

    window.findChild<QLineEdit*>("measuredWords")->setText("soft");
    QCOMPARE(view_->model()->rowCount(), 1);
    window.findChild<QLineEdit*>("measuredWords")->clear();

    // Datasheets on request; without the request the read ones stay.
    const QString page = QFINDTESTDATA("../../../samples/plots/white-vector.pdf");
    QVERIFY(!page.isEmpty() && QFile::copy(page, folder.filePath("m/White.pdf")));
    auto* pages = window.findChild<QAction*>("measuredPages");
    QVERIFY(!pages->isChecked());
    window.findChild<QAction*>("measuredIndexAgain")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 2, patience_ms);
    QCOMPARE(view_->model()->rowCount(), 3);
    pages->setChecked(true);
    QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 3, patience_ms);
    QCOMPARE(view_->model()->rowCount(), 4);
    pages->setChecked(false);
    window.findChild<QAction*>("measuredIndexAgain")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 4, patience_ms);
    QCOMPARE(view_->model()->rowCount(), 4);

    // A library of another program version is rebuilt from its folders, with a notice.
    {
      std::fstream file(folder.filePath("l.db").toStdString(),
                        std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(63);  // the last byte of user_version in the head of an SQLite file
      file.put('\1');
    }
    MeasuredWindow another({view, settings, {}, {}, {}, {}, {}, {}});
    QSignalSpy shownThere(&another, &MeasuredWindow::shown);
    another.show();
    QTRY_COMPARE_WITH_TIMEOUT(shownThere.count(), 1, patience_ms);
    QCOMPARE(another.findChild<QTableView*>("measuredTable")->model()->rowCount(),
             3);  // the page is written on request, too
    const QString said = another.findChild<QLabel*>("measuredSaid")->text();
    QVERIFY2(said.contains("version 1"), qPrintable(said));
  }

  void whatIsNoLibraryIsSaid() {
    QTemporaryDir folder;
    std::ofstream(folder.filePath("x.db").toStdString()) << "no library";
    ViewSettings view;
    QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
    MeasuredWindow window({view, settings, {}, {}, {}, {}, {}, {}});
    QSignalSpy shown(&window, &MeasuredWindow::shown);
    window.openLibrary(folder.filePath("x.db"));
    QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 1, patience_ms);
    QVERIFY(window.findChild<QLabel*>("measuredSaid")->text().contains("x.db"));
  }
};

DETENT_WINDOW_TEST(MeasuredTest)
#include "measured_test.moc"
