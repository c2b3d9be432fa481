// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Answers to the window's questions, given beforehand.

#include <deque>
#include <QPrinter>
#include <utility>
#include <vector>

#include "editor/window/prompts.h"
#include "model/templates.h"

namespace detent::editor::tests {

/// Each answer is used once; a question nobody expected is cancelled and counted.
class ScriptedPrompts : public Prompts {
 public:
  std::deque<SaveChoice> unsavedAnswers;
  std::deque<QStringList> openAnswers;
  std::deque<QString> saveAnswers;
  std::deque<bool> confirmAnswers;
  std::deque<QString> textAnswers;
  QString printedTo;              ///< a PDF; empty: printing is cancelled
  bool takesSuggestions = false;  ///< files are saved where the editor proposes
  std::deque<DeviceChoice> deviceAnswers;
  std::deque<std::string> magneticAnswers;
  MagneticChoice magneticTyped;                 ///< typed each time
  std::vector<MagneticChoice> magneticChoices;  ///< each dialogue's first ones
  std::deque<GraphExport> graphAnswers;
  int unexpected = 0;
  QStringList lastUnsaved;
  QString lastSuggested, lastFolder, lastFilter;
  int filterAnswer = 0;  ///< index of the filter that is chosen for a file to save

  SaveChoice unsaved(QWidget*, const QStringList& titles) override {
    lastUnsaved = titles;
    return next(unsavedAnswers, SaveChoice::cancel);
  }
  QStringList filesToOpen(QWidget*, const QString&, const QString& folder, const QStringList&) override {
    lastFolder = folder;
    return next(openAnswers, {});
  }
  QString folder(QWidget*, const QString&, const QString& now) override {
    lastFolder = now;
    return next(saveAnswers, {});
  }
  QString fileToSave(QWidget*, const QString&, const QString& suggested, const QString& filter,
                     QString* chosen) override {
    lastSuggested = suggested;
    lastFilter = filter;
    if (chosen) *chosen = filter.split(";;").value(filterAnswer);
    return takesSuggestions ? suggested : next(saveAnswers, {});
  }
  bool confirm(QWidget*, const QString&, const QString&) override { return next(confirmAnswers, false); }
  std::optional<Button> newButton(QWidget*) override { return *tactileButton(); }
  std::optional<QString> text(QWidget*, const QString&, const QString&, const QString&) override {
    return textAnswers.empty() ? std::nullopt : std::optional(next(textAnswers, {}));
  }

  std::optional<DeviceChoice> deviceExport(QWidget*, const Button&) override {
    if (deviceAnswers.empty()) return std::nullopt;
    return next(deviceAnswers, {});
  }

  std::optional<GraphExport> graphExport(QWidget*, const Button&, const DisplayUnits&) override {
    if (graphAnswers.empty()) return std::nullopt;
    return next(graphAnswers, {});
  }

  std::optional<std::string> magneticKey(QWidget*, const Button&, const DisplayUnits&,
                                         MagneticChoice& choice) override {
    magneticChoices.push_back(std::exchange(choice, magneticTyped));
    return magneticAnswers.empty() ? std::nullopt : std::optional(next(magneticAnswers, {}));
  }

  bool printer(QWidget*, QPrinter& printer) override {
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setOutputFileName(printedTo);
    return !printedTo.isEmpty();
  }

 private:
  template <class T>
  T next(std::deque<T>& answers, T otherwise) {
    if (answers.empty()) {
      ++unexpected;
      return otherwise;
    }
    T answer = answers.front();
    answers.pop_front();
    return answer;
  }
};

}  // namespace detent::editor::tests
