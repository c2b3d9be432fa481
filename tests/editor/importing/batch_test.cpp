// SPDX-License-Identifier: GPL-3.0-or-later
// Many files imported at once: each result is the one of the importer alone, and leads somewhere.

#include <algorithm>
#include <csignal>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include "editor/files/input_kind.h"
#include "editor/importing/batch_dialog.h"
#include "editor/importing/import_state.h"
#include "importer/all_graphs.h"
#include "model/file/button_file.h"
#include "model/file/svg_plot.h"
#include "tests/editor/window_tests.h"
#include "tests/samples/two_switches.h"

using namespace detent;
using namespace detent::editor;

namespace {

constexpr int patience_ms = 120000;  // machines under load, sanitizers

QString sample(const char* name) { return QStringLiteral(DETENT_SOURCE_DIR "/samples/plots/") + name; }

/// The dialogue with answers given beforehand.
struct BatchRig {
  explicit BatchRig(const QString& folder) {
    BatchActions actions;
    actions.files = [this](QWidget*) { return files; };
    actions.folder = [this](QWidget*) { return from; };
    actions.folderToSave = [this](QWidget*) {
      if (meanwhile) meanwhile();
      return saveIn;
    };
    actions.correct = [this](const QString& path, GraphId graph) {
      corrected << path, graphs.push_back(graph);
    };
    actions.open = [this](const QString& path, const Button& button) {
      opened << path, buttons.push_back(button);
    };
    saveIn = folder;
    dialog = std::make_unique<BatchDialog>(view, std::move(actions));
    dialog->show();
    list = dialog->findChild<QTreeWidget*>("batchList");
  }
  QPushButton& button(const char* name) { return *dialog->findChild<QPushButton*>(name); }
  bool running() { return button("batchStop").isEnabled(); }
  void read(const QStringList& paths) {
    files = paths;
    button("batchFiles").click();
    QVERIFY(QTest::qWaitFor([this] { return !running(); }, patience_ms));
  }
  QString cell(int row, int column) { return list->topLevelItem(row)->text(column); }
  QString summary() { return dialog->findChild<QLabel*>("batchSummary")->text(); }

  ViewSettings view;
  QStringList files, corrected, opened;
  QString from, saveIn;
  std::function<void()> meanwhile;  ///< runs while the dialogue for the folder is open
  std::vector<GraphId> graphs;
  std::vector<Button> buttons;
  std::unique_ptr<BatchDialog> dialog;
  QTreeWidget* list = nullptr;
};

}  // namespace

class BatchTest : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  QString at(const char* name) { return folder_.filePath(name); }
  void write(const QString& path, const std::string& text) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text.c_str()) >= 0);
  }

 private slots:
  void initTestCase() {
    write(at("two.svg"), tests::twoSwitchesSvg());
    const auto locking = readButtonFile(DETENT_SOURCE_DIR "/samples/buttons/EF.button.json");
    QVERIFY(locking.ok());
    write(at("states.svg"), svgFrom(*locking));
    write(at("empty.csv"), "");
    write(at("noise.pdf"), "no document");
  }

  void eachResultIsTheOneOfTheImporterAlone() {
    BatchRig rig(at("."));
    const QStringList paths{sample("force-meter-log.csv"),
                            sample("black-red-curves.png"),
                            at("two.svg"),
                            at("empty.csv"),
                            at("noise.pdf"),
                            at("nowhere.png")};
    rig.read(paths);
    QCOMPARE(rig.list->topLevelItemCount(), 6);
    for (int row = 0; row < 2; ++row) {
      importer::ImportRequest request;
      request.path = paths[row].toStdString();
      double confidence = 0;
      const auto alone = importer::attemptAllGraphs(
          request, {}, [&](const importer::ImportAttempt& attempt, const auto&, std::size_t) {
            QVERIFY(attempt.report.ok());
            confidence = attempt.report->confidence;
          });
      QVERIFY(alone.ok());
      QCOMPARE(rig.cell(row, 1), QString("%1 %").arg(qRound(100 * confidence)));
    }
    const QTreeWidgetItem& two = *rig.list->topLevelItem(2);  // two switches in one plot
    QCOMPARE(two.text(1), QString("2 of 2"));
    for (int row = 0; row < two.childCount(); ++row) {
      QVERIFY2(two.child(row)->text(0).endsWith(row == 0 ? "graph 1: Brown" : "graph 1: Red"),
               qPrintable(two.child(row)->text(0)));
      QVERIFY2(two.child(row)->text(1).contains('%'), qPrintable(two.child(row)->text(1)));
    }
    importer::ImportRequest red;
    red.path = at("two.svg").toStdString();
    red.hints.strokes.curve = "2";
    const auto attempt = importer::ImportSession::open(red.path)->attempt(red);
    rig.dialog->takeChecked(at("two.svg"), *attempt.report);
    for (int row = 0; row < two.childCount(); ++row)
      QCOMPARE(two.child(row)->text(1).endsWith(", checked"), row == 1);
    for (int row = 3; row < 6; ++row) {
      QCOMPARE(rig.cell(row, 1), QString("Refused"));
      QVERIFY2(rig.cell(row, 2).size() > 10 && !rig.cell(row, 2).contains("--"),
               qPrintable(rig.cell(row, 2)));
    }
    if (const QString pictures = qEnvironmentVariable("DETENT_PICTURES"); !pictures.isEmpty())
      rig.dialog->grab().save(pictures + "/batch.png");
    QVERIFY2(rig.summary().contains("6 of 6 files. Buttons: 4 (to check: 0), questions: 0, refused: 3."),
             qPrintable(rig.summary()));
  }

  // A scan's grain: read, but not as surely as nothing needs a check. Then a person imports both files.
  void whatIsUncertainIsToBeCheckedAndWhatWasCheckedIsNot() {
    QImage scan(sample("black-red-curves.png"));
    scan = scan.convertToFormat(QImage::Format_RGB32);
    QRandomGenerator grain(1);
    for (int y = 0; y < scan.height(); ++y)
      for (int x = 0; x < scan.width(); ++x) {
        const QColor c = scan.pixelColor(x, y);
        const int less = grain.bounded(9);
        scan.setPixelColor(
            x, y,
            QColor(std::max(0, c.red() - less), std::max(0, c.green() - less), std::max(0, c.blue() - less)));
      }
    QVERIFY(scan.save(at("scan.png")));
    BatchRig rig(at("."));
    const QStringList paths{at("scan.png"), at("noise.pdf"), at("states.svg")};
    rig.read(paths);
    QCOMPARE(rig.cell(0, 1), QString("88 %, check it"));
    QVERIFY(!rig.cell(0, 2).isEmpty());
    QCOMPARE(rig.cell(1, 1), QString("Refused"));
    QCOMPARE(rig.summary(), QString("3 of 3 files. Buttons: 3 (to check: 1), questions: 0, refused: 1."));
    importer::ImportRequest request;
    request.path = at("states.svg").toStdString();
    std::vector<importer::ImportReport> reports;
    const auto read = importer::attemptAllGraphs(
        request, {},
        [&](const importer::ImportAttempt& attempt, auto&&...) { reports.push_back(*attempt.report); });
    QVERIFY(read.ok() && reports.size() == 2);
    for (const QString& path : paths) rig.dialog->takeChecked(path, reports[0]);
    rig.dialog->takeChecked(at("states.svg"), reports[1]);
    rig.dialog->takeChecked("/elsewhere.png", reports[1]);
    const QString checked = QString("%1 %, checked").arg(qRound(100 * reports[0].confidence));
    for (int row = 0; row < 2; ++row) QCOMPARE(rig.cell(row, 1), checked);
    QCOMPARE(rig.cell(2, 1), QString("2 of 2"));
    for (int graph = 0; graph < 2; ++graph)
      QVERIFY(rig.list->topLevelItem(2)->child(graph)->text(1).endsWith(", checked"));
    QCOMPARE(rig.summary(), QString("3 of 3 files. Buttons: 4 (to check: 0), questions: 0, refused: 0."));
    rig.list->topLevelItem(1)->setSelected(true);
    rig.button("batchOpen").click();
    QVERIFY(rig.buttons == std::vector<Button>{reports[0].button});
  }

  // A reader that crashes ends its own process: the file is refused, and the others are read.
  void aCrashCostsOneFile() {
    BatchRig rig(at("."));
    rig.files = {sample("two-level-legend.png"), sample("force-meter-log.csv"),
                 sample("force-meter-log.csv")};
    rig.button("batchFiles").click();
    QVERIFY(QTest::qWaitFor([&] { return rig.cell(0, 1) == "Reading…"; }, patience_ms));
    for (const auto* process : rig.dialog->findChildren<QProcess*>())
      if (process->arguments().contains(rig.files[0]))
        ::kill(static_cast<pid_t>(process->processId()), SIGSEGV);
    QVERIFY(QTest::qWaitFor([&] { return !rig.running(); }, patience_ms));
    QCOMPARE(rig.cell(0, 1), QString("Refused"));
    QVERIFY2(rig.cell(0, 2).contains("crashed"), qPrintable(rig.cell(0, 2)));
    for (int row = 1; row < 3; ++row) QVERIFY2(rig.cell(row, 1).endsWith('%'), qPrintable(rig.cell(row, 1)));
  }

  void aDoubleClickOpensTheGraphInTheImportDialogue() {
    BatchRig rig(at("."));
    rig.read({at("two.svg"), at("states.svg")});
    QTreeWidgetItem* states = rig.list->topLevelItem(1);
    QCOMPARE(states->childCount(), 2);
    QCOMPARE(states->text(1), QString("2 of 2"));
    rig.list->scrollToItem(states->child(1));
    const QPoint place = rig.list->visualItemRect(states->child(1)).center();
    QTest::mouseClick(rig.list->viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(rig.list->viewport(), Qt::LeftButton, {}, place);
    QCOMPARE(rig.corrected, QStringList(at("states.svg")));
    QVERIFY((rig.graphs == std::vector<GraphId>{{1, 2}}));
    rig.button("batchOpen").click();
    QCOMPARE(rig.opened, QStringList(at("states.svg")));
    QCOMPARE(rig.buttons.size(), std::size_t{1});
  }

  // The graph that was chosen is the one to be corrected, whatever is found before it.
  void theChosenGraphIsSelected() {
    ImportState state;
    ImportDraft draft;
    draft.path = at("states.svg");
    draft.current = GraphId{1, 2};
    state.continueDraft(draft);
    QVERIFY(QTest::qWaitFor([&] { return state.current() != nullptr; }, patience_ms));
    QVERIFY((state.current()->id == GraphId{1, 2}));
    state.openFile(sample("black-red-curves.png"));
    QVERIFY(QTest::qWaitFor([&] { return state.current() != nullptr; }, patience_ms));
    draft.current = GraphId{9, 1};  // the document has lost pages since
    state.continueDraft(draft);
    QVERIFY(QTest::qWaitFor([&] { return state.current() != nullptr; }, patience_ms));
    QCOMPARE(state.current()->id.page, 1);
  }

  void buttonsAreSavedAndNothingIsOverwritten() {
    BatchRig rig(at("out"));
    QVERIFY(QDir().mkpath(at("out")));
    rig.read({sample("force-meter-log.csv"), at("noise.pdf")});
    rig.button("batchSave").click();
    QVERIFY2(rig.summary().startsWith("Buttons saved in"), qPrintable(rig.summary()));
    rig.button("batchSave").click();
    const QStringList saved = QDir(at("out")).entryList(QDir::Files);
    QCOMPARE(saved.size(), 2);
    for (const QString& name : saved)
      QVERIFY(readButtonFile(at("out/").toStdString() + name.toStdString()).ok());
    rig.saveIn = at("nowhere/at/all");
    rig.button("batchSave").click();
    QVERIFY2(rig.summary().startsWith("Saved 0 of 1 buttons"), qPrintable(rig.summary()));
  }

  void filesThatFinishWhileTheFolderIsChosenAreSavedToo() {
    BatchRig rig(at("meanwhile"));
    QVERIFY(QDir().mkpath(at("meanwhile")));
    rig.meanwhile = [&] { QVERIFY(QTest::qWaitFor([&] { return !rig.running(); }, patience_ms)); };
    rig.files = QStringList(12, sample("force-meter-log.csv"));
    rig.button("batchFiles").click();
    QVERIFY(QTest::qWaitFor([&] { return rig.button("batchSave").isEnabled(); }, patience_ms));
    rig.button("batchSave").click();
    QCOMPARE(QDir(at("meanwhile")).entryList(QDir::Files).size(), 12);
  }

  // With Ctrl a click on a selected row takes it out of the selection, and leaves it the current one.
  void theSelectedFileIsCorrectedNotTheOneClickedLast() {
    BatchRig rig(at("."));
    rig.read({at("empty.csv"), at("noise.pdf")});
    const auto click = [&](int row, Qt::KeyboardModifiers keys) {
      const QPoint place = rig.list->visualItemRect(rig.list->topLevelItem(row)).center();
      QTest::mouseClick(rig.list->viewport(), Qt::LeftButton, keys, place);
    };
    click(0, {});
    click(1, Qt::ControlModifier);
    click(1, Qt::ControlModifier);
    rig.button("batchCorrect").click();
    QCOMPARE(rig.corrected, QStringList(at("empty.csv")));
  }

  void stoppedFilesGiveNoResult() {
    BatchRig rig(at("."));
    rig.files = QStringList(40, sample("two-level-legend.png"));
    rig.button("batchFiles").click();
    QVERIFY(rig.running());
    QVERIFY(QTest::qWaitFor([&] { return rig.cell(0, 1) != "Waiting"; }, patience_ms));
    rig.button("batchStop").click();
    QVERIFY(!rig.running());
    QCOMPARE(rig.cell(39, 1), QString("Stopped"));
    const QString then = rig.summary();
    QTest::qWait(300);
    QCOMPARE(rig.summary(), then);
    rig.read({sample("force-meter-log.csv")});  // a new batch is not mixed with the old one
    QCOMPARE(rig.list->topLevelItemCount(), 1);
    QVERIFY2(rig.summary().startsWith("1 of 1 files"), qPrintable(rig.summary()));
  }

  void closingEndsIt() {
    BatchRig rig(at("."));
    rig.files = QStringList(40, sample("two-level-legend.png"));
    rig.button("batchFiles").click();
    rig.dialog->close();
    QVERIFY(!rig.running());
    rig.dialog->start(rig.files);
    rig.dialog.reset();  // closed while imports run
  }

  void aFolderGivesItsSheetsInOrder() {
    QVERIFY(QDir().mkpath(at("many/inner")));
    for (const char* name :
         {"many/10.png", "many/2.PNG", "many/notes.txt", "many/a.button.json", "many/inner/3.csv"})
      write(at(name), "x");
    QStringList names;
    for (const QString& path : sheetsBelow(at("many"))) names << QDir(at("many")).relativeFilePath(path);
    QCOMPARE(names, QStringList({"2.PNG", "10.png", "inner/3.csv"}));
    BatchRig rig(at("."));
    rig.from = at("many/nothing");
    rig.button("batchFolder").click();
    QVERIFY(rig.summary().contains("No datasheet"));
  }
};

DETENT_WINDOW_TEST(BatchTest)
#include "batch_test.moc"
