// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/export_controller.h"

#include "editor/document/message_words.h"
#include "editor/files/document_files.h"
#include "editor/files/exports.h"
#include "editor/library/compare_panel.h"
#include "editor/library/compare_plot.h"
#include "model/file/text_file.h"
#include "model/file/travel_steps.h"

namespace detent::editor {
namespace {

constexpr QSize exportedPicture_px{2400, 1600};
constexpr double exportedPixelRatio = 2;
constexpr QSize comparisonSize_px{900, 600};

std::pair<QString, QString> graphFile(GraphFileFormat format) {
  switch (format) {
    case GraphFileFormat::svg:
      return {ExportController::tr("SVG drawing"), ".svg"};
    case GraphFileFormat::pdf:
      return {ExportController::tr("PDF document"), ".pdf"};
    case GraphFileFormat::png:
      return {ExportController::tr("PNG picture"), ".png"};
  }
  return {};
}

}  // namespace

ExportController::ExportController(const ControllerContext& context, QObject* parent)
    : QObject(parent), at_(context) {}

void ExportController::write(DocumentTab& tab, const QString& title, const QString& filter,
                             const QString& ending,
                             const std::function<Result<Done>(const QString&)>& writeTo, QString* chosen) {
  QString path = at_.prompts.fileToSave(
      &at_.window, title, suggestedPath(tab.document(), at_.folderToSave(), ending), filter, chosen);
  if (path.isEmpty()) return;
  if (ending.startsWith('.') && QFileInfo(path).suffix().isEmpty()) path += ending;
  const auto written = writeTo(path);
  if (!written) {
    tab.notices().say("export", NoticeBar::Kind::trouble,
                      tr("Not exported: %1").arg(sentenceOf(written.failure())));
    return;
  }
  tab.notices().dismiss("export");
  at_.rememberSavedIn(QFileInfo(path).absolutePath());
  emit done(tr("Exported %1").arg(shownPath(path)));
}

void ExportController::samples(
    DocumentTab& tab, const QString& kind,
    const std::function<Result<Done>(const QString&, const DisplayUnits&)>& writeTo) {
  const DisplayUnits shown = at_.view.units();
  QStringList filters;
  for (const DisplayUnits& units : {shown, modelUnits})
    filters << tr("%1, %2 and %3").arg(kind, units.lengthSymbol(), units.forceSymbol()) + " (*.csv)";
  filters.removeDuplicates();
  QString chosen;
  write(
      tab, tr("Export samples"), filters.join(QStringLiteral(";;")), ".csv",
      [&](const QString& path) { return writeTo(path, chosen == filters.back() ? modelUnits : shown); },
      &chosen);
}

void ExportController::csv(DocumentTab& tab) {
  samples(tab, tr("CSV"), [&document = tab.document()](const QString& path, const DisplayUnits& units) {
    return exportCsv(csvText(document.button(), document.activeState(), units), path);
  });
}

void ExportController::csvAt(DocumentTab& tab) {
  const ButtonDocument& document = tab.document();
  const DisplayUnits& units = at_.view.units();
  const auto typed = at_.prompts.text(
      &at_.window, tr("Samples at given travels"),
      tr("Step, or travels separated by spaces or semicolons, in %1:").arg(units.lengthSymbol()),
      QStringLiteral("0.1 mm"));
  if (!typed) return;
  const auto travels_mm = travelsFrom(*typed, document.graph(), units);
  if (!travels_mm)
    return tab.notices().say("export", NoticeBar::Kind::trouble,
                             tr("Not exported: %1").arg(sentenceOf(travels_mm.failure(), units)));
  samples(tab, tr("CSV"), [&](const QString& path, const DisplayUnits& shown) {
    return exportCsv(inUnits(QString::fromStdString(csvAtTravels(*travels_mm, document.graph())), shown),
                     path);
  });
}

void ExportController::semicolonCsv(DocumentTab& tab) {
  samples(tab, tr("CSV with semicolons"),
          [&document = tab.document()](const QString& path, const DisplayUnits& units) {
            return exportCsv(withDecimalCommas(csvText(document.button(), document.activeState(), units)),
                             path);
          });
}

void ExportController::graph(DocumentTab& tab) {
  const Button& button = tab.document().button();
  const auto chosen = at_.prompts.graphExport(&at_.window, button, at_.view.units());
  if (!chosen) return;
  const auto& [name, ending] = graphFile(chosen->format);
  write(tab, tr("Export the graph"), name + " (*" + ending + ")", ending,
        [&](const QString& path) { return exportGraph(button, *chosen, path); });
}

void ExportController::png(DocumentTab& tab) {
  write(tab, tr("Export picture"), tr("PNG picture") + " (*.png)", ".png", [&](const QString& path) {
    return exportButtonPng(tab.workspace().renderImage(exportedPicture_px, exportedPixelRatio),
                           tab.document().button(), path);
  });
}

void ExportController::comparison(DocumentTab& tab, const ComparePanel& comparison) {
  const QString filter = QStringList{tr("PNG picture") + " (*.png)", tr("SVG drawing") + " (*.svg)",
                                     tr("PDF document") + " (*.pdf)"}
                             .join(";;");
  write(tab, tr("Export the comparison"), filter, ".png", [&](const QString& path) {
    return exportDrawing(
        comparisonSize_px, path,
        [&](QPaintDevice& device, QSize size) { comparison.plot().renderTo(device, size); },
        [&] { return comparison.plot().picture(exportedPicture_px, exportedPixelRatio); });
  });
}

void ExportController::wav(DocumentTab& tab) {
  write(tab, tr("Export the vibration of a press"), tr("WAV sound") + " (*.wav)", ".wav",
        [&](const QString& path) {
          return exportWav(tab.document().button(), tab.document().activeState(), path);
        });
}

void ExportController::dataPackage(DocumentTab& tab) {
  write(tab, tr("Export as a data package"), tr("Folder of a data package") + " (*)", "-datapackage",
        [&](const QString& path) { return exportDataPackage(tab.document().button(), path); });
}

void ExportController::tracedProject(DocumentTab& tab) {
  const ButtonDocument& document = tab.document();
  const QString filter =
      tr("Project with its picture") + " (*.tar);;" + tr("Project without a picture") + " (*.wpd.json)";
  write(tab, tr("Export for WebPlotDigitizer"), filter, ".tar", [&](const QString& path) {
    return exportTracedProject(document.button(), document.activeState(), at_.view.units(), path);
  });
}

void ExportController::page(DocumentTab& tab) {
  write(tab, tr("Share as web page"), tr("Web page") + " (*.html)", ".html",
        [&](const QString& path) { return exportPage({tab.document().button()}, path); });
}

void ExportController::device(DocumentTab& tab) {
  const auto chosen = at_.prompts.deviceExport(&at_.window, tab.document().button());
  if (!chosen) return;
  write(tab, tr("Export for a device"), chosen->name + " (*" + chosen->ending + ")", chosen->ending,
        [&](const QString& path) { return exportForDevice(tab.document().button(), chosen->wanted, path); });
}

void ExportController::magneticKey(DocumentTab& tab) {
  const auto header =
      at_.prompts.magneticKey(&at_.window, tab.document().button(), at_.view.units(), tab.magneticChoice());
  if (!header) return;
  write(tab, tr("Export for a magnetic keyboard"), tr("C header") + " (*.h)", ".h", [&](const QString& path) {
    return writeTextFileAtomically(QFile::encodeName(path).toStdString(), *header);
  });
}

}  // namespace detent::editor
