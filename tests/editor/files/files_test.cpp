// SPDX-License-Identifier: GPL-3.0-or-later
// Opening, saving, recent files, changes from outside, exports.

#include <QDir>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

#include "editor/document/message_words.h"
#include "editor/files/document_files.h"
#include "editor/files/exports.h"
#include "editor/files/file_watch.h"
#include "editor/files/input_kind.h"
#include "editor/files/open_marks.h"
#include "editor/files/recent_files.h"
#include "model/edits.h"
#include "model/file/button_file.h"
#include "model/templates.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;

namespace {

Button stronger(const Button& button, double factor) { return *scaleForce(button, factor); }

void writeFile(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

QByteArray contentsOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString sample(const char* name) { return QStringLiteral(DETENT_SOURCE_DIR "/samples/") + name; }

}  // namespace

class FilesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void distinguishesButtonsFromPages() {
    QCOMPARE(*inputKindOf(sample("buttons/B.button.json")), InputKind::button);
    QCOMPARE(*inputKindOf(sample("plots/two-level-legend.png")), InputKind::page);
    QCOMPARE(*inputKindOf(sample("plots/white-vector.pdf")), InputKind::page);
    QCOMPARE(*inputKindOf(sample("plots/force-meter-log.csv")), InputKind::page);
    writeFile(at("curve.csv"), "\xEF\xBB\xBFstroke,displacement_mm,force_N\r\npress,0,0\r\npress,1,1\r\n");
    QCOMPARE(*inputKindOf(at("curve.csv")), InputKind::curveCsv);
    writeFile(at("without-ending"), "  {\"format\": \"detent-button\"}");
    QCOMPARE(*inputKindOf(at("without-ending")), InputKind::button);
    // Projects of digitizers are JSON, too, and go to the import, which reports that this one is cut off.
    writeFile(at("project.wpd.json"), "{\"version\":[4,2],\"axesColl\":[{\"name\":\"mm");
    QCOMPARE(*inputKindOf(at("project.wpd.json")), InputKind::page);
    writeFile(at("other.json"), "{\"format\": \"detent-button\", \"name\": \"\\\"axesColl\\\"\"}");
    QCOMPARE(*inputKindOf(at("other.json")), InputKind::button);
    QCOMPARE(inputKindOf(at("nothing.json")).failure().code, FailureCode::unreadableInput);
    QCOMPARE(inputKindOf(folder_->path()).failure().code, FailureCode::unreadableInput);
    for (const char* pipe : {"pipe", "pipe.png", "pipe.json", "pipe.csv"}) {  // nobody will ever write to it
      QCOMPARE(mkfifo(qPrintable(at(pipe)), 0600), 0);
      QVERIFY(openDocument(at(pipe)).failure().sentence().find("this is not an ordinary file") !=
              std::string::npos);
    }
  }

  void savesWhatItOpens() {
    auto opened = openDocument(sample("buttons/B.button.json"));
    QVERIFY(opened.ok());
    ButtonDocument& document = **opened;
    QCOMPARE(document.title(), QString("B"));
    QVERIFY(!document.history().modified());
    const Button edited = stronger(document.button(), 1.25);
    document.history().apply(edited, "Scale force");
    QVERIFY(document.history().modified());

    QVERIFY(saveDocument(document, at("copy.button.json")).ok());
    QCOMPARE(document.path(), at("copy.button.json"));
    QVERIFY(!document.history().modified());
    auto again = openDocument(at("copy.button.json"));
    QVERIFY(again.ok());
    QVERIFY((*again)->button() == edited);
  }

  void graphsOfOtherSpeedsComeThroughAnEdit() {
    auto opened = openDocument(sample("../tests/model/file/fixtures/version-5.button.json"));
    QVERIFY(opened.ok());
    ButtonDocument& document = **opened;
    document.setAnnotations({});  // the pins and links would refuse the edit
    const Button before = document.button();
    QCOMPARE(before.states()[0].otherSpeeds.size(), std::size_t(2));
    const auto edited = editGraph(before, 0, [](const ForceGraph& graph) {
      return editStroke(graph, Stroke::press, [](const StrokeCurve& curve) {
        return moveKnot(curve, 1, {1.5, 0.72});
      });
    });
    QVERIFY(edited.ok());
    document.history().apply(*edited, "Move knot");
    QVERIFY(saveDocument(document, at("family.button.json")).ok());
    const Button saved = (*openDocument(at("family.button.json")))->button();
    QVERIFY(saved == document.button());
    for (std::size_t i = 0; i < 2; ++i)
      QVERIFY(saved.states()[i].otherSpeeds == before.states()[i].otherSpeeds);
    QVERIFY(!(saved.states()[0].graph == before.states()[0].graph));
  }

  void aDragIsNotSaved() {
    ButtonDocument document(*tactileButton());
    const Button before = document.button();
    document.history().beginDrag("Drag");
    document.history().preview(stronger(before, 2));
    QVERIFY(saveDocument(document, at("a.button.json")).ok());
    QVERIFY((*openDocument(at("a.button.json")))->button() == before);
    document.history().cancelDrag();
  }

  void aFailedSaveChangesNothing() {
    ButtonDocument document(*tactileButton());
    document.history().apply(stronger(document.button(), 2), "Scale force");
    const auto saved = saveDocument(document, at("no/such/folder/a.button.json"));
    QVERIFY(!saved.ok());
    QVERIFY(sentenceOf(saved.failure()).contains("folder"));
    QVERIFY(document.path().isEmpty());
    QVERIFY(document.history().modified());
  }

  void aBrokenFileIsRefusedWithItsPlace() {
    writeFile(at("broken.button.json"), "{\"format\": \"detent-button\",\n  \"version\": }");
    const auto opened = openDocument(at("broken.button.json"));
    QVERIFY(!opened.ok());
    QVERIFY(sentenceOf(opened.failure()).contains("broken.button.json"));
    QVERIFY(sentenceOf(opened.failure()).contains("line 2"));
  }

  void aSentenceNamesNoOptionOfTheCommandLine() {
    const auto said = [](const Subject& subject) {
      return sentenceOf(
          {FailureCode::wrongUsage, subject, "", Message("nothing moves"), Message("Press deeper")});
    };
    QCOMPARE(said(Subject::option("--press")), QString("Nothing moves. Press deeper."));
    QCOMPARE(said("--device sim:kite"), QString("sim:kite: nothing moves. Press deeper."));
    QCOMPARE(said("press trace"), QString("press trace: nothing moves. Press deeper."));
  }

  void aCsvOpensAsANewDocument() {
    ButtonDocument source(*tactileButton());
    QVERIFY(exportCsv(csvText(source.button(), 0), at("bump.csv")).ok());
    auto opened = openDocument(at("bump.csv"));
    QVERIFY(opened.ok());
    QVERIFY((*opened)->path().isEmpty());
    QCOMPARE((*opened)->title(), QString("bump"));
  }

  void reloadCanBeUndone() {
    auto opened = openDocument(sample("buttons/B.button.json"));
    QVERIFY(opened.ok());
    ButtonDocument& document = **opened;
    QVERIFY(saveDocument(document, at("b.button.json")).ok());
    const Button mine = stronger(document.button(), 1.5);
    document.history().apply(mine, "Scale force");
    ButtonDocument other(stronger(mine, 2));
    QVERIFY(saveDocument(other, at("b.button.json")).ok());

    QVERIFY(reloadDocument(document).ok());
    QVERIFY(document.button() == other.button());
    QVERIFY(!document.history().modified());
    document.history().stack().undo();
    QVERIFY(document.button() == mine);
    QVERIFY(document.history().modified());
  }

  void whatIsAnnotatedIsAStepAndComesBack() {
    ButtonDocument document(*tactileButton());
    document.history().markSaved();
    const Annotations notes{
        {{0, Stroke::press, 1, "unit 7"}}, {{"first", "", document.button().states()}}, {}};
    document.annotate(notes, "Note");
    QVERIFY(document.history().modified());
    QVERIFY(saveDocument(document, at("noted.button.json")).ok());
    QVERIFY(!document.history().modified());
    const auto opened = openDocument(at("noted.button.json"));
    QVERIFY(opened.ok());
    QVERIFY((*opened)->annotations() == notes);
    document.annotate({}, "Remove the note");
    QVERIFY(reloadDocument(document).ok());
    QVERIFY(document.annotations() == notes);
    document.history().stack().undo();  // the reload
    QVERIFY(document.annotations().empty());
  }

  void suggestsSafeNames() {
    ButtonDocument document(*rename(*tactileButton(), "../a:b/c"));
    QCOMPARE(suggestedPath(document, "/tmp", ".button.json"), QString("/tmp/-a-b-c.button.json"));
    writeFile(at("-a-b-c.button.json"), "taken");  // by a graph of the same sheet, a moment ago
    QCOMPARE(suggestedPath(document, folder_->path(), ".button.json"), at("-a-b-c 2.button.json"));
    QCOMPARE(withButtonEnding("x"), QString("x.button.json"));
    QCOMPARE(withButtonEnding("x.button"), QString("x.button.json"));
    QCOMPARE(withButtonEnding("x.JSON"), QString("x.JSON"));
  }

  void recentFilesAreNewestFirstOnceAndKept() {
    QSettings settings(at("settings.ini"), QSettings::IniFormat);
    RecentFiles recent(settings);
    QSignalSpy changed(&recent, &RecentFiles::changed);
    for (int i = 0; i < RecentFiles::kept + 3; ++i) recent.add(at(QString::number(i)));
    recent.add(at("5"));
    QCOMPARE(recent.paths().size(), RecentFiles::kept);
    QCOMPARE(recent.paths().first(), at("5"));
    QCOMPARE(recent.paths().count(at("5")), 1);
    recent.remove(at("5"));
    QVERIFY(!recent.paths().contains(at("5")));
    QVERIFY(changed.count() >= RecentFiles::kept);
    settings.sync();
    QSettings later(at("settings.ini"), QSettings::IniFormat);
    QCOMPARE(RecentFiles(later).paths(), recent.paths());
  }

  void filesOfOneNameShowTheirFolders() {
    QCOMPARE(distinctNames({"/a/kailh/plot.png", "/a/cherry/plot.png", "/b/cherry/plot.png", "/a/one.pdf"}),
             QStringList({"kailh/plot.png", "a/cherry/plot.png", "b/cherry/plot.png", "one.pdf"}));
    QCOMPARE(distinctNames({"/plot.png", "/a/plot.png"}), QStringList({"/plot.png", "a/plot.png"}));
    QCOMPARE(distinctNames({}), QStringList());
  }

  void noticesChangesFromOutsideOnly() {
    writeFile(at("w.button.json"), "one");
    FileWatch watch;
    QSignalSpy changed(&watch, &FileWatch::changedOutside), vanished(&watch, &FileWatch::vanished);
    watch.watch(at("w.button.json"));

    writeFile(at("w.button.json"), "two");
    QTRY_COMPARE(changed.count(), 1);
    writeFile(at("w.button.json"), "two");  // the same again: nothing to say
    QTest::qWait(400);
    QCOMPARE(changed.count(), 1);

    writeFile(at("other"), "three");  // what editors do: write beside, rename over
    QVERIFY(std::rename(qPrintable(at("other")), qPrintable(at("w.button.json"))) == 0);
    QTRY_COMPARE(changed.count(), 2);
    writeFile(at("other"), "four");  // and again: the watch has followed the new file
    QVERIFY(std::rename(qPrintable(at("other")), qPrintable(at("w.button.json"))) == 0);
    QTRY_COMPARE(changed.count(), 3);
    writeFile(at("w.button.json"), "five");
    QTRY_COMPARE(changed.count(), 4);

    QFile::remove(at("w.button.json"));
    QTRY_COMPARE(vanished.count(), 1);
    writeFile(at("w.button.json"), "six");
    QTRY_COMPARE(changed.count(), 5);

    watch.watch(at("w.button.json"));  // saved by ourselves
    watch.forget(at("w.button.json"));
    writeFile(at("w.button.json"), "seven");
    QTest::qWait(400);
    QCOMPARE(changed.count(), 5);
  }

  void ownSavesAreNoChanges() {
    ButtonDocument document(*tactileButton());
    QVERIFY(saveDocument(document, at("own.button.json")).ok());
    FileWatch watch;
    QSignalSpy changed(&watch, &FileWatch::changedOutside);
    watch.watch(document.path());
    document.history().apply(stronger(document.button(), 2), "Scale force");
    QVERIFY(saveDocument(document, document.path()).ok());
    watch.watch(document.path());
    QTest::qWait(500);
    QCOMPARE(changed.count(), 0);
  }

  void aFileWrittenBySomebodyElseIsNoticedBeforeEveryWrite() {
    auto opened = openDocument(sample("buttons/B.button.json"));
    ButtonDocument& document = **opened;
    QVERIFY(saveDocument(document, at("b.button.json")).ok());
    QCOMPARE(diskStateOf(document), DiskState::asKnown);
    QVERIFY(saveDocument(document, at("b.button.json")).ok());
    QCOMPARE(diskStateOf(document), DiskState::asKnown);
    auto other = openDocument(at("b.button.json"));
    (*other)->history().apply(stronger((*other)->button(), 2), "Scale");
    QVERIFY(saveDocument(**other, at("b.button.json")).ok());
    QCOMPARE(diskStateOf(document), DiskState::changed);
    QVERIFY(reloadDocument(document).ok());
    QCOMPARE(diskStateOf(document), DiskState::asKnown);
    QVERIFY(QFile::remove(at("b.button.json")));
    QCOMPARE(diskStateOf(document), DiskState::gone);
  }

  void aFileHasOneMarkWhoeverOpensIt() {
    QVERIFY(QFile::copy(sample("buttons/B.button.json"), at("b.button.json")));
    QVERIFY(QFile::link(at("b.button.json"), at("link.button.json")));
    auto mine = openDocument(at("b.button.json")), otherCopy = openDocument(at("link.button.json"));
    OpenMarks here(at("marks")), elsewhere(at("marks"));  // two programs, as far as lock files can tell
    here.watch(**mine);
    QVERIFY(!here.otherEditor(**mine));
    QSignalSpy changed(&elsewhere, &OpenMarks::otherEditorChanged);
    elsewhere.watch(**otherCopy);
    QCOMPARE(elsewhere.otherEditor(**otherCopy), std::optional(QCoreApplication::applicationPid()));
    QCOMPARE(changed.size(), 1);
    here.forget(**mine);
    QTRY_VERIFY_WITH_TIMEOUT(!elsewhere.otherEditor(**otherCopy), 3 * OpenMarks::tryAgain_ms);
    QCOMPARE(changed.size(), 2);
    here.watch(**mine);
    QVERIFY(here.otherEditor(**mine).has_value());
    elsewhere.forget(**otherCopy);
  }

  void travelsAreAStepOrAList() {
    const auto button = readButtonFile(sample("buttons/C.button.json").toStdString());
    QVERIFY(button.ok());
    const ForceGraph& graph = button->states()[0].graph;
    const DisplayUnits mm{LengthUnit::millimetre, ForceUnit::centinewton};
    const double end_mm = graph.press().end_mm();
    std::vector<double> each_mm;
    for (int i = 0; i < end_mm; ++i) each_mm.push_back(i);
    each_mm.push_back(end_mm);
    for (const char* step : {"1", "1 mm", " 1mm ", "0.1 cm"})  // the first text of the question has a unit
      QCOMPARE(*travelsFrom(step, graph, mm), each_mm);
    QCOMPARE(*travelsFrom("0; 0,5 mm  2", graph, mm), (std::vector<double>{0, 0.5, 2}));
    for (const char* refused : {"", " ; ", "0", "-1", "1e-9", "1; 99", "1; x", "; mm"})
      QVERIFY2(!travelsFrom(refused, graph, mm).ok(), refused);
  }

  void exportsAreWhole() {
    const Button button = *tactileButton();
    QVERIFY(exportCsv(csvText(button, 0), at("a.csv")).ok());
    QVERIFY(contentsOf(at("a.csv")).startsWith("stroke,displacement_mm,force_N\npress,0,0.3"));
    QVERIFY(exportCsv(withDecimalCommas(csvText(button, 0)), at("b.csv")).ok());
    QVERIFY(contentsOf(at("b.csv")).startsWith("stroke;displacement_mm;force_N\npress;0;0,3\n"));
    QCOMPARE(contentsOf(at("b.csv")).replace(',', '.').replace(';', ','), contentsOf(at("a.csv")));
    QImage picture(20, 10, QImage::Format_RGB32);
    picture.fill(Qt::red);
    QVERIFY(exportPng(picture, at("a.png")).ok());
    QCOMPARE(QImage(at("a.png")).size(), QSize(20, 10));
    QVERIFY(exportWav(button, 0, at("a.wav")).ok());
    const QByteArray sound = contentsOf(at("a.wav"));
    QVERIFY(sound.startsWith("RIFF"));
    QVERIFY(sound.size() > 48000 / 4 * 4);  // a quarter of a second of floats at least
    QVERIFY(!exportWav(button, 0, at("no/folder/a.wav")).ok());
    QVERIFY(!exportPng(picture, at("no/folder/a.png")).ok());
  }

  void aPictureHoldsItsButton() {
    const Button button = stronger(*tactileButton(), 1.234567890123);
    QImage picture(20, 10, QImage::Format_RGB32);
    picture.fill(Qt::red);
    QVERIFY(exportButtonPng(picture, button, at("with.png")).ok());
    QCOMPARE(QImage(at("with.png")).size(), QSize(20, 10));
    QCOMPARE(*inputKindOf(at("with.png")), InputKind::button);
    const auto opened = openDocument(at("with.png"));
    QVERIFY((*opened)->button() == button && (*opened)->path().isEmpty());
    QVERIFY((*opened)->history().modified());
    picture.setText(buttonInPicture, "{\"format\": 3}");
    QVERIFY(exportPng(picture, at("broken.png")).ok());
    const auto broken = openDocument(at("broken.png"));
    QVERIFY(!broken.ok());
    QVERIFY2(sentenceOf(broken.failure()).contains("broken.png"), qPrintable(sentenceOf(broken.failure())));
  }

  // The editor and the command line are two doors to the same bytes: every format, every file of it.
  void writesWhatTheCommandLineWrites() {
    const auto play = [](const QStringList& words) { return QProcess::execute(DETENT_PLAY, words); };
    const QString file = sample("buttons/B.button.json");
    const Button button = (*openDocument(file))->button();
    QVERIFY(QDir(folder_->path()).mkpath("mine") && QDir(folder_->path()).mkpath("theirs"));
    for (const auto& [word, format] : playback::exportFormats.all)
      for (const auto& [wayDown_s, press] : {std::pair(0.12, "standard"), std::pair(0.25, "human:250ms")}) {
        DeviceExport wanted;
        wanted.settings.format = format;
        wanted.wayDown_s = wayDown_s;
        const QString name = QString::fromUtf8(word);
        QVERIFY(exportForDevice(button, wanted, at("mine/" + name + ".out")).ok());
        QCOMPARE(
            play({"export", file, "--format", name, "--press", press, "-o", at("theirs/" + name + ".out")}),
            0);
      }
    const QStringList written = QDir(at("mine")).entryList(QDir::Files);
    QCOMPARE(written, QDir(at("theirs")).entryList(QDir::Files));
    QVERIFY(written.size() >= 14);  // twelve formats, of which two write a pair
    for (const QString& name : written) {
      QVERIFY(!contentsOf(at("mine/" + name)).isEmpty());
      QVERIFY2(contentsOf(at("mine/" + name)) == contentsOf(at("theirs/" + name)), qPrintable(name));
    }
    QVERIFY(exportWav(button, 0, at("mine.wav")).ok());
    QCOMPARE(play({"render", file, "--standard-press", "-o", at("theirs.wav")}), 0);
    QVERIFY(contentsOf(at("mine.wav")) == contentsOf(at("theirs.wav")));
    if (!playback::hasPageEngine()) return;
    QVERIFY(exportPage({button}, at("mine.html")).ok());
    QCOMPARE(play({"page", file, "-o", at("theirs.html")}), 0);
    QVERIFY(contentsOf(at("mine.html")).contains("<html"));
    QVERIFY(contentsOf(at("mine.html")) == contentsOf(at("theirs.html")));
  }

  // Files for programs of others, as detent-graph writes them: the same, table by table, in any unit, of
  // either state.
  void writesForOthersWhatTheCommandLineWrites() {
    const auto convert = [](const QStringList& words) {
      return QProcess::execute(DETENT_GRAPH, QStringList{"convert"} + words);
    };
    QVERIFY(QDir(folder_->path()).mkpath("theirs"));
    for (const char* name : {"B", "C", "latch"}) {
      const QString file = sample("buttons/") + name + ".button.json";
      const Button button = (*openDocument(file))->button();
      const QString mine = QString("mine-") + name, otherCopy = QString("theirs/") + name;
      QVERIFY(exportDataPackage(button, at(mine)).ok());
      QVERIFY(QDir(folder_->path()).mkpath(otherCopy));
      QCOMPARE(convert({file, at(otherCopy + "/datapackage.json")}), 0);
      const QStringList written = QDir(at(mine)).entryList(QDir::Files);
      QCOMPARE(written, QDir(at(otherCopy)).entryList(QDir::Files));
      QCOMPARE(written.size(), 2 + qsizetype(button.states().size()));
      for (const QString& each : written)
        QVERIFY2(contentsOf(at(mine + "/" + each)) == contentsOf(at(otherCopy + "/" + each)),
                 qPrintable(each));
      for (std::size_t state = 0; state < button.states().size(); ++state)
        for (const auto& [units, words] :
             {std::pair(DisplayUnits{LengthUnit::millimetre, ForceUnit::newton}, QStringList{"N", "mm"}),
              {DisplayUnits{LengthUnit::inch, ForceUnit::gramForce}, QStringList{"gf", "in"}}})
          for (const char* ending : {".tar", ".wpd.json"}) {
            QVERIFY(exportTracedProject(button, state, units, at(QString("mine") + ending)).ok());
            QStringList arguments{
                file, at(QString("theirs") + ending), "--force-unit", words[0], "--length-unit", words[1]};
            if (button.selfLocking())
              arguments += {"--state", QString::fromStdString(button.states()[state].name)};
            QCOMPARE(convert(arguments), 0);
            QVERIFY(!contentsOf(at(QString("mine") + ending)).isEmpty());
            QVERIFY2(contentsOf(at(QString("mine") + ending)) == contentsOf(at(QString("theirs") + ending)),
                     ending);
          }
    }
  }

  void aPackageIsWholeOrNotThere() {
    const Button button = *tactileButton();
    const auto none = exportDataPackage(button, at("no/such"));
    QVERIFY(!none.ok());
    QVERIFY(!QFileInfo::exists(at("no")));
    writeFile(at("taken"), "mine");
    const auto taken = exportDataPackage(button, at("taken"));
    QVERIFY(sentenceOf(taken.failure()).contains("the folder cannot be created"));
    QCOMPARE(contentsOf(at("taken")), QByteArray("mine"));
    // A place of a table that is taken: neither the other tables nor the description are exchanged.
    QVERIFY(exportDataPackage(button, at("again")).ok());
    const QByteArray before = contentsOf(at("again/datapackage.json"));
    QVERIFY(QFile::remove(at("again/figures.csv")) && QDir(at("again")).mkdir("figures.csv"));
    QVERIFY(!exportDataPackage(stronger(button, 2), at("again")).ok());
    QCOMPARE(contentsOf(at("again/datapackage.json")), before);
    QCOMPARE(contentsOf(at("again/curve.csv")), csvText(button, 0).toUtf8());
    QVERIFY(!exportTracedProject(button, 0, {}, at("no/such.tar")).ok());
    // A pair of a device's files that cannot be written whole leaves the earlier pair as it was.
    DeviceExport wanted;
    wanted.settings.format = playback::ExportFormat::ahap;
    QVERIFY(exportForDevice(button, wanted, at("pair.ahap")).ok());
    const QByteArray press = contentsOf(at("pair.press.ahap"));
    QVERIFY(QFile::remove(at("pair.release.ahap")) && QDir(folder_->path()).mkdir("pair.release.ahap"));
    wanted.wayDown_s = 0.2;
    QVERIFY(!exportForDevice(button, wanted, at("pair.ahap")).ok());
    QCOMPARE(contentsOf(at("pair.press.ahap")), press);
  }

  // Of a latch the press is that of the state shown.
  void aPressIsExportedInItsState() {
    const Button latch = *selfLockingButton();
    const Button locked = *Button::fromStates("", {latch.states()[1], latch.states()[0]});
    for (const auto& [button, state, name] : {std::tuple(latch, std::size_t{0}, "unlocked.wav"),
                                              {latch, std::size_t{1}, "locked.wav"},
                                              {locked, std::size_t{0}, "lockedFirst.wav"}})
      QVERIFY(exportWav(button, state, at(name)).ok());
    QCOMPARE(contentsOf(at("locked.wav")), contentsOf(at("lockedFirst.wav")));
    QVERIFY(contentsOf(at("locked.wav")) != contentsOf(at("unlocked.wav")));
  }

 private:
  QString at(const QString& name) const { return folder_->filePath(name); }
  std::unique_ptr<QTemporaryDir> folder_;
};

DETENT_GUILESS_TEST(FilesTest)
#include "files_test.moc"
