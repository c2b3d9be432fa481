// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/finding_words.h"

#include <optional>
#include <QCoreApplication>
#include <QStringList>

namespace detent::editor {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("detent::editor::ImportDialog", text); }

/// Words for a correction: the end of a sentence that asks the user for it, and the text of its button.
struct CorrectionWords {
  const char* instruction;
  const char* button;
};

/// A text that is translated; lupdate searches for this name.
constexpr const char* words(const char* text) { return text; }

/// Returns nullopt for a remedy that is not a correction.
std::optional<CorrectionWords> correctionWordsOf(RemedyKind kind) {
  switch (kind) {
    case RemedyKind::giveFrame:
      return {{words("draw the plot frame, or drag its corners onto the ends of the axes"),
               words("Draw plot frame")}};
    case RemedyKind::giveXAxis:
      return {{words("enter the values at both ends of the displacement axis"), words("Set axis values")}};
    case RemedyKind::giveYAxis:
      return {{words("enter the values at both ends of the force axis"), words("Set axis values")}};
    case RemedyKind::giveXUnit:
      return {{words("choose the unit of the displacement axis"), words("Displacement unit")}};
    case RemedyKind::giveYUnit:
      return {{words("choose the unit of the force axis"), words("Force unit")}};
    case RemedyKind::pickPress:
      return {{words("click the press curve on the page"), words("Pick press curve")}};
    case RemedyKind::pickRelease:
      return {{words("click the release curve on the page"), words("Pick release curve")}};
    case RemedyKind::noRelease:
      return {{words("say that the page shows no release of this button"), words("No release curve")}};
    case RemedyKind::addMask:
      return {{words("paint a mask over what is not part of a curve"), words("Paint mask")}};
    case RemedyKind::setResolution:
      return {{words("choose a resolution; Detent then traces the page as a picture"), words("Resolution")}};
    case RemedyKind::swapStrokes:
      return {{words("swap press and release"), words("Swap press and release")}};
    case RemedyKind::drawPress:
      return {{words("draw along the whole press curve"), words("Draw press curve")}};
    case RemedyKind::drawRelease:
      return {{words("draw along the whole release curve"), words("Draw release curve")}};
    case RemedyKind::chooseSwitch:
      return {{words("choose a switch in the list"), words("Choose switch")}};
    default:
      return {};
  }
}

QString instruction(RemedyKind kind) {
  const auto text = correctionWordsOf(kind);
  return text ? tr(text->instruction) : QString();
}

/// Questions of the importer, and choices that are words.
[[maybe_unused]] constexpr const char* questionWords[] = {
    words("which switch should be read"),
    words("which recording should be read"),
    words("what is the unit of force"),
    words("what is the unit of displacement"),
    words("which curves are press and release"),
    words("which curve is the release"),
    words("what do the columns measure"),
    words("which columns hold displacement and force"),
    words("which column holds the force"),
    words("which column holds the displacement"),
    words("does the second column of forces hold the release"),
    words("this button has no release"),
    words("their mean"),
    words("it is the release"),
    words("it is another recording")};

QString joined(const std::vector<RemedyKind>& corrections) {
  QStringList parts;
  for (const RemedyKind each : corrections) parts << instruction(each);
  if (parts.size() < 3) return asSentence(parts.join(tr(", or ")));
  const QString last = parts.takeLast();
  return asSentence(parts.join(tr(", ")) + tr(", or ") + last);
}

QString placeOf(const Failure& failure, const QString& documentName, const DisplayUnits& units) {
  QStringList parts;
  const QString subject = inWords(failure.subject.name, units);
  const bool shown =
      failure.subject.kind == Subject::Kind::part || failure.subject.kind == Subject::Kind::named;
  if (shown && subject != documentName) parts << subject;
  if (!failure.place.empty()) parts << inWords(failure.place, units);
  return parts.join(QStringLiteral(", "));
}

/// Adds advice that consists of words.
void addWords(Advice& advice, const Remedies& remedies, const DisplayUnits& units) {
  for (const Remedy& remedy : remedies)
    if (remedy.kind == RemedyKind::advice && !namesAnOption(inWords(remedy.words, units)))
      advice.remedy += (advice.remedy.isEmpty() ? "" : " ") + asSentence(inWords(remedy.words, units));
}

}  // namespace

bool isCorrection(RemedyKind kind) { return correctionWordsOf(kind).has_value(); }

std::vector<RemedyKind> correctionsAmong(const Remedies& remedies) {
  std::vector<RemedyKind> corrections;
  for (const Remedy& remedy : remedies)
    if (isCorrection(remedy.kind)) corrections.push_back(remedy.kind);
  return corrections;
}

Advice adviceFor(const Failure& failure, const QString& documentName, const DisplayUnits& units) {
  Advice advice;
  const QString place = placeOf(failure, documentName, units), problem = inWords(failure.problem, units);
  advice.problem = asSentence(place.isEmpty() ? problem : place + QStringLiteral(": ") + problem);
  advice.remedies = correctionsAmong(failure.remedies);
  if (!advice.remedies.empty()) advice.remedy = joined(advice.remedies);
  addWords(advice, failure.remedies, units);
  return advice;
}

Advice adviceFor(const importer::Doubt& doubt, const std::vector<RemedyKind>& corrections,
                 const DisplayUnits& units) {
  Advice advice{asSentence(inWords(messageOf(doubt), units)), joined(corrections), corrections};
  addWords(advice, doubt.remedies, units);
  return advice;
}

QString inWords(const importer::Remark& remark, const DisplayUnits& units) {
  QString text = asSentence(inWords(messageOf(remark), units));
  if (remark.code == importer::RemarkCode::operatingPointNotPlaced ||
      remark.code == importer::RemarkCode::resetPointNotPlaced)
    text += ' ' + tr("To set the point, right-click its place on the curve.");
  QStringList advised;
  for (const RemedyKind each : correctionsAmong(remark.remedies)) advised << instruction(each);
  if (!advised.isEmpty()) text += ' ' + asSentence(tr("If that is wrong, ") + advised.join(tr(", or ")));
  return text;
}

QString inWords(const std::vector<importer::EvidenceItem>& evidence, const DisplayUnits& units) {
  QStringList parts;
  for (const Message& message : messagesOf(evidence)) parts << inWords(message, units);
  return parts.join(QStringLiteral("; "));
}

QString inWords(const importer::Question& question) {
  QStringList choices;
  for (const importer::Choice& choice : question.choices) choices << tr(choice.text.c_str());
  QString what = tr(question.what.c_str());
  what.replace(0, 1, what.left(1).toUpper());
  return tr("%1? %2").arg(what, choices.join(QStringLiteral(", ")));
}

QString textOnButton(RemedyKind correction) {
  const auto text = correctionWordsOf(correction);
  return text ? tr(text->button) : QString();
}

QString nameOfFinding(importer::ImportStep step) {
  switch (step) {
    case importer::ImportStep::axes:
      return tr("Axes");
    case importer::ImportStep::strokes:
      return tr("Press and release");
    default:
      return tr("Plot frame");
  }
}

QString nameOfWork(importer::ImportStep step) {
  switch (step) {
    case importer::ImportStep::read:
      return tr("reading");
    case importer::ImportStep::locate:
      return tr("finding the plot frame");
    case importer::ImportStep::view:
      return tr("drawing the page");
    case importer::ImportStep::axes:
      return tr("axes");
    case importer::ImportStep::texts:
      return tr("reading texts");
    case importer::ImportStep::copies:
      return tr("comparing copies of the page");
    case importer::ImportStep::trace:
      return tr("tracing");
    case importer::ImportStep::strokes:
      return tr("strokes");
    case importer::ImportStep::refine:
      return tr("refined axes");
    case importer::ImportStep::fit:
      return tr("fit");
    case importer::ImportStep::callouts:
      return tr("reading callouts");
  }
  return {};
}

QString inProgress(importer::ImportStep step) {
  switch (step) {
    case importer::ImportStep::read:
      return tr("Reading the log …");
    case importer::ImportStep::locate:
    case importer::ImportStep::view:
    case importer::ImportStep::axes:
    case importer::ImportStep::texts:
    case importer::ImportStep::copies:
      return tr("Finding the graph and reading its axes …");
    case importer::ImportStep::trace:
      return tr("Tracing the curves …");
    case importer::ImportStep::strokes:
      return tr("Identifying press and release …");
    case importer::ImportStep::refine:
      return tr("Refining the axes …");
    case importer::ImportStep::fit:
    case importer::ImportStep::callouts:
      return tr("Fitting …");
  }
  return {};
}

QString causeOf(const importer::ImportReport& report, const DisplayUnits& units) {
  constexpr double same = 0.005;
  if (report.confidence >= sureEnough) return {};
  const importer::StepFinding* weakest = nullptr;
  if (report.evidence)
    for (const importer::StepFinding& step : report.evidence->steps)
      if (!weakest || step.confidence < weakest->confidence) weakest = &step;
  if (weakest && weakest->confidence <= report.confidence + same) {
    const QString evidence = inWords(weakest->evidence, units);
    const QString name = nameOfFinding(weakest->step);
    return evidence.isEmpty() ? name : QStringLiteral("%1: %2").arg(name, evidence);
  }
  QStringList doubts;
  if (report.doubt) doubts << inWords(messageOf(*report.doubt), units);
  for (const importer::Remark& remark : report.remarks)
    if (remark.code == importer::RemarkCode::doubted) doubts << inWords(messageOf(remark), units);
  return doubts.join(QStringLiteral("; "));
}

}  // namespace detent::editor
