// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/measured_words.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>
#include <QStringList>

#include "editor/document/number_text.h"
#include "editor/panels/key_figures_model.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double leastStep =
    1e-3;  // in N, mm, N/mm, mJ or as a share: finer than any meter behind these measurements
constexpr int mostDecimals = 6;

struct Measured {
  Q_DECLARE_TR_FUNCTIONS(Measured)
};

QString unitWords(KeyFigure figure, const DisplayUnits& units) {
  const FigureUnit unit = keyFigureNames()[static_cast<std::size_t>(figure)].unit;
  if (unit == FigureUnit::mJ) return QStringLiteral("mJ");
  return symbolOf(quantityOf(figure), units);
}

/// Number of decimals that the least step needs in the unit shown, so that the numbers of a column are
/// aligned.
int decimalsOf(KeyFigure figure, const DisplayUnits& units) {
  const double step = shownFigure(leastStep, figure, units);
  constexpr double rounding = 1e-9;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - rounding)), 0, mostDecimals);
}

}  // namespace

QString titleOf(const importer::LibrarySwitch& entry) {
  QString title = QString::fromStdString(entry.name);
  if (!entry.unit.empty())
    title = Measured::tr("%1, specimen %2").arg(title, QString::fromStdString(entry.unit));
  if (!entry.run.empty()) title = Measured::tr("%1, run %2").arg(title, QString::fromStdString(entry.run));
  return title;
}

QString kindWords(importer::SwitchKind kind) {
  switch (kind) {
    case importer::SwitchKind::linear:
      return Measured::tr("linear");
    case importer::SwitchKind::between:
      return Measured::tr("intermediate");
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
  return value / shownUnitOf(quantityOf(figure), units);
}

QString figureText(double value, KeyFigure figure, const DisplayUnits& units) {
  return fixedText(shownFigure(value, figure, units), decimalsOf(figure, units));
}

QString withError(const QString& shown, const std::optional<double>& sigma, KeyFigure figure,
                  const DisplayUnits& units) {
  if (!sigma) return shown;
  const QString error = figureText(*sigma, figure, units);
  const bool none = std::ranges::none_of(error, [](QChar c) { return c >= '1' && c <= '9'; });
  if (!none) return Measured::tr("%1 ± %2").arg(shown, error);
  // An error below the last shown digit is not added.
  return shown;
}

QString spreadWords(const importer::SwitchSpread& spread, const DisplayUnits& units) {
  if (spread.records < 2) return {};
  QStringList figures;
  for (const KeyFigure figure :
       {KeyFigure::peakForce, KeyFigure::drop, KeyFigure::bottomOutForce, KeyFigure::totalTravel})
    if (const auto& sd = spread.sd[figure])
      figures << Measured::tr("%1 ± %2 %3")
                     .arg(termOf(figure), figureText(*sd, figure, units), unitWords(figure, units));
  const QString between = figures.join(QStringLiteral(", "));
  if (spread.units > 1)
    return ' ' + Measured::tr("%1 measurements of %2 specimens of this switch. Spread: %3.")
                     .arg(spread.records)
                     .arg(spread.units)
                     .arg(between);
  return ' ' + Measured::tr("%1 measurements of one specimen of this switch. Spread: %2.")
                   .arg(spread.records)
                   .arg(between);
}

QString ratingWords(const std::vector<importer::Rating>& ratings) {
  QString words;
  for (const importer::Rating& each : ratings)
    words += ' ' + Measured::tr("Rated by %1 (licence: %2).")
                       .arg(QString::fromStdString(importer::ratingWords(each)),
                            QString::fromStdString(each.licence));
  return words;
}

QString doubtfulScaleWords() {
  return Measured::tr("Forces in this kind of file may differ greatly from those of other laboratories.");
}

QString figureTitle(KeyFigure figure, const DisplayUnits& units) {
  return Measured::tr("%1 (%2)").arg(termOf(figure), unitWords(figure, units));
}

}  // namespace detent::editor
