// SPDX-License-Identifier: GPL-3.0-or-later
// How people will press what is compared: computed beside the window and only while it is seen, said in
// words, never as a bare number.

#include "editor/pressing/press_view.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QSlider>
#include <QTableWidget>
#include <QTest>

#include "editor/pressing/effort_plot.h"
#include "editor/pressing/press_words.h"
#include "tests/editor/window_tests.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::test;
using playback::Claim;
using playback::PressFigure;
using playback::PressForecast;

namespace {

constexpr int patience_ms = 300000;  // seconds of computing, a minute under sanitizers

/// 64 fingers around a peak force and a rate of misses.
std::shared_ptr<const PressForecast> madeUp(double peak_N, double misses) {
  auto forecast = std::make_shared<PressForecast>();
  for (int i = 0; i < 64; ++i) {
    const double about = 0.9 + 0.2 * i / 63;
    forecast->ofFingers[static_cast<std::size_t>(PressFigure::peakForce)].push_back(peak_N * about);
    forecast->ofFingers[static_cast<std::size_t>(PressFigure::misses)].push_back(misses * about);
  }
  return forecast;
}

QString cell(const PressView& view, PressFigure figure, int column) {
  const auto* table = view.findChild<QTableWidget*>("pressTable");
  const auto* item = table->item(static_cast<int>(figure), column);
  return item != nullptr ? item->text() : QString();
}

}  // namespace

class PressViewTest : public QObject {
  Q_OBJECT

 private slots:
  void aNumberComesWithItsBandAndUnit() {
    const auto forecast = madeUp(0.6, 12);
    DisplayUnits units;
    units.force = ForceUnit::newton;
    QCOMPARE(bandWords(*forecast, PressFigure::peakForce, units), "0.60 (0.55 to 0.65)");
    QCOMPARE(termOf(PressFigure::peakForce, units).unit, "N");
    units.force = ForceUnit::centinewton;
    QCOMPARE(bandWords(*forecast, PressFigure::peakForce, units), "60 (55 to 65)");
    QCOMPARE(bandWords(*forecast, PressFigure::misses, units), "12 (11 to 13)");
    QCOMPARE(bandWords(*forecast, PressFigure::doubles, units), "no forecast");
  }

  void lessThanFifteenPercentIsNoDifference() {
    const auto first = madeUp(0.6, 12);
    const auto words = [&](const PressForecast& second, PressFigure figure) {
      return differenceWords(playback::differenceOf(*first, second, figure));
    };
    QCOMPARE(words(*madeUp(0.66, 12), PressFigure::peakForce), "no difference forecast");
    QCOMPARE(words(*madeUp(1.2, 12), PressFigure::peakForce), "higher, × 2.00");
    QCOMPARE(words(*madeUp(0.3, 12), PressFigure::peakForce), "lower, × 0.50");
    QCOMPARE(words(*madeUp(0.6, 12), PressFigure::doubles), "no forecast");
  }

  void aDotForEachForecast() {
    EffortPlot plot;
    plot.setForecasts({madeUp(0.6, 12), std::make_shared<PressForecast>(), madeUp(1.2, 3)}, {"a", "b", "c"},
                      {});
    QCOMPARE(plot.graphCount(), 2);
    QCOMPARE(plot.graph(1)->name(), "c");
    QVERIFY(plot.graph(0)->data()->at(0)->key < plot.graph(1)->data()->at(0)->key);
    QVERIFY(plot.graph(0)->data()->at(0)->value > plot.graph(1)->data()->at(0)->value);
    QVERIFY(plot.xAxis->range().upper > plot.graph(1)->data()->at(0)->key);
  }

  void whatCannotBeForecastSaysWhyAndWhatIfHelps() {
    PressView view;
    view.resize(700, 900);
    const Button button = tactileButton();  // says nowhere that it acts
    view.setButtons({{button, "Tactile"}}, {});
    auto* table = view.findChild<QTableWidget*>("pressTable");
    QTest::qWait(600);
    QCOMPARE(table->columnCount(), 0);  // hidden: nothing is computed
    view.show();
    QTRY_COMPARE_WITH_TIMEOUT(cell(view, PressFigure::peakForce, 1), "no forecast", patience_ms);
    QVERIFY(view.findChild<QLabel*>("pressWords")
                ->text()
                .contains("Tactile: The button has no operating point."));
    QVERIFY(view.findChild<QLabel*>("pressPlace")->text().isEmpty());

    view.findChild<QCheckBox*>("pressElsewhere")->setChecked(true);
    auto* slider = view.findChild<QSlider*>("pressOperateAt");
    slider->setValue(150);
    QCOMPARE(view.findChild<QLabel*>("pressPlace")->text(), "1.5 mm");
    QTRY_VERIFY_WITH_TIMEOUT(cell(view, PressFigure::peakForce, 1).contains(" to "), patience_ms);
    QVERIFY(!view.findChild<QLabel*>("pressWords")->text().contains("operating point"));
    QCOMPARE(view.findChild<EffortPlot*>("effortPlot")->graphCount(), 1);
    QVERIFY(view.tableText().startsWith("\"Forecast\",\"Tactile\"\n\"Peak force of the fingertip ("));
    QVERIFY(!button.states().front().operatingPoint_mm);  // a forecast, not an edit

    view.resize(420, 900);
    view.setButtons({{button, "Tactile"}, {linearButton(), "Linear"}}, {});
    QTRY_COMPARE_WITH_TIMEOUT(table->columnCount(), 4, patience_ms);
    QVERIFY(cell(view, PressFigure::peakForce, 3).contains("er, × ") ||
            cell(view, PressFigure::peakForce, 3) == "no difference forecast" ||
            cell(view, PressFigure::peakForce, 3) == "not decided");
    QTRY_VERIFY(table->horizontalScrollBar()->maximum() > 0);
    QTRY_COMPARE(table->verticalScrollBar()->maximum(), 0);  // all rows are seen
  }

  void aForecastThatWasOvertakenDoesNotCome() {
    PressSource source;
    std::vector<std::uint64_t> answers;
    connect(&source, &PressSource::ready, this,
            [&](const auto& answer) { answers.push_back(answer->revision); });
    source.request({tactileButton()}, 1.5);
    const std::uint64_t last = source.request({linearButton()}, {});  // has no operating point: at once
    QTRY_VERIFY_WITH_TIMEOUT(!answers.empty(), patience_ms);
    QCOMPARE(answers, std::vector<std::uint64_t>{last});
    source.request({tactileButton()}, 1.5);
    source.cancel();
    QTest::qWait(300);
    QCOMPARE(answers.size(), std::size_t{1});
  }
};

DETENT_WINDOW_TEST(PressViewTest)
#include "press_view_test.moc"
