// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/message_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "editor/document/number_text.h"

namespace detent::editor {
namespace {

constexpr int digits = 6;  // as a quantity field shows

QString inWords(const MessageValue& value, const DisplayUnits& units) {
  switch (value.measure) {
    case Measure::text:
      return QString::fromStdString(value.text);
    case Measure::number:
      return numberText(value.number, digits);
    case Measure::share:
      return fixedText(100 * value.number, 0) + QStringLiteral(" %");
    case Measure::displacement_mm:
      return numberText(units.lengthFrom(value.number), digits) + ' ' + units.lengthSymbol();
    case Measure::force_N:
      return numberText(units.forceFrom(value.number), digits) + ' ' + units.forceSymbol();
    case Measure::messages:
      break;
  }
  QStringList parts;
  for (const Message& message : value.messages) parts << inWords(message, units);
  return parts.join(QStringLiteral("; "));
}

}  // namespace

QString inWords(const Message& message, const DisplayUnits& units) {
  std::vector<std::string> values;
  for (const MessageValue& value : message.values()) values.push_back(inWords(value, units).toStdString());
  const QString pattern = QCoreApplication::translate("detent", message.words());
  return QString::fromStdString(filled(pattern.toStdString(), values));
}

QString asSentence(QString text) {
  text = text.trimmed();
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  if (!text.endsWith('.') && !text.endsWith('!') && !text.endsWith('?')) text += '.';
  return text;
}

QString shortened(const QString& text, int longest) {
  return text.size() <= longest ? text : text.left(longest - 1) + QChar(0x2026);
}

QString sentenceOf(const Failure& failure, const DisplayUnits& units) {
  QStringList where;
  if (!failure.subject.empty()) where << inWords(failure.subject.name, units);
  if (!failure.place.empty()) where << inWords(failure.place, units);
  QString text = where.join(QStringLiteral(", "));
  if (!text.isEmpty()) text += QStringLiteral(": ");
  text += inWords(failure.problem, units) + '.';
  for (const Remedy& remedy : failure.remedies)
    if (remedy.kind == RemedyKind::advice) text += ' ' + asSentence(inWords(remedy.words, units));
  return text;
}

}  // namespace detent::editor
