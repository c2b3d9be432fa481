// SPDX-License-Identifier: GPL-3.0-or-later
// What is exported is read back by detent-import as the button it was, in every preset, format and unit.

#include "editor/files/graph_export.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "importer/page/document.h"
#include "model/compare.h"
#include "model/file/graph_program.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;

namespace {

constexpr double most_percent = 0.1;

struct Written {
  GraphPreset preset;
  GraphFileFormat format;
  DisplayUnits units;
  PlotLanguage language = PlotLanguage::english;
};

const char* endingOf(GraphFileFormat format) {
  switch (format) {
    case GraphFileFormat::svg:
      return ".svg";
    case GraphFileFormat::pdf:
      return ".pdf";
    case GraphFileFormat::png:
      return ".png";
  }
  return "";
}

Button sample(const QString& name) {
  return *readButton(
      (QStringLiteral(DETENT_SOURCE_DIR "/samples/buttons/") + name + ".button.json").toStdString());
}

GraphExport exportOf(const Written& written) {
  GraphExport wanted;
  wanted.format = written.format;
  wanted.language = written.language;
  wanted.style = styleOf(written.preset, written.units);
  if (written.language == PlotLanguage::german) wanted.style.decimalSign = ',';
  return wanted;
}

}  // namespace

class GraphExportTest : public QObject {
  Q_OBJECT

 private slots:
  void readsBackWhatItWrote_data() {
    QTest::addColumn<QString>("button");
    QTest::addColumn<int>("preset");
    QTest::addColumn<int>("format");
    QTest::addColumn<int>("length");
    QTest::addColumn<int>("force");
    QTest::addColumn<int>("language");
    const bool all = qEnvironmentVariableIsSet("DETENT_ALL_EXPORTS");
    const auto add = [](const QString& button, int preset, int format, int length, int force, int language) {
      QTest::addRow("%s preset %d format %d unit %d %d language %d", qPrintable(button), preset, format,
                    length, force, language)
          << button << preset << format << length << force << language;
    };
    const QStringList buttons = all ? QStringList{"A", "B", "C", "D", "E", "F"} : QStringList{"C"};
    for (const QString& button : buttons)
      for (int preset = 0; preset < 3; ++preset)
        for (int format = 0; format < 3; ++format)
          for (int force = 0; force < (all ? 7 : 1); ++force)
            add(button, preset, format, force % 5, force, force % 2);
    if (all) return;
    for (int force = 1; force < 7; ++force) add("A", 0, 0, force % 5, force, force % 2);
    add("E", 1, 0, 3, 3, 1);  // half a loop, on an axis that could end far behind it
    for (const char* button : {"B", "D"}) add(button, 1, 2, 0, 0, 0);  // black and white pictures
  }

  void readsBackWhatItWrote() {
    QFETCH(QString, button);
    QFETCH(int, preset);
    QFETCH(int, format);
    QFETCH(int, length);
    QFETCH(int, force);
    QFETCH(int, language);
    constexpr LengthUnit lengths[] = {LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::micrometre,
                                      LengthUnit::inch, LengthUnit::mil};
    constexpr ForceUnit forces[] = {ForceUnit::newton,      ForceUnit::centinewton,   ForceUnit::gramForce,
                                    ForceUnit::millinewton, ForceUnit::kilogramForce, ForceUnit::ounceForce,
                                    ForceUnit::poundForce};
    Written written{static_cast<GraphPreset>(preset),
                    static_cast<GraphFileFormat>(format),
                    {},
                    static_cast<PlotLanguage>(language)};
    written.units.length = lengths[length];
    written.units.force = forces[force];
    const Button drawn = sample(button);
    const QString path = folder_.filePath(QStringLiteral("graph") + endingOf(written.format));
    const auto done = exportGraph(drawn, exportOf(written), path);
    QVERIFY(done.ok());
    const QString back = folder_.filePath("back.button.json");
    QFile::remove(back);
    QProcess import;
    import.start(QStringLiteral(DETENT_IMPORT), {path, "-o", back, "--quality", "precise"});
    QVERIFY(import.waitForFinished(120'000));
    QVERIFY2(import.exitCode() == 0, import.readAllStandardError().constData());
    const auto read = readButton(back.toStdString());
    QVERIFY(read.ok());
    const auto apart = compare(polylinesOf(drawn.states()[0].graph), polylinesOf(read->states()[0].graph));
    QVERIFY(apart.ok() && apart->press);
    QCOMPARE(apart->release.has_value(), drawn.states()[0].graph.release().has_value());
    qInfo("mean %.4f %%, most %.4f %%", 100 * apart->meanOfSpan, 100 * apart->maxOfSpan);
    QVERIFY(100 * apart->meanOfSpan <= most_percent);
  }

  // Numbers and words of a PDF are text, that can be found and copied, in both languages.
  void wordsOfAPdfAreText_data() {
    QTest::addColumn<QString>("button");
    QTest::addColumn<int>("language");
    QTest::addColumn<QString>("word");
    QTest::newRow("English") << "C" << 0 << "Displacement";
    QTest::newRow("German") << "C" << 1 << "Schaltpunkt";
    QTest::newRow("German, states") << "EF" << 1 << "(eingerastet)";
  }

  void wordsOfAPdfAreText() {
    QFETCH(QString, button);
    QFETCH(int, language);
    QFETCH(QString, word);
    const QString path = folder_.filePath("words.pdf");
    QVERIFY(
        exportGraph(
            sample(button),
            exportOf({GraphPreset::datasheet, GraphFileFormat::pdf, {}, static_cast<PlotLanguage>(language)}),
            path)
            .ok());
    const auto document = importer::Document::open(path.toStdString());
    QVERIFY(document.ok());
    const auto page = document->page(1);
    QVERIFY(page.ok());
    QStringList texts;
    for (const importer::TextBox& box : page->texts) texts << QString::fromStdString(box.utf8);
    QVERIFY2(texts.join(' ').contains(word), qPrintable(texts.join('|')));
  }

 private:
  QTemporaryDir folder_;
};

DETENT_WINDOW_TEST(GraphExportTest)
#include "graph_export_test.moc"
