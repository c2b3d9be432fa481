// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The experimenter's view of a study: its folder, everyone's progress, and the next participant. Participants
// see study_window.h.

#include <functional>
#include <memory>
#include <optional>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTableWidget>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/study/study_window.h"
#include "playback/study.h"

namespace detent::editor {

/// Access of the experimenter's view to devices and files; tests replace it.
struct StudyContext {
  /// The open buttons, for making a new study.
  std::function<std::vector<ButtonDocument*>()> documents = [] { return std::vector<ButtonDocument*>{}; };
  /// Device profile of the feel panel; empty: none.
  std::function<QString()> profileFile = [] { return QString(); };
  /// Sound device, rate and buffer, as chosen for the feel panel.
  std::function<playback::PlayerSettings()> sound = [] { return playback::PlayerSettings{}; };
  /// Force device, as chosen for the feel panel; empty: none.
  std::function<Result<std::optional<playback::ForceDeviceChoice>>()> force = [] {
    return Result<std::optional<playback::ForceDeviceChoice>>(std::nullopt);
  };
  std::function<Result<std::unique_ptr<playback::StudyPlayer>>(const playback::Study&,
                                                               const playback::StudyPlayerSettings&)>
      open = playback::StudyPlayer::start;
};

/// Hides the windows of the program that a participant must not see. GUI thread.
class HiddenWindows {
 public:
  /// Hides all open windows except these two.
  void hideAllBut(const QWidget* shown, const QWidget* alsoShown);
  void bringBack();

 private:
  std::vector<QPointer<QWidget>> hidden_;
};

/// The experimenter's view. Not modal. GUI thread.
class ExperimenterDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ExperimenterDialog(StudyContext context = {}, QWidget* parent = nullptr);
  /// Shows that study; a folder without a study is reported in the window.
  void showStudy(const QString& folder);

 private:
  /// Source of the answers of the next session.
  enum class Answers { person, rehearsal, guess, perfect };

  QLayout* folderRow();
  QWidget* peopleTable();
  QLayout* nextForm();
  QLayout* actionRow();
  void makeNew();
  void choose();
  void refresh();
  void listPeople(const std::vector<playback::ParticipantRecord>& records);
  void start();
  Result<Done> startPerson(playback::Study study);
  static Result<Done> askOrOpen(const playback::ParticipantRecord& record, StudyWork& work);
  void showStation(StudyWork work);
  void showProgress(const StudyProgress& progress);
  QScreen* participantScreen() const;
  Result<Done> tellDone(const std::string& participant);
  Result<Done> simulate(const playback::Study& study);
  void writeReport();
  Result<Done> writeReportTo(const QString& file);
  void tell(const QString& text);
  playback::Listening listening() const {
    return static_cast<playback::Listening>(listening_->currentData().toInt());
  }
  bool masked() const { return listening() == playback::Listening::masked; }
  Answers answers() const { return static_cast<Answers>(answers_->currentData().toInt()); }

  StudyContext context_;
  QString folder_;
  QPointer<StudyWindow> window_;
  QLabel *title_ = nullptr, *trouble_ = nullptr;
  QTableWidget* people_ = nullptr;
  QLineEdit *participant_ = nullptr, *headphones_ = nullptr;
  QComboBox *answers_ = nullptr, *listening_ = nullptr, *sensor_ = nullptr, *language_ = nullptr,
            *screen_ = nullptr;
  QCheckBox* force_ = nullptr;
  QLabel* progress_ = nullptr;
  QString atWork_;  ///< id of the participant in window_
  HiddenWindows hidden_;
  QPushButton *start_ = nullptr, *report_ = nullptr;
};

}  // namespace detent::editor
