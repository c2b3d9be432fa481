// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the windows against those that were looked at and blessed (tests/editor/golden).

#include <cstdlib>
#include <QApplication>
#include <QDir>
#include <QFontDatabase>
#include <QListView>
#include <QTemporaryDir>
#include <QTest>

#include "editor/library/compare_panel.h"
#include "editor/library/template_dialog.h"
#include "editor/window/appearance.h"
#include "editor/window/main_window.h"
#include "model/edits.h"
#include "tests/editor/window/scripted_prompts.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;

namespace {

// Font rendering differs by a shade between machines; a moved or missing thing differs by much more.
constexpr int channelTolerance = 40;
constexpr double shareTolerance = 0.01;
constexpr int patience_ms = 20000;  // for a forecast on a busy machine

const QString goldenFolder = QStringLiteral(DETENT_SOURCE_DIR "/tests/editor/golden/");

QString sample(const char* name) { return QStringLiteral(DETENT_SOURCE_DIR "/samples/") + name; }

bool differs(QRgb a, QRgb b) {
  return std::abs(qRed(a) - qRed(b)) > channelTolerance ||
         std::abs(qGreen(a) - qGreen(b)) > channelTolerance ||
         std::abs(qBlue(a) - qBlue(b)) > channelTolerance;
}

/// Share of pixels that differ; `marks` becomes the golden picture, pale, with these in red.
double differenceOf(const QImage& now, const QImage& golden, QImage& marks) {
  marks = golden.convertToFormat(QImage::Format_RGB32);
  qint64 different = 0;
  for (int y = 0; y < golden.height(); ++y)
    for (int x = 0; x < golden.width(); ++x) {
      const bool differ = differs(now.pixel(x, y), golden.pixel(x, y));
      different += differ;
      const int pale = 192 + qGray(golden.pixel(x, y)) / 4;
      marks.setPixel(x, y, differ ? qRgb(220, 0, 0) : qRgb(pale, pale, pale));
    }
  return static_cast<double>(different) / (golden.width() * golden.height());
}

}  // namespace

class GoldenTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    settings_ = std::make_unique<QSettings>(folder_->filePath("s.ini"), QSettings::IniFormat);
    view_ = std::make_unique<ViewSettings>();
    recovery_ = std::make_unique<RecoveryStore>(folder_->filePath("recovery"));
    view_->setAppearance(Appearance::light);
  }

  void welcome() { compareWindow("welcome-light", Appearance::light, {}); }
  void mainLight() {
    compareWindow("main-light", Appearance::light, {"buttons/C.button.json", "buttons/B.button.json"});
  }
  void mainDark() { compareWindow("main-dark", Appearance::dark, {"buttons/latch.button.json"}); }

  void notices() {
    auto window = makeWindow(Appearance::light);
    window->files().open({sample("buttons/B.button.json")});
    window->notices().say("a", NoticeBar::Kind::trouble,
                          "Not opened: broken.button.json, line 2: malformed.");
    window->notices().say("b", NoticeBar::Kind::information, "Detent ended without closing.",
                          {{"recover", "Recover", [] {}}, {"discard", "Discard", [] {}}});
    QTest::qWait(500);
    check("notices-light", window->grab().toImage());
  }

  /// Forces and contacts are named beside each other, not over each other.
  void lowGraph() {
    auto window = makeWindow(Appearance::light);
    window->files().open({sample("buttons/B.button.json")});
    check("low-graph", window->tabs().current()->workspace().renderImage({420, 150}, 1));
  }

  void comparison() {
    auto window = makeWindow(Appearance::light);
    window->files().open({sample("buttons/C.button.json"), sample("buttons/B.button.json")});
    window->compareWith(nullptr);
    auto* dialog = window->findChild<ComparePanel*>();
    dialog->findChild<QToolButton*>("compareDifference")->click();
    QTest::qWait(100);
    auto* forecast = dialog->findChild<QLabel*>("forecastWords");
    QTRY_VERIFY_WITH_TIMEOUT(!forecast->text().isEmpty(), patience_ms);
    QTest::qWait(100);  // lets the texts wrap
    check("compare-light", dialog->grab().toImage());
  }

  void templates() {
    QApplication::setPalette(lightPalette());
    TemplateDialog dialog;
    dialog.resize(400, 460);
    check("templates-light", dialog.grab().toImage());
  }

 private:
  std::unique_ptr<MainWindow> makeWindow(Appearance appearance) {
    view_->setAppearance(appearance);
    auto window = std::make_unique<MainWindow>(WindowContext{*view_, *settings_, prompts_, *recovery_});
    window->resize(1000, 640);
    window->show();
    return window;
  }

  void compareWindow(const QString& name, Appearance appearance, const std::vector<const char*>& files) {
    auto window = makeWindow(appearance);
    for (const char* file : files) window->files().open({sample(file)});
    if (files.size() > 1) window->findChild<QDockWidget*>("libraryDock")->show();
    QTest::qWait(500);  // waits for the pictures of the library
    if (files.size() > 1) {
      const auto* open = window->findChild<QListView*>("libraryOpenButtons")->model();
      QTRY_VERIFY_WITH_TIMEOUT(open->index(0, 0).data().toString().contains('\n'), patience_ms);
    }
    check(name, window->grab().toImage());
  }

  void check(const QString& name, const QImage& now) {
    const QString file = goldenFolder + name + ".png";
    if (qEnvironmentVariableIsSet("DETENT_BLESS")) {
      QDir().mkpath(goldenFolder);
      QVERIFY(now.save(file));
      return;
    }
    const QString how =
        "Look at it, then bless with DETENT_BLESS=1 ctest --preset release -R editor_golden_test, and look "
        "at "
        "the difference in git.";
    const QImage golden(file);
    const QString out = QDir::current().filePath(name + ".out.png"),
                  diff = QDir::current().filePath(name + ".diff.png");
    if (golden.isNull() || golden.size() != now.size()) {
      now.save(out);
      QFAIL(qPrintable(
          QString("%1 is not there or of another size; what was drawn is %2. %3").arg(file, out, how)));
    }
    QImage marks;
    const double share = differenceOf(now.convertToFormat(QImage::Format_RGB32), golden, marks);
    if (share <= shareTolerance) return;
    now.save(out);
    marks.save(diff);
    QFAIL(qPrintable(QString("%1 % of %2 differ (up to %3 % may); see %4 and %5. %6")
                         .arg(share * 100, 0, 'f', 2)
                         .arg(name)
                         .arg(shareTolerance * 100)
                         .arg(out, diff, how)));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<QSettings> settings_;
  std::unique_ptr<ViewSettings> view_;
  std::unique_ptr<RecoveryStore> recovery_;
  tests::ScriptedPrompts prompts_;
};

DETENT_WINDOW_TEST(GoldenTest, [] {
  QApplication::setStyle(outlinedStyle());
  if (!QFontDatabase::families().contains("DejaVu Sans")) {
    std::puts("SKIPPED golden pictures of the editor: the font DejaVu Sans is not installed");
    return false;
  }
  QApplication::setFont(QFont("DejaVu Sans", 9));
  return true;
})
#include "golden_test.moc"
