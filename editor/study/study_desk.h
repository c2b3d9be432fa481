// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The experimenter's view of a study: its folder, how far everyone is, who is next. Participants see
// study_window.h.

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "playback/playback.h"

namespace detent::editor {

/// Not modal. GUI thread.
class StudyDesk : public QDialog {
  Q_OBJECT

 public:
  explicit StudyDesk(QWidget* parent = nullptr);
  /// Shows that study; a folder that holds none is told in the window.
  void open(const QString& folder);

 private:
  void choose();
  void refresh();
  void start();
  void writeReport();
  void tell(const QString& text);
  Result<std::unique_ptr<playback::StudyPlayer>> player(const playback::Study& study) const;

  QString folder_;
  QLabel *title_ = nullptr, *trouble_ = nullptr;
  QTableWidget* people_ = nullptr;
  QLineEdit* participant_ = nullptr;
  QComboBox* listening_ = nullptr;
  QCheckBox* rehearse_ = nullptr;
  QPushButton *start_ = nullptr, *report_ = nullptr;
};

}  // namespace detent::editor
