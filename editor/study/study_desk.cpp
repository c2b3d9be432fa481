// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/study_desk.h"

#include <chrono>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "editor/study/study_window.h"
#include "model/file/text_file.h"

namespace detent::editor {

namespace {

enum Column { idColumn, answeredColumn, kindColumn, notesColumn, columnCount };

double wallClock_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

StudyDesk::StudyDesk(QWidget* parent) : QDialog(parent) {
  setObjectName("studyDesk");
  setWindowTitle(tr("Study: experimenter"));
  resize(720, 480);
  title_ = new QLabel(tr("Open the folder of a study; detent-play study new makes one."));
  title_->setObjectName("studyTitle");
  title_->setWordWrap(true);
  auto* choose = new QPushButton(tr("&Open a study…"));
  choose->setObjectName("studyOpen");
  choose->setToolTip(tr("Choose the folder of a study"));
  people_ = new QTableWidget(0, columnCount);
  people_->setObjectName("studyPeople");
  people_->setAccessibleName(tr("Participants"));
  people_->setHorizontalHeaderLabels({tr("Participant"), tr("Answered"), tr("Kind"), tr("To be known")});
  people_->horizontalHeader()->setSectionResizeMode(notesColumn, QHeaderView::Stretch);
  people_->verticalHeader()->hide();
  people_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  people_->setSelectionBehavior(QAbstractItemView::SelectRows);
  participant_ = new QLineEdit;
  participant_->setObjectName("studyParticipant");
  participant_->setPlaceholderText(tr("P01: letters and digits, no name of a person"));
  listening_ = new QComboBox;
  listening_->setObjectName("studyListening");
  listening_->addItems({tr("Quiet"), tr("Masked by noise you play")});
  rehearse_ = new QCheckBox(tr("&Rehearse without a sound device; every row says so"));
  rehearse_->setObjectName("studyRehearse");
  start_ = new QPushButton(tr("&Begin or resume"));
  start_->setObjectName("studyStart");
  start_->setToolTip(tr("Open the participant's window"));
  report_ = new QPushButton(tr("Write the re&port…"));
  report_->setObjectName("studyReport");
  report_->setToolTip(tr("Write tables and pictures of what was answered so far as one HTML page"));
  trouble_ = new QLabel;
  trouble_->setObjectName("studyTrouble");
  trouble_->setWordWrap(true);
  auto* form = new QFormLayout;
  form->addRow(tr("&Participant"), participant_);
  form->addRow(tr("&Listening"), listening_);
  form->addRow(rehearse_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(start_);
  buttons->addWidget(report_);
  buttons->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(title_);
  layout->addWidget(choose, 0, Qt::AlignLeft);
  layout->addWidget(people_, 1);
  layout->addLayout(form);
  layout->addLayout(buttons);
  layout->addWidget(trouble_);
  connect(choose, &QPushButton::clicked, this, &StudyDesk::choose);
  connect(start_, &QPushButton::clicked, this, &StudyDesk::start);
  connect(report_, &QPushButton::clicked, this, &StudyDesk::writeReport);
  connect(people_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (row >= 0) participant_->setText(people_->item(row, idColumn)->text());
  });
  refresh();
}

void StudyDesk::tell(const QString& text) { trouble_->setText(text); }

void StudyDesk::choose() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a study"), folder_);
  if (!folder.isEmpty()) open(folder);
}

void StudyDesk::open(const QString& folder) {
  folder_ = folder;
  refresh();
}

void StudyDesk::refresh() {
  start_->setEnabled(false);
  report_->setEnabled(false);
  people_->setRowCount(0);
  tell({});
  if (folder_.isEmpty()) return;
  const Result<playback::Study> study = playback::openStudy(folder_.toStdString());
  if (!study) return tell(QString::fromStdString(study.failure().sentence()));
  title_->setText(tr("%1: %2 buttons, %3 trials for each participant")
                      .arg(QString::fromStdString(study->name))
                      .arg(study->buttons.size())
                      .arg(playback::countedTrials(*study)));
  const auto records = playback::readParticipants(*study);
  if (!records) return tell(QString::fromStdString(records.failure().sentence()));
  start_->setEnabled(true);
  report_->setEnabled(!records->empty());
  for (const playback::ParticipantRecord& record : *records) {
    const int row = people_->rowCount();
    people_->insertRow(row);
    QStringList notes;
    for (const std::string& note : record.notes) notes << QString::fromStdString(note);
    people_->setItem(row, idColumn, new QTableWidgetItem(QString::fromStdString(record.participant)));
    people_->setItem(row, answeredColumn,
                     new QTableWidgetItem(tr("%1 of %2").arg(record.answers.size()).arg(record.plan.size())));
    people_->setItem(row, kindColumn,
                     new QTableWidgetItem(record.sessions.empty()
                                              ? QString()
                                              : QString(playback::nameOf(record.sessions.back().kind))));
    people_->setItem(row, notesColumn, new QTableWidgetItem(notes.join("; ")));
  }
}

Result<std::unique_ptr<playback::StudyPlayer>> StudyDesk::player(const playback::Study& study) const {
  playback::StudyPlayerSettings settings;
  settings.rehearse = rehearse_->isChecked();
  return playback::StudyPlayer::start(study, settings);
}

void StudyDesk::start() {
  Result<playback::Study> opened = playback::openStudy(folder_.toStdString());
  if (!opened) return tell(QString::fromStdString(opened.failure().sentence()));
  auto study = std::make_unique<playback::Study>(*std::move(opened));
  if (Result<Done> same = playback::checkStimuli(*study); !same)
    return tell(QString::fromStdString(same.failure().sentence()));
  Result<std::unique_ptr<playback::StudyPlayer>> made = player(*study);
  if (!made)
    return tell(tr("%1 Or rehearse without one.").arg(QString::fromStdString(made.failure().sentence())));
  playback::SessionStart begin;
  begin.kind = (*made)->sounding() ? playback::SessionKind::real : playback::SessionKind::rehearsal;
  begin.listening =
      listening_->currentIndex() == 1 ? playback::Listening::masked : playback::Listening::quiet;
  begin.device = (*made)->device();
  begin.utc_s = wallClock_s();
  Result<playback::ParticipantSession> session =
      playback::ParticipantSession::open(*study, participant_->text().toStdString(), begin);
  if (!session) return tell(QString::fromStdString(session.failure().sentence()));
  const Result<std::string> consent = readTextFile((study->folder / "consent.txt").string());
  auto kept = std::make_unique<playback::ParticipantSession>(*std::move(session));
  auto* window = new StudyWindow(std::move(study), std::move(kept), *std::move(made),
                                 consent ? QString::fromStdString(*consent) : QString());
  connect(window, &StudyWindow::finished, this, &StudyDesk::refresh, Qt::QueuedConnection);
  window->show();
}

void StudyDesk::writeReport() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Write the report"), folder_ + "/report.html",
                                                    tr("Web page (*.html)"));
  if (file.isEmpty()) return;
  const Result<playback::Study> study = playback::openStudy(folder_.toStdString());
  if (!study) return tell(QString::fromStdString(study.failure().sentence()));
  const auto records = playback::readParticipants(*study);
  if (!records) return tell(QString::fromStdString(records.failure().sentence()));
  const std::string page = playback::resultsPage(playback::resultsOf(*study, *records), {});
  const Result<Done> written = writeTextFileAtomically(file.toStdString(), page);
  tell(written ? tr("Written: %1").arg(file) : QString::fromStdString(written.failure().sentence()));
}

}  // namespace detent::editor
