// SPDX-License-Identifier: GPL-3.0-or-later
// Autosave and recovery, with real processes that are killed.

#include <QDir>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "editor/files/document_files.h"
#include "editor/files/recovery_store.h"
#include "model/edits.h"
#include "model/templates.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;

namespace {

Button stronger(const Button& button, double factor) { return *scaleForce(button, factor); }

QStringList filesUnder(const QString& folder) {
  QStringList names;
  const QStringList sessions = QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
  for (const QString& session : sessions)
    names << QDir(folder + "/" + session).entryList({"*.recovery.json"}, QDir::Files);
  return names;
}

// The second process of these tests: an editor with one modified document, which runs for ever.
int editorToBeKilled(QCoreApplication& app, const QString& folder) {
  RecoveryStore store(folder);
  ButtonDocument document(*tactileButton());
  document.setPath("/somewhere/mine.button.json");
  document.history().apply(stronger(document.button(), 1.5), "Scale force");
  store.watch(document);
  store.flush();
  QTextStream(stdout) << "written" << Qt::endl;
  return app.exec();
}

/// Starts this program again as editorToBeKilled and waits until its work is on the disk.
class OtherEditor {
 public:
  explicit OtherEditor(const QString& folder) {
    process_.start(QCoreApplication::applicationFilePath(),
                   {"RecoveryTest", "--editor-to-be-killed", folder});
    started_ = process_.waitForStarted() && process_.waitForReadyRead(20000);
  }
  bool started() const { return started_; }
  void kill() {
    process_.kill();
    process_.waitForFinished();
  }
  ~OtherEditor() { kill(); }

 private:
  QProcess process_;
  bool started_ = false;
};

}  // namespace

class RecoveryTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void recordsSurviveTheirText() {
    const RecoveryRecord record{*clickyButton(),
                                "/a/ü.button.json",
                                "ü",
                                QDateTime::currentDateTimeUtc(),
                                "a hash",
                                PageCutout{"\x89PNG\r\n\x1a\n", {1, 2, 3, 4, 5, 6, 7, 8, 9}},
                                Annotations{{{0, Stroke::press, 1.5, "ask the tester"}}, {}, {}}};
    const auto read = recoveryFromText(recoveryText(record), "x");
    QVERIFY(read.ok());
    QVERIFY(read->button == record.button);
    QCOMPARE(read->path, record.path);
    QCOMPARE(read->title, record.title);
    QCOMPARE(read->written, record.written);
    QCOMPARE(read->knownContent, record.knownContent);
    QVERIFY(read->cutout == record.cutout);
    QVERIFY(read->annotations == record.annotations);
    QVERIFY(!recoveryFromText("{}", "x").ok());
    QVERIFY(!recoveryFromText("{\"format\":\"detent-recovery\",\"version\":2}", "x").ok());
    QVERIFY(!recoveryFromText("no json", "x").ok());
  }

  void onlyModifiedDocumentsAreWritten() {
    RecoveryStore store(folder_->path());
    ButtonDocument document(*tactileButton());
    store.watch(document);
    store.flush();
    QVERIFY(filesUnder(folder_->path()).isEmpty());
    document.history().apply(stronger(document.button(), 2), "Scale force");
    store.flush();
    QCOMPARE(filesUnder(folder_->path()).size(), 1);
    document.history().stack().undo();  // unmodified again
    store.flush();
    QVERIFY(filesUnder(folder_->path()).isEmpty());
    store.forget(document);
  }

  void writesByItselfWithinFiveSeconds() {
    RecoveryStore store(folder_->path());
    ButtonDocument document(*tactileButton());
    store.watch(document);
    document.history().apply(stronger(document.button(), 2), "Scale force");
    QTRY_COMPARE_WITH_TIMEOUT(filesUnder(folder_->path()).size(), 1, 5000);
    store.forget(document);
  }

  void aCleanCloseLeavesNothing() {
    {
      RecoveryStore store(folder_->path());
      ButtonDocument document(*tactileButton());
      store.watch(document);
      document.history().apply(stronger(document.button(), 2), "Scale force");
      store.flush();
      store.forget(document);
    }
    QVERIFY(QDir(folder_->path()).isEmpty());
  }

  void aKilledEditorsWorkComesBackExactly() {
    OtherEditor other(folder_->path());
    QVERIFY(other.started());
    other.kill();
    RecoveryStore store(folder_->path());
    const auto left = store.leftBehind();
    QCOMPARE(left.size(), 1);
    QVERIFY(left[0].record.button == stronger(*tactileButton(), 1.5));
    QCOMPARE(left[0].record.path, QString("/somewhere/mine.button.json"));
    QCOMPARE(left[0].record.title, QString("mine"));
    store.discard(left[0]);
    QVERIFY(filesUnder(folder_->path()).isEmpty());
    QVERIFY(store.leftBehind().isEmpty());
  }

  void aRunningEditorsWorkIsItsOwn() {
    OtherEditor other(folder_->path());
    QVERIFY(other.started());
    RecoveryStore store(folder_->path());
    QVERIFY(store.leftBehind().isEmpty());
    QCOMPARE(filesUnder(folder_->path()).size(), 1);
  }

  void whatIsOfferedToOneIsNotOfferedToTheNext() {
    {
      OtherEditor other(folder_->path());
      QVERIFY(other.started());
    }
    {
      RecoveryStore first(folder_->path());
      QCOMPARE(first.leftBehind().size(), 1);
      RecoveryStore second(folder_->path());
      QVERIFY(second.leftBehind().isEmpty());
    }
    RecoveryStore later(
        folder_->path());  // neither recovered nor discarded, so the next editor offers it again
    QCOMPARE(later.leftBehind().size(), 1);
  }

  void aBrokenRecoveryFileIsNamedAndStays() {
    QDir(folder_->path()).mkpath("dead");
    QFile file(folder_->filePath("dead/1.recovery.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"format\": \"detent-reco");
    file.close();
    RecoveryStore store(folder_->path());
    QStringList unreadable;
    QVERIFY(store.leftBehind(&unreadable).isEmpty());
    QCOMPARE(unreadable.size(), 1);
    QVERIFY(file.exists());
  }

  void aFolderThatCannotBeWrittenIsSaid() {
    QFile inTheWay(folder_->filePath("file"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    RecoveryStore store(folder_->filePath("file/recovery"));
    QSignalSpy failed(&store, &RecoveryStore::failed);
    ButtonDocument document(*tactileButton());
    store.watch(document);
    document.history().apply(stronger(document.button(), 2), "Scale force");
    store.flush();
    QCOMPARE(failed.count(), 1);
    store.forget(document);
  }

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

DETENT_WINDOW_TEST(RecoveryTest, [] {
  const QStringList arguments = QCoreApplication::arguments();
  if (arguments.size() != 4 || arguments[2] != "--editor-to-be-killed") return true;
  std::exit(editorToBeKilled(*QCoreApplication::instance(), arguments[3]));
})
#include "recovery_test.moc"
