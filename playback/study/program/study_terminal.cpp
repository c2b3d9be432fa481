// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/program/study_terminal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "model/file/text_file.h"
#include "model/message.h"
#include "playback/device/steady_clock.h"
#include "playback/device/terminal.h"
#include "playback/study.h"
#include "playback/study/program/timed_trial.h"
#include "playback/study/trials/participant_words.h"

namespace detent::playback {

namespace {

constexpr double terminalPoll_s = 0.05;
constexpr std::size_t mostKeys = 9;  // 1..9 press, a..i answer

enum class Outcome : std::uint8_t { answered, paused, stopped };

/// Words with their values, on standard error.
void sayOnTerminal(const std::string& words) { std::fputs(words.c_str(), stderr); }

/// The participant's answer.
struct Given {
  std::size_t choice = 0;
  std::optional<double> rating;
};

char lowerCase(char key) { return key >= 'A' && key <= 'Z' ? static_cast<char>(key - 'A' + 'a') : key; }

/// Opens the device settings: a player, or a rehearsal if there is no device and never was one.
Result<std::unique_ptr<StudyPlayer>> playerFor(const Study& study, const StudyDevices& devices,
                                               bool wasReal) {
  StudyPlayerSettings settings;
  settings.player = devices.player;
  settings.rehearse = devices.rehearse;
  settings.sensorPort = devices.sensor.port;
  settings.baud = devices.sensor.baud;
  settings.force = devices.force;
  if (study.profile) settings.calibration = study.profile->sensor;
  if (!devices.sensorProfileFile.empty()) {
    Result<DeviceProfile> profile = loadDeviceProfile(devices.sensorProfileFile);
    if (!profile) return profile.failure();
    settings.calibration = profile->sensor;
  }
  Result<std::unique_ptr<StudyPlayer>> player = StudyPlayer::start(study, settings);
  const bool noDevice = !player && player.failure().code == FailureCode::deviceTrouble;
  // Only where nothing was named and nothing was felt so far; a named device that is missing is an error.
  if (!noDevice || wasReal || !devices.player.device.empty() || !devices.sensor.port.empty() || devices.force)
    return player;
  std::fprintf(stderr, "warning: %s\nThis is a REHEARSAL: nothing is felt, and every row will say so.\n",
               player.failure().sentence().c_str());
  settings.rehearse = true;
  return StudyPlayer::start(study, settings);
}

/// The keys and words of one participant's work.
class Desk {
 public:
  Desk(const Study& study, ParticipantSession& session, StudyPlayer& player, const ParticipantWords& words,
       const Cancelled& cancelled)
      : study_(study),
        session_(session),
        player_(player),
        words_(words),
        cancelled_(cancelled),
        began_s_(now_s()),
        withForce_(!player.route().force.empty()) {}

  Result<Done> work() {
    RawTerminal terminal;
    if (isTimed() && !begun(terminal)) return Done{};
    while (session_.trial() != nullptr) {
      Result<Outcome> outcome = isTimed() ? timed(terminal) : ask(terminal);
      if (!outcome) return outcome.failure();
      if (*outcome == Outcome::paused) {
        sayOnTerminal(std::string("\n") + words_.paused + "\n");
        return Done{};
      }
      if (*outcome == Outcome::stopped) return session_.end("stopped by the participant");
    }
    sayOnTerminal(std::string("\n") + words_.last + "\n");
    return session_.end("complete");
  }

 private:
  Result<Outcome> ask(RawTerminal& terminal) {
    const Trial& trial = *session_.trial();
    if (trial.breakBefore && !rested(terminal)) return Outcome::paused;
    TrialDesk desk(study_, trial, began_s_, now_s());
    typed_.clear();
    player_.beginTrial();
    show(desk);
    player_.troubleSinceAsked();
    for (;;) {
      if (cancelled_()) return Outcome::paused;
      if (const StudyTrouble trouble = player_.troubleSinceAsked(); trouble != StudyTrouble::none) {
        if (Result<Done> ok = session_.interrupted(nameOf(trouble)); !ok) return ok.failure();
        sayOnTerminal("\n" + filled(words_.interrupted, {nameOf(trouble)}) + "\n");
        awaitDevice(player_, terminal, words_, trouble, cancelled_);
        return ask(terminal);
      }
      const std::optional<char> typed = terminal.key(terminalPoll_s);
      desk.felt(player_.takeFelt());
      if (!typed) continue;
      if (*typed == escapeKey) player_.stopForce();
      const std::optional<char> key = lowerCase(*typed);     // Caps Lock
      if (*key == 'p' || *key == 4) return Outcome::paused;  // Ctrl-D
      if (*key == 'q' && confirmed(terminal)) return Outcome::stopped;
      press(desk, *key);
      const std::optional<Given> given = answerOf(desk, *key);
      if (!given) continue;
      Answer answer = desk.answer(given->choice, now_s());
      answer.rating = given->rating;
      Result<Done> kept = session_.record(answer);
      if (kept) return Outcome::answered;
      sayOnTerminal("\n" + filled(words_.notKept, {kept.failure().sentence()}) + "\n");
    }
  }

  bool onScale() const {
    return study_.design.kind == StudyKind::rating && study_.design.scale != RatingScale::pairwise;
  }

  void show(const TrialDesk& desk) const {
    sayNumber(desk.trial());
    if (onScale())
      showScale();
    else
      showChoices(desk);
    sayOnTerminal(std::string("  ") + keys() + "\n");
  }

  std::string keys() const { return words_.keys + (withForce_ ? std::string(", ") + words_.stopForce : ""); }

  void sayNumber(const Trial& trial) const {
    sayOnTerminal("\n" +
                  filled(trial.practice ? words_.practice : words_.trial,
                         {std::to_string(trial.number), std::to_string(session_.record().plan.size())}));
    sayOnTerminal(player_.sounding() ? std::string("\n") : std::string("   ") + words_.rehearsal + "\n");
  }

  void showScale() const {
    const bool magnitude = study_.design.scale == RatingScale::magnitude;
    sayOnTerminal(std::string("  ") + words_.press + " " + words_.spaceBar + "\n  " + words_.answer + " " +
                  filled(words_.thenEnter, {magnitude ? words_.magnitude : words_.preference}) + "\n");
  }

  void showChoices(const TrialDesk& desk) const {
    const Trial& trial = desk.trial();
    std::string text = std::string("  ") + words_.press;
    for (std::size_t i = 0; i < trial.choices.size(); ++i) text += " " + std::to_string(i + 1);
    if (desk.physicalTarget())
      text += "   " + filled(words_.realSwitch, {std::to_string(desk.physicalNumber())});
    else if (desk.hasX())
      text += std::string("  ") + words_.andX;
    text += std::string("\n  ") + words_.answer;
    for (std::size_t i = 0; i < trial.choices.size(); ++i)
      text += std::string("  ") + static_cast<char>('a' + i) + " = " +
              filled(comparisonWords(words_, study_.design), {std::to_string(i + 1)});
    sayOnTerminal(text + "\n");
  }

  // ---- timing

  bool isTimed() const { return study_.design.kind == StudyKind::timing; }

  const char* task() const {
    switch (study_.design.task) {
      case TimingTask::cue:
        return words_.cueTask;
      case TimingTask::window:
        return words_.windowTask;
      case TimingTask::tapping:
        break;
    }
    return words_.tappingTask;
  }

  /// Waits until the participant is there. False: the program is to end.
  bool begun(RawTerminal& terminal) const {
    const std::string said = filled(task(), {std::to_string(std::lround(study_.design.run_s))});
    std::string keys = "\n  " + said + "\n";
    if (!player_.sensed()) keys += std::string("  ") + words_.press + " " + words_.spaceBar + "\n";
    sayOnTerminal(keys + "  " + this->keys() + "\n\n" + words_.begin + " ");
    return anyKey(terminal);
  }

  Result<Outcome> timed(RawTerminal& terminal) {
    const Trial& trial = *session_.trial();
    if (trial.breakBefore && trial.number != restedBefore_ && !rested(terminal)) return Outcome::paused;
    restedBefore_ = trial.number;
    sayNumber(trial);
    for (;;) {
      const Result<TrialEnd> end =
          askTimed({study_, session_, player_, terminal, words_, cancelled_, began_s_});
      if (!end) return end.failure();
      if (*end == TrialEnd::answered) return Outcome::answered;
      if (*end == TrialEnd::paused) return Outcome::paused;
      if (*end != TrialEnd::stopping) continue;
      if (confirmed(terminal)) return Outcome::stopped;
      if (Result<Done> ok = session_.interrupted("stop not confirmed"); !ok) return ok.failure();
    }
  }

  void press(TrialDesk& desk, char key) {
    const Trial& trial = desk.trial();
    const bool x = key == 'x' && desk.hasX();
    if (onScale()) key = key == ' ' ? '1' : '\0';  // digits are the answer
    const std::size_t slot = x ? desk.slotOfX() : static_cast<std::size_t>(key - '1');
    if (!x && (key < '1' || slot >= trial.choices.size())) return;
    player_.press(slot, desk.buttonIn(slot), trial.mode);
    desk.tried(slot, now_s());
    std::fprintf(stderr, " %c", x ? 'X' : onScale() ? '*' : key);
  }

  /// The answer a key completes, felt or not.
  std::optional<Given> givenBy(const TrialDesk& desk, char key) {
    if (onScale()) return numberBy(key);
    const auto choice = static_cast<std::size_t>(key - 'a');
    if (key < 'a' || choice >= desk.trial().choices.size()) return {};
    return Given{choice, {}};
  }

  /// Digits and a point are collected until Enter.
  std::optional<Given> numberBy(char key) {
    constexpr std::size_t longest = 9;
    const bool digit = (key >= '0' && key <= '9') || key == '.' || key == ',';
    if (digit && typed_.size() < longest) {
      typed_ += key == ',' ? '.' : key;
      std::fprintf(stderr, "%c", key);
    }
    if (key == '\b' || key == '\x7f') {
      typed_.clear();
      sayOnTerminal(std::string(" [") + words_.takenBack + "] ");
    }
    if (key != '\n' && key != '\r') return {};
    const std::string typed = std::exchange(typed_, {});
    double number = 0;
    const auto [stop, error] = std::from_chars(typed.data(), typed.data() + typed.size(), number);
    if (error == std::errc() && stop == typed.data() + typed.size() && ratingFits(study_, number))
      return Given{0, number};
    const bool magnitude = study_.design.scale == RatingScale::magnitude;
    sayOnTerminal(std::string("  [") + (magnitude ? words_.typeMagnitude : words_.typePreference) + "]");
    return {};
  }

  std::optional<Given> answerOf(const TrialDesk& desk, char key) {
    const std::optional<Given> given = givenBy(desk, key);
    if (!given || desk.mayAnswer()) return given;
    std::string text = std::string("  [") + (onScale() ? words_.pressIt : words_.pressThem);
    for (std::size_t slot = desk.hasX() ? 0 : 1; slot <= desk.trial().choices.size(); ++slot) {
      const std::size_t at = slot == 0 ? desk.slotOfX() : slot - 1;
      if (desk.feltOf(at).whole > 0) continue;
      text += at == desk.slotOfX() ? std::string(" X") : " " + std::to_string(at + 1);
      if (desk.feltOf(at).presses > 0) text += std::string(" ") + words_.notYet;
    }
    sayOnTerminal(text + "]");
    return {};
  }

  /// The participant rests; any key goes on. False: the program is to end.
  bool rested(RawTerminal& terminal) const {
    sayOnTerminal(std::string("\n") + words_.rest + " ");
    return anyKey(terminal);
  }

  /// Escape only takes a device's force away. What is pressed meanwhile counts nowhere.
  bool anyKey(RawTerminal& terminal) const {
    while (!cancelled_()) {
      player_.takeFelt();
      const std::optional<char> key = terminal.key(terminalPoll_s);
      if (key && !stopsForce(*key)) return true;
    }
    return false;
  }

  bool stopsForce(char key) const {
    if (key != escapeKey || !withForce_) return false;
    player_.stopForce();
    return true;
  }

  bool confirmed(RawTerminal& terminal) const {
    sayOnTerminal(std::string("\n") + words_.stop + " ");
    while (!cancelled_()) {
      player_.takeFelt();
      const std::optional<char> key = terminal.key(terminalPoll_s);
      if (key && stopsForce(*key)) continue;
      if (key) return lowerCase(*key) == 'y' || lowerCase(*key) == words_.yes;
    }
    return false;
  }

  const Study& study_;
  ParticipantSession& session_;
  StudyPlayer& player_;
  const ParticipantWords& words_;
  const Cancelled& cancelled_;
  const double began_s_;
  const bool withForce_;
  std::size_t restedBefore_ = 0;  ///< timing: the trial
  std::string typed_;             ///< of a number
};

bool answeredForReal(const ParticipantRecord& record) {
  return std::any_of(record.sessions.begin(), record.sessions.end(),
                     [](const SessionStart& s) { return s.kind == SessionKind::real; });
}

enum class Decision : std::uint8_t { agreed, declined, left };

Decision decided(const ParticipantWords& words, const Cancelled& cancelled) {
  RawTerminal terminal;
  sayOnTerminal(std::string("\n  ") + words.agree + "\n");
  while (!cancelled()) {
    const std::optional<char> key = terminal.key(terminalPoll_s);
    if (!key) continue;
    if (lowerCase(*key) == 'y' || lowerCase(*key) == 'j') return Decision::agreed;
    if (lowerCase(*key) == 'n') return Decision::declined;
    if (*key == 4) break;  // Ctrl-D
  }
  return Decision::left;
}

/// Shows the text and asks; whether to begin. A "no" is counted, and nothing else is kept.
Result<bool> consented(const Study& study, const std::string& language, const Cancelled& cancelled,
                       SessionStart& start) {
  const Result<ConsentText> text = consentIn(study.folder, language);
  if (!text) return text.failure();
  std::fprintf(stderr, "%s", text->text.c_str());
  const ParticipantWords& words = participantWords(language);
  const Decision decision = decided(words, cancelled);
  const ConsentDecision kept{text->language, text->sha256, wallClock_s()};
  if (decision == Decision::agreed) start.consent = kept;
  if (decision == Decision::declined) {
    if (Result<Done> ok = recordDeclined(study.folder, kept); !ok) return ok.failure();
    sayOnTerminal(std::string("\n") + words.goodbye + "\n");
  }
  return decision == Decision::agreed;
}

}  // namespace

Result<ParticipantRecord> askParticipant(const Study& study, const AskedParticipant& asked,
                                         const StudyDevices& devices, const Cancelled& cancelled) {
  if (study.buttons.size() > mostKeys && study.design.kind == StudyKind::matching)
    return Failure{FailureCode::wrongUsage, "study run", "",
                   "a terminal has keys for 9 buttons, the study has " + std::to_string(study.buttons.size()),
                   "Run it in detent-edit, or with fewer buttons"};
  if (!RawTerminal().interactive())
    return Failure{FailureCode::deviceTrouble, "study run", "",
                   "standard input is not a terminal to answer at",
                   "Run it in a terminal or in detent-edit, or pass --simulate"};
  const Result<ParticipantRecord> before = readParticipant(study, asked.id);
  if (!before) return before.failure();
  Result<std::unique_ptr<StudyPlayer>> player = playerFor(study, devices, answeredForReal(*before));
  if (!player) return player.failure();
  const bool sounding = (*player)->sounding();
  const double noiseLevel = sounding ? devices.player.masking.level : 0;
  SessionStart start{sounding ? SessionKind::real : SessionKind::rehearsal,
                     asked.listening,
                     (*player)->device(),
                     "",
                     wallClock_s(),
                     noiseLevel,
                     (*player)->route(),
                     {}};
  const Result<ParticipantRecord> known = ParticipantSession::toOpen(study, asked.id, start);
  if (!known) return known.failure();
  std::string language = asked.language;
  if (language.empty()) language = known->consent ? known->consent->language : "en";
  const ParticipantWords& words = participantWords(language);
  if (!known->consent && !known->complete()) {
    const Result<bool> agreed = consented(study, language, cancelled, start);
    if (!agreed) return agreed.failure();
    if (!*agreed) return *known;
    start.utc_s = wallClock_s();
  }
  Result<ParticipantSession> session = ParticipantSession::open(study, asked.id, start);
  if (!session) return session.failure();
  for (const std::string& note : session->record().notes) std::fprintf(stderr, "warning: %s\n", note.c_str());
  if (session->trial() == nullptr) return session->record();
  if (noiseLevel > 0)
    sayOnTerminal(
        filled(words.rain, {devices.player.masking.device.empty() ? words.behindTheSignal
                                                                  : devices.player.masking.device}) +
        "\n");
  Desk desk(study, *session, **player, words, cancelled);
  if (Result<Done> ok = desk.work(); !ok) return ok.failure();
  return session->record();
}

}  // namespace detent::playback
