// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/quantity/expression.h"

#include <cmath>
#include <limits>
#include <string>

#include "model/units.h"

namespace detent::editor {
namespace {

constexpr int deepestBrackets = 16;
constexpr qsizetype longestText = 200;
constexpr double sameUnit = 1e-12;  // relative: sizes of one unit differ by rounding only

struct Unit {
  double size = 1;
  Dimension dimension;
};

std::optional<Unit> unitFrom(const QString& word) {
  const std::string name = word.toStdString();
  if (const auto length = lengthUnitFrom(name)) return Unit{millimetresPer(*length), {0, 1, 0}};
  if (const auto force = forceUnitFrom(name)) return Unit{newtonsPer(*force), {1, 0, 0}};
  if (name == "s") return Unit{1, {0, 0, 1}};
  if (name == "ms") return Unit{1e-3, {0, 0, 1}};
  if (name == "Ns") return Unit{1, {1, 0, 1}};
  return {};
}

bool isDecimalSign(QChar c) { return c == QLatin1Char('.') || c == QLatin1Char(',') || c == QChar(0x066B); }
bool isGroupSign(QChar c) { return c == QLatin1Char('\'') || c == QChar(0x2019) || c == QChar(0x066C); }
bool isUnitSign(QChar c) { return c.isLetter() || c == QLatin1Char('"') || c == QChar(0x00B5); }
bool isTimes(QChar c) {
  return c == QLatin1Char('*') || c == QChar(0x00D7) || c == QChar(0x00B7) || c == QChar(0x22C5);
}
bool isOver(QChar c) { return c == QLatin1Char('/') || c == QChar(0x00F7); }

/// Recursive-descent parser; stops at the first fault.
class Reader {
 public:
  Reader(const QString& text, Dimension shown, double shownSize)
      : text_(text), shown_(shown), shownSize_(shownSize) {}

  Evaluation read() {
    if (text_.size() > longestText) fail(QuantityTrouble::noNumber, text_.left(20) + QChar(0x2026));
    const Amount value = sum(0);
    skipSpaces();
    if (!trouble_ && at_ < text_.size()) refuseHere();
    if (!trouble_ && !anyDigit_) fail(QuantityTrouble::noNumber, text_);
    if (!trouble_ && !std::isfinite(value.amount)) fail(QuantityTrouble::notFinite, text_);
    return {value, trouble_, culprit_};
  }

 private:
  Amount sum(int depth) {
    Amount left = product(depth);
    while (!trouble_) {
      skipSpaces();
      const bool plus = next([](QChar c) { return c == QLatin1Char('+'); });
      if (!plus && !next(isMinusSign)) return left;
      Amount right = product(depth);
      if (trouble_) return left;
      bringTogether(left, right);
      left.amount += plus ? right.amount : -right.amount;
    }
    return left;
  }

  Amount product(int depth) {
    Amount left = factor(depth);
    while (!trouble_) {
      skipSpaces();
      const bool times = next(isTimes);
      if (!times && !next(isOver)) return left;
      const Amount right = factor(depth);
      if (!times && right.amount == 0) fail(QuantityTrouble::notFinite, text_);
      if (trouble_) return left;
      if (!times && left.dimension.none() && !right.dimension.none())
        left = fractionOf(left, right);
      else
        combine(left, right, times);
    }
    return left;
  }

  Amount factor(int depth) {
    skipSpaces();
    const bool negative = next(isMinusSign);
    if (!negative) next([](QChar c) { return c == QLatin1Char('+'); });
    Amount value = primary(depth);
    if (negative) value.amount = -value.amount;
    return value;
  }

  Amount primary(int depth) {
    skipSpaces();
    Amount value{1, {}, 1};
    bool something = false;
    if (next([](QChar c) { return c == QLatin1Char('('); })) {
      if (depth >= deepestBrackets) return fail(QuantityTrouble::noNumber, text_);
      value = sum(depth + 1);
      skipSpaces();
      if (!trouble_ && !next([](QChar c) { return c == QLatin1Char(')'); })) refuseHere();
      something = true;
    } else if (at_ < text_.size() && (text_[at_].isDigit() || isDecimalSign(text_[at_]))) {
      value.amount = number();
      something = true;
    }
    skipSpaces();
    if (trouble_ || at_ >= text_.size() || !isUnitSign(text_[at_])) {
      if (!something && !trouble_) refuseHere();
      return value;
    }
    const Unit unit = unitHere();
    if (trouble_) return value;
    combine(value, {unit.size, unit.dimension, unit.size}, true);
    return value;
  }

  double number() {
    const qsizetype from = at_;
    QString digits;
    int signs = 0;
    while (at_ < text_.size() &&
           (text_[at_].isDigit() || isDecimalSign(text_[at_]) || isGroupSign(text_[at_]))) {
      if (text_[at_].isDigit())
        digits += QChar(QLatin1Char(static_cast<char>('0' + text_[at_].digitValue())));
      else if (isDecimalSign(text_[at_]) && ++signs == 1)
        digits += QLatin1Char('.');
      else
        signs = 2;
      ++at_;
    }
    readExponent(digits);
    const QString typed = text_.mid(from, at_ - from);
    skipSpaces();
    if (signs > 1 || (at_ < text_.size() && text_[at_].isDigit())) {
      fail(QuantityTrouble::groupSeparator, signs > 1 ? typed : text_.mid(from));
      return 0;
    }
    bool ok = false;
    const double value = digits.toDouble(&ok);
    if (!ok) fail(std::isinf(value) ? QuantityTrouble::notFinite : QuantityTrouble::noNumber, typed);
    anyDigit_ = true;
    return value;
  }

  // Reads an exponent ("1e-3"), which must not be taken for the start of a unit.
  void readExponent(QString& digits) {
    if (at_ >= text_.size() || text_[at_].toLower() != QLatin1Char('e')) return;
    qsizetype end = at_ + 1;
    QString power = QStringLiteral("e");
    if (end < text_.size() && (isMinusSign(text_[end]) || text_[end] == QLatin1Char('+')))
      power += isMinusSign(text_[end++]) ? QLatin1Char('-') : QLatin1Char('+');
    const qsizetype firstDigit = end;
    while (end < text_.size() && text_[end].isDigit())
      power += QChar(QLatin1Char(static_cast<char>('0' + text_[end++].digitValue())));
    if (end == firstDigit) return;
    digits += power;
    at_ = end;
  }

  // "gram force" and "in." are units too, so the longest known word counts.
  Unit unitHere() {
    const qsizetype from = at_;
    qsizetype end = from;
    while (end < text_.size() && (isUnitSign(text_[end]) || text_[end] == QLatin1Char('.') ||
                                  text_[end] == QLatin1Char(' ') || text_[end] == QLatin1Char('-')))
      ++end;
    for (qsizetype to = end; to > from; --to) {
      const QString word = text_.mid(from, to - from);
      if (word.back().isSpace() || (to < text_.size() && isUnitSign(text_[to]) && word.back().isLetter()))
        continue;
      if (const auto unit = unitFrom(word)) {
        at_ = to;
        return *unit;
      }
    }
    fail(QuantityTrouble::unknownUnit, text_.mid(from, end - from).trimmed());
    return {};
  }

  // Terms of a sum must have one dimension. A bare number beside a number with a unit is only clear if that
  // unit is the shown one.
  void bringTogether(Amount& left, Amount& right) {
    if (left.dimension == right.dimension) {
      if (left.unit != right.unit) left.unit = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    Amount* bare = left.dimension.none() ? &left : right.dimension.none() ? &right : nullptr;
    if (!bare) return void(fail(QuantityTrouble::otherQuantity, text_));
    if (!inShownUnit(bare == &left ? right : left)) return void(fail(QuantityTrouble::mixedUnits, text_));
    *bare = {bare->amount * shownSize_, shown_, shownSize_};
  }

  // "3/4 mm" is three quarters of a millimetre: the unit belongs to the fraction.
  static Amount fractionOf(const Amount& left, const Amount& right) {
    return {left.amount / (right.amount / right.unit) * right.unit, right.dimension, right.unit};
  }

  bool inShownUnit(const Amount& value) const {
    return value.dimension == shown_ && std::abs(value.unit - shownSize_) <= sameUnit * shownSize_;
  }

  static void combine(Amount& left, const Amount& right, bool times) {
    const int sign = times ? 1 : -1;
    left.dimension.force += sign * right.dimension.force;
    left.dimension.length += sign * right.dimension.length;
    left.dimension.time += sign * right.dimension.time;
    left.unit = times ? left.unit * right.unit : left.unit / right.unit;
    left.amount = times ? left.amount * right.amount : left.amount / right.amount;
  }

  template <class Is>
  bool next(Is is) {
    if (trouble_ || at_ >= text_.size() || !is(text_[at_])) return false;
    ++at_;
    return true;
  }
  void skipSpaces() {
    while (at_ < text_.size() && text_[at_].isSpace()) ++at_;
  }
  void refuseHere() {
    const QString rest = text_.mid(at_).trimmed();
    const bool separator = !rest.isEmpty() && isGroupSign(rest[0]);
    fail(separator ? QuantityTrouble::groupSeparator : QuantityTrouble::noNumber,
         rest.isEmpty() ? text_ : rest);
  }
  Amount fail(QuantityTrouble trouble, const QString& culprit) {
    if (!trouble_) {
      trouble_ = trouble;
      culprit_ = culprit;
    }
    return {};
  }

  const QString& text_;
  const Dimension shown_;
  const double shownSize_;
  qsizetype at_ = 0;
  bool anyDigit_ = false;
  std::optional<QuantityTrouble> trouble_;
  QString culprit_;
};

}  // namespace

Evaluation evaluate(const QString& text, Dimension shown, double shownSize) {
  return Reader(text, shown, shownSize).read();
}

}  // namespace detent::editor
