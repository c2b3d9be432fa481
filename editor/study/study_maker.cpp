// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/study_maker.h"

#include <cmath>
#include <functional>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QRandomGenerator>
#include <QSet>
#include <QTemporaryDir>
#include <QVBoxLayout>
#include <utility>

#include "editor/document/described.h"
#include "editor/document/number_text.h"
#include "editor/feel/setup_widgets.h"
#include "editor/study/study_words.h"
#include "model/file/button_file.h"

namespace detent::editor {

namespace {

constexpr std::size_t usualPractice = 4;
// rough estimate per question, so that nobody plans three hours by mistake
constexpr double question_s = 12;
constexpr double timed_s = 3;  // seconds for a trial with a cue or a window
constexpr double restOfRun_s = 5;

/// A name for a button's file that no other button has.
QString labelOf(const QString& title, QSet<QString>& taken) {
  QString label = title.trimmed();
  label.replace('/', '-').replace('\\', '-');
  if (label.isEmpty() || label.startsWith('.')) label.prepend('_');
  QString unique = label;
  for (int i = 2; taken.contains(unique); ++i) unique = QStringLiteral("%1 %2").arg(label).arg(i);
  taken << unique;
  return unique;
}

QuantityField* countField(const char* name, std::size_t least, std::size_t most, std::size_t value,
                          const QString& tip) {
  auto* field = described(new QuantityField(Quantity::count, {}), name, tip);
  field->setRange({static_cast<double>(least), static_cast<double>(most)});
  field->setValue(static_cast<double>(value));
  return field;
}

QCheckBox* modeBox(const char* name, const QString& text, bool checked) {
  auto* box = described(new QCheckBox(text), name,
                        StudyMaker::tr("Kind of feedback. Every pair is presented with each kind that is "
                                       "ticked, in random order and without names"));
  box->setChecked(checked);
  return box;
}

/// Numbers of a list such as "0.6; 0.8; 1". Unreadable ones become 0, which no design accepts.
std::vector<double> numbersIn(const QString& text) {
  std::vector<double> numbers;
  for (const QString& part : text.split(';', Qt::SkipEmptyParts))
    if (!part.trimmed().isEmpty())
      numbers.push_back(readQuantity(part, Quantity::number, {}).value.value_or(0));
  return numbers;
}

QLineEdit* numbersField(const char* name, const std::vector<double>& numbers, const QString& tip) {
  QStringList texts;
  for (const double number : numbers) texts << quantityText(number, Quantity::number, {});
  auto* field = described(new QLineEdit(texts.join("; ")), name, tip);
  field->setPlaceholderText(texts.join("; "));
  return field;
}

/// A field with a button beside it that fills it from a file dialogue.
QWidget* browsedRow(QLineEdit* field, QPushButton* browse, std::function<QString()> choose) {
  browse->setAutoDefault(false);
  QObject::connect(browse, &QPushButton::clicked, field, [field, choose = std::move(choose)] {
    if (const QString chosen = choose(); !chosen.isEmpty()) field->setText(chosen);
  });
  return rowOf({field, browse});
}

}  // namespace

StudyMaker::StudyMaker(const std::vector<ButtonDocument*>& documents, const QString& profileFile,
                       QWidget* parent)
    : QDialog(parent), profileFile_(profileFile) {
  setObjectName("studyMaker");
  setWindowTitle(tr("New study"));
  resize(560, 640);
  list_ = described(new QListWidget, "makerButtons", {}, tr("Buttons of the study"));
  QSet<QString> taken;
  for (const ButtonDocument* document : documents) {
    buttons_.push_back(document->button());
    auto* item = new QListWidgetItem(labelOf(document->title(), taken), list_);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
  length_ = described(new QLabel, "makerLength");
  length_->setWordWrap(true);
  trouble_ = described(new QLabel, "makerTrouble");
  trouble_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(new QLabel(tr("Buttons, as they are shown now:")));
  layout->addWidget(list_, 1);
  layout->addLayout(designForm());
  layout->addLayout(folderRow());
  layout->addWidget(length_);
  layout->addWidget(trouble_);
  layout->addLayout(actionRow());
  connect(list_, &QListWidget::itemChanged, this, &StudyMaker::showLength);
  connect(folder_, &QLineEdit::textChanged, this, &StudyMaker::showLength);
  showLength();
}

QLayout* StudyMaker::designForm() {
  kind_ = comboBox("makerKind", tr("The participants' task"));
  addChoice(kind_, tr("Which of two buttons is X? (ABX)"), static_cast<int>(playback::StudyKind::abx));
  addChoice(kind_, tr("Are two buttons the same? (same or different)"),
            static_cast<int>(playback::StudyKind::sameDifferent));
  addChoice(kind_, tr("Which of all buttons is X? (matching)"),
            static_cast<int>(playback::StudyKind::matching));
  addChoice(kind_, tr("Which of two buttons has more of a quantity? (threshold)"),
            static_cast<int>(playback::StudyKind::threshold));
  addChoice(kind_, tr("How does a button feel? (rating)"), static_cast<int>(playback::StudyKind::rating));
  addChoice(kind_, tr("When do participants press? (timing)"), static_cast<int>(playback::StudyKind::timing));
  quantity_ = comboBox(
      "makerQuantity",
      tr("One of the two buttons has more of this quantity. The study adapts the difference to the answers"));
  for (const auto& [text, quantity] :
       {std::pair{tr("force"), playback::LevelQuantity::peakForce},
        std::pair{tr("strength of the click"), playback::LevelQuantity::eventSize},
        std::pair{tr("travel"), playback::LevelQuantity::travel},
        std::pair{tr("snap"), playback::LevelQuantity::snap},
        std::pair{tr("roughness along the travel"), playback::LevelQuantity::grainStrength}})
    addChoice(quantity_, text, static_cast<int>(quantity));
  scale_ = comboBox("makerScale", tr("How buttons are rated"));
  addChoice(scale_, tr("how much people like it, 1 to 7"),
            static_cast<int>(playback::RatingScale::preference));
  addChoice(scale_, tr("how strong it is, rated with any number"),
            static_cast<int>(playback::RatingScale::magnitude));
  addChoice(scale_, tr("which of two is better"), static_cast<int>(playback::RatingScale::pairwise));
  trials_ = countField("makerTrials", 1, playback::mostTrials, playback::StudyDesign{}.trials,
                       tr("Number of questions for each pair or button and each kind of feedback"));
  practice_ = countField("makerPractice", 0, playback::mostPractice, usualPractice,
                         tr("Practice questions, which do not count"));
  makeTimingFields();
  makeSoundFields();
  full_ = modeBox("makerFull", tr("everything"), true);
  clicks_ = modeBox("makerClicks", tr("clicks only"), false);
  slopes_ = modeBox("makerSlopes", tr("slopes only"), false);
  connect(kind_, &QComboBox::currentIndexChanged, this, &StudyMaker::kindChosen);
  connect(scale_, &QComboBox::currentIndexChanged, this, &StudyMaker::showLength);
  connect(task_, &QComboBox::currentIndexChanged, this, &StudyMaker::kindChosen);
  for (QLineEdit* field : {intervals_, windows_})
    connect(field, &QLineEdit::textChanged, this, &StudyMaker::showLength);
  for (QuantityField* field : {trials_, practice_, run_s_}) {
    connect(field, &QuantityField::valueChanged, this, &StudyMaker::showLength);
    connect(field, &QuantityField::refusalChanged, this, &StudyMaker::showLength);
  }
  for (QCheckBox* box : {full_, clicks_, slopes_})
    connect(box, &QCheckBox::toggled, this, &StudyMaker::showLength);
  form_ = new QFormLayout;
  QFormLayout* const form = form_;
  form->addRow(tr("&Task:"), kind_);
  form->addRow(tr("Quantity that is va&ried:"), quantity_);
  form->addRow(tr("&Scale:"), scale_);
  form->addRow(tr("Press:"), task_);
  form->addRow(tr("Inter&vals in s:"), intervals_);
  form->addRow(tr("Time &windows in s:"), windows_);
  form->addRow(tr("Seconds per r&un:"), run_s_);
  form->addRow(tr("&Questions per condition:"), trials_);
  form->addRow(tr("&Practice:"), practice_);
  form->addRow(tr("Feedback:"), rowOf({full_, clicks_, slopes_}));
  form->addRow(tr("Soun&d:"), sound_);
  form->addRow(tr("Recordin&g:"), recordingRow());
  form->addRow(tr("Sound &level in dB:"), soundLevel_dB_);
  form->addRow(tr("Sound dela&y in ms:"), soundDelay_ms_);
  form->addRow(tr("Device profile:"),
               new QLabel(profileFile_.isEmpty() ? tr("none (choose it in the Feel panel under Setup)")
                                                 : QFileInfo(profileFile_).fileName()));
  form->addRow(tr("C&onsent texts:"), consentRow());
  for (QWidget* field :
       std::initializer_list<QWidget*>{quantity_, scale_, task_, intervals_, windows_, run_s_, recordingRow_,
                                       soundLevel_dB_, soundDelay_ms_})
    form->setRowVisible(field, false);
  return form;
}

void StudyMaker::makeTimingFields() {
  const playback::StudyDesign usual;
  task_ = comboBox("makerTask", tr("When or how fast participants press the button"));
  addChoice(task_, tr("with the last of four beats"), static_cast<int>(playback::TimingTask::cue));
  addChoice(task_, tr("while a ball is between two bars"), static_cast<int>(playback::TimingTask::window));
  addChoice(task_, tr("as fast as can be kept up"), static_cast<int>(playback::TimingTask::tapping));
  intervals_ =
      numbersField("makerIntervals", usual.intervals_s,
                   tr("Time between beats, or from the ball's start until it reaches the bars, %1 to %2 s. "
                      "Separate several with semicolons")
                       .arg(numberText(playback::leastInterval_s), numberText(playback::mostInterval_s)));
  windows_ = numbersField(
      "makerWindows", usual.windows_s,
      tr("Time for which the ball is between the bars, %1 to %2 s. Separate several with semicolons")
          .arg(numberText(playback::leastWindow_s), numberText(playback::mostWindow_s)));
  run_s_ = described(new QuantityField(Quantity::number, {}), "makerRun",
                     tr("Seconds from the first press, %1 to %2")
                         .arg(numberText(playback::shortestRun_s), numberText(playback::longestRun_s)));
  run_s_->setRange({playback::shortestRun_s, playback::longestRun_s});
  run_s_->setValue(usual.run_s);
}

QWidget* StudyMaker::consentRow() {
  consent_ = described(new QLineEdit, "makerConsent",
                       tr("Text files that participants read first, one for each language: NAME.en.txt, "
                          "NAME.de.txt; separate several with semicolons"));
  consent_->setPlaceholderText(tr("a short text in English and German"));
  auto* browse = described(new QPushButton(tr("C&hoose…")), "makerConsentBrowse", tr("Choose consent texts"));
  return browsedRow(consent_, browse, [this] {
    return QFileDialog::getOpenFileNames(this, tr("Consent texts"), QDir::homePath(), tr("Texts (*.txt)"))
        .join("; ");
  });
}

/// The sound of a press: nothing, the vibration, or a recording; then its level and delay.
void StudyMaker::makeSoundFields() {
  sound_ = comboBox("makerSound", tr("What participants hear of each press, beside the vibration"));
  addChoice(sound_, tr("nothing"), static_cast<int>(HeardSound::nothing));
  addChoice(sound_, tr("the vibration itself"), static_cast<int>(HeardSound::vibration));
  addChoice(sound_, tr("a recording"), static_cast<int>(HeardSound::recording));
  recording_ =
      described(new QLineEdit, "makerRecording",
                tr("A sound file of at most 5 s that begins with the click; it plays once per press"));
  soundLevel_dB_ =
      described(new QuantityField(Quantity::number, {}), "makerSoundLevel",
                tr("dB added to the sound, %1 to %2")
                    .arg(numberText(playback::softestSound_dB), numberText(playback::loudestSound_dB)));
  soundLevel_dB_->setRange({playback::softestSound_dB, playback::loudestSound_dB});
  soundLevel_dB_->setValue(playback::StudySound{}.level_dB);
  soundDelay_ms_ = described(new QuantityField(Quantity::number, {}), "makerSoundDelay",
                             tr("Milliseconds from the click to its sound, 0 to %1")
                                 .arg(numberText(playback::longestSoundDelay_ms)));
  soundDelay_ms_->setRange({0, playback::longestSoundDelay_ms});
  soundDelay_ms_->setValue(playback::StudySound{}.delay_ms);
  connect(sound_, &QComboBox::currentIndexChanged, this, &StudyMaker::kindOfSoundChosen);
  connect(recording_, &QLineEdit::textChanged, this, &StudyMaker::showLength);
  for (QuantityField* field : {soundLevel_dB_, soundDelay_ms_})
    connect(field, &QuantityField::refusalChanged, this, &StudyMaker::showLength);
}

QWidget* StudyMaker::recordingRow() {
  auto* browse = described(new QPushButton(tr("Choos&e…")), "makerRecordingBrowse",
                           tr("Choose a recording of the press"));
  recordingRow_ = browsedRow(recording_, browse, [this] {
    return QFileDialog::getOpenFileName(this, tr("Recording of a press"), QDir::homePath(),
                                        tr("Sounds (*.wav *.flac *.ogg)") + ";;" + tr("All files (*)"));
  });
  return recordingRow_;
}

void StudyMaker::kindOfSoundChosen() {
  form_->setRowVisible(recordingRow_, heard() == HeardSound::recording);
  for (QuantityField* field : {soundLevel_dB_, soundDelay_ms_})
    form_->setRowVisible(field, heard() != HeardSound::nothing);
  showLength();
}

/// The usual number of trials of a kind is the initial value.
void StudyMaker::kindChosen() {
  form_->setRowVisible(quantity_, kind() == playback::StudyKind::threshold);
  form_->setRowVisible(scale_, kind() == playback::StudyKind::rating);
  const bool timed = kind() == playback::StudyKind::timing;
  const bool tapping = timed && task() == playback::TimingTask::tapping;
  form_->setRowVisible(task_, timed);
  form_->setRowVisible(intervals_, timed && !tapping);
  form_->setRowVisible(windows_, timed && task() == playback::TimingTask::window);
  form_->setRowVisible(run_s_, tapping);
  trials_->setValue(static_cast<double>(playback::usualTrials(kind(), task())));
  showLength();
}

QLayout* StudyMaker::folderRow() {
  folder_ = described(new QLineEdit, "makerFolder",
                      tr("New folder that will hold the whole study. It can be copied to another computer"));
  auto* browse =
      described(new QPushButton(tr("&Choose…")), "makerBrowse", tr("Choose where to create the folder"));
  auto* label = new QLabel(tr("&Folder:"));
  label->setBuddy(folder_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(
      browsedRow(
          folder_, browse,
          [this] { return QFileDialog::getSaveFileName(this, tr("Folder of the study"), QDir::homePath()); }),
      1);
  return row;
}

QLayout* StudyMaker::actionRow() {
  make_ = described(new QPushButton(tr("Create stud&y")), "makerMake");
  make_->setDefault(true);
  auto* cancel = described(new QPushButton(tr("Cancel")), "makerCancel");
  connect(make_, &QPushButton::clicked, this, &StudyMaker::make);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  auto* row = new QHBoxLayout;
  row->addStretch();
  row->addWidget(cancel);
  row->addWidget(make_);
  return row;
}

playback::StudyDesign StudyMaker::design() const {
  playback::StudyDesign design;
  design.kind = kind();
  design.quantity = static_cast<playback::LevelQuantity>(quantity_->currentData().toInt());
  design.scale = static_cast<playback::RatingScale>(scale_->currentData().toInt());
  design.task = task();
  design.intervals_s = numbersIn(intervals_->text());
  design.windows_s = numbersIn(windows_->text());
  design.run_s = run_s_->value();
  design.trials = static_cast<std::size_t>(trials_->value());
  design.practice = static_cast<std::size_t>(practice_->value());
  if (heard() == HeardSound::vibration) design.sound.source = playback::renderedSound;
  if (heard() == HeardSound::recording)
    design.sound.source =
        QFile::encodeName(QFileInfo(recording_->text().trimmed()).absoluteFilePath()).toStdString();
  if (heard() != HeardSound::nothing) {
    design.sound.level_dB = soundLevel_dB_->value();
    design.sound.delay_ms = soundDelay_ms_->value();
  }
  design.modes.clear();
  if (full_->isChecked()) design.modes.push_back(playback::FeedbackMode::full);
  if (clicks_->isChecked()) design.modes.push_back(playback::FeedbackMode::clickOnly);
  if (slopes_->isChecked()) design.modes.push_back(playback::FeedbackMode::slopeOnly);
  design.seed = QRandomGenerator::system()->generate64();
  return design;
}

std::vector<std::size_t> StudyMaker::chosen() const {
  std::vector<std::size_t> rows;
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->checkState() == Qt::Checked) rows.push_back(static_cast<std::size_t>(row));
  return rows;
}

void StudyMaker::showLength() {
  trouble_->clear();
  const playback::StudyDesign planned = design();
  const std::size_t buttons = chosen().size();
  const Result<Done> possible = playback::checkDesign(planned, buttons);
  bool readable = heard() != HeardSound::recording || !recording_->text().trimmed().isEmpty();
  for (const QuantityField* field : {trials_, practice_, run_s_}) readable = readable && field->acceptable();
  if (heard() != HeardSound::nothing)
    readable = readable && soundLevel_dB_->acceptable() && soundDelay_ms_->acceptable();
  make_->setEnabled(possible.ok() && readable && !folder_->text().trimmed().isEmpty());
  if (!possible) return length_->setText(studySentence(possible.failure()));
  const std::size_t cells = playback::asksForPairs(planned) ? playback::pairsOf(buttons).size() : buttons;
  const std::size_t questions = cells * planned.trials * planned.modes.size() + planned.practice;
  double each_s = question_s;
  if (planned.kind == playback::StudyKind::timing)
    each_s = planned.task == playback::TimingTask::tapping ? planned.run_s + restOfRun_s : timed_s;
  length_->setText(tr("Questions for each participant: %1, about %2 minutes.")
                       .arg(questions)
                       .arg(std::ceil(static_cast<double>(questions) * each_s / 60)));
}

Result<std::vector<playback::ConsentText>> StudyMaker::consents() const {
  std::vector<playback::ConsentText> texts;
  for (const QString& file : consent_->text().split(';', Qt::SkipEmptyParts)) {
    if (file.trimmed().isEmpty()) continue;
    Result<playback::ConsentText> text = playback::readConsent(file.trimmed().toStdString());
    if (!text) return text.failure();
    texts.push_back(*std::move(text));
  }
  return texts;
}

Result<playback::Study> StudyMaker::makeFrom(const QString& filesFolder) const {
  std::vector<std::string> files;
  for (const std::size_t row : chosen()) {
    const QString label = list_->item(static_cast<int>(row))->text();
    files.push_back(QDir(filesFolder).filePath(label + ".button.json").toStdString());
    if (Result<Done> written = writeButtonFile(files.back(), buttons_[row]); !written)
      return written.failure();
  }
  playback::StudyDesign planned = design();
  Result<std::vector<playback::ConsentText>> texts = consents();
  if (!texts) return texts.failure();
  planned.consents = *std::move(texts);
  return playback::createStudy(QDir::cleanPath(folder_->text().trimmed()).toStdString(), files,
                               profileFile_.toStdString(), planned);
}

void StudyMaker::make() {
  const QTemporaryDir files;
  if (!files.isValid()) return trouble_->setText(files.errorString());
  const Result<playback::Study> study = makeFrom(files.path());
  if (!study) return trouble_->setText(studySentence(study.failure()));
  emit made(QString::fromStdString(study->folder.string()));
  accept();
}

}  // namespace detent::editor
