// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/participant_record.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "model/sha256.h"
#include "model/version.h"
#include "playback/study/journal/line_journal.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

constexpr int journalVersion = 1;
constexpr std::size_t chainDigits = 16;
constexpr std::string_view chainKey = ",\"chain\":\"";
constexpr double clockTolerance_s = 1;

std::string chainOf(const std::string& before, const std::string& body) {
  return sha256Hex(before + body).substr(0, chainDigits);
}

/// `body` is a JSON object; the line is the same object with the chain as its last key.
std::string chained(const Json& object, std::string& chain) {
  const std::string body = jsonText(object);
  chain = chainOf(chain, body);
  return body.substr(0, body.size() - 1) + std::string(chainKey) + chain + "\"}";
}

struct SplitLine {
  std::string body, chain;
};

std::optional<SplitLine> splitLine(const std::string& line) {
  const std::size_t at = line.rfind(chainKey);
  if (at == std::string::npos || line.size() != at + chainKey.size() + chainDigits + 2) return {};
  return SplitLine{line.substr(0, at) + "}", line.substr(at + chainKey.size(), chainDigits)};
}

Json jsonOf(const Felt& felt) {
  return {{"presses", felt.presses},
          {"whole", felt.whole},
          {"peak_N", felt.peak_N},
          {"travel_mm", felt.travel_mm}};
}

Felt feltFrom(const Json& json) {
  return {json.at("presses"), json.at("whole"), json.at("peak_N"), json.at("travel_mm")};
}

Json jsonOf(const StudyRoute& route) {
  Json json{
      {"sensor", route.sensorPort}, {"sensor_calibration", route.sensorCalibration}, {"sound", route.sound}};
  if (!route.force.empty()) json["force"] = route.force;
  if (route.timing)
    json["timing"] = {
        {"press", route.timing->press},
        {"cue", route.timing->cue},
        {"cue_latency_s", route.timing->cueLatency_s ? Json(*route.timing->cueLatency_s) : Json(nullptr)}};
  return json;
}

StudyRoute routeFrom(const Json& line) {
  if (!line.contains("route")) return {};  // journals of version 1, which did not store it
  const Json& json = line.at("route");
  StudyRoute route{json.at("sensor"), json.at("sensor_calibration"), json.at("sound")};
  if (json.contains("force")) route.force = json.at("force");
  if (!json.contains("timing")) return route;
  const Json& timing = json.at("timing");
  route.timing = TimingRoute{timing.at("press"), timing.at("cue"), {}};
  if (const Json& latency = timing.at("cue_latency_s"); !latency.is_null())
    route.timing->cueLatency_s = latency;
  return route;
}

/// Reads one journal, line by line. Throws nlohmann's exceptions for values of a wrong type.
class Replay {
 public:
  Replay(const Study& study, const std::string& participant, std::string file)
      : study_(study), file_(std::move(file)) {
    record_.participant = participant;
  }

  Result<Done> take(const std::string& line) {
    ++line_;
    const std::optional<SplitLine> split = splitLine(line);
    if (!split || chainOf(chain_, split->body) != split->chain)
      return wrong(Message("this line or an earlier one was changed by hand"),
                   Message("Restore the journal from a copy; while it is damaged, its answers are not used"));
    chain_ = split->chain;
    const Json json = Json::parse(split->body);
    if (line_ == 1) return header(json);
    const std::string event = json.at("event");
    if (event == "consent") return consent(json);
    if (event == "session") return session(json);
    if (event == "answer") return answer(json);
    if (event == "interruption") return ++record_.interruptions, Done{};
    if (event == "end") return end(json);
    return wrong(Message("this line holds an event \"%1\" that this program does not know", event),
                 Message("Use the program that wrote the journal"));
  }

  ParticipantRecord take() { return std::move(record_); }
  std::size_t line() const { return line_; }
  Failure wrong(Message problem, const Message& remedy) const {
    return {FailureCode::unreadableInput, file_, Message("line %1", line_), std::move(problem), remedy};
  }

 private:
  Result<Done> header(const Json& json) {
    if (json.at("format") != "detent-study-journal")
      return wrong(Message("the file is not a journal of a study"),
                   Message("Move this file out of the study"));
    if (const int version = json.at("version"); version != journalVersion)
      return wrong(Message("the journal has version %1, which this program cannot read", version),
                   Message("Use the program that wrote the journal"));
    if (json.at("participant") != record_.participant)
      return wrong(Message("this is the journal of %1", jsonText(json.at("participant"))),
                   Message("Give the file its original name again"));
    if (json.at("study_sha256") != study_.sha256)
      return wrong(Message("the journal belongs to another study, or study.json was changed later"),
                   Message("Restore study.json, or move the journal to its own study"));
    record_.program = json.at("program");
    record_.begunBefore = json.value("begun_before", std::size_t{0});
    record_.place = json.value("place", record_.begunBefore);
    record_.plan = planTrials(study_, record_.participant, record_.place);
    placeNextLevel(study_, record_);
    return Done{};
  }

  Result<Done> consent(const Json& json) {
    record_.consent = ConsentDecision{json.at("language"), json.at("sha256"), json.at("utc_s")};
    return Done{};
  }

  Result<Done> session(const Json& json) {
    SessionStart s;
    const auto kind = sessionKinds.value(json.at("kind").get<std::string>());
    const auto listening = listenings.value(json.at("listening").get<std::string>());
    if (!kind || !listening)
      return wrong(Message("this line has a kind of session that this program does not know: %1, %2",
                           jsonText(json.at("kind")), jsonText(json.at("listening"))),
                   Message("Use the program that wrote the journal"));
    s.kind = *kind;
    s.listening = *listening;
    s.route = routeFrom(json);
    s.device = json.at("device");
    s.simulation = json.at("simulation");
    s.utc_s = json.at("utc_s");
    // absent in journals of versions that made no masking noise
    s.noiseLevel = json.value("noise_level", 0.0);
    if (const std::size_t cut = json.at("cut_bytes"); cut > 0)
      note("half a line (" + std::to_string(cut) + " bytes) was cut off: what it held was never confirmed");
    if (!record_.sessions.empty()) placeAfterPause(s);
    record_.sessions.push_back(s);
    record_.endedEarly = false;
    return Done{};
  }

  /// Start of this session, relative to the first one. The system clock may have been changed meanwhile; the
  /// steady clock gives a lower bound. A simulation invents its times, so they prove no clock wrong.
  void placeAfterPause(const SessionStart& s) {
    const double bySystemClock_s = s.utc_s - record_.sessions.front().utc_s;
    if (s.kind != SessionKind::simulated && bySystemClock_s < spent_s_ - clockTolerance_s)
      note("two clocks disagree: the system clock stepped back by " +
           std::to_string(std::lround(spent_s_ - bySystemClock_s)) +
           " s; times within a trial are not touched, the pause counts as none");
    start_s_ = std::max(bySystemClock_s, spent_s_);
  }

  Result<Done> answer(const Json& json) {
    if (record_.sessions.empty())
      return wrong(Message("this line is an answer outside a session"), Message("Restore the journal"));
    const Trial* trial = record_.next();
    if (trial == nullptr || json.at("trial") != trial->number)
      return wrong(Message("this line answers trial %1 out of order", jsonText(json.at("trial"))),
                   Message("Restore the journal"));
    takeLevel(json);
    const std::string chosen = json.at("answer");
    Answer a;
    a.trial = trial->number;
    a.choice = trial->choices.size();
    for (std::size_t i = 0; i < trial->choices.size(); ++i)
      if (answerName(study_, *trial, i) == chosen) a.choice = i;
    if (json.contains("rating")) a.rating = json.at("rating").get<double>();
    if (json.contains("presses_s")) {
      a.presses_s = json.at("presses_s").get<std::vector<double>>();
      a.pressWithin_s = json.at("press_within_s");
    }
    if (a.choice == trial->choices.size() || !ratingFits(study_, a.rating) || !timesFit(*trial, a, json) ||
        (hasRightAnswer(study_.design.kind) && json.at("x") != answerName(study_, *trial, trial->target)))
      return wrong(Message("this answer does not fit the list of trials"), Message("Restore the journal"));
    a.replays = json.at("replays").get<std::vector<std::size_t>>();
    a.replaysX = json.at("replays_x");
    if (json.contains("felt")) {  // missing in journals up to version 0.2
      for (const Json& felt : json.at("felt")) a.felt.push_back(feltFrom(felt));
      a.feltX = feltFrom(json.at("felt_x"));
    }
    if (Result<Done> ok = checkFelt(a, trial->choices.size(), json.contains("felt")); !ok) return ok;
    a.onset_s = json.at("onset_s");
    a.firstPress_s = json.at("first_press_s");
    a.answer_s = json.at("answer_s");
    const SessionStart& s = record_.sessions.back();
    record_.answers.push_back({a, s.kind, s.listening, record_.interruptions, start_s_ + a.onset_s});
    spent_s_ = start_s_ + a.onset_s + a.answer_s;
    record_.interruptions = 0;
    placeNextLevel(study_, record_);
    return Done{};
  }

  /// Checks that the stimuli were felt, because a journal may come from another machine.
  Result<Done> checkFelt(const Answer& a, std::size_t choices, bool kept) const {
    if (a.replays.size() > choices || a.felt.size() > choices)
      return wrong(Message("this answer does not fit the list of trials"), Message("Restore the journal"));
    if (!kept || record_.sessions.back().kind != SessionKind::real || feltEnough(study_, a)) return Done{};
    return wrong(Message("this line is an answer about a button that was not felt"),
                 Message("Restore the journal"));
  }

  bool timesFit(const Trial& trial, const Answer& a, const Json& json) const {
    if (!pressesFit(study_, trial, a)) return false;
    return study_.design.kind != StudyKind::timing ||
           (json.at("interval_s") == trial.interval_s && json.at("window_s") == trial.window_s);
  }

  /// The recorded level counts, not the one that this machine would choose: if two levels are equally
  /// informative, the last digit of a logarithm decides.
  void takeLevel(const Json& json) {
    if (study_.design.kind != StudyKind::threshold) return;
    Trial& trial = record_.plan[record_.answers.size()];
    const std::size_t reference = trial.choices[1 - trial.target];
    for (const StudyLevel& level : study_.levels)
      if (level.reference == reference && json.at("x") == study_.buttons[level.button].label)
        trial.choices[trial.target] = level.button;
  }

  Result<Done> end(const Json& json) {
    record_.endReason = json.at("reason");
    record_.endedEarly = !record_.complete();
    return Done{};
  }

  void note(const std::string& text) { record_.notes.push_back(record_.participant + ": " + text); }

  const Study& study_;
  std::string file_, chain_;
  ParticipantRecord record_;
  std::size_t line_ = 0;
  double start_s_ = 0, spent_s_ = 0;  // seconds since the first session began
};

}  // namespace

const Trial* ParticipantRecord::next() const {
  return answers.size() >= plan.size() || endedEarly ? nullptr : &plan[answers.size()];
}

Result<ParticipantRecord> replayJournal(const Study& study, const std::string& participant,
                                        const std::vector<std::string>& lines, const std::string& unfinished,
                                        const std::string& file) {
  Replay replay(study, participant, file);
  for (const std::string& line : lines) {
    try {
      if (Result<Done> ok = replay.take(line); !ok) return ok.failure();
    } catch (const Json::exception&) {
      return replay.wrong(Message("the content is broken"), Message("Restore the journal from a copy"));
    }
  }
  ParticipantRecord record = replay.take();
  if (!unfinished.empty())
    record.notes.push_back(participant +
                           ": the journal ends in half a line; it is being written, or was cut off");
  return record;
}

std::filesystem::path journalOf(const Study& study, const std::string& participant) {
  return study.folder / "participants" / (participant + ".jsonl");
}

namespace {

ParticipantRecord notBegun(const std::string& participant) {
  ParticipantRecord record;
  record.participant = participant;
  return record;
}

}  // namespace

Result<ParticipantRecord> readParticipant(const Study& study, const std::string& participant) {
  const std::filesystem::path file = journalOf(study, participant);
  std::error_code error;
  if (!std::filesystem::exists(file, error) && !std::filesystem::exists(headFileOf(file), error))
    return notBegun(participant);
  Result<std::string> text = readTextFile(file.string());
  if (!text) return text.failure();
  const JournalText journal = splitJournal(*text);
  if (journal.isForeign()) return notAJournal(file);
  Result<ParticipantRecord> record =
      replayJournal(study, participant, journal.lines, journal.unfinished, file.string());
  if (!record) return record;
  if (Result<Done> ok = checkHead(file, journal.lines); !ok) return ok.failure();
  return record;
}

void Felt::add(const Felt& more) {
  presses += more.presses;
  whole += more.whole;
  peak_N = std::max(peak_N, more.peak_N);
  travel_mm = std::max(travel_mm, more.travel_mm);
}

bool feltEnough(const Study& study, const Answer& answer) {
  const auto whole = [](const Felt& felt) { return felt.whole > 0; };
  // A press that closes the contact counts, even if it was not completed; the times show whether it was.
  if (study.design.kind == StudyKind::timing) return answer.felt.size() == 1 && answer.felt[0].presses > 0;
  if (!asksForX(study.design.kind))
    return !answer.felt.empty() && std::all_of(answer.felt.begin(), answer.felt.end(), whole);
  if (study.design.targets == TargetKind::virtualButton && !whole(answer.feltX)) return false;
  return study.design.kind == StudyKind::abx
             ? answer.felt.size() == 2 && std::all_of(answer.felt.begin(), answer.felt.end(), whole)
             : std::any_of(answer.felt.begin(), answer.felt.end(), whole);
}

std::optional<double> countedPress(const Trial& trial, const std::vector<double>& presses_s) {
  for (const double press_s : presses_s)
    if (press_s > -trial.interval_s / 2 && press_s < trial.interval_s) return press_s;
  return {};
}

bool pressesFit(const Study& study, const Trial& trial, const Answer& answer) {
  const std::vector<double>& presses = answer.presses_s;
  if (study.design.kind != StudyKind::timing) return presses.empty();
  constexpr std::size_t most = 10000;
  const bool finite = std::all_of(presses.begin(), presses.end(), [](double p) { return std::isfinite(p); });
  const auto notRising = std::adjacent_find(presses.begin(), presses.end(), std::greater_equal<>());
  if (!finite || notRising != presses.end() || presses.size() > most || !std::isfinite(answer.pressWithin_s))
    return false;
  return study.design.task == TimingTask::tapping ? presses.size() >= 2
                                                  : countedPress(trial, presses).has_value();
}

bool ratingFits(const Study& study, const std::optional<double>& rating) {
  const StudyDesign& d = study.design;
  if (d.kind != StudyKind::rating || d.scale == RatingScale::pairwise) return !rating;
  if (!rating) return false;
  if (d.scale == RatingScale::magnitude) return *rating > 0 && *rating <= greatestMagnitude;
  return *rating >= 1 && *rating <= bestPreference && *rating == std::floor(*rating);
}

namespace {

/// Records of all sites, with the site's name before the id, because P01 of two sites are two people.
Result<std::vector<ParticipantRecord>> readSites(const Study& study) {
  std::vector<ParticipantRecord> all;
  for (const std::string& site : study.sites) {
    const Result<Study> one = openStudy(siteFolder(study.folder, site));
    if (!one) return one.failure();
    Result<std::vector<ParticipantRecord>> records = readParticipants(*one);
    if (!records) return records.failure();
    for (ParticipantRecord& record : *records) {
      record.participant = site + "-" + record.participant;
      record.site = site;
      all.push_back(std::move(record));
    }
  }
  return all;
}

}  // namespace

Result<std::vector<ParticipantRecord>> readParticipants(const Study& study) {
  if (!study.sites.empty()) return readSites(study);
  const std::filesystem::path folder = study.folder / "participants";
  std::error_code error;
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::filesystem::path file = entry.path();
    // the head of a missing journal shows that it existed
    if (file.extension() == ".head") file.replace_extension(".jsonl");
    if (file.extension() == ".jsonl") files.insert(file);
  }
  if (error)
    return Failure{FailureCode::unreadableInput, folder.string(), "",
                   Message("the folder cannot be read (%1)", error.message()),
                   Message("Restore the folder from a copy")};
  std::vector<ParticipantRecord> records;
  for (const std::filesystem::path& file : files) {
    Result<ParticipantRecord> record = readParticipant(study, file.stem().string());
    if (!record) {
      ParticipantRecord damaged;
      damaged.participant = file.stem().string();
      damaged.damage = record.failure();
      record = std::move(damaged);
    }
    records.push_back(*std::move(record));
  }
  return records;
}

namespace {

Json headerOf(const Study& study, const ParticipantRecord& participant) {
  Json buttons = Json::array();
  for (std::size_t i = 0; i < study.givenButtons(); ++i)
    buttons.push_back({{"label", study.buttons[i].label}, {"sha256", study.buttons[i].sha256}});
  Json header{{"format", "detent-study-journal"},
              {"version", journalVersion},
              {"participant", participant.participant},
              {"place", participant.place},
              {"study", study.name},
              {"study_sha256", study.sha256},
              {"program", version()},
              {"seed", study.design.seed},
              {"profile_sha256", study.profileSha256},
              {"buttons", buttons}};
  if (const StudySound& sound = study.design.sound; !sound.source.empty())
    header["sound"] = {{"source", sound.source}, {"level_dB", sound.level_dB}, {"delay_ms", sound.delay_ms}};
  return header;
}

}  // namespace

std::string headerLine(const Study& study, const ParticipantRecord& participant, const StudyRoute& route,
                       std::string& chain) {
  Json header = headerOf(study, participant);
  header["head"] = true;
  header["begun_before"] = participant.begunBefore;
  header["route"] = jsonOf(route);
  return chained(header, chain);
}

std::string headerOfBrowser(const Study& study, const ParticipantRecord& participant) {
  return jsonText(headerOf(study, participant));
}

std::string consentLine(const ConsentDecision& d, std::string& chain) {
  return chained({{"event", "consent"},
                  {"decision", "agreed"},
                  {"language", d.language},
                  {"sha256", d.sha256},
                  {"utc_s", d.utc_s}},
                 chain);
}

std::string sessionLine(const SessionStart& s, std::size_t cutBytes, std::string& chain) {
  return chained({{"event", "session"},
                  {"kind", nameOf(s.kind)},
                  {"listening", nameOf(s.listening)},
                  {"device", s.device},
                  {"noise_level", s.noiseLevel},
                  {"simulation", s.simulation},
                  {"route", jsonOf(s.route)},
                  {"program", version()},
                  {"utc_s", s.utc_s},
                  {"cut_bytes", cutBytes}},
                 chain);
}

std::string answerLine(const Study& study, const Trial& trial, const Answer& a, std::string& chain) {
  Json choices = Json::array(), felt = Json::array();
  for (const std::size_t button : feltButtons(study.design, trial))
    choices.push_back(study.buttons[button].label);
  for (const Felt& each : a.felt) felt.push_back(jsonOf(each));
  Json line{{"event", "answer"},
            {"trial", trial.number},
            {"practice", trial.practice},
            {"mode", nameOf(trial.mode)},
            {"choices", choices}};
  const bool right = hasRightAnswer(study.design.kind);
  if (right) line["x"] = answerName(study, trial, trial.target);
  line["answer"] = answerName(study, trial, a.choice);
  if (right) line["correct"] = a.choice == trial.target;
  if (a.rating) line["rating"] = *a.rating;
  if (study.design.kind == StudyKind::timing) {
    line["interval_s"] = trial.interval_s;
    line["window_s"] = trial.window_s;
    line["presses_s"] = a.presses_s;
    line["press_within_s"] = a.pressWithin_s;
  }
  line["replays"] = a.replays;
  line["replays_x"] = a.replaysX;
  line["felt"] = felt;
  line["felt_x"] = jsonOf(a.feltX);
  line["onset_s"] = a.onset_s;
  line["first_press_s"] = a.firstPress_s;
  line["answer_s"] = a.answer_s;
  return chained(line, chain);
}

std::string interruptionLine(const Trial& trial, const std::string& reason, std::string& chain) {
  return chained({{"event", "interruption"}, {"trial", trial.number}, {"reason", reason}}, chain);
}

std::string endLine(const std::string& reason, std::string& chain) {
  return chained({{"event", "end"}, {"reason", reason}}, chain);
}

std::filesystem::path headFileOf(const std::filesystem::path& journal) {
  std::filesystem::path head = journal;
  return head.replace_extension(".head");
}

Result<Done> writeHead(const std::filesystem::path& journal, std::size_t lines, const std::string& chain) {
  return writeTextFileAtomically(headFileOf(journal).string(), std::to_string(lines) + " " + chain + "\n");
}

namespace {

/// Returns true if a journal mentions its head file; those of version 0.2 had none at first.
bool hadHead(const std::vector<std::string>& lines) {
  if (lines.empty()) return false;
  const Json header = Json::parse(lines.front(), nullptr, false);
  return header.is_object() && header.value("head", false);
}

}  // namespace

Result<Done> checkHead(const std::filesystem::path& journal, const std::vector<std::string>& lines) {
  const std::filesystem::path file = headFileOf(journal);
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    if (!hadHead(lines)) return Done{};
    return Failure{FailureCode::unreadableInput, journal.string(), "",
                   Message("the file \"%1\", which belongs to the journal, is missing; the end of the "
                           "journal may have been cut off",
                           file.filename().string()),
                   Message("Restore both files from a copy")};
  }
  const Result<std::string> text = readTextFile(file.string());
  if (!text) return text.failure();
  std::istringstream head(*text);
  std::size_t count = 0;
  std::string chain;
  if (!(head >> count))
    return Failure{FailureCode::unreadableInput, file.string(), "",
                   Message("the file does not record the length of the journal"),
                   Message("Restore both files from a copy")};
  head >> chain;
  if (count <= lines.size() &&
      chainAfter({lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(count)}) == chain)
    return Done{};
  return Failure{FailureCode::unreadableInput, journal.string(), "",
                 Message("the journal should have %1 lines, but some of them are missing", count),
                 Message("Restore the journal from a copy")};
}

std::string chainAfter(const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  const std::optional<SplitLine> last = splitLine(lines.back());
  return last ? last->chain : std::string();
}

}  // namespace detent::playback
