// SPDX-License-Identifier: GPL-3.0-or-later
// The import dialogue as its users meet it: sample plots in, corrections by mouse and keyboard, buttons out.

#include "editor/importing/import_dialog.h"

#include <functional>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QScopeGuard>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "editor/files/input_kind.h"
#include "editor/importing/advice_bar.h"
#include "editor/importing/findings_panel.h"
#include "editor/importing/import_state.h"
#include "editor/importing/page_list.h"
#include "editor/importing/page_list_model.h"
#include "editor/importing/page_return.h"
#include "editor/importing/page_view.h"
#include "model/file/button_file.h"
#include "model/file/svg_plot.h"
#include "tests/editor/importing/stall_probe.h"
#include "tests/editor/window_tests.h"
#include "tests/samples/two_switches.h"

using namespace detent;
using namespace detent::editor;
using Report = std::shared_ptr<const importer::ImportReport>;

namespace {

constexpr int patience_ms = 60000;  // machines under load, sanitizers

QString sample(const char* name) { return QStringLiteral(DETENT_SOURCE_DIR "/samples/plots/") + name; }

/// Keeps pictures of what the tests saw where DETENT_PICTURES names a folder.
void keepPicture(QWidget& widget, const QString& name) {
  const QString folder = qEnvironmentVariable("DETENT_PICTURES");
  if (folder.isEmpty()) return;
  QTest::qWait(50);
  widget.grab().save(folder + '/' + name + ".png");
}

struct OwnSettings {
  ViewSettings settings;
};

/// As a person has it before a sheet is in it.
class ShownDialog : private OwnSettings, public ImportDialog {
 public:
  ShownDialog() : ImportDialog(settings) { show(); }
  QPushButton* const accept = findChild<QPushButton*>("import");
  AdviceBar* const banner = findChild<AdviceBar*>();
  PageView* const view = findChild<PageView*>();
};

struct OwnState : OwnSettings {
  ImportState itsState;
};

/// The page alone, without the dialogue around it.
class ShownView : private OwnState, public PageView {
 public:
  explicit ShownView(QSize size = {900, 700}) : PageView(itsState, settings) {
    resize(size);
    show();
  }
};

/// Axes and a curve, but no numbers and no box: the importer cannot know.
QImage pictureWithoutNumbers() {
  QImage picture(800, 600, QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  painter.setPen(QPen(Qt::black, 2));
  painter.drawLine(100, 500, 700, 500);
  painter.drawLine(100, 500, 100, 100);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(200, 0, 0), 3));
  QPolygonF curve;
  for (int x = 100; x <= 690; ++x)
    curve << QPointF(x, 500 - 0.5 * (x - 100) - (x > 650 ? 2.0 * (x - 650) : 0));
  painter.drawPolyline(curve);
  return picture;
}

/// The lines of a drawing of sample C whose frame ends at the last tick, without those that `gone` names and
/// with `changed` in the others.
QString drawingOfC(const QTemporaryDir& folder, const std::function<bool(const QString&)>& gone,
                   const std::function<void(QString&)>& changed = {}) {
  const auto button = readButtonFile(DETENT_SOURCE_DIR "/samples/buttons/C.button.json");
  SvgPlotStyle style;
  style.roomBeyondEnd = 0;
  QStringList kept;
  for (QString line : QString::fromStdString(svgFrom(*button, style)).split('\n')) {
    if (gone(line)) continue;
    if (changed) changed(line);
    kept << line;
  }
  QFile file(folder.filePath("drawing.svg"));
  if (file.open(QIODevice::WriteOnly)) file.write(kept.join('\n').toUtf8());
  return file.fileName();
}

void drawFrame(PageView& view, importer::Point topLeft, importer::Point bottomRight) {
  view.setTool(PageToolKind::drawFrame);
  const QPoint from = view.toWidget(topLeft).toPoint(), to = view.toWidget(bottomRight).toPoint();
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&view, to);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
}

void typeInto(QLineEdit* edit, const char* text) {
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, text);
  QTest::keyClick(edit, Qt::Key_Return);
}

bool settled(const ImportState& state) {
  const ImportGraph* graph = state.current();
  return !state.opening() && graph && graph->pending == 0 && graph->last;
}

}  // namespace

class ImportDialogTest : public QObject {
  Q_OBJECT

  /// Opened, its graph imported, all pages searched.
  static bool open(ImportState& state, const QString& path) {
    state.openFile(path);
    const bool done = QTest::qWaitFor(
        [&] { return settled(state) && state.searchedPages() == state.pageCount(); }, patience_ms);
    QTest::qWait(1);
    return done;
  }
  static bool again(ImportState& state) {
    const bool done = QTest::qWaitFor([&] { return settled(state); }, patience_ms);
    QTest::qWait(1);  // the view is updated after the answer
    return done;
  }
  static const importer::ImportReport& report(const ImportState& state) {
    return *state.current()->last->report;
  }

  QTemporaryDir folder_;
  QString twoSwitches_ = folder_.filePath("two.svg");

 private slots:
  void initTestCase() {
    QFile file(twoSwitches_);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(tests::twoSwitchesSvg().c_str()) > 0);
  }
  void aSampleIsImportedWithoutAWord();
  void anAxisIsCorrectedAndOnlyWhatDependsOnItRuns();
  void oneMisreadTickIsRetyped();
  void aNamedTickKeepsTheOthers();
  void anEndAgainstThePrintedNumbersIsDoubted();
  void exchangedAxesAreRefusedByName();
  void anotherQuantityIsAnHonestAnswer();
  void aClickBeforeTheSearchEndsCounts();
  void unitsArePickedAndGoBackToFound();
  void aColourIsPickedOnThePage();
  void aMaskChangesTheTraceAndUndoRestores();
  void strokesAreExchanged();
  void qualityKeepsCorrections();
  void aWorkIsStopped();
  void staleAnswersAreDropped();
  void brokenFilesSayWhatToDo_data();
  void brokenFilesSayWhatToDo();
  void aFrameDrawnByHandOnAPictureWithoutGraph();
  void aDrawnFrameIsTheOneShownAndStandsFreelyWithCtrl();
  void whileAGraphIsReadNothingSaysThereIsNone();
  void theImportsFilterShowsWhatItPromises();
  void theLastGoodResultStays();
  void aDoubtedNumberNamesItsCause();
  void aFrameIsTakenToWhereItsCurveEnds();
  void anAxisThatGoesOnOffersToExtendTheFrame();
  void severalGraphsAtOnce();
  void ofSeveralSwitchesOneIsChosen();
  void severalSwitchesOfOnePlotAtOnce();
  void aForceLog();
  void aPastedPicture();
  void theFrameIsDraggedWithTheMouse();
  void aCurveIsDrawnByHand();
  void thePageLiesStillUnderAGesture();
  void aFieldInHandKeepsItsSelection();
  void theFieldsOfAFallingAxisNameItsEndsByPlace();
  void whatIsShownGivenAgainChangesNothing();
  void findingsEndWithTheirLastBox();
  void aFrameBesideTheShownOneAddsAGraph();
  void theBannerRequestsAMissingUnit();
  void axisEndsAreTypedAlikeInEveryLanguage();
  void graphsAreListedWithoutTheirPages();
  void theOriginSetsBothAxes();
  void aTickOfAFrameAskewStandsWhereItWasClicked();
  void theDialogueFitsSmallScreens();
  void anotherSheetAsksBeforeCorrectionsGo();
  void aGraphOnItsSideIsCorrectedToo();
  void theKeyboardReachesEverything();
  void theWindowNeverStalls();
  void closingWhileItWorks();
  void picturesOfInputs();
};

void ImportDialogTest::aSampleIsImportedWithoutAWord() {
  ShownDialog dialog;
  QVERIFY(!dialog.accept->isEnabled());
  QSignalSpy imported(&dialog, &ImportDialog::imported), closed(&dialog, &QDialog::accepted);
  dialog.openFile(sample("two-level-legend.png"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QVERIFY(!dialog.findChild<AdviceBar*>()->isVisible());
  QTest::qWait(50);
  QVERIFY(dialog.findChild<PageList*>()->width() > 100);
  keepPicture(dialog, "two-level");
  QTest::mouseClick(dialog.accept, Qt::LeftButton);
  QCOMPARE(imported.count(), 1);
  QCOMPARE(closed.count(), 1);
  const auto result = imported.front().front().value<Report>();
  QVERIFY(std::abs(result->button.states().front().graph.travel_mm() - 3.2) < 0.03);
  QCOMPARE(result->press.fit.tactilePoints.size(), std::size_t{2});
}

void ImportDialogTest::anAxisIsCorrectedAndOnlyWhatDependsOnItRuns() {
  ImportState state;
  QVERIFY(open(state, sample("white-vector.pdf")));
  const double travel_mm = report(state).button.states().front().graph.travel_mm();
  QVERIFY(report(state).seconds.count(importer::ImportStep::trace));
  Corrections next = state.current()->history.now();
  next.x.min = 0, next.x.max = 9;  // twice the true range
  state.apply(next, "Displacement range");
  QVERIFY(again(state));
  QVERIFY(std::abs(report(state).button.states().front().graph.travel_mm() - 2 * travel_mm) <
          0.01 * travel_mm);
  const auto& seconds = report(state).seconds;
  QVERIFY(seconds.count(importer::ImportStep::axes) && seconds.count(importer::ImportStep::strokes) &&
          seconds.count(importer::ImportStep::fit));
  QVERIFY(!seconds.count(importer::ImportStep::locate) && !seconds.count(importer::ImportStep::texts) &&
          !seconds.count(importer::ImportStep::trace));
  QVERIFY(!report(state).evidence->axes.calibration.value.x.ticks.empty());  // still shown, though not used
  state.undo();
  QVERIFY(again(state));
  QVERIFY(std::abs(report(state).button.states().front().graph.travel_mm() - travel_mm) < 1e-9);
  QVERIFY(!report(state).seconds.count(importer::ImportStep::axes));  // the axes were kept, not read again
}

void ImportDialogTest::oneMisreadTickIsRetyped() {
  ShownView view({800, 600});
  ImportState& state = view.state();
  QVERIFY(open(state, sample("white-vector.pdf")));
  const auto before = *report(state).x;
  const auto& ticks = view.drawn().xTicks;
  QVERIFY(ticks.size() >= 3);
  const auto last =
      std::max_element(ticks.begin(), ticks.end(), [](auto& a, auto& b) { return a.at.x < b.at.x; });
  const double value = last->value;
  QTest::mouseDClick(&view, Qt::LeftButton, {}, view.toWidget(last->at).toPoint());
  auto* editor = view.findChild<QLineEdit*>("tickValue");
  QVERIFY(editor);
  QCOMPARE(editor->text().toDouble(), value);
  editor->setText("nonsense");
  QTest::keyClick(editor, Qt::Key_Return);
  QVERIFY(!state.working());
  QTest::qWait(1);
  editor = view.findChild<QLineEdit*>("tickValue");
  QVERIFY(editor);  // the field waits for a number
  editor->setText(QString::number(2 * value));
  QTest::keyClick(editor, Qt::Key_Return);
  QVERIFY(again(state));
  QVERIFY(std::abs(report(state).x->max - 2 * before.max) < 0.02 * before.max);
  QVERIFY(std::abs(report(state).x->min - before.min) < 0.01);
  QCOMPARE(state.current()->history.now().x.ticks.size(), std::size_t{1});
}

namespace {

/// A drawing of sample C whose tick label of 1 mm is misprinted as 4.
QString drawingWithAMisprint(const QTemporaryDir& folder) {
  return drawingOfC(
      folder, [](const QString&) { return false; },
      [](QString& line) {
        if (line.contains("x=\"209.50\" y=\"419.00\"")) line.replace(">1.0<", ">4.0<");
      });
}

/// The same drawing with other axis titles.
QString drawingTitled(const QTemporaryDir& folder, const QString& x, const QString& y) {
  return drawingOfC(
      folder, [](const QString&) { return false; },
      [&](QString& line) { line.replace("Displacement (mm)", x).replace("Force (N)", y); });
}

}  // namespace

// The labels 0, 0.5, 1.5 and on are right: naming the misprinted one uses them all.
void ImportDialogTest::aNamedTickKeepsTheOthers() {
  QTemporaryDir folder;
  ShownView view({800, 600});
  ImportState& state = view.state();
  ViewSettings settings;
  FindingsPanel panel(state, settings);
  QVERIFY(open(state, drawingWithAMisprint(folder)));
  const auto forceRange = [&] {
    return panel.findChild<QToolButton*>("resetY")->parentWidget()->findChild<QLabel*>()->text();
  };
  const QString forceBefore = forceRange();
  const auto before = *report(state).x;
  QCOMPARE(std::ranges::count_if(before.ticks, &importer::TickLabel::agrees), 8);
  const auto& ticks = view.drawn().xTicks;
  const auto misprint = std::ranges::find_if(ticks, [](const DrawnTick& tick) { return !tick.used; });
  QVERIFY(misprint != ticks.end());
  QTest::mouseDClick(&view, Qt::LeftButton, {}, view.toWidget(misprint->at).toPoint());
  auto* editor = view.findChild<QLineEdit*>("tickValue");
  QVERIFY(editor);
  editor->setText("1");
  QTest::keyClick(editor, Qt::Key_Return);
  QVERIFY(again(state));
  const auto& after = *report(state).x;
  QCOMPARE(after.min, 0.0);
  QCOMPARE(after.max, before.max);
  QCOMPARE(std::ranges::count_if(after.ticks, &importer::TickLabel::agrees), 8);
  QCOMPARE(forceRange(), forceBefore);  // says nothing about the axis that was not corrected
  QVERIFY(after.contradicting.empty());
  QVERIFY(!report(state).doubt);
}

// "4.1" where the page prints 4.0: said in words, and nothing in the panel moves for it.
void ImportDialogTest::anEndAgainstThePrintedNumbersIsDoubted() {
  QTemporaryDir folder;
  ShownDialog dialog;
  dialog.openFile(drawingTitled(folder, "Displacement (mm)", "Force (N)"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QVERIFY(again(dialog.view->state()));
  const auto rowsOfFields = [&] {
    QList<int> rows;
    for (const char* name : {"xMin", "xMax", "yMin", "yMax"})
      rows << dialog.findChild<QLineEdit*>(name)->mapTo(&dialog, QPoint()).y();
    return rows;
  };
  const QList<int> before = rowsOfFields();
  auto* right = dialog.findChild<QLineEdit*>("xMax");
  typeInto(right, "4.1");
  QVERIFY(again(dialog.view->state()));
  QVERIFY(dialog.accept->isEnabled());  // what is given holds, with a remark
  QCOMPARE(rowsOfFields(), before);
  QVERIFY(report(dialog.view->state()).confidence < 0.9);
  QVERIFY(std::ranges::any_of(dialog.findChildren<QLabel*>(), [](const QLabel* label) {
    return label->isVisible() && label->text().contains("contradict");
  }));
  keepPicture(dialog, "given-against-labels");
  typeInto(right, "4");
  QVERIFY(again(dialog.view->state()));
  QVERIFY(dialog.accept->isEnabled());
  QCOMPARE(rowsOfFields(), before);
  const auto& x = *report(dialog.view->state()).x;
  QCOMPARE(std::ranges::count_if(x.ticks, &importer::TickLabel::agrees), 9);  // though the end was given
}

// The page says so; its frame, taken by hand, leads to the same refusal without a question.
void ImportDialogTest::exchangedAxesAreRefusedByName() {
  QTemporaryDir folder;
  ShownDialog dialog;
  ImportState& state = dialog.view->state();
  dialog.openFile(drawingTitled(folder, "Force (gf)", "Travel (mm)"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.banner->isVisible(), patience_ms);
  QVERIFY2(dialog.banner->text().contains("exchanged"), qPrintable(dialog.banner->text()));
  QVERIFY(!state.current());
  keepPicture(dialog, "exchanged");
  QTest::mouseClick(dialog.view, Qt::LeftButton, {}, dialog.view->toWidget({300, 200}).toPoint());
  QVERIFY(state.current());
  QVERIFY(again(state));
  QVERIFY2(dialog.banner->text().contains("exchanged"), qPrintable(dialog.banner->text()));
  QVERIFY(!dialog.findChild<QPushButton*>("otherQuantity"));
  QVERIFY(!dialog.accept->isEnabled());
}

// Force over time: none of the units is right, and there is a button that says so.
void ImportDialogTest::anotherQuantityIsAnHonestAnswer() {
  QTemporaryDir folder;
  ShownDialog dialog;
  ImportState& state = dialog.view->state();
  dialog.openFile(drawingTitled(folder, "Time (s)", "Force (N)"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.banner->isVisible(), patience_ms);
  QTest::mouseClick(dialog.view, Qt::LeftButton, {}, dialog.view->toWidget({300, 200}).toPoint());
  QVERIFY(state.current());
  QVERIFY(again(state));
  auto* other = dialog.findChild<QPushButton*>("otherQuantity");
  QVERIFY(other && other->isVisible());
  keepPicture(dialog, "another-quantity");
  QTest::mouseClick(other, Qt::LeftButton);
  QVERIFY(state.current()->isOther());
  QVERIFY(again(state));
  QVERIFY2(dialog.banner->text().contains("no displacement"), qPrintable(dialog.banner->text()));
  QVERIFY(!dialog.accept->isEnabled());
  state.undo();
  QVERIFY(again(state));
  QVERIFY(!dialog.banner->text().contains("no displacement"));
}

void ImportDialogTest::aClickBeforeTheSearchEndsCounts() {
  QTemporaryDir folder;
  ShownView view;
  ImportState& state = view.state();
  state.openFile(drawingTitled(folder, "Force (gf)", "Travel (mm)"));
  QTRY_VERIFY_WITH_TIMEOUT(state.sheet() || state.searchedPages() == 1, patience_ms);
  if (state.searchedPages() == 1) QSKIP("the page was searched before it could be clicked");
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.toWidget({300, 200}).toPoint());
  QVERIFY(!state.current());
  QTRY_VERIFY_WITH_TIMEOUT(state.current(), patience_ms);
  QVERIFY(again(state));
}

void ImportDialogTest::unitsArePickedAndGoBackToFound() {
  ViewSettings settings;
  ImportState state;
  FindingsPanel panel(state, settings);
  panel.show();
  QVERIFY(open(state, sample("brown-one-ink.png")));
  auto* unit = panel.findChild<QComboBox*>("yUnit");
  auto* reset = panel.findChild<QToolButton*>("resetYUnit");
  QCOMPARE(unit->currentText(), QString("cN"));
  QVERIFY(!reset->isVisibleTo(&panel));
  const double force_N = report(state).press.fit.tactilePoints.front().point.force_N;
  unit->setCurrentText("gf");
  emit unit->activated(unit->currentIndex());
  QVERIFY(again(state));
  QVERIFY(std::abs(report(state).press.fit.tactilePoints.front().point.force_N - 0.980665 * force_N) <
          1e-3 * force_N);
  QVERIFY(!report(state).seconds.count(importer::ImportStep::trace));
  QVERIFY(reset->isVisibleTo(&panel));
  reset->click();
  QVERIFY(again(state));
  QCOMPARE(unit->currentText(), QString("cN"));
  QCOMPARE(state.current()->history.now(), Corrections{});
}

void ImportDialogTest::aColourIsPickedOnThePage() {
  ShownView view;
  ImportState& state = view.state();
  QVERIFY(open(state, sample("two-level-legend.png")));
  QVERIFY(QTest::qWaitFor([&] { return state.sheet() != nullptr; }, patience_ms));
  const auto& traced = view.drawn().release->traced;
  view.setTool(PageToolKind::pressColor);
  // The release curve is called the press: strokes change their names.
  const QPoint at = view.pageToWidget().map(traced[traced.size() / 3]).toPoint();
  QTest::mouseMove(&view, at);
  QTest::mouseClick(&view, Qt::LeftButton, {}, at);
  QCOMPARE(view.tool(), PageToolKind::adjust);
  const auto color = state.current()->history.now().pressColor;
  QVERIFY(color);
  QVERIFY(again(state));
  QVERIFY(!report(state).seconds.count(importer::ImportStep::locate));
  QVERIFY(report(state).seconds.count(importer::ImportStep::trace));
}

void ImportDialogTest::aMaskChangesTheTraceAndUndoRestores() {
  ShownView view;
  ImportState& state = view.state();
  QVERIFY(open(state, sample("two-level-legend.png")));
  const Report before = state.current()->last->report;
  view.setTool(PageToolKind::maskBox);
  const QPointF end = view.pageToWidget().map(view.drawn().press->fit.back());
  const QPoint from = (end - QPointF(40, 20)).toPoint(), to = (end + QPointF(40, 60)).toPoint();
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&view, (from + to) / 2);
  QTest::mouseMove(&view, to);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  QCOMPARE(state.current()->history.now().masks.size(), std::size_t{1});
  QVERIFY(again(state));
  QVERIFY(!state.current()->last->report ||
          state.current()->last->report->seconds.count(importer::ImportStep::trace));
  QVERIFY(!state.current()->last->report ||
          !state.current()->last->report->seconds.count(importer::ImportStep::locate));
  state.undo();
  QVERIFY(again(state));
  QCOMPARE(report(state).button.states(), before->button.states());
}

void ImportDialogTest::strokesAreExchanged() {
  ImportState state;
  QVERIFY(open(state, sample("brown-german-comma.png")));
  const double peak_N = report(state).press.fit.tactilePoints.front().point.force_N;
  Corrections next = state.current()->history.now();
  next.swapStrokes = true;
  state.apply(next, "Swap press and release");
  QVERIFY(again(state));
  QVERIFY(state.current()->last->report);
  QVERIFY(!report(state).seconds.count(importer::ImportStep::trace));
  const auto& points = report(state).press.fit.tactilePoints;
  QVERIFY(points.empty() || std::abs(points.front().point.force_N - peak_N) > 0.02);
}

void ImportDialogTest::qualityKeepsCorrections() {
  ImportState state;
  QVERIFY(open(state, sample("white-chinese-gf.png")));
  Corrections next = state.current()->history.now();
  next.yUnit = ForceUnit::centinewton;
  state.apply(next, "Force unit");
  QVERIFY(again(state));
  state.setQuality(importer::Quality::draft);
  QVERIFY(again(state));
  QCOMPARE(report(state).quality, importer::Quality::draft);
  QCOMPARE(report(state).y->unit, std::string("cN"));
  QCOMPARE(report(state).y->unitBy, DecidedBy::given);
}

void ImportDialogTest::aWorkIsStopped() {
  ImportState state;
  QVERIFY(open(state, sample("white-chinese-gf.png")));
  const auto before = state.current()->last;
  state.setQuality(importer::Quality::precise);
  QVERIFY(state.working());
  state.cancel();
  QVERIFY(!state.working());
  QTest::qWait(300);
  QCOMPARE(state.current()->last, before);
  QVERIFY(!state.current()->upToDate(state.quality()));
  state.selectGraph(state.current()->id);
  QVERIFY(again(state));
  QVERIFY(state.current()->upToDate(state.quality()));
}

void ImportDialogTest::staleAnswersAreDropped() {
  ImportState state;
  QVERIFY(open(state, sample("white-vector.pdf")));
  QSignalSpy results(&state, &ImportState::resultChanged);
  Corrections next = state.current()->history.now();
  for (const double max : {5.0, 6.0, 7.0, 8.0}) {
    next.x.min = 0, next.x.max = max;
    state.apply(next, "Displacement range");
  }
  QVERIFY(again(state));
  QCOMPARE(report(state).x->max, 8.0);
  // Another file while the first is at work: nothing of the first comes any more.
  next.x.max = 9;
  state.apply(next, "Displacement range");
  QVERIFY(open(state, sample("brown-one-ink.png")));
  QCOMPARE(state.documentName(), QString("brown-one-ink.png"));
  QVERIFY(std::abs(report(state).x->max - 4) < 0.01);
}

void ImportDialogTest::brokenFilesSayWhatToDo_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("says");
  QTest::newRow("empty") << QByteArray() << "empty.png"
                         << "empty";
  QTest::newRow("text") << QByteArray("hello") << "a.pdf"
                        << "plain text";
  QTest::newRow("truncated") << QByteArray("%PDF-1.7\n1 0 obj\n<<") << "cut.pdf"
                             << "truncated";
  QTest::newRow("missing") << QByteArray("-") << ""
                           << "no such file";
}

void ImportDialogTest::brokenFilesSayWhatToDo() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, name);
  QFETCH(QString, says);
  QTemporaryDir folder;
  const QString path = folder.filePath(name.isEmpty() ? "missing.pdf" : name);
  if (!name.isEmpty()) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  }
  ShownDialog dialog;
  dialog.openFile(path);
  QTRY_VERIFY_WITH_TIMEOUT(dialog.banner->isVisible(), patience_ms);
  QVERIFY2(dialog.banner->text().contains(says), qPrintable(dialog.banner->text()));
  QVERIFY(!dialog.banner->text().contains("--"));
  QVERIFY(!dialog.findChild<QPushButton*>("import")->isEnabled());
  // The next file opens as if nothing had been.
  dialog.openFile(sample("white-vector.pdf"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QPushButton*>("import")->isEnabled(), patience_ms);
  QVERIFY(!dialog.banner->isVisible());
}

void ImportDialogTest::aFrameDrawnByHandOnAPictureWithoutGraph() {
  ShownDialog dialog;
  dialog.openPicture(pictureWithoutNumbers());
  QTRY_VERIFY_WITH_TIMEOUT(dialog.banner->isVisible(), patience_ms);
  ImportState& state = dialog.view->state();
  QTRY_VERIFY_WITH_TIMEOUT(state.sheet(), patience_ms);
  QVERIFY(!state.current());
  QTest::qWait(20);
  keepPicture(dialog, "no-graph");
  // The axes are drawn at x = 100 and y = 500: a hand that misses them by some pixels means them.
  const double by = 5 / std::sqrt(std::abs(dialog.view->pageToWidget().determinant()));
  drawFrame(*dialog.view, {100 + by, 100}, {700, 500 - by});
  QVERIFY(state.current());
  const FrameCorners corners = *state.current()->corners();
  QVERIFY2(std::abs(corners[3].x - 100) < 1.5 && std::abs(corners[3].y - 500) < 1.5,
           qPrintable(QString("%1, %2").arg(corners[3].x).arg(corners[3].y)));
  QVERIFY(again(state));
  QVERIFY(state.current()->last->failure);  // an error says that numbers are missing
  QVERIFY(dialog.banner->isVisible());
  keepPicture(dialog, "no-numbers");
  for (const auto& [field, value] : {std::pair("xMin", "0"), {"xMax", "4"}, {"yMin", "0"}, {"yMax", "120"}}) {
    auto* edit = dialog.findChild<QLineEdit*>(field);
    edit->setFocus();
    edit->clear();
    QTest::keyClicks(edit, value);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  QTRY_VERIFY_WITH_TIMEOUT(state.current()->good, patience_ms);
  QVERIFY(again(state));
  const auto& graph = report(state).button.states().front().graph;
  QVERIFY(std::abs(graph.travel_mm() - 4 * 590 / 600.0) < 0.06);
  keepPicture(dialog, "by-hand");
}

void ImportDialogTest::aDrawnFrameIsTheOneShownAndStandsFreelyWithCtrl() {
  ShownDialog dialog;
  dialog.openPicture(pictureWithoutNumbers());
  ImportState& state = dialog.view->state();
  QTRY_VERIFY_WITH_TIMEOUT(dialog.banner->isVisible() && state.sheet(), patience_ms);
  QTest::qWait(20);
  PageView& view = *dialog.view;
  const double by = 5 / std::sqrt(std::abs(view.pageToWidget().determinant()));
  const importer::Point from{100 + by, 100}, to{700, 500 - by};
  for (const bool freely : {false, true}) {
    const Qt::KeyboardModifiers keys = freely ? Qt::ControlModifier : Qt::NoModifier;
    view.setTool(PageToolKind::drawFrame);
    QTest::mousePress(&view, Qt::LeftButton, keys, view.toWidget(from).toPoint());
    QMouseEvent move(QEvent::MouseMove, view.toWidget(to), view.mapToGlobal(view.toWidget(to)), Qt::NoButton,
                     Qt::LeftButton, keys);
    QCoreApplication::sendEvent(&view, &move);
    keepPicture(dialog, freely ? "frame-freely" : "frame-snapped");
    const QImage picture = view.grab().toImage();
    const auto shownAt = [&](double x) {  // dashes in the upper part of the left edge, free of the curve
      int dashes = 0;
      for (int step = 0; step < 200; ++step) {
        const QPointF at = view.toWidget({x, 150.0 + step});
        int reddest = 0;
        for (const double beside_px : {-1.0, 0.0, 1.0}) {
          const QColor color = picture.pixelColor((at + QPointF(beside_px, 0)).toPoint());
          reddest = std::max(reddest, color.red() - color.green());
        }
        dashes += reddest > 80;
      }
      return dashes > 60;
    };
    QCOMPARE(shownAt(from.x), freely);
    QCOMPARE(shownAt(100), !freely);
    QTest::mouseRelease(&view, Qt::LeftButton, keys, view.toWidget(to).toPoint());
    const FrameCorners corners = *state.current()->corners();
    const double x = freely ? from.x : 100, y = freely ? to.y : 500;
    QVERIFY2(std::abs(corners[3].x - x) < 1.5 && std::abs(corners[3].y - y) < 1.5,
             qPrintable(QString("%1, %2").arg(corners[3].x).arg(corners[3].y)));
    QVERIFY(again(state));
  }
}

void ImportDialogTest::whileAGraphIsReadNothingSaysThereIsNone() {
  ShownDialog dialog;
  ImportState& state = dialog.view->state();
  const auto saysNone = [&] {
    const auto labels = dialog.banner->findChildren<QLabel*>();
    return dialog.banner->isVisible() && std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
             return label->text().contains("No force graph");
           });
  };
  bool saidWhileRead = false;
  const auto readToItsEnd = [&] {
    return QTest::qWaitFor(
        [&] {
          saidWhileRead = saidWhileRead || saysNone();
          return settled(state);
        },
        patience_ms);
  };
  dialog.openPicture(pictureWithoutNumbers());
  QTRY_VERIFY_WITH_TIMEOUT(saysNone() && state.sheet(), patience_ms);
  QTest::qWait(20);
  drawFrame(*dialog.view, {100, 100}, {700, 500});
  QVERIFY(!saysNone());
  QVERIFY(readToItsEnd());
  state.correct("Axes", [](Corrections& c) { c.x.min = 0, c.x.max = 4, c.y.min = 0, c.y.max = 120; });
  QVERIFY(readToItsEnd());
  for (const char* name : {"two-level-legend.png", "white-vector.pdf"}) {
    dialog.openFile(sample(name));
    QVERIFY(readToItsEnd());
  }
  QVERIFY(!saidWhileRead);
}

// The file filter shows every sample sheet, whatever the case of its ending, and no button files.
void ImportDialogTest::theImportsFilterShowsWhatItPromises() {
  const QString filter = importFilters().front();
  const QString patterns = filter.section('(', -1).section(')', 0, 0);
  const auto isShown = [&](const QString& name) { return QDir::match(patterns.split(' '), name); };
  for (const char* kind : {"pictures", "logs", "atasheets"}) QVERIFY2(filter.contains(kind), kind);
  int sheets = 0;
  for (const QFileInfo& file : QDir(sample("")).entryInfoList({"*"}, QDir::Files)) {
    if (QStringList{"md", "sh", "py", "tsv"}.contains(file.suffix())) continue;
    const Result<InputKind> kind = inputKindOf(file.filePath());
    QVERIFY(kind && *kind == InputKind::page);
    QVERIFY2(isShown(file.fileName()) && isShown(file.fileName().toUpper()), qPrintable(file.fileName()));
    ++sheets;
  }
  QVERIFY(sheets >= 10);
  for (const char* ending : {"png", "jpg", "jpeg", "bmp", "tif", "tiff", "webp", "gif", "pdf", "svg", "csv",
                             "ods", "tar", "wpd.json"})
    QVERIFY2(isShown(QString("sheet.") + ending), ending);
  QVERIFY(!isShown("B.button.json"));
}

void ImportDialogTest::theLastGoodResultStays() {
  ImportState state;
  QVERIFY(open(state, sample("two-level-legend.png")));
  const auto good = state.current()->good;
  Corrections next = state.current()->history.now();
  next.masks = {{0, 0, 5000, 5000}};  // everything
  state.apply(next, "Paint mask");
  QVERIFY(again(state));
  QVERIFY(state.current()->last->failure);
  QCOMPARE(state.current()->good, good);
  QSignalSpy accepted(&state, &ImportState::accepted), stopped(&state, &ImportState::acceptStopped);
  state.acceptAll();
  QCOMPARE(accepted.count(), 0);  // the shown result is not yet that of the settings
  QCOMPARE(stopped.count(), 1);
  state.undo();
  QVERIFY(again(state));
  state.acceptAll();
  QCOMPARE(accepted.count(), 1);
}

void ImportDialogTest::aDoubtedNumberNamesItsCause() {
  QTemporaryDir folder;
  ShownDialog dialog;
  auto* cause = dialog.findChild<QLabel*>("confidenceCause");
  dialog.openFile(sample("two-level-legend.png"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QVERIFY(!cause->isVisible());  // sure: nothing to name
  // The legend names a release, and there is none.
  dialog.openFile(
      drawingOfC(folder, [](const QString& line) { return line.startsWith("<path class=\"release\""); }));
  QTRY_VERIFY_WITH_TIMEOUT(cause->isVisible(), patience_ms);
  QVERIFY2(cause->text().contains("Release"), qPrintable(cause->text()));
  const auto* number = dialog.findChild<QLabel*>("confidence");
  QVERIFY(number && number->text().contains('%'));
  const int below_px = cause->mapTo(&dialog, QPoint()).y() - number->mapTo(&dialog, QPoint()).y();
  QVERIFY(below_px > 0 && below_px < 4 * number->height());  // the text stands beside the number it explains
}

// A box that ends at 3.5 mm, while the axis and the curve go on to 4.
void ImportDialogTest::aFrameIsTakenToWhereItsCurveEnds() {
  QTemporaryDir folder;
  const QString file = drawingOfC(
      folder, [](const QString& line) { return line.startsWith("<line x1=\"616.00\" y1=\"44.00\""); },
      [](QString& line) {
        if (line.contains("#c9c9c9")) line.replace("x2=\"616.00\"", "x2=\"548.25\"");
        line.replace("width=\"542.00\" height=\"356.00\"", "width=\"474.25\" height=\"356.00\"");
      });
  ShownDialog dialog;
  dialog.openFile(file);
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QTRY_VERIFY(dialog.findChild<QLineEdit*>("xMax")->text().startsWith('4'));  // what is shown follows
  for (const char* offered : {"xExtend", "yExtend"})  // nothing is left to be extended
    QVERIFY2(!dialog.findChild<QPushButton*>(offered)->isVisible(), offered);
  QSignalSpy imported(&dialog, &ImportDialog::imported);
  QTest::mouseClick(dialog.accept, Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(imported.count(), 1, patience_ms);
  const auto result = imported.front().front().value<Report>();
  const double end_mm = result->evidence->axes.calibration.value.x.max;  // the curve's, and a little room
  QVERIFY2(end_mm >= 4 && end_mm < 4.1, qPrintable(QString::number(end_mm)));
}

// A box that ends at 0.8 N, above its curve, while the tick labels go on to 1.
void ImportDialogTest::anAxisThatGoesOnOffersToExtendTheFrame() {
  QTemporaryDir folder;
  const QString file = drawingOfC(
      folder,
      [](const QString& line) { return line.startsWith("<line x1=\"74.00\" y1=\"44.00\" x2=\"616.00\""); },
      [](QString& line) {
        if (line.contains("#c9c9c9")) line.replace("y1=\"44.00\"", "y1=\"115.20\"");
        line.replace("y=\"44.00\" width=\"542.00\" height=\"356.00\"",
                     "y=\"115.20\" width=\"542.00\" height=\"284.80\"");
        line.replace("616.00 51.12", "616.00 125.00");  // the bottom-out ends in the box
      });
  ShownDialog dialog;
  dialog.openFile(file);
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  auto* offered = dialog.findChild<QPushButton*>("yExtend");
  QTRY_VERIFY(offered->isVisible());
  QVERIFY(!dialog.findChild<QPushButton*>("xExtend")->isVisible());
  QVERIFY2(offered->text().contains("0.8") && offered->text().contains('1'), qPrintable(offered->text()));
  QTest::mouseClick(offered, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(!offered->isVisible() && dialog.accept->isEnabled(), patience_ms);
  QTRY_COMPARE(dialog.findChild<QLineEdit*>("yMax")->text().toDouble(), 1.0);
  QSignalSpy imported(&dialog, &ImportDialog::imported);
  QTest::mouseClick(dialog.accept, Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(imported.count(), 1, patience_ms);
  const auto result = imported.front().front().value<Report>();
  QVERIFY(std::abs(result->evidence->axes.calibration.value.y.max - 1) < 0.002);
}

void ImportDialogTest::severalGraphsAtOnce() {
  // Two sample plots on one picture.
  const QImage one(sample("brown-one-ink.png")), two(sample("white-chinese-gf.png"));
  QImage joined(one.width() + two.width() + 60, std::max(one.height(), two.height()) + 40,
                QImage::Format_RGB32);
  joined.fill(Qt::white);
  {
    QPainter painter(&joined);
    painter.drawImage(20, 20, one);
    painter.drawImage(one.width() + 40, 20, two);
  }
  ImportState state;
  PageList list(state);
  state.openPicture(joined);
  QVERIFY(QTest::qWaitFor([&] { return settled(state) && state.searchedPages() == 1; }, patience_ms));
  QCOMPARE(state.graphs().size(), std::size_t{2});
  QCOMPARE(list.model()->rowCount(), 3);
  for (int row = 1; row < 3; ++row)
    QVERIFY(list.model()->setData(list.model()->index(row, 0), Qt::Checked, Qt::CheckStateRole));
  QCOMPARE(state.tickedCount(), 2);
  QSignalSpy accepted(&state, &ImportState::accepted), all(&state, &ImportState::allAccepted);
  state.acceptAll();
  QTRY_COMPARE_WITH_TIMEOUT(all.count(), 1, patience_ms);
  QCOMPARE(accepted.count(), 2);
  QVERIFY(accepted[0][0].value<Report>()->graph != accepted[1][0].value<Report>()->graph);
}

void ImportDialogTest::ofSeveralSwitchesOneIsChosen() {
  ShownDialog dialog;
  QSignalSpy imported(&dialog, &ImportDialog::imported);
  dialog.openFile(twoSwitches_);
  auto* list = dialog.findChild<QListWidget*>("switches");
  QTRY_VERIFY_WITH_TIMEOUT(list->isVisible(), patience_ms);
  QTRY_VERIFY(dialog.banner->isVisible());
  QVERIFY(dialog.banner->text().contains("2 switches"));
  QVERIFY(!dialog.banner->text().contains("--"));
  QVERIFY(!dialog.accept->isEnabled());
  QCOMPARE(list->count(), 2);
  QCOMPARE(list->item(0)->text(), QString("Brown"));
  QCOMPARE(list->item(1)->text(), QString("Red"));
  const QImage red = list->item(1)->icon().pixmap(22, 14).toImage();
  QCOMPARE(red.pixelColor(11, 7), QColor("#2e8b37"));
  keepPicture(dialog, "several-switches");
  // A ticked switch can be imported, and the heading says so.
  const auto* heading = dialog.findChild<QLabel*>("confidence");
  QCOMPARE(heading->text(), QString("Not readable yet"));
  list->item(0)->setCheckState(Qt::Checked);
  QTRY_COMPARE(heading->text(), QString("1 switch will be imported"));
  QVERIFY(dialog.accept->isEnabled());
  list->item(0)->setCheckState(Qt::Unchecked);
  QTRY_COMPARE(heading->text(), QString("Not readable yet"));

  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(1)).center());
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QVERIFY(dialog.banner->isVisible() && list->isVisible());  // another graph can still be chosen
  QVERIFY(dialog.banner->text().contains("2 switches"));
  QCOMPARE(list->currentRow(), 1);
  keepPicture(dialog, "switch-chosen");
  QCOMPARE(dialog.draft().graphs.front().corrections.curve, std::string("Red"));
  QCOMPARE(*draftFrom(textOf(dialog.draft())), dialog.draft());
  QTest::mouseClick(dialog.accept, Qt::LeftButton);
  QCOMPARE(imported.count(), 1);
  const Button button = imported.front().front().value<Report>()->button;
  QCOMPARE(button.name(), std::string("two Red"));
  QVERIFY(!button.states().front().graph.release());
  QCOMPARE(requestAgain(*button.provenance()).hints.strokes.curve, std::string("Red"));
}

void ImportDialogTest::severalSwitchesOfOnePlotAtOnce() {
  ImportState state;
  QVERIFY(open(state, twoSwitches_));
  QVERIFY(state.current()->last->failure);
  const auto switches = state.current()->switches();
  QCOMPARE(switches.size(), std::size_t{2});
  for (const SwitchChoice& each : switches) state.setCurveTicked(each.curve, true);
  QCOMPARE(state.tickedCount(), 2);
  QSignalSpy accepted(&state, &ImportState::accepted), all(&state, &ImportState::allAccepted);
  state.acceptAll();
  QTRY_COMPARE_WITH_TIMEOUT(all.count(), 1, patience_ms);
  QCOMPARE(accepted.count(), 2);
  QCOMPARE(accepted[0][0].value<Report>()->button.name(), std::string("two Brown"));
  QCOMPARE(accepted[1][0].value<Report>()->button.name(), std::string("two Red"));
  QCOMPARE(state.tickedCount(), 0);
}

void ImportDialogTest::aForceLog() {
  ShownDialog dialog;
  QSignalSpy imported(&dialog, &ImportDialog::imported);
  dialog.openFile(sample("force-meter-log.csv"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QTest::qWait(20);
  keepPicture(dialog, "force-log");
  dialog.accept->click();
  QCOMPARE(imported.count(), 1);
}

void ImportDialogTest::aPastedPicture() {
  ImportState state;
  state.openPicture(QImage(sample("black-red-curves.png")));
  QVERIFY(QTest::qWaitFor([&] { return settled(state); }, patience_ms));
  QVERIFY(state.current()->last->report);
  QCOMPARE(QString::fromStdString(report(state).button.provenance()->sourceFile), state.documentName());
  state.openPicture(QImage());
  QTRY_VERIFY_WITH_TIMEOUT(state.openFailure(), patience_ms);
}

void ImportDialogTest::theFrameIsDraggedWithTheMouse() {
  ShownView view;
  ImportState& state = view.state();
  QVERIFY(open(state, sample("brown-one-ink.png")));
  const auto corners = *view.shownCorners();
  const QPoint from = view.toWidget(corners[1]).toPoint(), to = from + QPoint(-30, 20);
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&view, (from + to) / 2);
  QTest::mouseMove(&view, to);
  QVERIFY(view.hasPreview());
  QVERIFY(!state.working());  // nothing is computed during the drag
  QTest::keyClick(&view, Qt::Key_Escape);
  QVERIFY(!view.hasPreview());
  QVERIFY(!state.current()->history.canUndo());
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);

  const auto drag = [&](Qt::KeyboardModifiers modifiers) {
    QTest::mousePress(&view, Qt::LeftButton, modifiers, from);
    for (const QPoint at : {(from + to) / 2, to}) {
      QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
      QCoreApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, modifiers, to);
    return again(state);
  };
  QVERIFY(drag({}));
  auto frame = state.current()->history.now().frame;
  QVERIFY(frame);
  const double scale = std::abs(view.pageToWidget().m11());
  QVERIFY(std::abs((*frame)[1].x - (corners[1].x - 30 / scale)) < 2 / scale);
  // one corner moves alone
  for (const std::size_t other : {0u, 2u, 3u}) QCOMPARE((*frame)[other], corners[other]);
  keepPicture(view, "implied-grid");
  state.undo();
  QVERIFY(again(state));
  QVERIFY(drag(Qt::ControlModifier));
  frame = state.current()->history.now().frame;
  QCOMPARE((*frame)[2].x, (*frame)[1].x);  // with Ctrl the frame stays a rectangle
  QCOMPARE((*frame)[0].y, (*frame)[1].y);
  QCOMPARE((*frame)[3], corners[3]);
  state.undo();
  QVERIFY(again(state));
  QVERIFY(state.current()->last->report);
}

void ImportDialogTest::aFrameBesideTheShownOneAddsAGraph() {
  // One graph twice on a page, and only the left one is framed at first.
  const QImage one(sample("two-level-legend.png"));
  QImage page(2 * one.width(), one.height(), QImage::Format_RGB32);
  page.fill(Qt::white);
  {
    QPainter painter(&page);
    painter.drawImage(0, 0, one);
    painter.drawImage(one.width(), 0, one);
  }
  ShownView view({1200, 500});
  ImportState& state = view.state();
  state.openPicture(page);
  QVERIFY(again(state));
  const std::size_t found = state.graphs().size();
  const GraphId first = state.current()->id;
  const FrameCorners before = *view.shownCorners();
  const bool isLeft = before[0].x < one.width();
  const double by = isLeft ? one.width() : -one.width();
  view.fitPage();
  view.setTool(PageToolKind::drawFrame);
  const QPoint from = view.toWidget({before[0].x + by, before[0].y}).toPoint();
  const QPoint to = view.toWidget({before[2].x + by, before[2].y}).toPoint();
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&view, (from + to) / 2);
  QTest::mouseMove(&view, to);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  QVERIFY(again(state));
  QCOMPARE(state.graphs().size(), found + 1);
  QVERIFY(!(state.current()->id == first));
  QVERIFY(!state.graph(first)->history.canUndo());  // the first graph is unchanged
  QVERIFY(state.current()->last->report);
  const GraphId added = state.current()->id;
  state.tickAll();
  QCOMPARE(state.tickedCount(), static_cast<int>(state.graphs().size()));
  state.selectNext(-1);
  QVERIFY(!(state.current()->id == added));
  state.selectNext(1);
  QVERIFY(state.current()->id == added);
  state.tickAll();
  QCOMPARE(state.tickedCount(), 0);
}

// Clicks a few pixels beside the curve snap to it, so the result is the printed curve. A drawing over a part
// of a stroke replaces that part.
void ImportDialogTest::aCurveIsDrawnByHand() {
  ShownView view;
  ImportState& state = view.state();
  QVERIFY(open(state, sample("two-level-legend.png")));
  const Report found = state.current()->good->report;
  const auto& evidence = *state.current()->good->evidence;
  const StrokeCurve& press = found->button.states()[0].graph.press();
  const auto onPage = [&](double x) {
    const importer::Point at = evidence.axes.calibration.value.toView({x, press.force_N(x)});
    return view.toWidget(evidence.view.viewToPage(at));
  };
  const auto draw = [&](double from, double to, int points) {
    view.setTool(PageToolKind::drawPress);
    for (int i = 0; i <= points; ++i) {
      const QPoint at = (onPage(from + (to - from) * i / points) + QPointF(0, i % 2 ? 2 : -2)).toPoint();
      QTest::mouseClick(&view, Qt::LeftButton, {}, at);
    }
    QTest::keyClick(&view, Qt::Key_Return);
    return again(state);
  };
  const double length = press.travel_mm();
  QVERIFY(draw(press.start_mm() + 0.01 * length, press.start_mm() + 0.95 * length, 24));
  QCOMPARE(view.tool(), PageToolKind::adjust);
  QVERIFY(!state.current()->history.now().drawn.press.empty());
  Report drawn = state.current()->good->report;
  QVERIFY(drawn != found);
  const auto apart = [&](const Report& report) {
    const StrokeCurve& other = report->button.states()[0].graph.press();
    double worst = 0;
    for (double x = press.start_mm() + 0.05 * length; x < press.start_mm() + 0.9 * length; x += 0.01 * length)
      worst = std::max(worst, std::abs(other.force_N(x) - press.force_N(x)));
    return worst / (press.forceRange_N().second - press.forceRange_N().first);
  };
  qInfo("drawn by hand: off by %.2f %% of the span at most", 100 * apart(drawn));
  QVERIFY(apart(drawn) < 0.03);
  state.undo();
  QVERIFY(again(state));
  QVERIFY(apart(state.current()->good->report) < 1e-9);
  QVERIFY(draw(press.start_mm() + 0.4 * length, press.start_mm() + 0.6 * length, 8));
  QVERIFY(apart(state.current()->good->report) < 0.03);
  QVERIFY(std::abs(state.current()->good->report->button.states()[0].graph.press().end_mm() -
                   press.end_mm()) < 0.02 * length);
}

// A message appears while a curve is drawn: the page must not move under the pointer until the curve is
// finished.
void ImportDialogTest::thePageLiesStillUnderAGesture() {
  ShownDialog dialog;
  dialog.openFile(sample("two-level-legend.png"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QVERIFY(!dialog.banner->isVisible());
  dialog.view->setTool(PageToolKind::drawPress);
  const QPoint start = dialog.view->rect().center();
  const importer::Point page = dialog.view->toPage(start);
  const auto onDialog = [&] { return dialog.view->mapTo(&dialog, dialog.view->toWidget(page)); };
  const QPointF before = onDialog();
  QTest::mousePress(dialog.view, Qt::LeftButton, {}, start);
  const int height = dialog.view->height();
  dialog.banner->say(AdviceBar::Tone::doubt, {"Something is not certain", "Look at it", {}});
  QTRY_VERIFY(dialog.view->height() < height);
  QVERIFY(QLineF(onDialog(), before).length() < 0.01);
  QTest::mouseRelease(dialog.view, Qt::LeftButton, {}, dialog.view->toWidget(page).toPoint());
  QVERIFY(QLineF(onDialog(), before).length() < 0.01);  // the page stays while clicks go on
  QTest::keyClick(dialog.view, Qt::Key_Escape);
  QVERIFY(QLineF(onDialog(), before).length() > 1);  // the page fits its new room
}

namespace {

// Force drawn downwards, 0 at the top: 50 cN at 1.5 mm. `numbered`: with labels along the force axis.
QString plotOfFallingForce(bool numbered) {
  const auto x = [](double mm) { return 80 + 140 * mm; };
  const auto y = [](double cN) { return 60 + 4 * cN; };
  QString svg =
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="720" height="540" font-family="sans-serif" font-size="14">
<rect width="720" height="540" fill="white"/><rect x="80" y="60" width="560" height="400" fill="none" stroke="black"/>)";
  for (int i = 0; i <= 4; ++i)
    svg += QStringLiteral(
               "<path d=\"M%1 460v-6\" stroke=\"black\"/><text x=\"%1\" y=\"482\" "
               "text-anchor=\"middle\">%2</text>")
               .arg(x(i))
               .arg(i);
  for (int cN = 0; cN <= 100 && numbered; cN += 20)
    svg += QStringLiteral(
               "<path d=\"M80 %1h6\" stroke=\"black\"/><text x=\"72\" y=\"%2\" text-anchor=\"end\">%3</text>")
               .arg(y(cN))
               .arg(y(cN) + 5)
               .arg(cN);
  svg += QStringLiteral(
             "<text x=\"360\" y=\"515\" text-anchor=\"middle\">Displacement (mm)</text>"
             "<text transform=\"translate(30 260) rotate(-90)\" text-anchor=\"middle\">Force (cN)</text>"
             "<path fill=\"none\" stroke=\"#c00000\" stroke-width=\"2\" d=\"M%1 %2C%3 %4 %5 %4 %6 %4C%7 %4 "
             "%8 %9 %10 %9C")
             .arg(x(0))
             .arg(y(2))
             .arg(x(0.5))
             .arg(y(50))
             .arg(x(1))
             .arg(x(1.5))
             .arg(x(1.8))
             .arg(x(1.9))
             .arg(y(30))
             .arg(x(2.2));
  svg += QStringLiteral("%1 %2 %3 %4 %5 %6L%7 %8\"/></svg>")
             .arg(x(2.6))
             .arg(y(30))
             .arg(x(3.2))
             .arg(y(50))
             .arg(x(3.7))
             .arg(y(60))
             .arg(x(3.95))
             .arg(y(95));
  return svg;
}

}  // namespace

// The fields show what stands at each end; typing that again changes nothing, and an axis of no length is
// refused.
void ImportDialogTest::theFieldsOfAFallingAxisNameItsEndsByPlace() {
  const QString svg = plotOfFallingForce(true);
  const QTemporaryDir folder;
  QFile file(folder.filePath("down.svg"));
  QVERIFY(file.open(QIODevice::WriteOnly) && file.write(svg.toUtf8()) > 0);
  file.close();
  ShownDialog dialog;
  dialog.openFile(file.fileName());
  auto* bottom = dialog.findChild<QLineEdit*>("yMin");
  auto* top = dialog.findChild<QLineEdit*>("yMax");
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QTRY_COMPARE(bottom->text(), QStringLiteral("100"));
  QCOMPARE(top->text(), QStringLiteral("0"));
  keepPicture(dialog, "axis-falls");
  typeInto(top, "100");
  QVERIFY2(top->accessibleDescription().contains("same value"), qPrintable(top->accessibleDescription()));
  typeInto(top, "0");
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  typeInto(bottom, "100");
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QCOMPARE(bottom->text(), QStringLiteral("100"));
  QCOMPARE(top->text(), QStringLiteral("0"));
  keepPicture(dialog, "axis-falls-given");
  QSignalSpy imported(&dialog, &ImportDialog::imported);
  QTest::mouseClick(dialog.accept, Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(imported.count(), 1, patience_ms);
  const auto result = imported.front().front().value<Report>();
  const auto peaks = tactilePoints(result->button.states()[0].graph.press(), Stroke::press);
  QCOMPARE(peaks.size(), std::size_t(1));
  QVERIFY2(std::abs(peaks[0].force_N - 0.50) < 0.005, qPrintable(QString::number(peaks[0].force_N)));
  QVERIFY2(std::abs(peaks[0].displacement_mm - 1.5) < 0.05,
           qPrintable(QString::number(peaks[0].displacement_mm)));
}

// An answer that arrives before the user types an end of an axis must not put the typed text behind the old
// value.
void ImportDialogTest::aFieldInHandKeepsItsSelection() {
  ViewSettings settings;
  ImportState state;
  FindingsPanel panel(state, settings);
  panel.show();
  QVERIFY(open(state, sample("brown-one-ink.png")));
  auto* max = panel.findChild<QLineEdit*>("yMax");
  max->selectAll();
  const QString all = max->selectedText();
  QVERIFY(!all.isEmpty());
  emit state.resultChanged();
  QTest::qWait(1);
  QCOMPARE(max->selectedText(), all);
}

// The panel cannot be scrolled beyond its last box, and no box is squeezed.
void ImportDialogTest::findingsEndWithTheirLastBox() {
  ViewSettings settings;
  ImportState state;
  FindingsPanel panel(state, settings);
  panel.resize(300, 300);
  panel.show();
  QVERIFY(open(state, sample("brown-one-ink.png")));
  const QWidget* box = panel.findChild<QLabel*>("seconds")->parentWidget();
  QTRY_VERIFY(box->geometry().bottom() > panel.viewport()->height());
  constexpr int margins_px = 20;
  QTRY_VERIFY2(panel.widget()->height() - box->geometry().bottom() <= margins_px,
               qPrintable(QString::number(panel.widget()->height() - box->geometry().bottom())));
  const auto squeezed = [&] {
    QStringList texts;
    for (const auto* label : panel.findChildren<QLabel*>())
      if (label->wordWrap() && label->isVisible() && label->height() < label->heightForWidth(label->width()))
        texts << QString("%1 of %2: %3")
                     .arg(label->height())
                     .arg(label->heightForWidth(label->width()))
                     .arg(label->text());
    return texts.join('\n');
  };
  QTRY_VERIFY2(squeezed().isEmpty(), qPrintable(squeezed()));
}

// The sheet names no unit of force: nothing is guessed quietly, and one click in the banner settles it.
void ImportDialogTest::theBannerRequestsAMissingUnit() {
  QImage page(sample("brown-one-ink.png"));
  {
    QPainter painter(&page);
    painter.fillRect(0, 160, 38, 150, Qt::white);  // "force (cN)"
  }
  ShownDialog dialog;
  dialog.openPicture(page);
  QTRY_VERIFY_WITH_TIMEOUT(dialog.banner->isVisible(), patience_ms);
  QTest::qWait(50);
  QVERIFY(!dialog.accept->isEnabled());
  keepPicture(dialog, "missing-unit");
  for (const ForceUnit unit :
       {ForceUnit::newton, ForceUnit::centinewton, ForceUnit::millinewton, ForceUnit::gramForce,
        ForceUnit::kilogramForce, ForceUnit::ounceForce, ForceUnit::poundForce}) {
    const auto* offered =
        dialog.findChild<QPushButton*>(QStringLiteral("forceUnit_") + DisplayUnits{{}, unit}.forceSymbol());
    QVERIFY(offered && offered->isVisible());
    QVERIFY2(dialog.banner->rect().contains(QRect(offered->mapTo(dialog.banner, QPoint()), offered->size())),
             qPrintable(offered->text()));
  }
  auto* inGram = dialog.findChild<QPushButton*>("forceUnit_gf");
  QVERIFY(inGram && inGram->isVisible());
  QSignalSpy imported(&dialog, &ImportDialog::imported);
  QTest::mouseClick(inGram, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QVERIFY(dialog.view->units().force == ForceUnit::gramForce);  // labels are in the page's unit
  QTest::mouseClick(dialog.accept, Qt::LeftButton);
  QCOMPARE(imported.count(), 1);
  const auto result = imported.front().front().value<Report>();
  QCOMPARE(result->y->unit, std::string("gf"));
  QCOMPARE(result->y->unitBy, DecidedBy::given);
}

// Typing or choosing again the shown value of each axis gives the same button.
void ImportDialogTest::whatIsShownGivenAgainChangesNothing() {
  for (const char* plot : {"white-vector.pdf", "brown-german-comma.png"}) {
    ShownDialog dialog;
    dialog.openFile(sample(plot));
    QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
    ImportState& state = dialog.view->state();
    const Button before = report(state).button;
    const auto& was = before.states()[0].graph.press();
    const double span_N = was.forceRange_N().second - was.forceRange_N().first;
    const auto isSame = [&](const QString& what) {
      QVERIFY(again(state));
      QVERIFY2(dialog.accept->isEnabled(), qPrintable(what));
      const StrokeCurve& is = report(state).button.states()[0].graph.press();
      QVERIFY2(std::abs(is.end_mm() - was.end_mm()) < 0.005 * was.end_mm(), qPrintable(what));
      for (int i = 0; i <= 20; ++i) {
        const double at_mm = was.start_mm() + 0.9 * i / 20 * was.travel_mm();  // the bottom-out is steep
        QVERIFY2(std::abs(is.force_N(at_mm) - was.force_N(at_mm)) < 0.02 * span_N,
                 qPrintable(QString("%1 at %2 mm").arg(what).arg(at_mm)));
      }
      QCOMPARE(tactilePoints(is, Stroke::press).size(), tactilePoints(was, Stroke::press).size());
    };
    for (const char* name : {"xMin", "xMax", "yMin", "yMax"}) {
      auto* edit = dialog.findChild<QLineEdit*>(name);
      typeInto(edit, qPrintable(edit->text()));
      isSame(QString("%1: %2").arg(plot, name));
      if (QTest::currentTestFailed()) return;
    }
    for (const char* name : {"xUnit", "yUnit"}) {
      auto* box = dialog.findChild<QComboBox*>(name);
      emit box->activated(box->currentIndex());
      isSame(QString("%1: %2").arg(plot, name));
      if (QTest::currentTestFailed()) return;
    }
  }
}

void ImportDialogTest::axisEndsAreTypedAlikeInEveryLanguage() {
  struct Typing {
    QString text;
    std::optional<double> max_cN;  ///< none: the text is refused and stays as typed
  };
  const Typing typings[] = {{"120.5", 120.5},
                            {"120,5", 120.5},
                            {"1.205 N", 120.5},
                            {"1,205N", 120.5},
                            {"100+20", 120},
                            {"+5", 125},
                            {"-10 %", 112.5},
                            {"1,250.5", {}},
                            {"1 250", {}},
                            {"60 mm", {}},
                            {"many", {}},
                            {"2*60 cN", 120},
                            {"122.9 gf", 122.9 * 0.980665}};
  ViewSettings settings;
  ImportState state;
  FindingsPanel panel(state, settings);
  panel.show();
  QVERIFY(open(state, sample("brown-one-ink.png")));
  QTest::qWait(1);
  auto* max = panel.findChild<QLineEdit*>("yMax");
  const auto restored = qScopeGuard([] { QLocale::setDefault(QLocale::c()); });
  for (const char* language : {"C", "de_DE", "fr_FR", "en_IN", "ar_EG"}) {
    QLocale::setDefault(QLocale(language));
    double now_cN = 0;
    for (const auto& [text, max_cN] : typings) {
      max->setText(text);
      max->setModified(true);
      emit max->editingFinished();
      const QByteArray what = QString("%1 in %2").arg(text, language).toUtf8();
      if (max_cN) now_cN = *max_cN;
      const auto given = state.current()->history.now().y.max;
      QVERIFY2(given && std::abs(*given - now_cN) < 1e-6, what);
      QVERIFY2(max_cN || max->text() == text, what);
      QTest::qWait(1);  // the fields follow
    }
  }
  QVERIFY(again(state));
}

void ImportDialogTest::graphsAreListedWithoutTheirPages() {
  ImportState state;
  PageList list(state);
  list.show();
  QVERIFY(open(state, sample("white-vector.pdf")));
  QCOMPARE(list.model()->rowCount(), 2);  // a page, its graph
  list.setGraphsOnly(true);
  QVERIFY(list.isRowHidden(0) && !list.isRowHidden(1));
  QVERIFY(open(state, sample("two-level-legend.png")));
  QVERIFY(list.isRowHidden(0) && !list.isRowHidden(1));
  list.setGraphsOnly(false);
  QVERIFY(!list.isRowHidden(0));
}

void ImportDialogTest::theOriginSetsBothAxes() {
  ShownView view({800, 600});
  ImportState& state = view.state();
  QVERIFY(open(state, sample("white-vector.pdf")));
  const FrameCorners corners = *view.shownCorners();
  view.setTool(PageToolKind::scale);
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.toWidget(corners[3]).toPoint() + QPoint(3, 2));
  auto* editor = view.findChild<QLineEdit*>("tickValue");
  QVERIFY(editor);
  QCOMPARE(editor->text(), QString("0"));
  QTest::keyClick(editor, Qt::Key_Return);
  const Corrections& given = state.current()->history.now();
  QCOMPARE(given.x.ticks.size(), std::size_t{1});
  QCOMPARE(given.y.ticks.size(), std::size_t{1});
  QVERIFY(given.x.ticks[0].at == corners[3] && given.y.ticks[0].value == 0);
  state.undo();  // one step
  QVERIFY(state.current()->history.now() == Corrections{});
  QVERIFY(again(state));
}

void ImportDialogTest::aTickOfAFrameAskewStandsWhereItWasClicked() {
  ShownView view({800, 600});
  ImportState& state = view.state();
  QImage picture(1000, 900, QImage::Format_RGB32);
  picture.fill(Qt::white);
  {
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(34, 34, 34), 1.5));
    painter.drawPolygon(QPolygonF({{220, 120}, {900, 170}, {800, 700}, {110, 640}}));
  }
  state.openPicture(picture);
  QTRY_VERIFY_WITH_TIMEOUT(state.sheet() && state.searchedPages() == 1, patience_ms);
  const FrameCorners askew{{{219.7, 119.6}, {900.2, 170.3}, {800, 699.9}, {109.8, 640.2}}};
  state.addGraph(askew);
  QVERIFY(again(state));
  view.fitPage();
  view.setTool(PageToolKind::scale);
  for (double share = 0.1; share < 0.95; share += 0.083) {
    const QPoint clicked = view.toWidget(placeAlong(GraphAxis::x, askew, share)).toPoint();
    QTest::mouseClick(&view, Qt::LeftButton, {}, clicked);
    auto* editor = view.findChild<QLineEdit*>("tickValue");
    QVERIFY(editor);
    editor->setText(QString::number(share));
    QTest::keyClick(editor, Qt::Key_Return);
    QVERIFY(again(state));
    const auto& ticks = state.current()->history.now().x.ticks;
    const QPointF off = view.toWidget(ticks.back().at) - clicked;
    QVERIFY2(std::hypot(off.x(), off.y()) < 1.5, qPrintable(QString("%1 %2").arg(off.x()).arg(off.y())));
  }
}

// A screen of 1366x768 at twice the size leaves 683x384: the buttons at the bottom must still be visible.
void ImportDialogTest::theDialogueFitsSmallScreens() {
  ShownDialog dialog;
  dialog.openFile(sample("two-level-legend.png"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  for (const QSize screen : {QSize(1366, 768), QSize(1024, 700), QSize(683, 384)}) {
    const QSize room = screen - QSize(8, 40);  // a window's frame, a panel of the desktop
    dialog.resize(room);
    QTest::qWait(20);
    QVERIFY2(dialog.width() <= room.width() && dialog.height() <= room.height(),
             qPrintable(QString("%1x%2 at most %3x%4")
                            .arg(dialog.width())
                            .arg(dialog.height())
                            .arg(room.width())
                            .arg(room.height())));
    QVERIFY(dialog.rect().contains(QRect(dialog.accept->mapTo(&dialog, QPoint()), dialog.accept->size())));
    auto* bar = dialog.findChild<QToolBar*>();
    for (QAction* action : bar->actions())
      if (QWidget* button = bar->widgetForAction(action); !action->isSeparator())
        QVERIFY2(button->isVisible(), qPrintable(action->text() + QString(" at %1").arg(screen.width())));
    const auto* findings = dialog.findChild<FindingsPanel*>();
    QVERIFY2(findings->horizontalScrollBar()->maximum() == 0,
             qPrintable(QString("the findings scroll sideways at %1").arg(screen.width())));
    keepPicture(dialog, QString("screen-%1").arg(screen.width()));
  }
}

void ImportDialogTest::anotherSheetAsksBeforeCorrectionsGo() {
  ShownDialog dialog;
  int requests = 0;
  bool mayLeave = false;
  dialog.setLeaveQuestion([&] { return ++requests, mayLeave; });
  dialog.openFile(sample("two-level-legend.png"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.accept->isEnabled(), patience_ms);
  QCOMPARE(requests, 0);
  ImportState& state = dialog.findChild<PageView*>()->state();
  state.correct("Swap press and release", [](Corrections& c) { c.swapStrokes = true; });
  dialog.openFile(sample("white-vector.pdf"));
  QCOMPARE(requests, 1);
  QCOMPARE(state.documentName(), QString("two-level-legend.png"));
  mayLeave = true;
  dialog.openFile(sample("white-vector.pdf"));
  QCOMPARE(state.documentName(), QString("white-vector.pdf"));
}

void ImportDialogTest::aGraphOnItsSideIsCorrectedToo() {
  const QImage upright(sample("brown-one-ink.png"));
  ShownView view;
  ImportState& state = view.state();
  for (const int degrees : {90, 270}) {
    state.openPicture(upright.transformed(QTransform().rotate(degrees)));
    QVERIFY(QTest::qWaitFor([&] { return settled(state) && state.searchedPages() == 1; }, patience_ms));
    QVERIFY(state.current()->listed->quarterTurns != 0);
    const double travel_mm = report(state).button.states().front().graph.travel_mm();
    const auto corners = *view.shownCorners();
    const QPointF top = view.toWidget(corners[1]) - view.toWidget(corners[0]);
    QVERIFY(top.x() > 100 && std::abs(top.y()) < 2);  // the page is shown upright
    Corrections next = state.current()->history.now();
    next.frame = corners;
    state.apply(next, "Move plot frame");
    QVERIFY(again(state));
    QVERIFY2(state.current()->last->report,
             state.current()->last->failure ? english(state.current()->last->failure->problem).c_str() : "");
    QVERIFY(std::abs(report(state).button.states().front().graph.travel_mm() - travel_mm) < 0.02);
  }
}

void ImportDialogTest::theKeyboardReachesEverything() {
  ShownDialog dialog;
  dialog.openFile(sample("white-vector.pdf"));
  QVERIFY(QTest::qWaitFor([&] { return settled(dialog.view->state()); }, patience_ms));
  dialog.view->setFocus();
  QTest::keyClick(dialog.view, Qt::Key_Tab);  // the top left corner
  QTest::keyClick(dialog.view, Qt::Key_Left);
  QTest::keyClick(dialog.view, Qt::Key_Left, Qt::ShiftModifier);
  const auto& history = dialog.view->state().current()->history;
  QVERIFY(history.now().frame);
  QVERIFY(again(dialog.view->state()));
  QTest::keyClick(&dialog, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!history.now().frame);  // both nudges were one step
  QVERIFY(again(dialog.view->state()));
  // Enter in a field ends the field, not the dialogue.
  auto* field = dialog.findChild<QLineEdit*>("xMax");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "4.5");  // as printed
  QTest::keyClick(field, Qt::Key_Return);
  QVERIFY(dialog.isVisible());
  QCOMPARE(history.now().x.max, 4.5);
  QVERIFY(again(dialog.view->state()));
  // Text that cannot be read keeps the dialogue open, because the field does not show the previous value.
  field->selectAll();
  QTest::keyClicks(field, "six");
  QVERIFY(dialog.accept->isEnabled());
  QTest::mouseClick(dialog.accept, Qt::LeftButton);
  QVERIFY(dialog.isVisible());
  QCOMPARE(field->text(), QString("six"));
  QVERIFY(!field->accessibleDescription().isEmpty());
  QVERIFY(dialog.isVisible());
  field->selectAll();
  QTest::keyClicks(field, "4.5");
  QTest::keyClick(field, Qt::Key_Return);
  QVERIFY(field->accessibleDescription().isEmpty());
  dialog.view->setFocus();
  QTest::keyClick(dialog.view, Qt::Key_Tab);
  for (int i = 0; i < 4; ++i) QTest::keyClick(dialog.view, Qt::Key_Tab);
  QTest::keyClick(dialog.view, Qt::Key_Return);  // a tick's value
  auto* editor = dialog.view->findChild<QLineEdit*>("tickValue");
  QVERIFY(editor);
  QTest::keyClick(editor, Qt::Key_Escape);
  QVERIFY(!dialog.view->findChild<QLineEdit*>("tickValue"));
  QVERIFY(dialog.isVisible());
  QTest::keyClick(dialog.view, Qt::Key_Return);
  editor = dialog.view->findChild<QLineEdit*>("tickValue");
  QVERIFY(editor);
  QTest::keyClick(editor, Qt::Key_Return);  // takes the value; the page must not take the key as well
  QVERIFY(!dialog.view->findChild<QLineEdit*>("tickValue"));
  for (const QWidget* widget : dialog.findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisibleTo(&dialog)) continue;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const auto* label = qobject_cast<const QLabel*>(widget);
    const bool named = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()) || label;
    const bool part = widget->objectName().startsWith("qt_") || widget->inherits("QSplitter") ||
                      widget->parentWidget()->inherits("QAbstractSpinBox") ||
                      widget->parentWidget()->inherits("QComboBox");
    QVERIFY2(named || part, qPrintable(widget->objectName() + ' ' + widget->metaObject()->className()));
  }
}

void ImportDialogTest::theWindowNeverStalls() {
  ShownDialog dialog;
  QTest::qWait(100);
  StallProbe probe;
  dialog.openFile(sample("two-level-legend.png"));
  QVERIFY(QTest::qWaitFor([&] { return settled(dialog.view->state()); }, patience_ms));
  // Figures are the benchmark's; this one says that nothing of an import runs in the window's thread.
  QVERIFY2(probe.longest_ms() < 250, qPrintable(QString::number(probe.longest_ms())));
}

void ImportDialogTest::closingWhileItWorks() {
  ViewSettings settings;
  for (int i = 0; i < 3; ++i) {
    ImportDialog dialog(settings);
    dialog.show();
    dialog.openFile(sample("white-chinese-gf.png"));
    QTest::qWait(30 * i);
  }
  // The ends of their threads are waited for when the program ends. A closed dialogue works no more and may
  // be used again.
  ImportDialog dialog(settings);
  dialog.show();
  dialog.openFile(sample("white-chinese-gf.png"));
  dialog.reject();
  const auto& state = dialog.findChild<PageView*>()->state();
  QVERIFY(!state.opening() && !state.working());
  QTest::qWait(200);
  QVERIFY(!state.isOpen());
  dialog.show();
  dialog.openFile(sample("white-vector.pdf"));
  QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QPushButton*>("import")->isEnabled(), patience_ms);
}

/// For the eye: DETENT_PICTURE_INPUTS names files, divided by '|'; a picture of each is kept.
void ImportDialogTest::picturesOfInputs() {
  const QStringList inputs = qEnvironmentVariable("DETENT_PICTURE_INPUTS").split('|', Qt::SkipEmptyParts);
  if (inputs.isEmpty()) QSKIP("no inputs are named");
  if (qEnvironmentVariableIsSet("DETENT_PICTURE_DARK")) {
    QPalette dark(QColor("#2b2f34"));
    dark.setColor(QPalette::Highlight, QColor("#3d6f9e"));
    QApplication::setPalette(dark);
  }
  for (const QString& input : inputs) {
    ViewSettings settings;
    ImportDialog dialog(settings);
    dialog.show();
    auto* view = dialog.findChild<PageView*>();
    dialog.openFile(input);
    const auto& state = view->state();
    QVERIFY(QTest::qWaitFor(
        [&] {
          return state.openFailure() ||
                 (state.pageCount() > 0 && state.searchedPages() == state.pageCount() && !state.working());
        },
        patience_ms));
    keepPicture(dialog, QFileInfo(input).completeBaseName());
  }
}

DETENT_WINDOW_TEST(ImportDialogTest)
#include "import_dialog_test.moc"
