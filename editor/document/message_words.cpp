// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/message_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <string_view>
#include <utility>

#include "editor/document/number_text.h"

namespace detent::editor {
namespace {

constexpr int digits = 6;  // as in a quantity field

// Subjects of failures (model/result.h), marked for translation here because the rooms do not mark them.
[[maybe_unused]] constexpr const char* partNames[] = {
    QT_TRANSLATE_NOOP("detent", "actuation point"),
    QT_TRANSLATE_NOOP("detent", "release point"),
    QT_TRANSLATE_NOOP("detent", "press distance"),
    QT_TRANSLATE_NOOP("detent", "release distance"),
    QT_TRANSLATE_NOOP("detent", "top dead zone"),
    QT_TRANSLATE_NOOP("detent", "bottom dead zone"),
    QT_TRANSLATE_NOOP("detent", "stroke curve"),
    QT_TRANSLATE_NOOP("detent", "force graph"),
    QT_TRANSLATE_NOOP("detent", "stroke sketch"),
    QT_TRANSLATE_NOOP("detent", "self-locking button"),
    QT_TRANSLATE_NOOP("detent", "links"),
    QT_TRANSLATE_NOOP("detent", "specimens"),
    QT_TRANSLATE_NOOP("detent", "points"),
    QT_TRANSLATE_NOOP("detent", "share"),
    QT_TRANSLATE_NOOP("detent", "compare"),
    QT_TRANSLATE_NOOP("detent", "button"),
    QT_TRANSLATE_NOOP("detent", "buttons"),
    QT_TRANSLATE_NOOP("detent", "weights"),
    QT_TRANSLATE_NOOP("detent", "key figures"),
    QT_TRANSLATE_NOOP("detent", "plot frame"),
    QT_TRANSLATE_NOOP("detent", "plot"),
    QT_TRANSLATE_NOOP("detent", "plot frame entered by hand"),
    QT_TRANSLATE_NOOP("detent", "selection"),
    QT_TRANSLATE_NOOP("detent", "force device"),
    QT_TRANSLATE_NOOP("detent", "press trace"),
    QT_TRANSLATE_NOOP("detent", "standard press"),
    QT_TRANSLATE_NOOP("detent", "device profile"),
    QT_TRANSLATE_NOOP("detent", "default device"),
    QT_TRANSLATE_NOOP("detent", "sample rate"),
    QT_TRANSLATE_NOOP("detent", "page"),
    QT_TRANSLATE_NOOP("detent", "text of the clipboard"),
    QT_TRANSLATE_NOOP("detent", "fit options"),
    QT_TRANSLATE_NOOP("detent", "point spacing"),
    QT_TRANSLATE_NOOP("detent", "samples"),
    QT_TRANSLATE_NOOP("detent", "live playback"),
    QT_TRANSLATE_NOOP("detent", "rendered press"),
    QT_TRANSLATE_NOOP("detent", "answer"),
    QT_TRANSLATE_NOOP("detent", "playback setting"),
    QT_TRANSLATE_NOOP("detent", "travel of the button"),
    QT_TRANSLATE_NOOP("detent", "rate in Hz"),
    QT_TRANSLATE_NOOP("detent", "mass of the device in kg"),
    QT_TRANSLATE_NOOP("detent", "friction of the device in N"),
    QT_TRANSLATE_NOOP("detent", "damping of the device in N·s/mm"),
    QT_TRANSLATE_NOOP("detent", "encoder step in mm"),
    QT_TRANSLATE_NOOP("detent", "delay of the device in s"),
    QT_TRANSLATE_NOOP("detent", "motor lag of the device in s"),
    QT_TRANSLATE_NOOP("detent", "steepest slope in N/mm"),
    QT_TRANSLATE_NOOP("detent", "force limit in N"),
    QT_TRANSLATE_NOOP("detent", "limit of force change in N/s"),
    QT_TRANSLATE_NOOP("detent", "speed limit in mm/s"),
};

// Words of the command line that occur in sentences (feedbackModes, levelQuantities, listenings of playback),
// and what the window calls them.
constexpr std::pair<std::string_view, const char*> choiceWords[] = {
    {"full", QT_TRANSLATE_NOOP("detent", "everything")},
    {"click-only", QT_TRANSLATE_NOOP("detent", "clicks only")},
    {"slope-only", QT_TRANSLATE_NOOP("detent", "slopes only")},
    {"peak-force", QT_TRANSLATE_NOOP("detent", "force")},
    {"event-size", QT_TRANSLATE_NOOP("detent", "strength of the click")},
    {"travel", QT_TRANSLATE_NOOP("detent", "travel")},
    {"snap", QT_TRANSLATE_NOOP("detent", "snap")},
    {"grain-strength", QT_TRANSLATE_NOOP("detent", "roughness along the travel")},
    {"quiet", QT_TRANSLATE_NOOP("detent", "quiet")},
    {"masked", QT_TRANSLATE_NOOP("detent", "masked by rain noise")},
};

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

/// The name of an option of the command line, which a window does not have.
const QRegularExpression& optionName() {
  static const QRegularExpression option(QStringLiteral("(^|[\\s(:])--[a-z][a-z0-9-]*"));
  return option;
}

QString withFullStop(const QString& text) {
  const bool ends = text.endsWith('.') || text.endsWith('!') || text.endsWith('?');
  return ends ? text : text + '.';
}

}  // namespace

QString inWords(const Message& message, const DisplayUnits& units) {
  std::vector<std::string> values;
  for (const MessageValue& value : message.values()) values.push_back(inWords(value, units).toStdString());
  const char* words = message.words();
  for (const auto& [choice, shown] : choiceWords)
    if (choice == words) words = shown;
  const QString pattern = QCoreApplication::translate("detent", words);
  return QString::fromStdString(filled(pattern.toStdString(), values));
}

QString asSentence(QString text) {
  text = text.trimmed();
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  return withFullStop(text);
}

QString shortened(const QString& text, int longest) {
  return text.size() <= longest ? text : text.left(longest - 1) + QChar(0x2026);
}

bool namesAnOption(const QString& text) { return optionName().match(text).hasMatch(); }

QString sentenceOf(const Failure& failure, const DisplayUnits& units) {
  QStringList where;
  const QString subject = inWords(failure.subject.name, units).remove(optionName()).trimmed();
  if (!subject.isEmpty()) where << subject;
  if (!failure.place.empty()) where << inWords(failure.place, units);
  const QString problem = withFullStop(inWords(failure.problem, units));
  QString text = where.isEmpty() ? asSentence(problem) : where.join(QStringLiteral(", ")) + ": " + problem;
  for (const Remedy& remedy : failure.remedies)
    if (remedy.kind == RemedyKind::advice && !namesAnOption(inWords(remedy.words, units)))
      text += ' ' + asSentence(inWords(remedy.words, units));
  return text;
}

}  // namespace detent::editor
