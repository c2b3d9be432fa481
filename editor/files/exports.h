// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exports beside button files: samples, drawings, pictures, sound. A file is written whole or not at all.

#include <functional>
#include <QImage>
#include <QPaintDevice>
#include <QString>

#include "editor/document/display_units.h"
#include "model/button.h"
#include "playback/sharing.h"

namespace detent::editor {

/// Samples of one state in the CSV of the programs' contract (mm, N).
QString csvText(const Button& button, std::size_t state, const DisplayUnits& units = modelUnits);
/// The samples of a CSV in mm and N (model/file/curve_csv.h) in other units, which its header then names; 12
/// digits. In mm and N it stays as it is.
QString inUnits(const QString& csv, const DisplayUnits& units);
/// The CSV for spreadsheets of countries with a decimal comma: fields separated by semicolons.
QString withDecimalCommas(QString csv);
Result<Done> exportCsv(const QString& csv, const QString& path);

/// Travels in mm from typed text, in the shown units. One number is a step from zero to the end; several,
/// separated by spaces or semicolons, are the travels themselves. Failure: a number that cannot be read, lies
/// outside the travel, or is a step that gives too many samples.
Result<std::vector<double>> travelsFrom(const QString& text, const ForceGraph& graph,
                                        const DisplayUnits& units);

/// Key of the text in a PNG that holds the button, without notes, versions and page.
inline const QString buttonInPicture = QStringLiteral("detent-button");
/// Writes a picture that contains its button: Detent opens the button, not the picture.
Result<Done> exportButtonPng(QImage picture, const Button& button, const QString& path);
Result<Done> exportPng(const QImage& picture, const QString& path);
/// Writes a drawing of this size, by the path's ending: ".svg" and ".pdf" as vectors by `draw`, anything else
/// `picture` as PNG.
Result<Done> exportDrawing(QSize size, const QString& path,
                           const std::function<void(QPaintDevice&, QSize)>& draw,
                           const std::function<QImage()>& picture);

/// The vibration of a standard press (playback/playback.h) that begins in that state, on a perfect device:
/// mono float WAV, 48 kHz.
Result<Done> exportWav(const Button& button, std::size_t state, const QString& path);

/// The buttons as one web page, as `detent-play page` writes it, byte for byte. Failure: as
/// playback::sharePage, or the disk's.
Result<Done> exportPage(const std::vector<Button>& buttons, const QString& path);

/// Writes the button as a Frictionless data package, byte for byte as `detent-graph convert` does. `folder`
/// is created if it does not exist, and removed again if it would stay empty.
Result<Done> exportDataPackage(const Button& button, const QString& folder);
/// Writes a state as a WebPlotDigitizer project, as `detent-graph convert` does, with axes in `units`: with
/// its picture (a TAR archive), or without it if `path` ends in .json.
Result<Done> exportTracedProject(const Button& button, std::size_t state, const DisplayUnits& units,
                                 const QString& path);

/// A press for another device: the button from its first state, pressed by a finger with this downstroke;
/// byte for byte as `detent-play export` writes it.
struct DeviceExport {
  playback::ExportSettings settings;  ///< the press's name is filled in here
  double wayDown_s = 0.12;            ///< 0.01..10
};
/// Failure: as playback::exportPress. Any thread.
Result<playback::Exported> deviceExport(const Button& button, const DeviceExport& wanted);
/// Writes these files, all or none.
Result<Done> exportForDevice(const Button& button, const DeviceExport& wanted, const QString& path);

}  // namespace detent::editor
