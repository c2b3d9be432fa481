// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogue for a magnetic keyboard's key: what is typed is what is drawn, said and exported.

#include "editor/window/magnetic_dialog.h"

#include <QFile>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <utility>

#include "model/edits.h"
#include "model/file/button_file.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;

namespace {

Button magneticSample(const char* name) {
  return *readButtonFile(std::string(DETENT_SOURCE_DIR "/samples/buttons/") + name + ".button.json");
}

}  // namespace

class MagneticDialogTest : public QObject {
  Q_OBJECT

 private slots:
  // C acts at 2 mm and resets at 1.4 mm of 4 mm; the second press begins at 1 mm.
  void fieldsAreWhatIsSaidAndExported() {
    MagneticDialog dialog(magneticSample("C"), {});
    dialog.show();
    QCOMPARE(said(dialog, "magneticEvents"),
             "The key closes at 2 mm, opens at 1.4 mm, closes at 2 mm, opens at 1.4 mm.");
    QVERIFY(header(dialog).contains("#define DETENT_RAPID_UM 0 "));
    QVERIFY(!header(dialog).contains("DEAD_ZONE") && !header(dialog).contains("Forecast"));
    QVERIFY(!field(dialog, "magneticPress")->isEnabled());
    box(dialog, "magneticRapid")->click();
    QVERIFY(field(dialog, "magneticPress")->isEnabled());
    type(dialog, "magneticPress", "0.25");
    type(dialog, "magneticRelease", "0.5");
    QCOMPARE(said(dialog, "magneticEvents"),
             "The key closes at 2 mm, opens at 3.5 mm, closes at 2 mm, opens at 3.5 mm.");
    box(dialog, "magneticContinuous")->click();
    type(dialog, "magneticTop", "0.1");
    QCOMPARE(said(dialog, "magneticEvents"),
             "The key closes at 2 mm, opens at 3.5 mm, closes at 1.25 mm, opens at 3.5 mm.");
    type(dialog, "magneticBottom", "1");
    QVERIFY(said(dialog, "magneticEvents").contains("opens at 2.999 mm"));
    type(dialog, "magneticDown", "1.5");
    QCOMPARE(said(dialog, "magneticEvents"), "The key stays open.");
    for (const char* line : {"DETENT_ACTUATE_UM 2000", "DETENT_RESET_UM 1400", "DETENT_RAPID_UM 250",
                             "DETENT_RAPID_RELEASE_UM 500", "DETENT_RAPID_CONTINUOUS 1",
                             "DETENT_TOP_DEAD_ZONE_UM 100", "DETENT_BOTTOM_DEAD_ZONE_UM 1000", "ARE ASSUMED"})
      QVERIFY2(header(dialog).contains(line), line);
  }

  // A acts and resets at 2 mm: a key that could not be exported as it opens.
  void aKeyThatOpensWhereItClosesGetsTheUsualReleasePoint() {
    MagneticDialog dialog(magneticSample("A"), {});
    dialog.show();
    QVERIFY(header(dialog).contains("DETENT_ACTUATE_UM 2000"));
    QVERIFY(header(dialog).contains("DETENT_RESET_UM 1900"));
  }

  void theReleasePointFollowsUntilItIsTyped() {
    MagneticDialog dialog(magneticSample("C"), {});
    dialog.show();
    const double distance_mm = dialog.settings().actuate_mm - dialog.settings().reset_mm;
    QVERIFY(distance_mm > 0);
    type(dialog, "magneticActuate", "1.2");
    QVERIFY(std::abs(dialog.settings().reset_mm - (1.2 - distance_mm)) < 1e-9);
    QVERIFY(accept(dialog)->isEnabled());
    type(dialog, "magneticReset", "0.9");
    type(dialog, "magneticActuate", "1.4");
    QCOMPARE(dialog.settings().reset_mm, 0.9);
  }

  // As it stands after typing, cancelling and opening again; what was not typed follows the button.
  void theChoiceComesBack() {
    QTemporaryDir folder;
    QFile readings(folder.filePath("mine.csv"));
    QVERIFY(readings.open(QIODevice::WriteOnly));
    readings.write("displacement_mm,reading\n0,100\n4,900\n");
    readings.close();
    MagneticDialog first(magneticSample("C"), {});
    first.show();
    box(first, "magneticRapid")->click();
    box(first, "magneticContinuous")->click();
    const std::pair<const char*, double> typed_mm[] = {
        {"magneticActuate", 1.7}, {"magneticPress", 0.3}, {"magneticRelease", 0.4}, {"magneticTop", 0.2},
        {"magneticBottom", 0.6},  {"magneticDown", 3.2},  {"magneticUp", 0.8}};
    for (const auto& [name, value_mm] : typed_mm) type(first, name, QString::number(value_mm));
    first.readSensor(readings.fileName());

    MagneticDialog again(magneticSample("C"), {}, first.choice());
    again.show();
    for (const auto& [name, value_mm] : typed_mm) QCOMPARE(field(again, name)->value(), value_mm);
    QVERIFY(field(again, "magneticPress")->isEnabled());
    QCOMPARE(said(again, "magneticEvents"), said(first, "magneticEvents"));
    QCOMPARE(said(again, "magneticReadings"), "Readings from mine.csv.");
    QCOMPARE(header(again), header(first));
    type(again, "magneticActuate", "1.5");
    QVERIFY(std::abs(again.settings().reset_mm - 0.9) < 1e-9);  // still follows, 0.6 mm above

    const Button softer = *scaleTravel(magneticSample("C"), 1.5);
    MagneticDialog edited(softer, {}, first.choice());
    QCOMPARE(edited.settings().actuate_mm, 1.7);
    QCOMPARE(edited.settings().travel_mm, 6.0);
    QVERIFY(std::abs(edited.settings().reset_mm - 0.8) < 1e-9);  // the button's distance is 0.9 mm now
  }

  // Curves and marks are children that a drawing makes anew.
  void aChangeDrawsOnce() {
    MagneticDialog dialog(magneticSample("C"), {});
    dialog.show();
    struct Count : QObject {
      int made = 0;
      bool eventFilter(QObject*, QEvent* event) override {
        made += event->type() == QEvent::ChildAdded;
        return false;
      }
    } count;
    dialog.findChild<QWidget*>("magneticPlot")->installEventFilter(&count);
    auto* line = field(dialog, "magneticActuate")->findChild<QLineEdit*>();
    line->selectAll();
    QTest::keyClicks(line, "1");
    const int afterTyping = std::exchange(count.made, 0);
    QEvent event(QEvent::PaletteChange);
    QCoreApplication::sendEvent(&dialog, &event);  // draws the same once
    QVERIFY(count.made > 0);
    QCOMPARE(afterTyping, count.made);
  }

  void whatContradictsIsRefusedWithItsReason() {
    MagneticDialog dialog(magneticSample("C"), {});
    dialog.show();
    const auto refused = [&](const QString& words) {
      return said(dialog, "magneticRefusal").contains(words) && !accept(dialog)->isEnabled() &&
             said(dialog, "magneticEvents").isEmpty();
    };
    type(dialog, "magneticReset", "2");
    QVERIFY(refused("release point: 2 mm does not lie between rest and the actuation point, 2 mm."));
    type(dialog, "magneticReset", "1.5");
    QVERIFY(accept(dialog)->isEnabled() && said(dialog, "magneticRefusal").isEmpty());
    type(dialog, "magneticReset", "abc");
    QVERIFY(!accept(dialog)->isEnabled() && !said(dialog, "magneticRefusal").isEmpty());
    type(dialog, "magneticReset", "1.5");
    type(dialog, "magneticTop", "1.6");
    QVERIFY(
        refused("top dead zone: the top dead zone of 1.6 mm is not between 0 and the release point, which is "
                "at 1.5 mm."));
    type(dialog, "magneticTop", "0");
    type(dialog, "magneticBottom", "3");
    QVERIFY(refused("the bottom dead zone of 3 mm is not between 0 and 2 mm"));
    type(dialog, "magneticBottom", "2");
    QVERIFY(accept(dialog)->isEnabled());
    box(dialog, "magneticRapid")->click();
    type(dialog, "magneticPress", "0");
    QVERIFY(refused("press distance: 0 mm is not greater than 0."));
    box(dialog, "magneticRapid")->click();  // then it is not used
    QVERIFY(accept(dialog)->isEnabled());
  }

  void readingsOfASensorAreTaken() {
    QTemporaryDir folder;
    const auto written = [&](const char* name, const QByteArray& text) {
      QFile file(folder.filePath(name));
      (void)file.open(QIODevice::WriteOnly);
      file.write(text);
      return file.fileName();
    };
    MagneticDialog dialog(magneticSample("C"), {});
    dialog.readSensor(written("bad.csv", "displacement_mm,reading\n0,1\n1,3\n2,2\n"));
    QVERIFY(said(dialog, "magneticReadings").contains("pair 3"));
    QVERIFY(header(dialog).contains("ARE ASSUMED"));
    dialog.readSensor(written("good.csv", "displacement_mm,reading\n0,100\n4,900\n"));
    QCOMPARE(said(dialog, "magneticReadings"), "Readings from good.csv.");
    QVERIFY(header(dialog).contains("Readings as measured") &&
            header(dialog).contains("DETENT_READING_AT_END 900"));
    // The example in the dialogue is a file that is read.
    const QString example = said(dialog, "magneticFormat").section("Example:\n", 1);
    dialog.readSensor(written("example.csv", example.toUtf8()));
    QCOMPARE(said(dialog, "magneticReadings"), "Readings from example.csv.");
    dialog.readSensor(folder.filePath("good.csv"));
    dialog.readSensor(folder.filePath("none.csv"));
    QVERIFY(header(dialog).contains("DETENT_READING_AT_END 900"));  // the last good ones stay
  }

  // Any button, and any units.
  void everySampleHasADialogue() {
    for (const char* name : {"A", "B", "C", "D", "E", "EF", "F", "push", "latch"}) {
      DisplayUnits units;
      units.length = LengthUnit::inch;
      MagneticDialog dialog(magneticSample(name), units);
      dialog.resize(dialog.minimumSizeHint());
      (void)dialog.grab();
      QVERIFY(accept(dialog)->isEnabled());
      QVERIFY(!said(dialog, "magneticEvents").isEmpty());
    }
  }

 private:
  static QString said(const MagneticDialog& dialog, const char* name) {
    return dialog.findChild<QLabel*>(name)->text();
  }
  static QString header(const MagneticDialog& dialog) { return QString::fromStdString(dialog.header()); }
  static QuantityField* field(const MagneticDialog& dialog, const char* name) {
    return dialog.findChild<QuantityField*>(name);
  }
  static QCheckBox* box(const MagneticDialog& dialog, const char* name) {
    return dialog.findChild<QCheckBox*>(name);
  }
  static QPushButton* accept(const MagneticDialog& dialog) {
    return dialog.findChild<QPushButton*>("magneticExport");
  }
  static void type(const MagneticDialog& dialog, const char* name, const QString& text) {
    auto* line = field(dialog, name)->findChild<QLineEdit*>();
    line->clear();
    QTest::keyClicks(line, text);
  }
};

DETENT_WINDOW_TEST(MagneticDialogTest)
#include "magnetic_dialog_test.moc"
