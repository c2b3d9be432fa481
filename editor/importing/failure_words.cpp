// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/failure_words.h"

#include <array>
#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <utility>

namespace detent::editor {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("detent::editor::ImportDialog", text); }

struct Option {
  const char* name;
  Remedy remedy;
};

constexpr std::array<Option, 10> options{{{"--frame", Remedy::frame},
                                          {"--x-axis", Remedy::xAxis},
                                          {"--y-axis", Remedy::yAxis},
                                          {"--x-unit", Remedy::xUnit},
                                          {"--y-unit", Remedy::yUnit},
                                          {"--press-color", Remedy::pressColor},
                                          {"--release-color", Remedy::releaseColor},
                                          {"--mask", Remedy::mask},
                                          {"--dpi", Remedy::dpi},
                                          {"--swap-strokes", Remedy::swap}}};

/// What to do on the page, as the end of a sentence.
QString instruction(Remedy remedy) {
  switch (remedy) {
    case Remedy::frame:
      return tr("draw the plot frame, or drag its corners onto the ends of the axes");
    case Remedy::xAxis:
      return tr("give the displacement axis the values at its two ends");
    case Remedy::yAxis:
      return tr("give the force axis the values at its two ends");
    case Remedy::xUnit:
      return tr("choose the unit of the displacement axis");
    case Remedy::yUnit:
      return tr("choose the unit of the force axis");
    case Remedy::pressColor:
      return tr("click the press curve with the pipette");
    case Remedy::releaseColor:
      return tr("click the release curve with the pipette");
    case Remedy::mask:
      return tr("paint a mask over what is no curve");
    case Remedy::dpi:
      return tr("set a resolution, so that a picture of the page is traced");
    case Remedy::swap:
      return tr("exchange press and release");
  }
  return {};
}

QString sentence(QString text) {
  text = text.trimmed();
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  if (!text.endsWith('.') && !text.endsWith('!') && !text.endsWith('?')) text += '.';
  return text;
}

QString joined(const std::vector<Remedy>& remedies) {
  QStringList parts;
  for (const Remedy remedy : remedies) parts << instruction(remedy);
  if (parts.size() < 3) return sentence(parts.join(tr(", or ")));
  const QString last = parts.takeLast();
  return sentence(parts.join(tr(", ")) + tr(", or ") + last);
}

/// Sentences that are right here but speak of passing files to a program.
QString forTheDialog(QString text) {
  static const std::array<std::pair<const char*, const char*>, 6> words{
      {{", or raise the limit", ""},
       {" or raise the limit", ""},
       {"and pass the new file", "and open the new file"},
       {"and pass that", "and open that"},
       {"and pass the copy", "and open the copy"},
       {"or pass a picture", "or open a picture"}}};
  for (const auto& [from, to] : words) text.replace(QLatin1String(from), QLatin1String(to));
  if (text.startsWith(QLatin1String("Pass "))) text.replace(0, 4, QStringLiteral("Open"));
  return text;
}

QString placeOf(const Failure& failure, const QString& documentName) {
  QStringList parts;
  const QString subject = QString::fromStdString(failure.subject),
                place = QString::fromStdString(failure.place);
  if (!subject.isEmpty() && subject != documentName && subject != QLatin1String("tracing")) parts << subject;
  if (!place.isEmpty() && !place.startsWith(QLatin1String("--"))) parts << place;
  return parts.join(QStringLiteral(", "));
}

}  // namespace

Advice adviceFor(const Failure& failure, const QString& documentName) {
  Advice advice;
  const QString remedy = QString::fromStdString(failure.remedy), place = placeOf(failure, documentName);
  const QString problem = QString::fromStdString(failure.problem);
  advice.problem = sentence(place.isEmpty() ? problem : place + QStringLiteral(": ") + problem);
  for (const Option& option : options) {
    if (remedy.contains(QLatin1String(option.name))) advice.remedies.push_back(option.remedy);
  }
  if (advice.remedies.empty() && failure.code == FailureCode::noForceGraph)
    advice.remedies.push_back(Remedy::frame);
  if (!advice.remedies.empty()) {
    advice.remedy = joined(advice.remedies);
  } else if (!remedy.contains(QLatin1String("--"))) {
    advice.remedy = sentence(forTheDialog(remedy));
  }
  return advice;
}

Advice adviceWith(const Failure& failure, const QString& documentName, const std::vector<Remedy>& remedies) {
  Advice advice = adviceFor(failure, documentName);
  advice.remedies = remedies;
  advice.remedy = joined(remedies);
  return advice;
}

QString warningInWords(const std::string& warning) {
  static const QRegularExpression call(QStringLiteral("[;,.]? ?(?:or )?pass (--[a-z-]+)[^;]*"));
  QString text = QString::fromStdString(warning);
  QStringList advised;
  for (auto each = call.globalMatch(text); each.hasNext();) {
    const QString name = each.next().captured(1);
    for (const Option& option : options) {
      if (name == QLatin1String(option.name)) advised << instruction(option.remedy);
    }
  }
  text.remove(call);
  text = sentence(text);
  if (!advised.isEmpty()) text += ' ' + sentence(tr("If that is wrong, ") + advised.join(tr(", or ")));
  return text;
}

QString nameOf(Remedy remedy) {
  switch (remedy) {
    case Remedy::frame:
      return tr("Draw plot frame");
    case Remedy::xAxis:
    case Remedy::yAxis:
      return tr("Set axis values");
    case Remedy::xUnit:
      return tr("Displacement unit");
    case Remedy::yUnit:
      return tr("Force unit");
    case Remedy::pressColor:
      return tr("Pick press curve");
    case Remedy::releaseColor:
      return tr("Pick release curve");
    case Remedy::mask:
      return tr("Paint mask");
    case Remedy::dpi:
      return tr("Resolution");
    case Remedy::swap:
      return tr("Exchange strokes");
  }
  return {};
}

}  // namespace detent::editor
