// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/exports.h"

#include <cmath>
#include <filesystem>
#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>

#include "editor/document/begun_in.h"
#include "editor/files/document_files.h"
#include "editor/files/native_path.h"
#include "editor/quantity/quantity.h"
#include "model/check.h"
#include "model/file/curve_csv.h"
#include "model/file/data_package.h"
#include "model/file/text_file.h"
#include "model/file/traced_project.h"
#include "model/file/travel_steps.h"
#include "playback/playback.h"

namespace detent::editor {
namespace {

/// Name of a press for `detent-play export --press`; the standard press has a downstroke of 120 ms.
std::string pressName(double wayDown_s) {
  const long wayDown_ms = std::lround(1000 * wayDown_s);
  return wayDown_ms == 120 ? "standard" : "human:" + std::to_string(wayDown_ms) + "ms";
}

}  // namespace

QString csvText(const Button& button, std::size_t state, const DisplayUnits& units) {
  DETENT_CHECK(state < button.states().size(), "the state to export is one of the button's");
  return inUnits(QString::fromStdString(csvFrom(button.states()[state].graph)), units);
}

QString inUnits(const QString& csv, const DisplayUnits& units) {
  if (units == modelUnits) return csv;
  constexpr int digits = 12;
  QStringList lines = csv.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  lines[0] = QStringLiteral("stroke,displacement_%1,force_%2").arg(units.lengthSymbol(), units.forceSymbol());
  for (qsizetype i = 1; i < lines.size(); ++i) {
    const QStringList fields = lines[i].split(QLatin1Char(','));
    lines[i] = QStringList{fields[0], QString::number(units.lengthFrom(fields[1].toDouble()), 'g', digits),
                           QString::number(units.forceFrom(fields[2].toDouble()), 'g', digits)}
                   .join(QLatin1Char(','));
  }
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QString withDecimalCommas(QString csv) {
  return csv.replace(QLatin1Char(','), QLatin1Char(';')).replace(QLatin1Char('.'), QLatin1Char(','));
}

Result<Done> exportCsv(const QString& csv, const QString& path) {
  return writeTextFileAtomically(nativePath(path), csv.toStdString());
}

namespace {

struct SampledAt {
  Q_DECLARE_TR_FUNCTIONS(SampledAt)
};

}  // namespace

Result<std::vector<double>> travelsFrom(const QString& text, const ForceGraph& graph,
                                        const DisplayUnits& units) {
  std::vector<double> typed;
  // A blank before a letter stands between a number and its unit.
  static const QRegularExpression separator(QStringLiteral("\\s*;\\s*|\\s+(?![^\\s\\d.,+-])"));
  for (const QString& part : text.split(separator, Qt::SkipEmptyParts)) {
    const QuantityReading reading = readQuantity(part, Quantity::length, units);
    if (!reading.value)
      return Failure{FailureCode::wrongUsage, "", "",
                     refusalOf(reading, Quantity::length, units).toStdString(),
                     SampledAt::tr("Type a step such as 0.1, or travels such as 0; 0.5; 2").toStdString()};
    typed.push_back(*reading.value);
  }
  return typed.size() == 1 ? travelsAtEach(typed.front(), graph) : travelsWithin(std::move(typed), graph);
}

Result<Done> exportButtonPng(QImage picture, const Button& button, const QString& path) {
  picture.setText(buttonInPicture, buttonText(button));
  return exportPng(picture, path);
}

Result<Done> exportPng(const QImage& picture, const QString& path) {
  QByteArray png;
  QBuffer buffer(&png);
  if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG"))
    return Failure{FailureCode::internalFault, path.toStdString(), "",
                   Message("the picture cannot be saved as a PNG"),
                   Message("Choose a smaller size for the picture")};
  return writeTextFileAtomically(nativePath(path), png.toStdString());
}

Result<Done> exportDrawing(QSize size, const QString& path,
                           const std::function<void(QPaintDevice&, QSize)>& draw,
                           const std::function<QImage()>& picture) {
  const bool svg = path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
  if (!svg && !path.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive)) return exportPng(picture(), path);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly))
    return Failure{FailureCode::internalFault, path.toStdString(), "", Message("the picture cannot be drawn"),
                   Message("Export a PNG instead")};
  if (svg) {
    QSvgGenerator drawing;
    drawing.setOutputDevice(&buffer);
    drawing.setSize(size);
    drawing.setViewBox(QRect(QPoint(), size));
    draw(drawing, size);
  } else {
    QPdfWriter page(&buffer);
    page.setPageSize(QPageSize(QSizeF(size), QPageSize::Point, {}, QPageSize::ExactMatch));
    page.setPageMargins({});
    page.setResolution(72);  // a unit of the drawing is a point
    draw(page, size);
  }
  return writeTextFileAtomically(nativePath(path), bytes.toStdString());
}

Result<Done> exportWav(const Button& button, std::size_t state, const QString& path) {
  const Button begun = begunIn(button, state);
  const auto prepared = playback::prepareProgram(begun, {}, playback::usualSettings());
  if (!prepared) return prepared.failure();
  const auto press = playback::standardPress(prepared->program);
  const auto felt = playback::asPressed(begun, *prepared, press, {}, playback::usualSettings());
  if (!felt) return felt.failure();
  const auto written =
      playback::renderPressToFile(felt->prepared.program, press, {}, std::filesystem::path(nativePath(path)));
  if (!written) return written.failure();
  return Done{};
}

Result<Done> exportPage(const std::vector<Button>& buttons, const QString& path) {
  const auto page = playback::sharePage(buttons);
  if (!page) return page.failure();
  return writeTextFileAtomically(nativePath(path), *page);
}

Result<Done> exportDataPackage(const Button& button, const QString& folder) {
  const std::filesystem::path path(nativePath(folder));
  std::error_code error;
  const bool made = std::filesystem::create_directory(path, error);
  if (error)
    return Failure{FailureCode::wrongUsage, folder.toStdString(), "",
                   Message("the folder cannot be created: %1", error.message()),
                   Message("Choose another folder or another name")};
  auto written = writeDataPackage(button, (path / "datapackage.json").string());
  if (!written && made) std::filesystem::remove(path, error);
  return written;
}

Result<Done> exportTracedProject(const Button& button, std::size_t state, const DisplayUnits& units,
                                 const QString& path) {
  DETENT_CHECK(state < button.states().size(), "the state to export is one of the button's");
  SvgPlotStyle style;
  style.forceUnit = units.force;
  style.lengthUnit = units.length;
  const bool plain = path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
  return writeTextFileAtomically(
      nativePath(path), (plain ? tracedProjectFrom : tracedArchiveFrom)(button.states()[state], style));
}

Result<playback::Exported> deviceExport(const Button& button, const DeviceExport& wanted) {
  const auto prepared = playback::prepareProgram(button, {}, playback::usualSettings());
  if (!prepared) return prepared.failure();
  const std::string press = pressName(wanted.wayDown_s);
  const auto trace = playback::namedPress(press, prepared->program);
  if (!trace) return trace.failure();
  const auto felt = playback::asPressed(button, *prepared, *trace, {}, playback::usualSettings());
  if (!felt) return felt.failure();
  playback::ExportSettings settings = wanted.settings;
  settings.pressName = playback::pressInWords(press);
  return playback::exportPress(felt->button, felt->prepared.program, *trace, settings);
}

Result<Done> exportForDevice(const Button& button, const DeviceExport& wanted, const QString& path) {
  const auto exported = deviceExport(button, wanted);
  if (!exported) return exported.failure();
  const auto written = playback::writeExported(*exported, nativePath(path));
  if (!written) return written.failure();
  return Done{};
}

}  // namespace detent::editor
