// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/experimenter_dialog.h"

#include <algorithm>
#include <QApplication>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QProgressDialog>
#include <QScreen>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/document/form_widgets.h"
#include "editor/feel/setup_widgets.h"
#include "editor/forecast/forecast_words.h"
#include "editor/study/study_maker.h"
#include "editor/study/study_words.h"
#include "model/file/text_file.h"

namespace detent::editor {

namespace {

constexpr double usualNoiseLevel = 0.1;  // rms, share of full scale; the same as in `detent-play study run`

enum Column { idColumn, answeredColumn, kindColumn, notesColumn, columnCount };

QString progressWords(const playback::ParticipantRecord& record) {
  const QString answered = QCoreApplication::translate("ExperimenterDialog", "%1 of %2")
                               .arg(record.answers.size())
                               .arg(record.plan.size());
  if (record.complete())
    return QCoreApplication::translate("ExperimenterDialog", "%1, complete").arg(answered);
  return record.endedEarly
             ? QCoreApplication::translate("ExperimenterDialog", "%1, ended early").arg(answered)
             : answered;
}

QString kindWords(const playback::ParticipantRecord& record) {
  if (record.sessions.empty()) return {};
  switch (record.sessions.back().kind) {
    case playback::SessionKind::real:
      return QCoreApplication::translate("ExperimenterDialog", "person");
    case playback::SessionKind::rehearsal:
      return QCoreApplication::translate("ExperimenterDialog", "REHEARSAL, without a device");
    case playback::SessionKind::simulated:
      break;
  }
  return QCoreApplication::translate("ExperimenterDialog", "SIMULATED");
}

/// The first unused id: "P01", "P02", ...
QString freeId(const std::vector<playback::ParticipantRecord>& records) {
  for (int i = 1;; ++i) {
    QString id = QStringLiteral("P%1").arg(i, 2, 10, QChar('0'));
    if (std::none_of(records.begin(), records.end(),
                     [&](const auto& r) { return r.participant == id.toStdString(); }))
      return id;
  }
}

}  // namespace

void HiddenWindows::hideAllBut(const QWidget* shown, const QWidget* alsoShown) {
  for (QWidget* window : QApplication::topLevelWidgets()) {
    if (window == shown || window == alsoShown || !window->isVisible()) continue;
    hidden_.emplace_back(window);
    window->hide();
  }
}

void HiddenWindows::bringBack() {
  for (const QPointer<QWidget>& window : hidden_)
    if (window) window->show();
  hidden_.clear();
}

ExperimenterDialog::ExperimenterDialog(StudyContext context, QWidget* parent)
    : QDialog(parent), context_(std::move(context)) {
  setObjectName("studyDesk");
  setWindowTitle(tr("Study: experimenter"));
  resize(760, 560);
  title_ = described(new QLabel, "studyTitle");
  title_->setWordWrap(true);
  progress_ = described(new QLabel, "studyProgress");
  progress_->setWordWrap(true);
  trouble_ = wrappingLabel("studyTrouble");
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(folderRow());
  layout->addWidget(title_);
  layout->addWidget(peopleTable(), 1);
  layout->addLayout(nextForm());
  layout->addWidget(progress_);
  layout->addWidget(trouble_);
  layout->addLayout(actionRow());
  refresh();
}

// ---- widgets

QLayout* ExperimenterDialog::folderRow() {
  const auto button = [this](const char* name, const QString& text, const QString& tip, auto act) {
    QPushButton* made = plainButton(name, text, tip);
    connect(made, &QPushButton::clicked, this, act);
    return made;
  };
  auto* row = new QHBoxLayout;
  row->addWidget(button("studyNew", tr("&New study…"), tr("Create a study with the open buttons"),
                        &ExperimenterDialog::makeNew));
  row->addWidget(button("studyOpen", tr("&Open a study…"), tr("Choose the folder of a study"),
                        &ExperimenterDialog::choose));
  row->addStretch();
  return row;
}

QWidget* ExperimenterDialog::peopleTable() {
  people_ = described(new QTableWidget(0, columnCount), "studyPeople", {}, tr("Participants"));
  people_->setHorizontalHeaderLabels({tr("Participant"), tr("Answered"), tr("Answers by"), tr("Remarks")});
  people_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  people_->horizontalHeader()->setSectionResizeMode(notesColumn, QHeaderView::Stretch);
  people_->verticalHeader()->hide();
  people_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  people_->setSelectionBehavior(QAbstractItemView::SelectRows);
  connect(people_, &QTableWidget::cellClicked, this,
          [this](int row) { participant_->setText(people_->item(row, idColumn)->text()); });
  return people_;
}

QLayout* ExperimenterDialog::nextForm() {
  participant_ = described(new QLineEdit, "studyParticipant",
                           tr("Use letters, digits, - and _, not a person's name. Participants in the list "
                              "continue with the question that they had reached"));
  answers_ = comboBox(
      "studyAnswers",
      tr("Rehearsals and simulated answers are marked in every row and on every page of the report"));
  addChoice(answers_, tr("a person, with the sound device"), static_cast<int>(Answers::person));
  addChoice(answers_, tr("nobody: a rehearsal without a sound device"), static_cast<int>(Answers::rehearsal));
  addChoice(answers_, tr("the program, guessing"), static_cast<int>(Answers::guess));
  addChoice(answers_, tr("the program, always correct"), static_cast<int>(Answers::perfect));
  listening_ = comboBox("studyListening", tr("What the participant hears; recorded with every answer"));
  addChoice(listening_, tr("quiet"), static_cast<int>(playback::Listening::quiet));
  addChoice(listening_, tr("masked by rain noise"), static_cast<int>(playback::Listening::masked));
  headphones_ = described(new QLineEdit, "studyHeadphones",
                          tr("Sound device of the headphones that play rain noise; turn up the volume until "
                             "the vibration is inaudible"));
  headphones_->setPlaceholderText(
      tr("if empty: the sound device of the vibration, on the channels after those of the vibration"));
  sensor_ = comboBoxOfNames(
      "studySensor", tr("Serial port of a force sensor under the finger, calibrated by the study's device "
                        "profile. If empty, participants press with keys or large on-screen buttons"));
  sensor_->setEditable(true);
  sensor_->addItem(QString());
  sensor_->addItems(serialPorts());
  force_ = described(
      new QCheckBox(tr("force device of the Feel panel")), "studyForce",
      tr("Participants press and feel the buttons on this device. Choose it in the Feel panel under Setup"));
  language_ = comboBox("studyLanguage", tr("Language of all texts that the participant reads"));
  for (const QString& code : ParticipantLanguage::carried())
    addChoice(language_, code == "en" ? QStringLiteral("English") : QLocale(code).nativeLanguageName(), code);
  select(language_, QLocale().name().section('_', 0, 0));
  screen_ = comboBoxOfNames(
      "studyScreen",
      tr("The participant's window fills this screen; choose another one to keep this window visible"));
  const QList<QScreen*> screens = QGuiApplication::screens();
  for (int i = 0; i < screens.size(); ++i)
    addChoice(screen_, QStringLiteral("%1: %2").arg(i + 1).arg(screens[i]->name()), i);
  screen_->setCurrentIndex(screen_->count() - 1);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Next &participant:"), participant_);
  form->addRow(tr("Participant's lan&guage:"), language_);
  form->addRow(tr("Participant's s&creen:"), screen_);
  form->setRowVisible(screen_, screens.size() > 1);
  form->addRow(tr("&Answers by:"), answers_);
  form->addRow(tr("&Listening condition:"), listening_);
  form->addRow(tr("&Headphones:"), headphones_);
  form->addRow(tr("Force &sensor:"), sensor_);
  form->addRow(QString(), force_);
  const auto showHeadphones = [this, form] { form->setRowVisible(headphones_, masked()); };
  connect(listening_, &QComboBox::currentIndexChanged, this, showHeadphones);
  showHeadphones();
  return form;
}

QLayout* ExperimenterDialog::actionRow() {
  start_ = described(new QPushButton(tr("&Begin or continue")), "studyStart",
                     tr("Open the participant's window, or let the program answer"));
  report_ = described(new QPushButton(tr("Write the &report…")), "studyReport",
                      tr("Write tables and pictures of the answers so far as one HTML page"));
  report_->setAutoDefault(false);
  connect(start_, &QPushButton::clicked, this, &ExperimenterDialog::start);
  connect(report_, &QPushButton::clicked, this, &ExperimenterDialog::writeReport);
  auto* row = new QHBoxLayout;
  row->addWidget(start_);
  row->addWidget(report_);
  row->addStretch();
  return row;
}

void ExperimenterDialog::tell(const QString& text) { trouble_->setText(text); }

// ---- the folder

void ExperimenterDialog::makeNew() {
  auto* maker = new StudyMaker(context_.documents(), context_.profileFile(), this);
  maker->setAttribute(Qt::WA_DeleteOnClose);
  connect(maker, &StudyMaker::made, this, &ExperimenterDialog::showStudy);
  maker->open();
}

void ExperimenterDialog::choose() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a study"), folder_);
  if (!folder.isEmpty()) showStudy(folder);
}

void ExperimenterDialog::showStudy(const QString& folder) {
  folder_ = folder;
  tell({});
  refresh();
}

void ExperimenterDialog::refresh() {
  start_->setEnabled(false);
  report_->setEnabled(false);
  people_->setRowCount(0);
  title_->setText(tr("Create a new study with the open buttons, or open the folder of an existing one."));
  if (folder_.isEmpty()) return;
  const Result<playback::Study> study = playback::openStudy(folder_.toStdString());
  if (!study) return tell(studySentence(study.failure()));
  QStringList labels;
  for (std::size_t i = 0; i < study->givenButtons(); ++i)
    labels << QString::fromStdString(study->buttons[i].label);
  title_->setText(
      tr("<b>%1</b>: %2. Questions for each participant: %3")
          .arg(QString::fromStdString(study->name).toHtmlEscaped(), labels.join(", ").toHtmlEscaped())
          .arg(playback::countedTrials(*study)));
  const auto records = playback::readParticipants(*study);
  if (!records) return tell(studySentence(records.failure()));
  start_->setEnabled(true);
  report_->setEnabled(!records->empty());
  listPeople(*records);
  participant_->setText(freeId(*records));
}

void ExperimenterDialog::listPeople(const std::vector<playback::ParticipantRecord>& records) {
  for (const playback::ParticipantRecord& record : records) {
    QStringList notes;
    for (const std::string& note : record.notes) notes << QString::fromStdString(note);
    const QString texts[] = {QString::fromStdString(record.participant), progressWords(record),
                             kindWords(record), notes.join("; ")};
    const int row = people_->rowCount();
    people_->insertRow(row);
    for (int column = 0; column < columnCount; ++column)
      people_->setItem(row, column, new QTableWidgetItem(texts[column]));
  }
}

// ---- a participant

void ExperimenterDialog::start() {
  tell({});
  if (window_) {
    return tell(
        tr("A participant is answering. Finish or pause the session in the participant's window first."));
  }
  Result<playback::Study> study = playback::openStudy(folder_.toStdString());
  if (!study) return tell(studySentence(study.failure()));
  if (const Result<Done> same = playback::checkStimuli(*study); !same)
    return tell(studySentence(same.failure()));
  const bool person = answers() == Answers::person || answers() == Answers::rehearsal;
  const Result<Done> started = person ? startPerson(*std::move(study)) : simulate(*study);
  if (!person) refresh();
  if (!started) tell(studySentence(started.failure()));
}

Result<Done> ExperimenterDialog::startPerson(playback::Study opened) {
  StudyWork work;
  work.study = std::make_unique<playback::Study>(std::move(opened));
  work.participant = participant_->text().trimmed().toStdString();
  work.language = language_->currentData().toString();
  if (Result<Done> ok = playback::checkParticipantId(work.participant); !ok) return ok;
  playback::StudyPlayerSettings settings;
  settings.player = context_.sound();
  if (masked()) settings.player.masking = {usualNoiseLevel, headphones_->text().trimmed().toStdString()};
  settings.rehearse = answers() == Answers::rehearsal;
  settings.sensorPort = sensor_->currentText().trimmed().toStdString();
  if (work.study->profile) settings.calibration = work.study->profile->sensor;
  if (force_->isChecked()) {
    Result<std::optional<playback::ForceDeviceChoice>> force = context_.force();
    if (!force) return force.failure();
    if (!*force)
      return Failure{FailureCode::wrongUsage, "force device", "", Message("none is chosen"),
                     Message("Choose a force device in the Feel panel under Setup")};
    settings.force = *std::move(force);
  }
  work.sensor = !settings.sensorPort.empty() || settings.force;
  work.force = settings.force.has_value();
  Result<std::unique_ptr<playback::StudyPlayer>> player = context_.open(*work.study, settings);
  if (!player) {
    // A rehearsal can run without sound, but not without the force device.
    if (player.failure().code != FailureCode::deviceTrouble || settings.force) return player.failure();
    tell(tr("%1 Or choose a rehearsal.").arg(studySentence(player.failure())));
    return Done{};
  }
  work.player = *std::move(player);
  work.start.kind = work.player->sounding() ? playback::SessionKind::real : playback::SessionKind::rehearsal;
  work.start.listening = listening();
  work.start.noiseLevel = work.player->sounding() ? settings.player.masking.level : 0;
  work.start.device = work.player->device();
  work.start.utc_s = playback::systemClock_s();
  work.start.route = work.player->route();
  if (work.start.route.timing && !work.sensor) work.start.route.timing->press = TimedTrials::pressRoute();
  const Result<playback::ParticipantRecord> record =
      playback::ParticipantSession::toOpen(*work.study, work.participant, work.start);
  if (!record) return record.failure();
  if (record->complete()) return tellDone(work.participant);
  if (Result<Done> ok = askOrOpen(*record, work); !ok) return ok;
  showStation(std::move(work));
  return Done{};
}

/// A participant who has agreed before starts at once. Any other one reads the consent first, and is entered
/// in the journal only after agreeing.
Result<Done> ExperimenterDialog::askOrOpen(const playback::ParticipantRecord& record, StudyWork& work) {
  if (!record.consent) {
    Result<playback::ConsentText> consent =
        playback::consentIn(work.study->folder, work.language.toStdString());
    if (!consent) return consent.failure();
    work.consent = *std::move(consent);
    return Done{};
  }
  Result<playback::ParticipantSession> session =
      playback::ParticipantSession::open(*work.study, work.participant, work.start);
  if (!session) return session.failure();
  work.session = std::make_unique<playback::ParticipantSession>(*std::move(session));
  return Done{};
}

QScreen* ExperimenterDialog::participantScreen() const {
  const QList<QScreen*> screens = QGuiApplication::screens();
  const int chosen = screen_->currentData().toInt();
  return chosen < screens.size() ? screens[chosen] : QGuiApplication::primaryScreen();
}

/// Covers the whole of the participant's screen, so that nothing else of the program is visible. On a second
/// screen the experimenter's view stays.
void ExperimenterDialog::showStation(StudyWork work) {
  atWork_ = QString::fromStdString(work.participant);
  window_ = new StudyWindow(std::move(work));
  QScreen* const theirScreen = participantScreen();
  connect(window_, &StudyWindow::progressed, this, &ExperimenterDialog::showProgress);
  connect(window_, &StudyWindow::finished, this, [this] {
    hidden_.bringBack();
    progress_->clear();
    raise();
    activateWindow();
  });
  connect(window_, &QObject::destroyed, this, &ExperimenterDialog::refresh, Qt::QueuedConnection);
  window_->setGeometry(theirScreen->geometry());
  window_->showFullScreen();
  hidden_.hideAllBut(window_, theirScreen == screen() ? nullptr : this);
  window_->raise();
  window_->activateWindow();  // so that the participant can use the keys at once
  window_->setFocus();
  progress_->setText(tr("%1 is answering.").arg(atWork_));
}

void ExperimenterDialog::showProgress(const StudyProgress& progress) {
  const auto words = [&] {
    switch (progress.at) {
      case StudyProgress::At::consent:
        return tr("reading the consent text");
      case StudyProgress::At::words:
        return tr("reading the instructions");
      case StudyProgress::At::question:
        return tr("answering a question");
      case StudyProgress::At::rest:
        return tr("resting");
      case StudyProgress::At::pause:
        return tr("pausing");
      case StudyProgress::At::trouble:
        return tr("waiting for you: a device was disconnected");
      case StudyProgress::At::end:
        break;
    }
    return tr("finished, waiting for you");
  };
  progress_->setText(tr("%1: %2 of %3 answered; %4")
                         .arg(atWork_)
                         .arg(progress.answered)
                         .arg(progress.questions)
                         .arg(words()));
}

Result<Done> ExperimenterDialog::tellDone(const std::string& participant) {
  tell(tr("%1 has answered everything.").arg(QString::fromStdString(participant)));
  return Done{};
}

Result<Done> ExperimenterDialog::simulate(const playback::Study& study) {
  const Result<playback::Simulation> simulation =
      playback::simulationNamed(answers() == Answers::guess ? "guess" : "perfect");
  if (!simulation) return simulation.failure();
  if (Result<Done> ok = playback::checkSimulation(study, *simulation); !ok) return ok;
  const std::string id = participant_->text().trimmed().toStdString();
  Result<playback::ParticipantSession> session = playback::ParticipantSession::open(
      study, id,
      {playback::SessionKind::simulated, listening(), "", simulation->name, playback::systemClock_s()});
  if (!session) return session.failure();
  if (session->trial() == nullptr) return tellDone(id);
  QProgressDialog progress(tr("The program answers…"), tr("Stop"), 0,
                           static_cast<int>(session->record().plan.size()), this);
  progress.setWindowModality(Qt::WindowModal);
  while (const playback::Trial* trial = session->trial()) {
    if (progress.wasCanceled()) return Done{};
    if (Result<Done> ok = session->record(playback::simulatedAnswer(study, id, *trial, *simulation)); !ok)
      return ok;
    progress.setValue(static_cast<int>(session->record().answers.size()));
  }
  return session->end("complete");
}

// ---- the report

void ExperimenterDialog::writeReport() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Write the report"), folder_ + "/report.html",
                                                    tr("Web page (*.html)"));
  if (file.isEmpty()) return;
  const Result<Done> written = writeReportTo(file);
  tell(written ? tr("Written: %1").arg(file) : studySentence(written.failure()));
}

Result<Done> ExperimenterDialog::writeReportTo(const QString& file) {
  const Result<playback::Study> study = playback::openStudy(folder_.toStdString());
  if (!study) return study.failure();
  const auto records = playback::readParticipants(*study);
  if (!records) return records.failure();
  const auto expected = playback::foretold(*study);
  if (!expected) return expected.failure();
  return writeTextFileAtomically(file.toStdString(),
                                 playback::resultsPage(playback::resultsOf(*study, *records), *expected));
}

}  // namespace detent::editor
