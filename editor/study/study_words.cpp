// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/study_words.h"

#include <algorithm>
#include <iterator>
#include <QCoreApplication>

#include "editor/document/message_words.h"

namespace detent::editor {

namespace {

/// The field that corresponds to an option of the program: its label, and the class that contains that text.
struct Field {
  const char* option;
  const char* context;
  const char* label;
};

constexpr Field fields[] = {
    {"study", "detent::editor::ExperimenterDialog",
     QT_TRANSLATE_NOOP("detent::editor::ExperimenterDialog", "Study")},
    {"--participant", "detent::editor::ExperimenterDialog",
     QT_TRANSLATE_NOOP("detent::editor::ExperimenterDialog", "Next &participant:")},
    {"--condition", "detent::editor::ExperimenterDialog",
     QT_TRANSLATE_NOOP("detent::editor::ExperimenterDialog", "&Listening condition:")},
    {"--simulate", "detent::editor::ExperimenterDialog",
     QT_TRANSLATE_NOOP("detent::editor::ExperimenterDialog", "&Answers by:")},
    {"--quantity", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "Quantity that is va&ried:")},
    {"--intervals", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "Inter&vals in s:")},
    {"--windows", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "Time &windows in s:")},
    {"--run-seconds", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "Seconds per r&un:")},
    {"--trials", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "&Questions per condition:")},
    {"--practice", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "&Practice:")},
    {"--modes", "detent::editor::StudyMaker", QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "Feedback:")},
    {"--sound", "detent::editor::StudyMaker", QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "Soun&d:")},
    {"--sound-level", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "Sound &level in dB:")},
    {"--sound-delay", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "Sound dela&y in ms:")},
    {"--consent", "detent::editor::StudyMaker",
     QT_TRANSLATE_NOOP("detent::editor::StudyMaker", "C&onsent texts:")},
};

/// Name of the field for an option; the option itself if there is no field.
QString fieldOf(const QString& option) {
  const auto* const field =
      std::ranges::find_if(fields, [&](const Field& each) { return option == QLatin1String(each.option); });
  return field == std::ranges::end(fields) ? option
                                           : QCoreApplication::translate(field->context, field->label);
}

}  // namespace

QString studySentence(Failure failure) {
  if (failure.subject.kind == Subject::Kind::option || failure.subject.kind == Subject::Kind::part) {
    const QString option = inWords(failure.subject.name);
    QString field = fieldOf(option);
    field.remove('&');
    if (field.endsWith(':')) field.chop(1);
    failure.subject = Subject(field.toStdString());
    if (option == "--simulate") failure.remedies = {};  // its remedies are written for the command line
  }
  return sentenceOf(failure);
}

}  // namespace detent::editor
