// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/quality_figures.h"

#include <QCoreApplication>

#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("detent::editor::ImportDialog", text); }

QString levelName(importer::Quality quality) {
  switch (quality) {
    case importer::Quality::draft:
      return tr("Draft");
    case importer::Quality::standard:
      return tr("Standard");
    case importer::Quality::precise:
      return tr("Precise");
  }
  return {};
}

}  // namespace

QualityFigures figuresOf(importer::Quality quality) {
  switch (quality) {
    case importer::Quality::draft:
      return {quality, 0.51, 0.091};
    case importer::Quality::standard:
      break;
    case importer::Quality::precise:
      return {quality, 0.73, 0.044};
  }
  return {importer::Quality::standard, 0.61, 0.059};
}

QString describedQuality(importer::Quality quality) {
  const QualityFigures figures = figuresOf(quality);
  return tr("%1 – about %2 s, error %3 % of the axis")
      .arg(levelName(quality), numberText(figures.median_s, 2), numberText(figures.error_percentOfSpan, 2));
}

}  // namespace detent::editor
