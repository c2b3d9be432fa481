// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Makes a new study of the open buttons.

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/quantity/quantity_field.h"
#include "playback/study.h"

namespace detent::editor {

/// Asks for task, length and folder. Uses the buttons as they are now, saved or not. GUI thread.
class StudyMaker : public QDialog {
  Q_OBJECT

 public:
  /// `profileFile`: of the device the participants press; may be empty.
  StudyMaker(const std::vector<ButtonDocument*>& documents, const QString& profileFile,
             QWidget* parent = nullptr);

  void setFolder(const QString& folder) { folder_->setText(folder); }

 signals:
  void made(const QString& folder);

 private:
  QLayout* designForm();
  QLayout* folderRow();
  QWidget* consentRow();
  QWidget* recordingRow();
  void makeTimingFields();
  void makeSoundFields();
  void kindOfSoundChosen();
  QLayout* actionRow();
  void kindChosen();
  playback::TimingTask task() const {
    return static_cast<playback::TimingTask>(task_->currentData().toInt());
  }
  enum class HeardSound { nothing, vibration, recording };
  HeardSound heard() const { return static_cast<HeardSound>(sound_->currentData().toInt()); }
  playback::StudyKind kind() const { return static_cast<playback::StudyKind>(kind_->currentData().toInt()); }
  playback::StudyDesign design() const;
  Result<std::vector<playback::ConsentText>> consents() const;
  std::vector<std::size_t> chosen() const;
  void showLength();
  void make();
  /// Writes the chosen buttons to `filesFolder` and makes a study of them.
  Result<playback::Study> makeFrom(const QString& filesFolder) const;

  std::vector<Button> buttons_;
  QString profileFile_;
  QListWidget* list_ = nullptr;
  QFormLayout* form_ = nullptr;
  QComboBox *kind_ = nullptr, *quantity_ = nullptr, *scale_ = nullptr, *task_ = nullptr, *sound_ = nullptr;
  QLineEdit *intervals_ = nullptr, *windows_ = nullptr, *consent_ = nullptr, *recording_ = nullptr;
  QWidget* recordingRow_ = nullptr;
  QuantityField *trials_ = nullptr, *practice_ = nullptr, *run_s_ = nullptr, *soundLevel_dB_ = nullptr,
                *soundDelay_ms_ = nullptr;
  QCheckBox *full_ = nullptr, *clicks_ = nullptr, *slopes_ = nullptr;
  QLineEdit* folder_ = nullptr;
  QLabel *length_ = nullptr, *trouble_ = nullptr;
  QPushButton* make_ = nullptr;
};

}  // namespace detent::editor
