// SPDX-License-Identifier: GPL-3.0-or-later
// Forecasts of confusion in the window: computed beside it, said in words, and design help that can be
// undone.

#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include "editor/forecast/forecast_bar.h"
#include "editor/forecast/forecast_matrix.h"
#include "editor/forecast/forecast_words.h"
#include "editor/library/library_panel.h"
#include "model/edits.h"
#include "tests/editor/window_tests.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::test;

namespace {

constexpr int patience_ms = 20000;

Button scaled(const Button& button, double factor) {
  Result<Button> next = scaleForce(button, factor);
  if (!next) throw std::runtime_error(next.failure().sentence());
  return *std::move(next);
}

playback::PredictedPair pairOf(const Button& a, const Button& b) {
  return playback::predictConfusion(*playback::feel(a), *playback::feel(b));
}

/// A source and everything it answered.
struct SourceRig {
  ForecastSource source;
  std::vector<std::shared_ptr<const Forecast>> answers;
  std::vector<std::pair<int, int>> progress;
  SourceRig() {
    QObject::connect(&source, &ForecastSource::ready, &source, [this](auto f) { answers.push_back(f); });
    QObject::connect(&source, &ForecastSource::progress, &source,
                     [this](int done, int all) { progress.emplace_back(done, all); });
  }
};

}  // namespace

/// Posts its click when the button becomes enabled, so that the click is in the queue before any answer: a
/// loaded machine may have answered before the next poll.
class ClickOnceEnabled : public QObject {
 public:
  explicit ClickOnceEnabled(QPushButton* button) : button_(button) { button->installEventFilter(this); }
  bool clicked() const { return clicked_; }

 private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::EnabledChange && button_->isEnabled() && !posted_) {
      posted_ = true;
      QMetaObject::invokeMethod(
          button_,
          [this] {
            button_->click();
            clicked_ = true;
          },
          Qt::QueuedConnection);
    }
    return QObject::eventFilter(watched, event);
  }

  QPushButton* button_;
  bool posted_ = false, clicked_ = false;
};

class ForecastTest : public QObject {
  Q_OBJECT

 private slots:
  void itIsWhatPlaybackPredicts() {
    SourceRig rig;
    const Button a = tactileButton(), b = linearButton(), c = twoLevelButton();
    const auto revision = rig.source.request({a, b, c});
    QTRY_COMPARE_WITH_TIMEOUT(rig.answers.size(), std::size_t{1}, patience_ms);
    const Forecast& all = *rig.answers.front();
    QCOMPARE(all.revision, revision);
    QCOMPARE(all.pairs.size(), std::size_t{3});
    QCOMPARE(all.pairs[0].dPrime, pairOf(a, b).dPrime);
    QCOMPARE(all.pairs[1].dPrime, pairOf(a, c).dPrime);
    QCOMPARE(all.pairs[2].dPrime, pairOf(b, c).dPrime);
    QCOMPARE(rig.progress.back(), std::pair(6, 6));

    rig.source.request({c, a, b}, ForecastPairs::ofFirst);
    QTRY_COMPARE_WITH_TIMEOUT(rig.answers.size(), std::size_t{2}, patience_ms);
    QCOMPARE(rig.answers.back()->pairs.size(), std::size_t{2});
    QVERIFY(std::abs(rig.answers.back()->pairs[0].dPrime - all.pairs[1].dPrime) < 1e-6);
  }

  void theLatestRequestWins() {
    SourceRig rig;
    for (int i = 0; i < 20; ++i) rig.source.request({tactileButton(), scaled(tactileButton(), 1 + 0.01 * i)});
    const auto last = rig.source.request({tactileButton(), linearButton()});
    QTRY_VERIFY_WITH_TIMEOUT(!rig.answers.empty() && rig.answers.back()->revision == last, patience_ms);
    QCOMPARE(rig.answers.size(), std::size_t{1});
  }

  void whatIsGivenUpGivesNoAnswer() {
    SourceRig rig;
    rig.source.request({tactileButton(), linearButton(), twoLevelButton(), lockingButton()});
    rig.source.cancel();
    QTest::qWait(300);
    QVERIFY(rig.answers.empty());
    QVERIFY(rig.progress.empty());
  }

  void theBarSpeaksLive() {
    ForecastBar bar;
    bar.show();
    ButtonDocument a(tactileButton()), b(scaled(tactileButton(), 1.02));
    auto* words = bar.findChild<QLabel*>("forecastWords");
    auto* help = bar.findChild<QPushButton*>("makeDistinguishable");
    bar.setPair(&a, &b);
    QTRY_VERIFY_WITH_TIMEOUT(words->text().startsWith("People cannot tell these apart: "), patience_ms);
    QVERIFY(help->isEnabled());
    a.history().apply(twoLevelButton(), "Another");
    bar.setPair(&a, &b);
    QTRY_VERIFY_WITH_TIMEOUT(words->text().startsWith("People can tell these apart: "), patience_ms);
    QVERIFY(!help->isEnabled());
    bar.setPair(&a, &a);
    QVERIFY(words->text().isEmpty() && !help->isEnabled());
  }

  void distinguishableIsOneStep() {
    ForecastBar bar;
    bar.show();
    const Button first = tactileButton();
    ButtonDocument a(first), b(scaled(first, 1.02));
    bar.setPair(&a, &b);
    auto* help = bar.findChild<QPushButton*>("makeDistinguishable");
    QTRY_VERIFY_WITH_TIMEOUT(help->isEnabled(), patience_ms);
    QSignalSpy offered(&bar, &ForecastBar::offered);
    help->click();
    QVERIFY(!help->isEnabled());
    QTRY_COMPARE_WITH_TIMEOUT(offered.count(), 1, 6 * patience_ms);
    auto* menu = bar.findChild<QMenu*>("suggestionMenu");
    QVERIFY(menu && !menu->actions().empty());
    QAction* way = menu->actions().front();
    QVERIFY2(way->isEnabled(), qPrintable(way->text()));
    QVERIFY(way->text().contains(QChar(0x00D7)) && way->text().contains("in 90"));
    way->trigger();
    menu->close();
    QVERIFY(!(a.button() == first));
    QCOMPARE(a.history().stack().count(), 1);
    QVERIFY(pairOf(a.button(), b.button()).distinguished());
    a.history().stack().undo();
    QVERIFY(a.button() == first);
  }

  void whatWasFoundForAnotherButtonIsNotOffered() {
    ForecastBar bar;
    bar.show();
    ButtonDocument a(tactileButton()), b(scaled(tactileButton(), 1.02));
    bar.setPair(&a, &b);
    auto* help = bar.findChild<QPushButton*>("makeDistinguishable");
    QTRY_VERIFY_WITH_TIMEOUT(help->isEnabled(), patience_ms);
    QSignalSpy offered(&bar, &ForecastBar::offered);
    help->click();
    a.history().apply(scaled(tactileButton(), 1.01), "Scale");
    QTRY_VERIFY_WITH_TIMEOUT(help->isEnabled(), 6 * patience_ms);
    QCOMPARE(offered.count(), 0);
  }

  void theMatrixFollowsTheButtons() {
    ForecastMatrix matrix;
    ButtonDocument a(tactileButton()), b(scaled(tactileButton(), 1.02)), c(twoLevelButton());
    auto* table = matrix.findChild<QTableWidget*>("forecastTable");
    matrix.setDocuments({&a, &b, &c});
    matrix.show();
    QTRY_VERIFY_WITH_TIMEOUT(table->item(1, 1) != nullptr, patience_ms);
    QCOMPARE(table->rowCount(), 2);
    const QString second = b.title() + " (not saved, 2)";
    QCOMPARE(table->verticalHeaderItem(0)->text(), second);
    QCOMPARE(table->horizontalHeaderItem(1)->text(), second);
    QVERIFY(table->item(0, 1) == nullptr);  // a pair is there once
    QVERIFY(table->item(0, 0)->text().section(' ', -1).toDouble() > 9);
    QVERIFY(table->item(0, 0)->font().bold());
    QVERIFY(table->item(1, 0)->text().section(' ', -1).toDouble() < 9);
    QVERIFY(!table->item(1, 0)->font().bold());

    const QString before = table->item(0, 0)->text();
    b.history().apply(linearButton(), "Another");
    QTRY_VERIFY_WITH_TIMEOUT(table->item(0, 0)->text() != before, patience_ms);

    QSignalSpy compare(&matrix, &ForecastMatrix::compareRequested);
    emit table->cellDoubleClicked(1, 0);
    QCOMPARE(compare.count(), 1);
    QCOMPARE(compare.front().at(0).value<ButtonDocument*>(), &a);
    QCOMPARE(compare.front().at(1).value<ButtonDocument*>(), &c);

    matrix.setDocuments({&a, &c});  // at once: no number may stand at another pair
    QCOMPARE(table->rowCount(), 1);
    QVERIFY(table->item(0, 0) == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(table->item(0, 0) != nullptr, patience_ms);
  }

  void theMatrixCanBeStopped() {
    ForecastMatrix matrix;
    std::vector<std::unique_ptr<ButtonDocument>> owned;
    std::vector<ButtonDocument*> documents;
    for (int i = 0; i < 12; ++i) {
      owned.push_back(std::make_unique<ButtonDocument>(scaled(tactileButton(), 1 + 0.05 * i)));
      documents.push_back(owned.back().get());
    }
    matrix.setDocuments(documents);
    auto* stop = matrix.findChild<QPushButton*>("matrixStop");
    ClickOnceEnabled click(stop);
    matrix.show();
    QTRY_VERIFY_WITH_TIMEOUT(click.clicked(), patience_ms);
    QVERIFY(!stop->isVisible());
    QTest::qWait(400);
    QVERIFY(matrix.findChild<QTableWidget*>("forecastTable")->item(0, 0) == nullptr);
  }

  void oneButtonHasNobodyToBeTakenFor() {
    ForecastMatrix matrix;
    ButtonDocument only(tactileButton());
    matrix.setDocuments({&only});
    matrix.show();
    QTRY_VERIFY(matrix.findChild<QLabel*>("matrixWords")->text().contains("two"));
    QVERIFY(!matrix.findChild<QTableWidget*>("forecastTable")->isVisible());
    QVERIFY(!matrix.findChild<QProgressBar*>("matrixProgress")->isVisible());
  }

  void theLibrarySaysItOfTheOneShown() {
    LibraryPanel library;
    ButtonDocument a(tactileButton()), b(scaled(tactileButton(), 1.02)), c(twoLevelButton());
    library.setDocuments({&a, &b, &c}, &a);
    library.show();
    auto* list = library.findChild<QListView*>("libraryOpenButtons");
    const auto line = [&](int row) {
      return list->model()->index(row, 0).data().toString().section('\n', 1);
    };
    QTRY_VERIFY_WITH_TIMEOUT(line(1).startsWith("not told apart") && line(2).startsWith("told apart"),
                             patience_ms);
    QVERIFY(line(0).isEmpty());
    b.history().apply(twoLevelButton(), "Another");
    QTRY_VERIFY_WITH_TIMEOUT(line(1).startsWith("told apart"), patience_ms);
    library.setDocuments({&a, &b, &c}, &b);
    QVERIFY(line(1).isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(!line(0).isEmpty(), patience_ms);
  }
};

DETENT_WINDOW_TEST(ForecastTest)
#include "forecast_test.moc"
