// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/program/study_command.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/file/text_file.h"
#include "model/program/command_line.h"
#include "playback/device/steady_clock.h"
#include "playback/program/json_output.h"
#include "playback/program/number_option.h"
#include "playback/program/shared_options.h"
#include "playback/study.h"
#include "playback/study/station/station_page.h"
#include "playback/study/trials/participant_session.h"
#include "playback/study/trials/printed_counts.h"
#include "playback/study/trials/study_plan.h"
#include "playback/study/trials/timing_tables.h"

namespace detent::playback {

namespace {

// ---- new

struct NewArguments {
  std::string folder;
  std::vector<std::string> buttons;
  StudyDesign design;
  std::optional<std::uint64_t> seed;
  std::optional<std::size_t> trials;
  std::vector<std::string> modes;
  bool physical = false;
  std::string profileFile;
  std::vector<std::string> consentFiles;
  bool json = false;
};

Result<std::vector<FeedbackMode>> modesNamed(const std::vector<std::string>& names) {
  std::vector<FeedbackMode> found;
  for (const std::string& name : names) {
    const auto mode = feedbackModes.value(name);
    if (!mode || *mode == FeedbackMode::off)
      return Failure{FailureCode::wrongUsage, Subject::option("--modes"), "",
                     "\"" + name + "\" is not one of them",
                     "Give full, click-only, slope-only, separated by commas"};
    found.push_back(*mode);
  }
  return found;
}

int runNew(NewArguments a) {
  a.design.seed = a.seed ? *a.seed : std::random_device{}();
  a.design.trials = a.trials.value_or(usualTrials(a.design.kind, a.design.task));
  a.design.targets = a.physical ? TargetKind::physicalButton : TargetKind::virtualButton;
  if (!a.modes.empty()) {
    Result<std::vector<FeedbackMode>> named = modesNamed(a.modes);
    if (!named) return fail(named.failure());
    a.design.modes = *std::move(named);
  }
  for (const std::string& file : a.consentFiles) {
    Result<ConsentText> consent = readConsent(file);
    if (!consent) return fail(consent.failure());
    a.design.consents.push_back(*std::move(consent));
  }
  Result<Study> study = createStudy(a.folder, a.buttons, a.profileFile, a.design);
  if (!study) return fail(study.failure());
  std::fprintf(stderr, "%s: %s, %zu buttons, %zu trials for each participant, feel %s, seed %llu\n",
               a.folder.c_str(), nameOf(study->design.kind), study->givenButtons(), countedTrials(*study),
               feels.word(study->design.feel), static_cast<unsigned long long>(study->design.seed));
  if (a.json) {
    Json labels = Json::array();
    for (std::size_t i = 0; i < study->givenButtons(); ++i) labels.push_back(study->buttons[i].label);
    print({{"status", "ok"},
           {"study", study->name},
           {"kind", nameOf(study->design.kind)},
           {"buttons", labels},
           {"trials_per_participant", countedTrials(*study)},
           {"practice", study->design.practice},
           {"feel", feels.word(study->design.feel)},
           {"seed", study->design.seed},
           {"sha256", study->sha256}});
  }
  return 0;
}

std::string range(double low, double high) { return shortestText(low) + ".." + shortestText(high); }

void addNew(CLI::App& parent, Action& chosen) {
  CLI::App* app = parent.add_subcommand("new", "Create a study");
  const auto a = std::make_shared<NewArguments>();
  app->add_option("DIR", a->folder, "Folder to create; it holds the whole study and can be copied")
      ->required();
  app->add_option("BUTTON", a->buttons,
                  "*.button.json, at least two; one is enough for thresholds, scales and timing")
      ->required();
  addChoice(*app, "--kind", a->design.kind, studyKinds,
            "Which of two is X (abx), whether two are the same (same-different), which of all is X "
            "(matching); which of two has more (threshold); how "
            "good, how strong, which is better "
            "(rating); when is it pressed (timing)",
            "abx");
  addChoice(*app, "--quantity", a->design.quantity, levelQuantities,
            "threshold: the quantity to increase; the differences adapt to the answers", "peak-force");
  addChoice(
      *app, "--scale", a->design.scale, ratingScales,
      "rating: 1 to 7 (preference), any number for the strength (magnitude), or the better of two (pairwise)",
      "preference");
  addChoice(*app, "--task", a->design.task, timingTasks,
            "timing: press with the last of four beats (cue), while a moving target is in its window "
            "(window), or as fast as possible (tapping)",
            "cue");
  app->add_option("--intervals", a->design.intervals_s,
                  "timing, cue and window: s, separated by commas, " + range(leastInterval_s, mostInterval_s))
      ->delimiter(',')
      ->default_str("0.6,0.8,1");
  app->add_option("--windows", a->design.windows_s,
                  "timing, window: s, separated by commas, " + range(leastWindow_s, mostWindow_s))
      ->delimiter(',')
      ->default_str("0.08,0.12,0.16");
  app->add_option("--run-seconds", a->design.run_s, "timing, tapping: length of a run")
      ->capture_default_str()
      ->check(numberWithin(shortestRun_s, longestRun_s));
  app->add_option(
         "--trials", a->trials,
         "Trials per pair (abx, same-different, pairwise) or button (else), and mode; tapping: runs; " +
             range(1, mostTrials))
      ->default_str("10; same-different 20; threshold, timing 60; rating 4; tapping 3");
  app->add_option("--modes", a->modes, "Modes to compare: full, click-only, slope-only, separated by commas")
      ->delimiter(',')
      ->default_str("full");
  addChoice(*app, "--feel", a->design.feel, feels,
            "clear: as render, live, page and export play; paper: as in the paper", "clear");
  app->add_option(
      "--sound", a->design.sound.source,
      "What is heard of each press, on the outputs behind the vibration's: rendered (the vibration "
      "itself), or a sound file of at most 5 s that begins with the click; default: nothing");
  app->add_option("--sound-level", a->design.sound.level_dB, "dB added to the sound, -60..20")
      ->capture_default_str();
  app->add_option("--sound-delay", a->design.sound.delay_ms, "ms from the click to its sound, 0..500")
      ->capture_default_str();
  app->add_option("--seed", a->seed, "Seed of the random order; default: random, recorded");
  app->add_option("--practice", a->design.practice,
                  "Practice trials before the first that counts, " + range(0, mostPractice))
      ->capture_default_str();
  app->add_option("--pairs-each", a->design.pairsEach, "Number of random pairs per participant; 0: all")
      ->capture_default_str();
  app->add_flag("--physical", a->physical, "matching: X is a real switch, handed over by number");
  app->add_option("--profile", a->profileFile, "Device profile (docs/reference/device-profile.md)");
  app->add_option(
         "--consent", a->consentFiles,
         "Text shown before the first trial, one for each language: NAME.en.txt, NAME.de.txt; any other "
         "name is for all other languages. Default: a short text in English and German")
      ->delimiter(',')
      ->allow_extra_args(false);
  app->add_flag("--json", a->json, "One JSON object on stdout");
  app->callback([&chosen, a] { chosen = [a](const Cancelled&) { return runNew(*a); }; });
}

// ---- run

struct RunArguments {
  std::string folder, participant, simulation;
  std::optional<Listening> condition;  ///< empty: as in the journal
  bool json = false;
  std::vector<std::string> others;  ///< options of the former terminal station
};

Result<Done> checkAnswering(const RunArguments& a) {
  if (a.simulation.empty())
    return Failure{
        FailureCode::wrongUsage, "study run", "",
        "people do not answer in a terminal; this command only simulates",
        "Run the study in detent-edit (Button > Study with people), write a page for browsers with "
        "detent-play study station, or pass --simulate"};
  if (!a.others.empty())
    return Failure{FailureCode::wrongUsage, Subject::option(a.others.front()), "",
                   "is nothing that a simulated participant needs", "Leave it out"};
  return Done{};
}

/// Simulates a participant; reports each answer on stderr only after it is on disk.
int runRun(const RunArguments& a, const Cancelled& cancelled) {
  if (Result<Done> ok = checkAnswering(a); !ok) return fail(ok.failure());
  const Result<Study> study = openStudy(a.folder);
  if (!study) return fail(study.failure());
  if (Result<Done> ok = checkParticipantId(a.participant); !ok) return fail(ok.failure());
  if (Result<Done> ok = checkStimuli(*study); !ok) return fail(ok.failure());
  const Result<Simulation> simulation = simulationNamed(a.simulation);
  if (!simulation) return fail(simulation.failure());
  if (Result<Done> ok = checkSimulation(*study, *simulation); !ok) return fail(ok.failure());
  const SessionStart start{SessionKind::simulated, listeningOf(*study, a.participant, a.condition), "",
                           a.simulation, systemClock_s()};
  Result<ParticipantSession> session = ParticipantSession::open(*study, a.participant, start);
  if (!session) return fail(session.failure());
  for (const std::string& note : session->record().notes) std::fprintf(stderr, "warning: %s\n", note.c_str());
  while (const Trial* trial = session->trial()) {
    if (cancelled()) break;
    const std::size_t number = trial->number;
    if (Result<Done> ok = session->record(simulatedAnswer(*study, a.participant, *trial, *simulation)); !ok)
      return fail(ok.failure());
    std::fprintf(stderr, "recorded %zu\n", number);
    if (session->trial() == nullptr) {
      if (Result<Done> ok = session->end("complete"); !ok) return fail(ok.failure());
    }
  }
  const ParticipantRecord& record = session->record();
  std::fprintf(stderr, "%s: %zu of %zu trials answered%s\n", a.participant.c_str(), record.answers.size(),
               record.plan.size(), record.complete() ? ", complete" : "");
  if (a.json)
    print({{"status", "ok"},
           {"participant", a.participant},
           {"answered", record.answers.size()},
           {"trials", record.plan.size()},
           {"complete", record.complete()}});
  return 0;
}

void addRun(CLI::App& parent, Action& chosen) {
  CLI::App* app = parent.add_subcommand("run", "Simulate a participant's session, or the rest of it");
  const auto a = std::make_shared<RunArguments>();
  app->add_option("DIR", a->folder, "Folder of the study")->required();
  app->add_option("--participant", a->participant, "Anonymous id: letters, digits, - and _")->required();
  app->add_option("--simulate", a->simulation,
                  "The program answers: guess, perfect, errors=P (0..1); same-different also d-prime=D; "
                  "threshold studies also threshold=T, "
                  "the increase noticed in 75 of 100 trials (0.1: a tenth); timing studies "
                  "timing=PLACE,SPREAD or presses=FILE (trial,press_s)");
  addChoice(*app, "--condition", a->condition, listenings,
            "Listening: quiet, or masked by rain from headphones; recorded in every row, the same for all "
            "trials of a participant. Default: as before, quiet at first",
            "");
  app->add_flag("--json", a->json, "One JSON object on stdout");
  // so that options of the former terminal station can be answered with their replacement
  app->allow_extras();
  app->callback([&chosen, a, app] {
    a->others = app->remaining();
    chosen = [a](const Cancelled& cancelled) { return runRun(*a, cancelled); };
  });
}

// ---- station

struct StationArguments {
  std::string folder, outputFile;
  StationSettings settings;
};

int runStation(const StationArguments& a) {
  const Result<Study> study = openStudy(a.folder);
  if (!study) return fail(study.failure());
  const Result<std::string> page = stationPage(*study, a.settings);
  if (!page) return fail(page.failure());
  if (Result<Done> written = writeTextFileAtomically(a.outputFile, *page); !written)
    return fail(written.failure());
  std::fprintf(stderr, "%s: %zu participants, %zu kB; put the journals they hand over into %s/participants\n",
               a.outputFile.c_str(), a.settings.participants.size(), page->size() / 1000, a.folder.c_str());
  return 0;
}

void addStation(CLI::App& parent, Action& chosen) {
  CLI::App* app =
      parent.add_subcommand("station", "Write the study as a web page at which participants answer");
  const auto a = std::make_shared<StationArguments>();
  app->add_option("DIR", a->folder, "Folder of the study")->required();
  app->add_option("--participants", a->settings.participants,
                  "Ids of the page's participants, separated by commas; one opens PAGE#ID, or chooses")
      ->delimiter(',')
      ->required();
  app->add_option("-o,--output", a->outputFile, "The page, *.html")->required();
  addChoice(*app, "--condition", a->settings.listening, listenings,
            "Listening: quiet, or masked by a noise that you provide; recorded in every row", "quiet");
  app->add_option("--post", a->settings.postTo,
                  "Address that receives the journals (POST); default: participants download them");
  app->callback([&chosen, a] { chosen = [a](const Cancelled&) { return runStation(*a); }; });
}

// ---- merge

struct MergeArguments {
  std::vector<std::string> studies, sites;
  std::string out;
  bool json = false;
};

int runMerge(const MergeArguments& a) {
  const Result<Study> study = mergeStudies({a.studies.begin(), a.studies.end()}, a.sites, a.out);
  if (!study) return fail(study.failure());
  const Result<std::vector<ParticipantRecord>> records = readParticipants(*study);
  if (!records) return fail(records.failure());
  std::fprintf(stderr, "%s: %zu sites, %zu participants\n", a.out.c_str(), study->sites.size(),
               records->size());
  if (a.json)
    print({{"status", "ok"},
           {"study", study->name},
           {"sites", study->sites},
           {"participants", records->size()},
           {"sha256", study->sha256}});
  return 0;
}

void addMerge(CLI::App& parent, Action& chosen) {
  CLI::App* app = parent.add_subcommand("merge", "Merge the copies of a study that several laboratories ran");
  const auto a = std::make_shared<MergeArguments>();
  app->add_option("DIR", a->studies, "Folders of the laboratories' studies, at least two")
      ->required()
      ->expected(2, 100);
  app->add_option("-o,--output", a->out, "Folder to create for the merged study")->required();
  app->add_option("--sites", a->sites,
                  "Names of the laboratories, separated by commas; default: those of the folders")
      ->delimiter(',');
  app->add_flag("--json", a->json, "One JSON object on stdout");
  app->callback([&chosen, a] { chosen = [a](const Cancelled&) { return runMerge(*a); }; });
}

// ---- status, report

struct ReadArguments {
  std::string folder, htmlFile, csvFile, feltFile, bidsFolder;
  bool json = false, follow = false;
};

Json jsonOf(const ParticipantRecord& record) {
  const Trial* next = record.next();
  return {{"participant", record.participant},
          {"answered", record.answers.size()},
          {"trials", record.plan.size()},
          {"complete", record.complete()},
          {"next_trial", next != nullptr ? Json(next->number) : Json(nullptr)},
          {"kind", record.sessions.empty() ? "none" : nameOf(record.sessions.back().kind)},
          {"ended_early", record.endedEarly},
          {"consent", record.consent ? Json{{"language", record.consent->language},
                                            {"sha256", record.consent->sha256},
                                            {"utc_s", record.consent->utc_s}}
                                     : Json(nullptr)},
          {"unreadable", record.damage ? Json(record.damage->sentence()) : Json(nullptr)},
          {"notes", record.notes}};
}

std::string progressWords(const ParticipantRecord& record) {
  std::string text = std::to_string(record.answers.size()) + " of " + std::to_string(record.plan.size());
  if (record.complete()) text += ", complete";
  if (record.endedEarly) text += ", ended early";
  if (!record.sessions.empty() && record.sessions.back().kind != SessionKind::real)
    text += std::string(", ") + nameOf(record.sessions.back().kind);
  return text;
}

/// Progress of all participants, as text.
Result<std::string> statusWords(const Study& study) {
  Result<std::vector<ParticipantRecord>> records = readParticipants(study);
  if (!records) return records.failure();
  const auto padded = [](std::string id) {
    constexpr std::size_t idColumns = 16;
    if (id.size() < idColumns) id.resize(idColumns, ' ');
    return "  " + id + " ";
  };
  std::string text = study.name + ": " + nameOf(study.design.kind) + ", " +
                     std::to_string(study.givenButtons()) + " buttons, " +
                     std::to_string(countedTrials(study)) + " trials for each participant\n";
  for (const ParticipantRecord& record : *records) {
    text += padded(record.participant) + (record.damage ? record.damage->sentence() : progressWords(record)) +
            "\n";
    for (const std::string& note : record.notes) text += "    " + note + "\n";
  }
  for (const std::string& missing : missingParticipants(*records)) text += "  " + missing + "\n";
  if (records->empty()) text += "  no participant yet\n";
  if (const std::size_t declined = declinedIn(study.folder); declined > 0)
    text += "  " + std::to_string(declined) + " said \"no, thank you\"\n";
  return text;
}

int printStatusJson(const Study& study) {
  Result<std::vector<ParticipantRecord>> records = readParticipants(study);
  if (!records) return fail(records.failure());
  Json list = Json::array();
  for (const ParticipantRecord& record : *records) list.push_back(jsonOf(record));
  print({{"status", "ok"},
         {"study", study.name},
         {"kind", nameOf(study.design.kind)},
         {"trials_per_participant", countedTrials(study)},
         {"declined", declinedIn(study.folder)},
         {"missing", missingParticipants(*records)},
         {"participants", list}});
  return 0;
}

/// Prints the progress again whenever it has changed.
int followStatus(const Study& study, const Cancelled& cancelled) {
  constexpr double poll_s = 0.3;
  std::string shown;
  while (!cancelled()) {
    const Result<std::string> words = statusWords(study);
    if (!words) return fail(words.failure());
    if (*words != shown) {
      std::printf("%s%s", shown.empty() ? "" : "\n", words->c_str());
      std::fflush(stdout);
      shown = *words;
    }
    sleepUntil(now_s() + poll_s);
  }
  return 0;
}

int runStatus(const ReadArguments& a, const Cancelled& cancelled) {
  Result<Study> study = openStudy(a.folder);
  if (!study) return fail(study.failure());
  if (a.follow) return followStatus(*study, cancelled);
  if (a.json) return printStatusJson(*study);
  const Result<std::string> words = statusWords(*study);
  if (!words) return fail(words.failure());
  std::fputs(words->c_str(), stdout);
  return 0;
}

Result<StudyResults> resultsIn(const Study& study) {
  Result<std::vector<ParticipantRecord>> records = readParticipants(study);
  if (!records) return records.failure();
  return resultsOf(study, *records);
}

Result<StudyResults> resultsIn(const std::string& folder) {
  if (holdsPrintedCounts(folder)) return readPrintedCounts(folder);
  Result<Study> study = openStudy(folder);
  if (!study) return study.failure();
  return resultsIn(*study);
}

/// Forecast for the study's buttons on its device, mode by mode; empty for printed counts.
Result<std::vector<ForetoldPair>> foretoldIn(const std::string& folder) {
  if (holdsPrintedCounts(folder)) return std::vector<ForetoldPair>{};
  Result<Study> study = openStudy(folder);
  if (!study) return study.failure();
  if (!asksForX(study->design.kind))
    return std::vector<ForetoldPair>{};  // no forecast for tasks that do not ask which button X is
  return foretold(*study);
}

int runReport(const ReadArguments& a) {
  Result<StudyResults> results = resultsIn(a.folder);
  if (!results) return fail(results.failure());
  if (!a.csvFile.empty()) {
    if (Result<Done> ok = writeTextFileAtomically(a.csvFile, resultsCsv(*results)); !ok)
      return fail(ok.failure());
  }
  if (!a.feltFile.empty()) {
    if (Result<Done> ok = writeTextFileAtomically(a.feltFile, feltCsv(*results)); !ok)
      return fail(ok.failure());
  }
  if (!a.bidsFolder.empty()) {
    if (Result<Done> ok = writeBids(*results, a.bidsFolder); !ok) return fail(ok.failure());
  }
  if (!a.htmlFile.empty()) {
    Result<std::vector<ForetoldPair>> expected = foretoldIn(a.folder);
    if (!expected) return fail(expected.failure());
    if (Result<Done> ok = writeTextFileAtomically(a.htmlFile, resultsPage(*results, *expected)); !ok)
      return fail(ok.failure());
  }
  const std::string text = resultsText(*results);
  std::fputs(text.c_str(), a.json ? stderr : stdout);
  if (a.json) std::printf("%s\n", resultsJson(*results).c_str());
  return 0;
}

// ---- plan

struct PlanArguments {
  std::string folder, htmlFile, listsFolder;
  std::size_t people = 12;
  std::optional<Unfinished> unfinished;  ///< empty: keeps the present rule
  bool json = false;
};

int runPlan(const PlanArguments& a) {
  const Result<Study> study = openStudy(a.folder);
  if (!study) return fail(study.failure());
  Preregistration plan{a.people, {}, powerTables(*study), {}, a.unfinished.value_or(study->unfinished)};
  if (a.unfinished)
    if (Result<Done> ok = writeUnfinishedRule(*study, *a.unfinished); !ok) return fail(ok.failure());
  if (!a.listsFolder.empty()) {
    PlannedPlaces lists = usualPlaces(a.people);
    lists.unfinished = plan.unfinished;
    Result<std::string> sha256 = writeLists(*study, lists, a.listsFolder);
    if (!sha256) return fail(sha256.failure());
    plan.listsSha256 = *std::move(sha256);
  }
  if (!a.htmlFile.empty()) {
    Result<std::vector<ForetoldPair>> expected = foretoldIn(a.folder);
    if (!expected) return fail(expected.failure());
    plan.foretold = *std::move(expected);
    if (Result<Done> ok = writeTextFileAtomically(a.htmlFile, preregistrationPage(*study, plan)); !ok)
      return fail(ok.failure());
  }
  std::string text;
  Json tables = Json::array();
  for (const FigureTable& table : plan.power) {
    text += (text.empty() ? "" : "\n") + tableText(table);
    tables.push_back(Json::parse(tableJson(table)));
  }
  std::fputs(text.c_str(), a.json ? stderr : stdout);
  if (a.json)
    print({{"status", "ok"},
           {"study", study->name},
           {"people", a.people},
           {"trials_per_participant", countedTrials(*study)},
           {"unfinished", unfinishedRules.word(plan.unfinished)},
           {"lists_sha256", plan.listsSha256.empty() ? Json(nullptr) : Json(plan.listsSha256)},
           {"power", tables}});
  return 0;
}

void addPlan(CLI::App& parent, Action& chosen) {
  CLI::App* app = parent.add_subcommand(
      "plan", "Plan a study before the first participant: power, preregistration, lists of trials");
  const auto a = std::make_shared<PlanArguments>();
  app->add_option("DIR", a->folder, "Folder of the study")->required();
  app->add_option("--people", a->people, "Planned participants, 2..999, with the ids P01, P02, ...")
      ->capture_default_str()
      ->check(numberWithin(2, 999));
  app->add_option("-o,--output", a->htmlFile,
                  "HTML page for a preregistration: hypotheses, design, power, tests, forecast");
  addChoice(*app, "--unfinished", a->unfinished, unfinishedRules,
            "Participants who have not answered all trials: left-out of the main figures, or counted; the "
            "report shows both. Kept in the study; default: left-out",
            "");
  app->add_option("--lists", a->listsFolder,
                  "Folder for one CSV of trials for each participant; the study keeps to them");
  app->add_flag("--json", a->json, "One JSON object on stdout");
  app->callback([&chosen, a] { chosen = [a](const Cancelled&) { return runPlan(*a); }; });
}

// ---- presses

struct PressesArguments {
  std::string file;
  std::optional<TimingTask> task;
  bool json = false;
};

/// Tables for a study's folder or a CSV file. Sets `task` to the task of the study; for a file without a
/// given task, to the usual one.
Result<std::vector<FigureTable>> pressesIn(const std::string& file, std::optional<TimingTask>& task) {
  std::error_code error;
  if (!std::filesystem::is_directory(file, error)) {
    if (!task) task = TimingTask::window;
    const Result<TimedPeople> presses = readTimedPresses(file, *task);
    if (!presses) return presses.failure();
    return timingTables(*presses, file);
  }
  const Result<Study> study = openStudy(file);
  if (!study) return study.failure();
  if (study->design.kind != StudyKind::timing)
    return Failure{
        FailureCode::unreadableInput, file, "",
        std::string("is a study of kind ") + nameOf(study->design.kind) + ": nobody's presses were timed",
        "Name a study of kind timing, or a CSV file"};
  if (task && *task != study->design.task)
    return Failure{
        FailureCode::wrongUsage, Subject::option("--task"), "",
        std::string(nameOf(*task)) + ": " + file + " is a study of the task " + nameOf(study->design.task),
        "Leave --task out: a study knows its own"};
  task = study->design.task;
  Result<StudyResults> results = resultsIn(*study);
  if (!results) return results.failure();
  for (const std::string& warning : results->warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  if (results->rows.empty())
    return Failure{FailureCode::unreadableInput, file, "", "holds no press yet", "Let somebody press first"};
  return std::move(results->tables);
}

int runPresses(PressesArguments a) {
  const Result<std::vector<FigureTable>> fitted = pressesIn(a.file, a.task);
  if (!fitted) return fail(fitted.failure());
  std::string text;
  Json tables = Json::array();
  for (const FigureTable& table : *fitted) {
    text += (text.empty() ? "" : "\n") + tableText(table);
    tables.push_back(Json::parse(tableJson(table)));
  }
  std::fputs(text.c_str(), a.json ? stderr : stdout);
  if (a.json) print({{"status", "ok"}, {"task", nameOf(*a.task)}, {"tables", tables}});
  return 0;
}

void addPresses(CLI::App& parent, Action& chosen) {
  CLI::App* app = parent.add_subcommand("presses", "Analyse timed presses: aim and spread, with intervals");
  const auto a = std::make_shared<PressesArguments>();
  app->add_option("PRESSES", a->file,
                  "Folder of a timing study, or a CSV file with one row for each trial: "
                  "participant,interval_s,window_s,press_s; an empty press_s: no press")
      ->required();
  addChoice(*app, "--task", a->task, timingTasks,
            "Task of a CSV file: press with a cue, within a window, or as fast as possible (tapping); a "
            "study knows its own",
            "window");
  app->add_flag("--json", a->json, "One JSON object on stdout");
  app->callback([&chosen, a] { chosen = [a](const Cancelled&) { return runPresses(*a); }; });
}

void addReading(CLI::App& parent, Action& chosen) {
  const auto a = std::make_shared<ReadArguments>();
  CLI::App* status = parent.add_subcommand("status", "Show each participant's progress");
  CLI::App* report = parent.add_subcommand("report", "Report tables, intervals and d' of the answers so far");
  for (CLI::App* app : {status, report}) {
    app->add_option("DIR", a->folder, "Folder of the study")->required();
    app->add_flag("--json", a->json, "One JSON object on stdout");
  }
  report->add_option("-o,--output", a->htmlFile, "One HTML page with the tables and pictures");
  report->add_option("--csv", a->csvFile, "One row for each trial");
  report->add_option("--felt-csv", a->feltFile,
                     "One row for each trial and stimulus: presses, force in N, travel in mm");
  report->add_option("--bids", a->bidsFolder, "Folder for BIDS events");
  status->add_flag("--follow", a->follow, "Print it again after each answer; Ctrl-C ends it");
  status->callback(
      [&chosen, a] { chosen = [a](const Cancelled& cancelled) { return runStatus(*a, cancelled); }; });
  report->callback([&chosen, a] { chosen = [a](const Cancelled&) { return runReport(*a); }; });
}

}  // namespace

void addStudyCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand("study", "Run studies with people");
  app->require_subcommand(1);
  addNew(*app, chosen);
  addPlan(*app, chosen);
  addMerge(*app, chosen);
  addRun(*app, chosen);
  addStation(*app, chosen);
  addReading(*app, chosen);
  addPresses(*app, chosen);
}

}  // namespace detent::playback
