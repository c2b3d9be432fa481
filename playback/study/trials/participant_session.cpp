// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/participant_session.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string_view>

#include "model/number_table.h"
#include "playback/study/statistics/power.h"
#include "playback/study/statistics/quest_plus.h"
#include "playback/study/statistics/shuffle.h"
#include "playback/study/trials/planned_places.h"
#include "playback/study/trials/timing_controller.h"

namespace detent::playback {

namespace {

constexpr double quickest_s = 4, slowest_s = 12;  // K&L, Table 1: 150 trials in 20.9 min are 8.4 s each

/// Simulated and real answers must not be in one journal, because a table over both would be meaningless.
Result<Done> checkKind(const ParticipantRecord& record, const SessionStart& start) {
  for (const SessionStart& before : record.sessions) {
    const bool simulated = before.kind == SessionKind::simulated;
    if (simulated == (start.kind == SessionKind::simulated)) continue;
    return Failure{FailureCode::wrongUsage, Subject::option("--participant"), record.participant,
                   simulated ? Message("this participant already has simulated answers")
                             : Message("this participant already has answers that a person gave"),
                   Message("Give another participant id")};
  }
  if (!record.sessions.empty() && record.sessions.back().listening != start.listening)
    return Failure{FailureCode::wrongUsage, Subject::option("--condition"), record.participant,
                   Message("this participant has used the listening condition \"%1\" so far, not \"%2\"",
                           Message::of(nameOf(record.sessions.back().listening), {}),
                           Message::of(nameOf(start.listening), {})),
                   Message("Go on in the same condition, or give another participant id")};
  return Done{};
}

/// Number of other participants. Failure: one of them has an id that sounds the same.
Result<std::size_t> othersIn(const Study& study, const std::string& participant) {
  if (!study.sites.empty())
    return Failure{FailureCode::wrongUsage, study.folder.string(), "",
                   Message("this is the merged study of several sites: nobody answers in it"),
                   Message("Run the study of one site, then merge again")};
  std::size_t others = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(study.folder / "participants", error)) {
    const std::string id = entry.path().stem().string();
    if (entry.path().extension() != ".jsonl" || id == participant) continue;
    ++others;
    if (spokenId(id) == spokenId(participant))
      return Failure{FailureCode::wrongUsage, Subject::option("--participant"), participant,
                     Message("this id is too similar to \"%1\", which is already in the study", id),
                     Message("Give an id that sounds different when read aloud")};
  }
  return others;
}

}  // namespace

Result<ParticipantRecord> ParticipantSession::toOpen(const Study& study, const std::string& participant,
                                                     const SessionStart& start) {
  if (Result<Done> ok = checkParticipantId(participant); !ok) return ok.failure();
  if (const Result<std::size_t> others = othersIn(study, participant); !others) return others.failure();
  Result<ParticipantRecord> record = readParticipant(study, participant);
  if (!record) return record;
  if (Result<Done> ok = checkKind(*record, start); !ok) return ok.failure();
  return record;
}

Result<ParticipantSession> ParticipantSession::open(const Study& study, const std::string& participant,
                                                    const SessionStart& start) {
  if (Result<Done> ok = checkParticipantId(participant); !ok) return ok.failure();
  const Result<std::size_t> others = othersIn(study, participant);
  if (!others) return others.failure();
  const std::filesystem::path file = journalOf(study, participant);
  Result<LineJournal> journal = LineJournal::open(file);
  if (!journal) return journal.failure();
  const JournalText text = journal->opened();
  if (Result<Done> ok = checkHead(file, text.lines); !ok) return ok.failure();
  Result<ParticipantRecord> record = replayJournal(study, participant, text.lines, {}, file.string());
  if (!record) return record.failure();
  if (text.lines.empty()) {
    const Result<PlannedPlaces> plan = placesOf(study.folder);
    if (!plan) return plan.failure();
    record->begunBefore = *others;
    record->place = placeOf(*plan, participant, *others);
    record->plan = planTrials(study, participant, record->place);
    placeNextLevel(study, *record);
  }
  if (Result<Done> ok = checkKind(*record, start); !ok) return ok.failure();
  ParticipantSession session(study, *std::move(journal), *std::move(record));
  session.chain_ = chainAfter(text.lines);
  session.file_ = file;
  session.lines_ = text.lines.size();
  if (text.lines.empty()) {
    // Before the first line, because that mentions the head file, which must be valid even after a crash.
    if (Result<Done> ok = writeHead(file, 0, {}); !ok) return ok.failure();
    std::string chain = session.chain_;
    const std::string line = headerLine(study, session.record_, start.route, chain);
    if (Result<Done> ok = session.append(line, chain); !ok) return ok.failure();
  }
  if (session.record_.complete()) return session;
  if (start.consent) {
    std::string agreed = session.chain_;
    const std::string consent = consentLine(*start.consent, agreed);
    if (Result<Done> ok = session.append(consent, agreed); !ok) return ok.failure();
    session.record_.consent = start.consent;
  }
  std::string chain = session.chain_;
  const std::string line = sessionLine(start, text.unfinished.size(), chain);
  if (Result<Done> ok = session.append(line, chain); !ok) return ok.failure();
  session.record_.sessions.push_back(start);
  session.record_.endedEarly = false;
  return session;
}

Result<Done> ParticipantSession::append(const std::string& line, const std::string& chain) {
  Result<Done> written = journal_.append(line);
  if (!written) return written;
  chain_ = chain;
  (void)writeHead(file_, ++lines_,
                  chain_);  // the answer is stored; an outdated head file only detects less
  return written;
}

Result<Done> ParticipantSession::record(const Answer& answer) {
  const Trial* shown = trial();
  if (shown == nullptr || answer.trial != shown->number || answer.choice >= shown->choices.size())
    return Failure{FailureCode::wrongUsage, "answer", Message("trial %1", answer.trial),
                   Message("this is not the current trial"), Message("Answer the trial that is shown")};
  if (!ratingFits(*study_, answer.rating))
    return Failure{FailureCode::wrongUsage, "answer", Message("trial %1", answer.trial),
                   answer.rating ? Message("the answer does not lie on the scale")
                                 : Message("the answer contains no number"),
                   study_->design.scale == RatingScale::magnitude
                       ? Message("Give a number above 0, at most a million")
                       : Message("Give 1, 2, 3, 4, 5, 6 or 7")};
  if (!pressesFit(*study_, *shown, answer))
    return Failure{FailureCode::wrongUsage, "answer", Message("trial %1", answer.trial),
                   Message("no press fell within the time that counts"),
                   Message("Press at the cue; in tapping, press at least twice")};
  if (record_.sessions.back().kind == SessionKind::real && !feltEnough(*study_, answer))
    return Failure{FailureCode::wrongUsage, "answer", Message("trial %1", answer.trial),
                   Message("the answer is about a button that was not felt"),
                   Message("Press X and the button that it is compared with to the end, then answer")};
  std::string chain = chain_;
  const std::string line = answerLine(*study_, *shown, answer, chain);
  if (Result<Done> ok = append(line, chain); !ok) return ok;
  const SessionStart& s = record_.sessions.back();
  record_.answers.push_back({answer, s.kind, s.listening, record_.interruptions, answer.onset_s});
  record_.interruptions = 0;
  placeNextLevel(*study_, record_);
  return Done{};
}

Result<Done> ParticipantSession::interrupted(const std::string& reason) {
  const Trial* shown = trial();
  if (shown == nullptr) return Done{};
  std::string chain = chain_;
  const std::string line = interruptionLine(*shown, reason, chain);
  if (Result<Done> ok = append(line, chain); !ok) return ok;
  ++record_.interruptions;
  return Done{};
}

Result<Done> ParticipantSession::end(const std::string& reason) {
  std::string chain = chain_;
  const std::string line = endLine(reason, chain);
  if (Result<Done> ok = append(line, chain); !ok) return ok;
  record_.endedEarly = !record_.complete();
  record_.endReason = reason;
  return Done{};
}

double systemClock_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

Listening listeningOf(const Study& study, const std::string& participant,
                      const std::optional<Listening>& requested) {
  if (requested) return *requested;
  if (const Result<std::vector<ParticipantRecord>> records = readParticipants(study))
    for (const ParticipantRecord& record : *records)
      if (record.participant == participant && !record.sessions.empty())
        return record.sessions.back().listening;
  return Listening::quiet;
}

namespace {

/// The number after "NAME=", if it is within the range.
std::optional<double> numberBehind(const std::string& text, std::string_view name, double low, double high) {
  if (!text.starts_with(name)) return {};
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + name.size(), end, value);
  if (error != std::errc() || stop != end || !(value >= low && value <= high)) return {};
  return value;
}

/// Returns true if the simulated person errs. With a `threshold`, by QUEST+'s model of people with a medium
/// slope and lapse.
bool errs(const Study& study, const Trial& trial, const Simulation& simulation, StudyRandom& random) {
  double share = simulation.errorRate;
  if (simulation.threshold > 0) {
    constexpr double slope = 2, lapse = 0.02;
    share = 1 - shareCorrect(levelOf(study, trial.choices[trial.target])->increase, simulation.threshold,
                             slope, lapse);
  }
  return drawShare(random) < share;
}

/// Rates each button a step better than the one before it; an error gives a random rating.
void simulateRating(const Study& study, const Trial& trial, const Simulation& simulation, StudyRandom& random,
                    Answer& answer) {
  const bool anything = simulation.guess || errs(study, trial, simulation, random);
  if (study.design.scale == RatingScale::pairwise) {
    const std::size_t better = trial.choices[0] > trial.choices[1] ? 0 : 1;
    answer.choice = anything ? drawBelow(random, 2) : better;
    return;
  }
  const auto steps = static_cast<std::uint64_t>(bestPreference);
  const std::size_t step =
      anything ? drawBelow(random, steps) : std::min<std::size_t>(trial.choices[0], steps - 1);
  const bool magnitude = study.design.scale == RatingScale::magnitude;
  answer.rating = magnitude ? std::exp2(static_cast<double>(step)) : static_cast<double>(step + 1);
}

/// Index of the choice that is X, or that has more.
std::size_t simulatedChoice(const Study& study, const Trial& trial, const Simulation& simulation,
                            StudyRandom& random) {
  const std::size_t choices = trial.choices.size();
  if (simulation.guess) return drawBelow(random, choices);
  if (simulation.dPrime) {
    const double apart = trial.target == 1 ? *simulation.dPrime : 0, criterion = 1 + *simulation.dPrime / 2;
    const double felt = drawNormal(random) - drawNormal(random) - apart;
    return std::abs(felt) > criterion ? 1 : 0;
  }
  if (!errs(study, trial, simulation, random)) return trial.target;
  return (trial.target + 1 + drawBelow(random, choices - 1)) % choices;
}

/// Random presses of a person with this place and spread: the model of timingOf, without drift and lapses.
std::vector<double> drawnPresses(const StudyDesign& d, const Trial& trial, const PressTiming& timing,
                                 StudyRandom& random) {
  if (d.task == TimingTask::tapping) {
    std::vector<double> presses{0};
    while (presses.back() <= d.run_s)
      presses.push_back(presses.back() + timing.place * std::exp(timing.spread * drawNormal(random)));
    return presses;
  }
  const double carrier_s = d.task == TimingTask::window ? trial.window_s : trial.interval_s;
  for (int tries = 0; tries < 1000; ++tries) {
    const double press_s = timing.place * carrier_s + timing.spread * trial.interval_s * drawNormal(random);
    if (countedPress(trial, {press_s})) return {press_s};
  }
  return {};  // such a person makes no press that counts
}

/// A trial as a person would do it, with invented times.
Answer simulatedTiming(const Study& study, const Trial& trial, const Simulation& simulation,
                       StudyRandom& random) {
  constexpr double step_s = 0.01, longestTrial_s = 200;
  const double shown_s = static_cast<double>(trial.number - 1) * (quickest_s + slowest_s) / 2;
  TimingController controller(study, trial, 0, shown_s);
  const double zero_s =
      study.design.task == TimingTask::tapping ? shown_s + quickest_s / 4 : controller.cue_s();
  std::vector<double> presses;
  if (const auto given = simulation.presses_s.find(trial.number); given != simulation.presses_s.end())
    presses = given->second;
  else if (simulation.timing)
    presses = drawnPresses(study.design, trial, *simulation.timing, random);
  double now_s = shown_s;
  for (const double press_s : presses) {
    now_s = std::max(now_s, zero_s + press_s);
    if (controller.over(now_s)) break;
    controller.pressed(zero_s + press_s, 0);
    controller.felt({1, 1, 0, 0});
  }
  while (!controller.over(now_s) && now_s < shown_s + longestTrial_s) now_s += step_s;
  if (controller.fault() == TimingFault::none) return controller.answer(now_s);
  Answer nothing;  // record() refuses it
  nothing.trial = trial.number;
  return nothing;
}

/// "PLACE,SPREAD"
std::optional<PressTiming> timingNamed(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return {};
  const auto place = numberBehind(text.substr(0, comma), "timing=", -0.45, 5);
  const auto spread = numberBehind("=" + text.substr(comma + 1), "=", 1e-4, 0.5);
  if (!place || !spread) return {};
  return PressTiming{*place, *spread};
}

/// Reads CSV `trial,press_s`, sorted by trial.
Result<Simulation> pressesFrom(const std::string& file, const std::string& name) {
  constexpr std::size_t mostBytes = 16 << 20;
  const Result<std::string> text = readTable(file, mostBytes, "Give a CSV of presses");
  if (!text) return text.failure();
  NumberTable table(*text);
  std::optional<std::vector<std::size_t>> columns;
  if (table.next()) columns = table.columns({"trial", "press_s"});
  const auto refused = [&](Message problem) {
    return Failure{
        FailureCode::unreadableInput, file, table.place(), std::move(problem),
        Message("Give the columns trial,press_s: one row for each press, in seconds after the cue")};
  };
  if (!columns) return refused(Message("the file does not have the columns trial and press_s"));
  Simulation simulation;
  simulation.name = name;
  while (table.next()) {
    const std::size_t last = std::max((*columns)[0], (*columns)[1]);
    if (table.fields().size() <= last) return refused(Message("this line has too few fields"));
    const std::optional<double> trial = table.finite((*columns)[0]), press_s = table.finite((*columns)[1]);
    if (!trial || !press_s || *trial < 1 || *trial > 1e6)
      return refused(Message("this line does not hold a trial and a time"));
    simulation.presses_s[static_cast<std::size_t>(*trial)].push_back(*press_s);
  }
  if (simulation.presses_s.empty()) return refused(Message("the file holds no press"));
  for (auto& [trial, presses] : simulation.presses_s) std::sort(presses.begin(), presses.end());
  return simulation;
}

}  // namespace

Result<Simulation> simulationNamed(const std::string& name) {
  if (name == "guess") return Simulation{0, true, 0, name};
  if (name == "perfect") return Simulation{0, false, 0, name};
  if (const auto rate = numberBehind(name, "errors=", 0, 1)) return Simulation{*rate, false, 0, name};
  if (const auto threshold = numberBehind(name, "threshold=", 0.001, 10))
    return Simulation{0, false, *threshold, name};
  if (const auto dPrime = numberBehind(name, "d-prime=", 0, 10)) {
    Simulation simulation;
    simulation.name = name;
    simulation.dPrime = dPrime;
    return simulation;
  }
  if (const auto timing = timingNamed(name)) {
    Simulation simulation;
    simulation.name = name;
    simulation.timing = timing;
    return simulation;
  }
  constexpr std::string_view ofFile = "presses=";
  if (name.starts_with(ofFile)) return pressesFrom(name.substr(ofFile.size()), name);
  return Failure{
      FailureCode::wrongUsage, Subject::option("--simulate"), "",
      Message("\"%1\" is not a way to simulate answers", name),
      Message("Give guess, perfect, errors=P with P from 0 to 1, threshold=T with T from 0.001 to 10, "
              "d-prime=D with D from 0 to 10, timing=PLACE,SPREAD or presses=FILE")};
}

Result<Done> checkSimulation(const Study& study, const Simulation& simulation) {
  const bool timed = simulation.timing || !simulation.presses_s.empty();
  if (timed != (study.design.kind == StudyKind::timing))
    return Failure{FailureCode::wrongUsage, Subject::option("--simulate"), "",
                   timed ? Message("recorded presses can answer only timing studies")
                         : Message("this kind of simulation cannot answer a timing study"),
                   timed ? Message("Give guess, perfect or errors=P")
                         : Message("Give timing=PLACE,SPREAD or presses=FILE")};
  if (simulation.timing && study.design.task == TimingTask::tapping && simulation.timing->place < 0.01)
    return Failure{FailureCode::wrongUsage, Subject::option("--simulate"), "",
                   Message("in a tapping study, PLACE of timing=PLACE,SPREAD is the time between presses in "
                           "seconds, and this one is too short"),
                   Message("Give a time of 0.01 s or more")};
  if (simulation.dPrime && study.design.kind != StudyKind::sameDifferent)
    return Failure{FailureCode::wrongUsage, Subject::option("--simulate"), "",
                   Message("a simulated sensitivity (d') can answer only same/different studies"),
                   Message("Give guess, perfect or errors=P")};
  if (simulation.threshold == 0 || study.design.kind == StudyKind::threshold) return Done{};
  return Failure{FailureCode::wrongUsage, Subject::option("--simulate"), "",
                 Message("a simulated threshold can answer only threshold studies"),
                 Message("Give guess, perfect or errors=P")};
}

Answer simulatedAnswer(const Study& study, const std::string& participant, const Trial& trial,
                       const Simulation& simulation) {
  StudyRandom random = randomSeededBy(std::to_string(study.design.seed) + ":" + participant +
                                      ":answer:" + std::to_string(trial.number));
  if (study.design.kind == StudyKind::timing) return simulatedTiming(study, trial, simulation, random);
  const std::size_t choices = trial.choices.size();
  Answer answer;
  answer.trial = trial.number;
  if (study.design.kind == StudyKind::rating)
    simulateRating(study, trial, simulation, random, answer);
  else
    answer.choice = simulatedChoice(study, trial, simulation, random);
  answer.replays.assign(choices, 1);
  answer.felt.assign(choices, {1, 1, 0, 0});
  if (asksForX(study.design.kind)) {
    answer.replaysX = 1;
    answer.feltX = {1, 1, 0, 0};
  }
  answer.answer_s = quickest_s + (slowest_s - quickest_s) * drawShare(random);
  answer.firstPress_s = answer.answer_s / 4;
  answer.onset_s = static_cast<double>(trial.number - 1) * (quickest_s + slowest_s) / 2;
  return answer;
}

}  // namespace detent::playback
