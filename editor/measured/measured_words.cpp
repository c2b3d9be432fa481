// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/measured_words.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "editor/document/number_text.h"
#include "editor/panels/key_figures_model.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double percent = 100;
constexpr double leastStep =
    1e-3;  // N, mm, N/mm, mJ and share: finer than any meter behind these measurements
constexpr int mostDecimals = 6;

struct Measured {
  Q_DECLARE_TR_FUNCTIONS(Measured)
};

QString unitWords(KeyFigure figure, const DisplayUnits& units) {
  const FigureUnit unit = keyFigureNames()[static_cast<std::size_t>(figure)].unit;
  if (unit == FigureUnit::mJ) return QStringLiteral("mJ");
  return unit == FigureUnit::share ? QStringLiteral("%") : symbolOf(quantityOf(figure), units);
}

/// As many as the least step needs in the unit shown: numbers of a column stand under each other.
int decimalsOf(KeyFigure figure, const DisplayUnits& units) {
  const double step = shownFigure(leastStep, figure, units);
  constexpr double rounding = 1e-9;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - rounding)), 0, mostDecimals);
}

}  // namespace

QString titleOf(const importer::LibrarySwitch& entry) {
  QString title = QString::fromStdString(entry.name);
  if (!entry.unit.empty()) title = Measured::tr("%1, unit %2").arg(title, QString::fromStdString(entry.unit));
  if (!entry.run.empty()) title = Measured::tr("%1, run %2").arg(title, QString::fromStdString(entry.run));
  return title;
}

QString kindWords(importer::SwitchKind kind) {
  switch (kind) {
    case importer::SwitchKind::linear:
      return Measured::tr("linear");
    case importer::SwitchKind::between:
      return Measured::tr("between");
    case importer::SwitchKind::tactile:
      return Measured::tr("tactile");
  }
  return {};
}

QString licenceWords(const importer::LibrarySwitch& entry) {
  return entry.licence.empty() || entry.licence == importer::noLicenceStated
             ? Measured::tr("none stated")
             : QString::fromStdString(entry.licence);
}

QString creditWords(const importer::LibrarySwitch& entry) {
  return entry.credit.empty() ? Measured::tr("unknown") : QString::fromStdString(entry.credit);
}

QString creditedTitle(const importer::LibrarySwitch& entry) {
  return Measured::tr("%1\nCredit: %2\nLicence: %3")
      .arg(titleOf(entry), creditWords(entry), licenceWords(entry));
}

double shownFigure(double value, KeyFigure figure, const DisplayUnits& units) {
  const Quantity quantity = quantityOf(figure);
  return quantity == Quantity::share ? percent * value : value / shownUnitOf(quantity, units);
}

QString figureText(double value, KeyFigure figure, const DisplayUnits& units) {
  return fixedText(shownFigure(value, figure, units), decimalsOf(figure, units));
}

QString figureTitle(KeyFigure figure, const DisplayUnits& units) {
  return Measured::tr("%1 (%2)").arg(termOf(figure), unitWords(figure, units));
}

}  // namespace detent::editor
