// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/study_design.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "model/disk.h"
#include "model/file/button_file.h"
#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "model/sha256.h"
#include "model/text.h"
#include "model/version.h"
#include "playback/measurement/profile_file.h"
#include "playback/offline/press_files.h"
#include "playback/offline/render_press.h"
#include "playback/offline/standard_press.h"
#include "playback/study/statistics/shuffle.h"

namespace detent::playback {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int studyVersion = 3;  // version 1: see planTrials; before 3 every study had the feel of the paper
constexpr double stimulusRate_Hz = 48000;
constexpr const char* buttonEnding = ".button.json";

Failure wrong(Subject subject, Message problem, const Message& remedy) {
  return {FailureCode::wrongUsage, std::move(subject), "", std::move(problem), remedy};
}

/// Failure about an option; a window names its own control instead.
Failure wrongOption(const char* option, Message problem, const Message& remedy) {
  return wrong(Subject::option(option), std::move(problem), remedy);
}

Failure outside(const char* option, std::size_t value, std::size_t least, std::size_t most) {
  return wrongOption(option, Message("%1 lies outside %2 to %3", value, least, most),
                     Message("Give a number inside this range"));
}

Failure unreadable(const fs::path& file, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, file.string(), "", std::move(problem), std::move(remedies)};
}

std::string fileLabel(const std::string& file) {
  std::string name = fs::path(file).filename().string();
  if (name.ends_with(buttonEnding)) name.resize(name.size() - std::string_view(buttonEnding).size());
  return name;
}

std::string hashOf(const std::vector<float>& samples) {
  return sha256Hex({reinterpret_cast<const unsigned char*>(samples.data()), samples.size() * sizeof(float)});
}

Result<std::vector<StudyStimulus>> stimuliOf(const Study& study) {
  std::vector<StudyStimulus> stimuli;
  for (const FeedbackMode mode : study.design.modes) {
    for (std::size_t b = 0; b < study.buttons.size(); ++b) {
      Result<PreparedProgram> program = programFor(study, b, mode);
      if (!program) return program.failure();
      Result<RenderedPress> press = renderStandardPress(program->program, stimulusRate_Hz);
      if (!press) return press.failure();
      stimuli.push_back({b, mode, hashOf(press->samples)});
    }
  }
  return stimuli;
}

/// Refuses quantities that the button does not have: snap needs a jump, grain strength needs slopes.
Result<Done> checkLevelsDiffer(const Study& study) {
  const auto hashIn = [&](std::size_t button, FeedbackMode mode) {
    for (const StudyStimulus& s : study.stimuli)
      if (s.button == button && s.mode == mode) return s.sha256;
    return std::string();
  };
  for (const StudyLevel& level : study.levels)
    for (const FeedbackMode mode : study.design.modes)
      if (hashIn(level.button, mode) == hashIn(level.reference, mode))
        return wrongOption(
            "--quantity",
            Message("increasing \"%3\" makes no difference to the feel of the button \"%1\" (%2)",
                    study.buttons[level.reference].label, Message::of(nameOf(mode), {}),
                    Message::of(nameOf(study.design.quantity), {})),
            Message("Choose another quantity, mode, button or kind of feel"));
  return Done{};
}

Json jsonOf(const Study& study) {
  Json modes = Json::array(), buttons = Json::array(), stimuli = Json::array();
  for (const FeedbackMode mode : study.design.modes) modes.push_back(nameOf(mode));
  for (std::size_t i = 0; i < study.givenButtons(); ++i) {
    const StudyButton& b = study.buttons[i];
    buttons.push_back({{"label", b.label}, {"name", b.button.name()}, {"sha256", b.sha256}});
  }
  for (const StudyStimulus& s : study.stimuli)
    stimuli.push_back(
        {{"button", study.buttons[s.button].label}, {"mode", nameOf(s.mode)}, {"sha256", s.sha256}});
  const StudyDesign& d = study.design;
  Json json{{"format", "detent-study"},
            {"version", studyVersion},
            {"program", study.program},
            {"kind", nameOf(d.kind)},
            {"targets", d.targets == TargetKind::physicalButton ? "physical" : "virtual"},
            {"modes", modes},
            {"feel", feels.word(d.feel)},
            {"trials", d.trials},
            {"practice", d.practice},
            {"pairs_each", d.pairsEach},
            {"seed", d.seed},
            {"generator", generatorName},
            {"profile_sha256", study.profileSha256},
            {"buttons", buttons},
            {"stimuli", stimuli}};
  if (!d.sound.source.empty())
    json["sound"] = {{"source", d.sound.source},
                     {"sha256", d.sound.sha256},
                     {"level_dB", d.sound.level_dB},
                     {"delay_ms", d.sound.delay_ms}};
  if (d.kind == StudyKind::rating) json["scale"] = nameOf(d.scale);
  if (d.kind == StudyKind::timing) {
    json["task"] = nameOf(d.task);
    if (d.task == TimingTask::tapping)
      json["run_s"] = d.run_s;
    else
      json["intervals_s"] = d.intervals_s;
    if (d.task == TimingTask::window) json["windows_s"] = d.windows_s;
  }
  if (d.kind != StudyKind::threshold) return json;
  json["quantity"] = nameOf(d.quantity);
  Json& levels = json["levels"] = Json::array();
  for (const StudyLevel& level : study.levels)
    levels.push_back({{"button", study.buttons[level.reference].label}, {"increase", level.increase}});
  return json;
}

Result<FeedbackMode> modeNamed(const std::string& name, const std::string& file) {
  if (const auto mode = feedbackModes.value(name); mode && *mode != FeedbackMode::off) return *mode;
  return unreadable(file, Message("the file names a mode \"%1\" that does not exist", name),
                    Message("Restore the original file"));
}

/// The study in study.json, without the files of its buttons. Throws nlohmann's exceptions.
Result<Study> studyFrom(const Json& json, const std::string& file) {
  Study study;
  if (json.at("format") != "detent-study")
    return unreadable(
        file, Message("the file does not describe a study"),
        Message("Choose the folder of a study that “New study” or `detent-play study new` made"));
  study.version = json.at("version");
  if (study.version < 1 || study.version > studyVersion)
    return unreadable(file,
                      Message("the study has version %1; this program knows the versions 1 to %2",
                              study.version, studyVersion),
                      Message("Use the version of Detent that made the study"));
  if (json.at("generator") != generatorName)
    return unreadable(file,
                      Message("the order of the questions was made by another generator, %1",
                              jsonText(json.at("generator"))),
                      Message("Use the version of Detent that made the study"));
  study.program = json.at("program");
  StudyDesign& d = study.design;
  const std::string kind = json.at("kind");
  const auto known = studyKinds.value(kind);
  if (!known)
    return unreadable(file, Message("the file names a kind of study \"%1\" that does not exist", kind),
                      Message("Restore the original file"));
  d.kind = *known;
  if (d.kind == StudyKind::threshold) {
    const auto quantity = levelQuantities.value(json.at("quantity").get<std::string>());
    if (!quantity)
      return unreadable(
          file, Message("the file names a quantity %1 that does not exist", jsonText(json.at("quantity"))),
          Message("Restore the original file"));
    d.quantity = *quantity;
  }
  if (d.kind == StudyKind::rating) {
    const auto scale = ratingScales.value(json.at("scale").get<std::string>());
    if (!scale)
      return unreadable(
          file, Message("the file names a rating scale %1 that does not exist", jsonText(json.at("scale"))),
          Message("Restore the original file"));
    d.scale = *scale;
  }
  if (d.kind == StudyKind::timing) {
    const auto task = timingTasks.value(json.at("task").get<std::string>());
    if (!task)
      return unreadable(file,
                        Message("the file names a task %1 that does not exist", jsonText(json.at("task"))),
                        Message("Restore the original file"));
    d.task = *task;
    if (d.task == TimingTask::tapping)
      d.run_s = json.at("run_s");
    else
      d.intervals_s = json.at("intervals_s").get<std::vector<double>>();
    if (d.task == TimingTask::window) d.windows_s = json.at("windows_s").get<std::vector<double>>();
  }
  d.feel = Feel::paper;
  if (study.version > 2) {
    const auto feel = feels.value(json.at("feel").get<std::string>());
    if (!feel)
      return unreadable(
          file, Message("the file names a kind of feel %1 that does not exist", jsonText(json.at("feel"))),
          Message("Restore the original file"));
    d.feel = *feel;
  }
  if (json.contains("sound")) {
    const Json& sound = json.at("sound");
    d.sound = {sound.at("source"), sound.at("sha256"), sound.at("level_dB"), sound.at("delay_ms")};
  }
  d.targets = json.at("targets") == "physical" ? TargetKind::physicalButton : TargetKind::virtualButton;
  d.modes.clear();
  for (const Json& name : json.at("modes")) {
    Result<FeedbackMode> mode = modeNamed(name, file);
    if (!mode) return mode.failure();
    d.modes.push_back(*mode);
  }
  d.trials = json.at("trials");
  d.practice = json.at("practice");
  d.pairsEach = json.at("pairs_each");
  d.seed = json.at("seed");
  study.profileSha256 = json.at("profile_sha256");
  return study;
}

/// Recreates the levels of a threshold study from its buttons.
Result<Done> readLevels(Study& study, const Json& json) {
  if (study.design.kind != StudyKind::threshold) return Done{};
  const std::size_t given = study.buttons.size();
  for (const Json& entry : json.at("levels")) {
    const std::string label = entry.at("button");
    std::size_t reference = 0;
    while (reference < given && study.buttons[reference].label != label) ++reference;
    if (reference == given)
      return unreadable(study.folder / "study.json",
                        Message("the file has versions of the button \"%1\" with more of the varied "
                                "quantity, but this button is not in the study",
                                label),
                        Message("Restore the original file"));
    if (Result<Done> ok = addLevel(study, reference, entry.at("increase")); !ok) return ok;
  }
  for (std::size_t reference = 0; reference < given; ++reference)
    if (increasesOf(study, reference).size() < 2)
      return unreadable(
          study.folder / "study.json",
          Message(
              "the file has fewer than two versions of the button \"%1\" with more of the varied quantity",
              study.buttons[reference].label),
          Message("Restore the original file"));
  return Done{};
}

/// Reads the study's files and compares them with study.json.
Result<Done> readParts(Study& study, const Json& json) {
  for (const Json& entry : json.at("buttons")) {
    const std::string label = entry.at("label");
    const std::string file = (study.folder / "buttons" / (label + buttonEnding)).string();
    Result<std::string> text = readTextFile(file);
    if (!text) return text.failure();
    const std::string hash = sha256Hex(*text);
    if (entry.at("sha256") != hash)
      return unreadable(file, Message("the file was changed after the study was made"),
                        Message("Restore the file, or make a new study with the changed button"));
    Result<Button> button = buttonFromJson(*text, file);
    if (!button) return button.failure();
    study.buttons.push_back({label, hash, *std::move(button)});
  }
  if (!study.profileSha256.empty()) {
    const fs::path file = study.folder / "device.device";
    Result<std::string> text = readTextFile(file.string());
    if (!text) return text.failure();
    if (sha256Hex(*text) != study.profileSha256)
      return unreadable(file, Message("the file was changed after the study was made"),
                        Message("Restore the file, or make a new study"));
    Result<DeviceProfile> profile = parseDeviceProfile(*text, file.string());
    if (!profile) return profile.failure();
    study.profile = *std::move(profile);
  }
  if (study.design.sound.source != renderedSound && !study.design.sound.source.empty()) {
    const fs::path file = study.folder / fs::path(study.design.sound.source).filename();
    const Result<std::string> bytes = readTextFile(file.string());
    if (!bytes) return bytes.failure();
    if (sha256Hex(*bytes) != study.design.sound.sha256)
      return unreadable(file, Message("the file was changed after the study was made"),
                        Message("Restore the file, or make a new study"));
  }
  if (Result<Done> ok = readLevels(study, json); !ok) return ok;
  for (const Json& entry : json.at("stimuli")) {
    const std::string label = entry.at("button");
    const auto at = std::find_if(study.buttons.begin(), study.buttons.end(),
                                 [&](const StudyButton& b) { return b.label == label; });
    Result<FeedbackMode> mode = modeNamed(entry.at("mode"), (study.folder / "study.json").string());
    if (!mode) return mode.failure();
    if (at == study.buttons.end())
      return unreadable(study.folder / "study.json",
                        Message("the file names a button \"%1\" that is not in the study", label),
                        Message("Restore the original file"));
    study.stimuli.push_back(
        {static_cast<std::size_t>(at - study.buttons.begin()), *mode, entry.at("sha256")});
  }
  for (const FeedbackMode mode : study.design.modes) {
    for (std::size_t b = 0; b < study.buttons.size(); ++b) {
      if (std::none_of(study.stimuli.begin(), study.stimuli.end(),
                       [&](const StudyStimulus& s) { return s.button == b && s.mode == mode; }))
        return unreadable(study.folder / "study.json",
                          Message("the file does not record how the button \"%1\" feels in the mode %2",
                                  study.buttons[b].label, Message::of(nameOf(mode), {})),
                          Message("Restore the original file"));
    }
  }
  return Done{};
}

Result<Done> readButtons(Study& study, const std::vector<std::string>& files) {
  std::set<std::string> labels;
  for (const std::string& file : files) {
    Result<std::string> text = readTextFile(file);
    if (!text) return text.failure();
    Result<Button> button = buttonFromJson(*text, file);
    if (!button) return button.failure();
    const std::string label = fileLabel(file);
    if (!isUtf8(label))  // the label is stored in study.json, and names the study's copy of the file
      return wrong(file, Message("the name of the file is not encoded as UTF-8"), Message("Rename the file"));
    if (!labels.insert(label).second)
      return wrong(file, Message("two of the button files have the name \"%1\"", label),
                   Message("Rename one of the files"));
    study.buttons.push_back({label, sha256Hex(*text), *std::move(button)});
  }
  return Done{};
}

Result<Done> writeParts(const fs::path& folder, const Study& study, const std::vector<std::string>& files,
                        const std::string& profileFile, const std::string& soundFile) {
  std::error_code error;
  fs::create_directories(folder / "buttons", error);
  if (!error) fs::create_directory(folder / "participants", error);
  const auto copy = [&](const std::string& file, const fs::path& to) {
    if (!error && fs::copy_file(file, to, error)) error = writeToDisk(to);
  };
  for (std::size_t i = 0; i < files.size(); ++i)
    copy(files[i], folder / "buttons" / (study.buttons[i].label + buttonEnding));
  if (!profileFile.empty()) copy(profileFile, folder / "device.device");
  if (!soundFile.empty()) copy(soundFile, folder / study.design.sound.source);
  if (error)
    return unreadable(folder, Message("the folder cannot be created (%1)", error.message()),
                      Message("Check the folder, its permissions and the free space"));
  if (Result<Done> ok = writeConsents(folder, study.design.consents); !ok) return ok;
  return writeTextFileAtomically((folder / "study.json").string(), jsonText(jsonOf(study), 2) + "\n");
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t buttons) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t second = 1; second < buttons; ++second)
    for (std::size_t first = 0; first < second; ++first) pairs.emplace_back(first, second);
  return pairs;
}

Result<Done> checkParticipantId(const std::string& id) {
  constexpr std::size_t longest = 32;
  const bool plain = std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
  if (plain && !id.empty() && id.size() <= longest && id.front() != '-') return Done{};
  return wrongOption(
      "--participant", Message("\"%1\" is not a participant's id", id),
      Message("Give 1 to %1 letters, digits, - or _, such as P01, but no name of a person", longest));
}

std::string spokenId(const std::string& id) {
  std::string spoken;
  for (const char c : id) {
    if (c == '-' || c == '_') continue;
    const bool number = !spoken.empty() && spoken.back() >= '0' && spoken.back() <= '9';
    if (c == '0' && !number) continue;  // skips leading zeros of a number
    spoken += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return spoken;
}

bool asksForPairs(const StudyDesign& d) {
  return d.kind == StudyKind::abx || d.kind == StudyKind::sameDifferent ||
         (d.kind == StudyKind::rating && d.scale == RatingScale::pairwise);
}

std::size_t usualTrials(StudyKind kind, TimingTask task) {
  switch (kind) {
    case StudyKind::abx:
    case StudyKind::matching:
      break;
    case StudyKind::sameDifferent:
      return 20;  // half of the trials have the same button twice
    case StudyKind::threshold:
      return 60;
    case StudyKind::rating:
      return 4;
    case StudyKind::timing:
      return task == TimingTask::tapping ? 3 : 60;
  }
  return 10;
}

namespace {

/// Returns true if all values are within a range, different, and not too many.
bool eachOnceWithin(const std::vector<double>& values, double low, double high) {
  return !values.empty() && values.size() <= mostTimes &&
         std::set<double>(values.begin(), values.end()).size() == values.size() &&
         std::all_of(values.begin(), values.end(), [&](double v) { return v >= low && v <= high; });
}

Result<Done> checkTimes(const StudyDesign& d) {
  if (d.task == TimingTask::tapping) {
    if (d.run_s >= shortestRun_s && d.run_s <= longestRun_s) return Done{};
    return wrongOption("--run-seconds",
                       Message("%1 lies outside %2 to %3", d.run_s, shortestRun_s, longestRun_s),
                       Message("Give a number inside this range"));
  }
  if (!eachOnceWithin(d.intervals_s, leastInterval_s, mostInterval_s))
    return wrongOption(
        "--intervals",
        Message("the list of times is empty or too long, repeats a time, or has a time outside %1 to %2 s",
                leastInterval_s, mostInterval_s),
        Message("Give a list of 1 to %1 times that all differ", mostTimes));
  if (d.task == TimingTask::cue) return Done{};
  const double least = *std::min_element(d.intervals_s.begin(), d.intervals_s.end());
  if (eachOnceWithin(d.windows_s, leastWindow_s, mostWindow_s) &&
      *std::max_element(d.windows_s.begin(), d.windows_s.end()) < least)
    return Done{};
  return wrongOption(
      "--windows",
      Message("the list of times is empty or too long, repeats a time, or has a time that is "
              "outside %1 to %2 s or as long as an interval",
              leastWindow_s, mostWindow_s),
      Message("Give a list of 1 to %1 times that are all shorter than the shortest interval", mostTimes));
}

}  // namespace

Result<Done> checkDesign(const StudyDesign& d, std::size_t buttons) {
  const bool oneWillDo = d.kind == StudyKind::threshold || d.kind == StudyKind::timing ||
                         (d.kind == StudyKind::rating && d.scale != RatingScale::pairwise);
  if (buttons == 0 && oneWillDo)
    return wrong("study", Message("the study has no button"), Message("Give at least one button"));
  if (buttons == 0 || (buttons == 1 && !oneWillDo))
    return wrong("study",
                 buttons == 1 ? Message("the study has only 1 button") : Message("the study has no button"),
                 Message("Give at least two buttons"));
  if (buttons > mostButtons)
    return wrong("study", Message("the study has %1 buttons", buttons),
                 Message("Give at most %1", mostButtons));
  if (d.trials < 1 || d.trials > mostTrials) return outside("--trials", d.trials, 1, mostTrials);
  if (d.practice > mostPractice) return outside("--practice", d.practice, 0, mostPractice);
  const std::size_t pairs = buttons * (buttons - 1) / 2;
  if (d.pairsEach > 0 && !asksForPairs(d))
    return wrongOption("--pairs-each", Message("this option cannot be used in a study without pairs"),
                       Message("Leave this option out"));
  if (d.pairsEach > pairs)
    return wrongOption("--pairs-each",
                       Message("%1 pairs are requested, but there are only %2", d.pairsEach, pairs),
                       Message("Give fewer pairs, or 0 for all pairs"));
  if (d.modes.empty() || std::set<FeedbackMode>(d.modes.begin(), d.modes.end()).size() != d.modes.size())
    return wrongOption("--modes", Message("no mode is given, or one mode is given twice"),
                       Message("Choose at least one mode, each only once"));
  if (std::find(d.modes.begin(), d.modes.end(), FeedbackMode::off) != d.modes.end())
    return wrongOption("--modes", Message("the mode \"off\" plays nothing that participants could feel"),
                       Message("Give full, click-only or slope-only"));
  if (d.targets == TargetKind::physicalButton && d.kind != StudyKind::matching)
    return wrongOption("--physical", Message("this option needs a matching study"),
                       Message("Add --kind matching"));
  if (!(d.sound.level_dB >= softestSound_dB && d.sound.level_dB <= loudestSound_dB))
    return wrongOption(
        "--sound-level",
        Message("%1 lies outside %2 to %3", d.sound.level_dB, softestSound_dB, loudestSound_dB),
        Message("Give a number inside this range"));
  if (!(d.sound.delay_ms >= 0 && d.sound.delay_ms <= longestSoundDelay_ms))
    return wrongOption("--sound-delay",
                       Message("%1 lies outside %2 to %3", d.sound.delay_ms, 0, longestSoundDelay_ms),
                       Message("Give a number inside this range"));
  return d.kind == StudyKind::timing ? checkTimes(d) : Result<Done>(Done{});
}

Result<PressSound> pressSoundOf(const Study& study) {
  constexpr double longestSound_s = 5;
  const StudySound& settings = study.design.sound;
  PressSound sound;
  sound.rendered = settings.source == renderedSound;
  sound.level_dB = settings.level_dB;
  sound.delay_s = settings.delay_ms / 1000;
  if (sound.rendered || settings.source.empty()) return sound;
  Result<SoundSamples> samples = readSoundFile(study.folder / settings.source, longestSound_s);
  if (!samples) return samples.failure();
  sound.samples = std::move(samples->samples);
  sound.sampleRate_Hz = samples->sampleRate_Hz;
  return sound;
}

PlaybackSettings settingsFor(const Study& study, std::size_t button, FeedbackMode mode) {
  PlaybackSettings settings;
  settings.mode = mode;
  settings.feel = study.design.feel;
  if (study.design.kind != StudyKind::threshold) return settings;
  const StudyLevel* level = levelOf(study, button);
  return raised(settings, study.design.quantity, level != nullptr ? level->increase : 0);
}

Result<PreparedProgram> programFor(const Study& study, std::size_t button, FeedbackMode mode) {
  return prepareProgram(study.buttons[button].button, study.profile.value_or(DeviceProfile{}),
                        settingsFor(study, button, mode));
}

Result<Study> createStudy(const fs::path& folder, const std::vector<std::string>& buttonFiles,
                          const std::string& profileFile, const StudyDesign& design) {
  std::error_code error;
  if (fs::exists(folder, error))
    return wrong(folder.string(), Message("the folder exists already"),
                 Message("Name a new folder; a study is never overwritten"));
  if (Result<Done> ok = checkDesign(design, buttonFiles.size()); !ok) return ok.failure();
  Study study;
  study.folder = folder;
  study.program = version();
  study.version = studyVersion;
  study.design = design;
  if (Result<Done> ok = readButtons(study, buttonFiles); !ok) return ok.failure();
  if (!profileFile.empty()) {
    Result<std::string> text = readTextFile(profileFile);
    if (!text) return text.failure();
    Result<DeviceProfile> profile = parseDeviceProfile(*text, profileFile);
    if (!profile) return profile.failure();
    study.profile = *std::move(profile);
    study.profileSha256 = sha256Hex(*text);
  }
  std::string soundFile;
  if (!design.sound.source.empty() && design.sound.source != renderedSound) {
    soundFile = design.sound.source;
    study.folder = fs::path();
    if (const Result<PressSound> sound = pressSoundOf(study); !sound) return sound.failure();
    study.folder = folder;
    const Result<std::string> bytes = readTextFile(soundFile);
    if (!bytes) return bytes.failure();
    study.design.sound.source = "sound" + fs::path(soundFile).extension().string();
    study.design.sound.sha256 = sha256Hex(*bytes);
  }
  if (design.kind == StudyKind::threshold)
    if (Result<Done> ok = addUsualLevels(study); !ok) return ok.failure();
  Result<std::vector<StudyStimulus>> stimuli = stimuliOf(study);
  if (!stimuli) return stimuli.failure();
  study.stimuli = *std::move(stimuli);
  if (Result<Done> ok = checkLevelsDiffer(study); !ok) return ok.failure();
  fs::path draft = folder;
  draft += ".part";
  fs::remove_all(draft, error);
  Result<Done> written = writeParts(draft, study, buttonFiles, profileFile, soundFile);
  if (written) {
    fs::rename(draft, folder, error);
    if (!error) {
      writeFolderToDisk(folder);
      return openStudy(folder);
    }
    written = unreadable(folder, Message("the folder cannot be created (%1)", error.message()),
                         Message("Check the folder in which it should be created"));
  }
  fs::remove_all(draft, error);
  return written.failure();
}

Result<Study> openStudy(const fs::path& folder) {
  const std::string file = (folder / "study.json").string();
  Result<std::string> text = readTextFile(file);
  if (!text)
    return unreadable(
        folder,
        Message("the folder is not a study: its study.json cannot be read (%1)", text.failure().problem),
        Message("Choose the folder of a study, or make a new study (in the window: Button > Study with "
                "people; on the command line: `detent-play study new`)"));
  try {
    const Json json = Json::parse(*text);
    if (json.at("format") == "detent-merged-study") {
      if (json.at("version") != 1 || json.at("sites").empty())
        return unreadable(file, Message("the file names no sites that this program knows"),
                          Message("Use the version of Detent that made the study"));
      Result<Study> merged = openSites(json.at("sites").get<std::vector<std::string>>(), folder);
      if (merged) merged->sha256 = sha256Hex(*text);
      return merged;
    }
    Result<Study> study = studyFrom(json, file);
    if (!study) return study;
    study->folder = folder;
    study->name = fs::weakly_canonical(folder).filename().string();
    study->sha256 = sha256Hex(*text);
    if (Result<Done> ok = readParts(*study, json); !ok) return ok.failure();
    if (Result<Done> ok = checkDesign(study->design, study->givenButtons()); !ok)
      return unreadable(file, Message("%1: %2", ok.failure().subject.name, ok.failure().problem),
                        Message("Restore the original file"));
    const Result<PlannedPlaces> plan = placesOf(folder);
    if (!plan) return plan.failure();
    study->unfinished = plan->unfinished;
    return study;
  } catch (const Json::exception&) {
    return unreadable(file, Message("the content is broken"), Message("Restore the file from a copy"));
  }
}

Result<Done> checkStimuli(const Study& study) {
  Result<std::vector<StudyStimulus>> now = stimuliOf(study);
  if (!now) return now.failure();
  for (const StudyStimulus& made : study.stimuli) {
    const auto same = std::find_if(now->begin(), now->end(), [&](const StudyStimulus& s) {
      return s.button == made.button && s.mode == made.mode;
    });
    if (same != now->end() && same->sha256 == made.sha256) continue;
    return unreadable(
        study.folder,
        Message("button \"%1\" (%2) would feel different in this program (%3) than in the one that "
                "made the study (%4)",
                study.buttons[made.button].label, Message::of(nameOf(made.mode), {}), version(),
                study.program),
        Message("Go on with that program, or begin a new study"));
  }
  return Done{};
}

}  // namespace detent::playback
