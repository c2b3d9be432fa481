// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/quality_figures.h"

#include <algorithm>
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
  constexpr QualityFigures levels[] = {{importer::Quality::draft, 1, 0.112},
                                       {importer::Quality::standard, 1.13, 0.0835},
                                       {importer::Quality::precise, 3.6, 0.0628}};
  return *std::ranges::find(levels, quality, &QualityFigures::quality);
}

QString describedQuality(importer::Quality quality) {
  const QualityFigures figures = figuresOf(quality);
  const QString error = numberText(figures.error_percentOfSpan, 2);
  if (quality == importer::Quality::draft)
    return tr("%1 – fastest, error %2 % of the axis").arg(levelName(quality), error);
  return tr("%1 – takes %2 times as long as a draft, error %3 % of the axis")
      .arg(levelName(quality), numberText(figures.workOfDraft, 2), error);
}

}  // namespace detent::editor
