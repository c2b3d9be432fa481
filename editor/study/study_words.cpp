// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/study_words.h"

#include <QCoreApplication>

#include "editor/document/message_words.h"

namespace detent::editor {

namespace {

QString fieldOf(const QString& option) {
  if (option == "study") return QCoreApplication::translate("detent::editor::StudyDesk", "Study");
  if (option == "--quantity") return QCoreApplication::translate("detent::editor::StudyMaker", "Mo&re of:");
  if (option == "--intervals")
    return QCoreApplication::translate("detent::editor::StudyMaker", "Inter&vals, s:");
  if (option == "--windows") return QCoreApplication::translate("detent::editor::StudyMaker", "&Windows, s:");
  if (option == "--run-seconds")
    return QCoreApplication::translate("detent::editor::StudyMaker", "Seconds a r&un:");
  if (option == "--trials")
    return QCoreApplication::translate("detent::editor::StudyMaker", "&Questions each:");
  if (option == "--practice") return QCoreApplication::translate("detent::editor::StudyMaker", "&Practice:");
  if (option == "--modes") return QCoreApplication::translate("detent::editor::StudyMaker", "Feedback:");
  if (option == "--consent")
    return QCoreApplication::translate("detent::editor::StudyMaker", "C&onsent texts:");
  if (option == "--participant")
    return QCoreApplication::translate("detent::editor::StudyDesk", "Next &participant:");
  if (option == "--condition") return QCoreApplication::translate("detent::editor::StudyDesk", "&Listening:");
  if (option == "--simulate") return QCoreApplication::translate("detent::editor::StudyDesk", "&Answers by:");
  return option;
}

}  // namespace

QString studySentence(Failure failure) {
  if (failure.subject.kind == Subject::Kind::option || failure.subject.kind == Subject::Kind::part) {
    const QString option = inWords(failure.subject.name);
    QString field = fieldOf(option);
    field.remove('&');
    if (field.endsWith(':')) field.chop(1);
    failure.subject = Subject(field.toStdString());
    if (option == "--simulate") failure.remedies = {};  // spelled as at the command line
  }
  return sentenceOf(failure);
}

}  // namespace detent::editor
