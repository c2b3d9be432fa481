// SPDX-License-Identifier: GPL-3.0-or-later
// Preferences, the user's guide and the glossary in a real window.

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>

#include "editor/panels/figure_drawing.h"
#include "editor/window/appearance.h"
#include "editor/window/help_window.h"
#include "editor/window/main_window.h"
#include "editor/window/preferences_dialog.h"
#include "editor/window/stored_view.h"
#include "editor/window/translation.h"
#include "tests/editor/window/scripted_prompts.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;
using detent::editor::tests::ScriptedPrompts;

namespace {

const char* const docs = DETENT_SOURCE_DIR "/docs";

/// As a person does: the choice is made in the list that opens.
void choose(QWidget& window, const char* name, const QString& text) {
  auto* box = window.findChild<QComboBox*>(name);
  QVERIFY2(box && box->findText(text) >= 0, qPrintable(text));
  box->setCurrentIndex(box->findText(text));
  emit box->activated(box->currentIndex());
}

void keepPicture(QWidget& widget, const QString& name) {
  const QString folder = qEnvironmentVariable("DETENT_PICTURES");
  if (folder.isEmpty()) return;
  QTest::qWait(50);
  widget.grab().save(folder + '/' + name + ".png");
}

/// Pixels of this colour.
int countOf(const QImage& picture, const QColor& color) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) count += picture.pixelColor(x, y) == color;
  return count;
}

}  // namespace

class PreferencesHelpTest : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder_;

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void everyUnitIsOfferedAndAppliesAtOnce() {
    ViewSettings view;
    QSettings settings(folder_->filePath("p.ini"), QSettings::IniFormat);
    PreferencesDialog dialog(view, settings, {"en", "de"});
    dialog.show();
    for (const char* unit : {"mm", "cm", "um", "in", "mil"})
      QVERIFY2(dialog.findChild<QComboBox*>("preferencesLength")->findText(unit) >= 0 || *unit == 'u', unit);
    for (const char* unit : {"N", "cN", "mN", "gf", "kgf", "ozf", "lbf"})
      QVERIFY2(dialog.findChild<QComboBox*>("preferencesForce")->findText(unit) >= 0, unit);
    choose(dialog, "preferencesForce", "kgf");
    choose(dialog, "preferencesLength", "cm");
    QVERIFY(view.units() == (DisplayUnits{LengthUnit::centimetre, ForceUnit::kilogramForce}));
    view.setUnits({LengthUnit::inch, ForceUnit::ounceForce});  // units chosen at the status bar
    QCOMPARE(dialog.findChild<QComboBox*>("preferencesForce")->currentText(), QString("ozf"));
    QCOMPARE(dialog.findChild<QComboBox*>("preferencesLength")->currentText(), QString("in"));
    choose(dialog, "preferencesTheme", "dark");
    QCOMPARE(view.appearance(), Appearance::dark);
    view.setAppearance(Appearance::light);
    QCOMPARE(dialog.findChild<QComboBox*>("preferencesTheme")->currentText(), QString("light"));
  }

  void theLanguageIsThatOfTheNextStart() {
    ViewSettings view;
    QSettings settings(folder_->filePath("p.ini"), QSettings::IniFormat);
    PreferencesDialog dialog(view, settings, {"en", "de"});
    dialog.show();
    QVERIFY(dialog.findChild<QLabel*>("preferencesLanguageNote")->text().contains("restarted"));
    choose(dialog, "preferencesLanguage", "Deutsch");
    QCOMPARE(settings.value(languageKey).toString(), QString("de"));
    QCOMPARE(PreferencesDialog(view, settings, {"en", "de"})
                 .findChild<QComboBox*>("preferencesLanguage")
                 ->currentText(),
             QString("Deutsch"));
    keepPicture(dialog, "preferences");
    choose(dialog, "preferencesLanguage", "same as system");
    QVERIFY(settings.value(languageKey).toString().isEmpty());
  }

  // A setting that names no language of the program has no effect.
  void aBrokenLanguageIsNoLanguage() {
    QSettings settings(folder_->filePath("p.ini"), QSettings::IniFormat);
    const auto chosen = [&](const QVariant& stored) {
      settings.setValue(languageKey, stored);
      return chosenLocale(settings, DETENT_TRANSLATIONS).language();
    };
    QCOMPARE(chosen("de"), QLocale::German);
    QCOMPARE(chosen("en"), QLocale::English);
    for (const QVariant& broken : {QVariant("zz"), QVariant(""), QVariant(17), QVariant("../de"), QVariant()})
      QCOMPARE(chosen(broken), QLocale().language());
  }

  void theLayoutGoesBackToTheFirstOne() {
    QSettings settings(folder_->filePath("w.ini"), QSettings::IniFormat);
    ViewSettings view;
    ScriptedPrompts prompts;
    RecoveryStore recovery(folder_->filePath("recovery"));
    MainWindow window({view, settings, prompts, recovery});
    window.resize(1280, 820);
    window.show();
    window.files().open({QStringLiteral(DETENT_SOURCE_DIR "/samples/buttons/B.button.json")});
    QTest::qWait(100);
    auto* library = window.findChild<QDockWidget*>("libraryDock");
    auto* inspector = window.findChild<QDockWidget*>("inspectorDock");
    auto* values = window.findChild<QDockWidget*>("valuesDock");
    const Qt::DockWidgetArea first = window.dockWidgetArea(values);
    const bool shown = library->isVisible();
    const int width_px = inspector->width();
    library->show();
    window.addDockWidget(Qt::LeftDockWidgetArea, values);
    window.resizeDocks({inspector}, {width_px + 150}, Qt::Horizontal);
    library->setVisible(!shown);
    for (QAction* action : window.allActions())
      if (action->objectName() == "preferences") action->trigger();
    auto* preferences = window.findChild<PreferencesDialog*>();
    QVERIFY(preferences && preferences->isVisible());
    preferences->findChild<QPushButton*>("preferencesReset")->click();
    QTest::qWait(50);
    QCOMPARE(library->isVisible(), shown);
    QCOMPARE(window.dockWidgetArea(values), first);
    QVERIFY2(std::abs(inspector->width() - width_px) <= 2, qPrintable(QString::number(inspector->width())));
    preferences->close();
  }

  void theGuideIsReadInAWindow() {
    GuideWindow guide(docs);
    guide.show();
    auto* pages = guide.findChild<QTextBrowser*>("guidePages");
    QVERIFY(pages->toPlainText().contains("The editor") && pages->toPlainText().contains("Key figures"));
    const QUrl first = pages->source();
    emit pages->anchorClicked(QUrl("studies.md"));
    QVERIFY(pages->source().path().endsWith("/guide/studies.md"));
    QVERIFY(pages->toPlainText().size() > 1000);
    emit pages->anchorClicked(QUrl("../develop/decisions/gone.md"));  // not installed
    QVERIFY(pages->source().path().endsWith("/guide/studies.md"));
    QVERIFY(guide.findChild<QLabel*>("guideNote")->isVisible());
    guide.findChild<QPushButton*>("guideBack")->click();
    QCOMPARE(pages->source(), first);
    auto* search = guide.findChild<QLineEdit*>("guideSearch");
    QTest::keyClicks(search, "shortcuts");
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(pages->textCursor().selectedText().toLower(), QString("shortcuts"));
    guide.findChild<QPushButton*>("guideStart")->click();
    QCOMPARE(pages->horizontalScrollBar()->maximum(), 0);  // pictures fit
    keepPicture(guide, "guide");
    const auto picture =
        pages->loadResource(QTextDocument::ImageResource, QUrl("../pictures/main-light.png"));
    QVERIFY(!picture.value<QImage>().isNull() && picture.value<QImage>().width() <= guide.width());
  }

  void aMissingGuideIsSaid() {
    GuideWindow guide({});
    guide.show();
    QVERIFY(guide.findChild<QTextBrowser*>("guidePages")->toPlainText().contains("not installed"));
    QVERIFY(!guide.findChild<QPushButton*>("guideStart")->isEnabled());
  }

  // Six terms, each with a drawing of its own, in the colours of the window.
  void theGlossaryDrawsSixTerms() {
    const QPalette before = QApplication::palette();
    for (const bool dark : {false, true}) {
      QApplication::setPalette(dark ? darkPalette() : lightPalette());
      GlossaryWindow glossary;
      glossary.show();
      const GraphColors colors = graphColors(dark);
      QList<QImage> seen;
      for (const char* name : {"glossaryOperating", "glossaryPeak", "glossaryBottomOut", "glossaryTravel",
                               "glossaryHysteresis", "glossarySnap"}) {
        const auto* picture = glossary.findChild<QLabel*>(name);
        QVERIFY2(picture, name);
        const QImage image = picture->pixmap().toImage();
        QVERIFY2(!seen.contains(image), name);
        QVERIFY2(countOf(image, colors.refused) > 20, name);  // the picture marks the term in this colour
        QVERIFY2(countOf(image, colors.background) > 1000, name);
        seen << image;
      }
      keepPicture(glossary, dark ? "glossary-dark" : "glossary-light");
      QApplication::setPalette(dark ? lightPalette() : darkPalette());
      QCoreApplication::processEvents();
      QVERIFY(glossary.findChild<QLabel*>("glossaryPeak")->pixmap().toImage() !=
              seen[1]);  // pictures follow the theme
    }
    QApplication::setPalette(before);
  }
};

DETENT_WINDOW_TEST(PreferencesHelpTest)
#include "preferences_help_test.moc"
