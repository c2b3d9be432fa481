// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/quantity/quantity.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

namespace detent::editor {
namespace {

constexpr double percent = 0.01;  // the unit in which shares are shown

QString tr(const char* text) { return QCoreApplication::translate("Quantity", text); }

Dimension dimensionOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return {0, 1, 0};
    case Quantity::force:
      return {1, 0, 0};
    case Quantity::slope:
      return {1, -1, 0};
    case Quantity::damping:
      return {1, -1, 1};
    default:
      return {};
  }
}

QuantityReading refused(QuantityTrouble trouble, const QString& culprit) { return {{}, 0, trouble, culprit}; }

// A typed change of the present value: "+5", "-=0.1".
struct Change {
  enum class Kind { none, plus, minus } kind = Kind::none;
  QString rest;
};

Change changeIn(const QString& text) {
  const bool plus = text.startsWith(QLatin1Char('+')), minus = !text.isEmpty() && isMinusSign(text[0]);
  const bool explicitly = (plus || minus) && text.size() > 1 && text[1] == QLatin1Char('=');
  if (explicitly) return {plus ? Change::Kind::plus : Change::Kind::minus, text.mid(2)};
  if (plus) return {Change::Kind::plus, text.mid(1)};
  return {Change::Kind::none, text};
}

// "30 %" of a share means 0.3, of any other quantity that part of the present value. With a sign it means a
// change by that part, for a share too.
QuantityReading readPercent(const QString& text, Quantity quantity, std::optional<double> now) {
  const Change change = changeIn(text);
  const bool less = change.kind == Change::Kind::minus ||
                    (change.kind == Change::Kind::none && !text.isEmpty() && isMinusSign(text[0]));
  QString number = change.rest;
  if (less && change.kind == Change::Kind::none) number.remove(0, 1);
  const Evaluation part = evaluate(number, {}, 1);
  if (part.trouble) return refused(*part.trouble, part.culprit);
  if (!part.value.dimension.none()) return refused(QuantityTrouble::noNumber, text + QLatin1Char('%'));
  const double share = part.value.amount * percent;
  const bool changes = less || change.kind == Change::Kind::plus;
  if (quantity == Quantity::share && !changes) return {share, share, {}, {}};
  if (!now) return refused(QuantityTrouble::nothingToChange, text + QLatin1Char('%'));
  const double factor = !changes ? share : less ? 1 - share : 1 + share;
  return {*now * factor, 0, {}, {}};
}

// Asks about a number below 1 without a percent sign, because it is more often meant as a share than as a
// part of a percent.
QString doubtOfShare(const QString& text, double share, const DisplayUnits& units) {
  const QString typedText = quantityWithUnit(share, Quantity::share, units);
  if (share > 1) return tr("%1 is more than 100 %. Press Enter again to keep it.").arg(typedText);
  const bool bare = !text.contains(QLatin1Char('%'));
  if (!bare || share <= 0 || share >= percent) return {};
  return tr("%1 is less than 1 %. Did you mean %2? Press Enter again to keep it.")
      .arg(typedText, quantityWithUnit(share / percent, Quantity::share, units));
}

// Limits of a button: the force of a finger, and the travel of the longest lever switches.
constexpr double mostForce_N = 20, mostTravel_mm = 30;
// Usual values of buttons: in this range another unit is proposed.
constexpr double usualForce_N[] = {0.05, 10}, usualTravel_mm[] = {0.1, 10};

// The typed number with the first unit in which its value would be usual.
QString meantBy(const QString& text, Quantity quantity, const DisplayUnits& units) {
  const auto isLetter = [](QChar c) { return c.isLetter(); };
  const QString number = text.left(std::find_if(text.begin(), text.end(), isLetter) - text.begin()).trimmed();
  const bool isForce = quantity == Quantity::force;
  const auto& [least, most] = isForce ? usualForce_N : usualTravel_mm;
  const QStringList others =
      isForce ? QStringList{"gf", "cN", "mN", "ozf"} : QStringList{"mil", QStringLiteral("µm")};
  for (const QString& unit : others) {
    QString other = number + QLatin1Char(' ') + unit;
    const QuantityReading reading = readQuantity(other, quantity, units);
    if (reading.value && std::abs(*reading.value) >= least && std::abs(*reading.value) <= most) return other;
  }
  return {};
}

QuantityReading readNumber(const QString& text, Quantity quantity, double unit, std::optional<double> now) {
  const Change change = changeIn(text);
  if (change.kind == Change::Kind::minus && !now) return refused(QuantityTrouble::nothingToChange, text);
  const Evaluation read = evaluate(change.rest, dimensionOf(quantity), unit);
  if (read.trouble) return refused(*read.trouble, read.culprit);
  const bool plain = read.value.dimension.none();
  if (!plain && !(read.value.dimension == dimensionOf(quantity)))
    return refused(QuantityTrouble::otherQuantity, text);
  double shown = plain ? read.value.amount : read.value.amount / unit;
  double value = plain ? read.value.amount * unit : read.value.amount;
  if (change.kind != Change::Kind::none && now) {
    value = change.kind == Change::Kind::plus ? *now + value : *now - value;
    shown = value / unit;
  }
  return {value, shown, {}, {}};
}

}  // namespace

QuantityReading readQuantity(const QString& text, Quantity quantity, const DisplayUnits& units,
                             std::optional<double> now) {
  QString trimmed = text.trimmed();
  if (trimmed.isEmpty()) return refused(QuantityTrouble::empty, {});
  const double unit = shownUnitOf(quantity, units);
  if (quantity == Quantity::resolution && trimmed.endsWith(QLatin1String("dpi"), Qt::CaseInsensitive))
    trimmed = trimmed.chopped(3).trimmed();
  QuantityReading reading;
  if (trimmed.endsWith(QLatin1Char('%'))) {
    reading = readPercent(trimmed.chopped(1).trimmed(), quantity, now);
    if (reading.value) reading.shown = *reading.value / unit;
  } else {
    reading = readNumber(trimmed, quantity, unit, now);
  }
  if (!reading.value) return reading;
  if (!std::isfinite(*reading.value) || !std::isfinite(reading.shown))
    return refused(QuantityTrouble::notFinite, trimmed);
  const bool whole = quantity == Quantity::count || quantity == Quantity::resolution;
  if (whole && *reading.value != std::round(*reading.value))
    return refused(QuantityTrouble::notWhole, trimmed);
  return reading;
}

QString refusalOf(const QuantityReading& reading, Quantity quantity, const DisplayUnits& units) {
  const QString symbol = symbolOf(quantity, units);
  const QString example = symbol.isEmpty() ? numberText(1.25) : numberText(1.25) + QLatin1Char(' ') + symbol;
  switch (reading.trouble) {
    case QuantityTrouble::empty:
      return tr("The field is empty. Type for example %1.").arg(example);
    case QuantityTrouble::noNumber:
      return tr("“%1” is not a number. Type for example %2, or +5, or -10 %.").arg(reading.culprit, example);
    case QuantityTrouble::groupSeparator:
      return tr("“%1” can be read in two ways. Type the number without spaces or separators between "
                "thousands.")
          .arg(reading.culprit);
    case QuantityTrouble::unknownUnit:
      return symbol.isEmpty()
                 ? tr("“%1” is not a unit for this value. Type the number alone.").arg(reading.culprit)
                 : tr("“%1” is not a known unit. Type for example %2.").arg(reading.culprit, example);
    case QuantityTrouble::otherQuantity:
      return symbol.isEmpty() ? tr("“%1” has a unit. Type a number without a unit.").arg(reading.culprit)
                              : tr("The unit in “%1” does not suit this field. Type a number in %2.")
                                    .arg(reading.culprit, symbol);
    case QuantityTrouble::mixedUnits:
      return tr("Give every number in “%1” a unit.").arg(reading.culprit);
    case QuantityTrouble::nothingToChange:
      return tr("“%1” is relative to the present value, but the field is empty. Type a value, for example "
                "%2.")
          .arg(reading.culprit, example);
    case QuantityTrouble::notWhole:
      return tr("“%1” is not a whole number. Type a number without decimals.").arg(reading.culprit);
    case QuantityTrouble::notFinite:
      return tr("“%1” is too large, or divides by zero. Type another number.").arg(reading.culprit);
  }
  return {};
}

QString doubtOf(const QString& text, double value, Quantity quantity, const DisplayUnits& units) {
  if (quantity == Quantity::share) return doubtOfShare(text, value, units);
  const bool isForce = quantity == Quantity::force;
  if (!isForce && quantity != Quantity::length) return {};
  if (std::abs(value) <= (isForce ? mostForce_N : mostTravel_mm)) return {};
  const QString meant = meantBy(text, quantity, units);
  const QString typedText = quantityWithUnit(value, quantity, units);
  return meant.isEmpty() ? tr("%1 is unusually high. Press Enter again to keep it.").arg(typedText)
                         : tr("%1 is unusually high. Did you mean %2? Press Enter again to keep %1.")
                               .arg(typedText, meant);
}

double shownUnitOf(Quantity quantity, const DisplayUnits& units) {
  switch (quantity) {
    case Quantity::length:
      return units.toMm(1);
    case Quantity::force:
      return units.toN(1);
    case Quantity::slope:
    case Quantity::damping:
      return units.toSlope(1);
    case Quantity::share:
      return percent;
    default:
      return 1;
  }
}

QString symbolOf(Quantity quantity, const DisplayUnits& units) {
  switch (quantity) {
    case Quantity::length:
      return units.lengthSymbol();
    case Quantity::force:
      return units.forceSymbol();
    case Quantity::slope:
      return units.slopeSymbol();
    case Quantity::damping:
      return units.forceSymbol() + QStringLiteral("·s/") + units.lengthSymbol();
    case Quantity::resolution:
      return QStringLiteral("dpi");
    case Quantity::share:
      return QStringLiteral("%");
    default:
      return {};
  }
}

QString quantityText(double value, Quantity quantity, const DisplayUnits& units, int significant) {
  return numberText(value / shownUnitOf(quantity, units), significant);
}

QString quantityWithUnit(double value, Quantity quantity, const DisplayUnits& units, int significant) {
  const QString number = quantityText(value, quantity, units, significant);
  const QString symbol = symbolOf(quantity, units);
  const bool wouldChange = quantity == Quantity::share && value < 0;  // "-3 %" typed is a change
  return symbol.isEmpty() || wouldChange ? number : number + QLatin1Char(' ') + symbol;
}

}  // namespace detent::editor
