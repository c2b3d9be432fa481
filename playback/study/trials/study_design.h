// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study with people: its buttons, task and number of trials. One study is one folder that can be copied:
// study.json, buttons/, device.device (optional), consent.txt and consent.LANGUAGE.txt (consent.h),
// participants/ID.jsonl.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/named_values.h"
#include "model/result.h"
#include "playback/prepare/device_profile.h"
#include "playback/prepare/playback_settings.h"
#include "playback/prepare/prepare_program.h"
#include "playback/realtime/press_sound.h"
#include "playback/study/statistics/press_timing.h"
#include "playback/study/trials/consent.h"
#include "playback/study/trials/planned_places.h"

namespace detent::playback {

enum class StudyKind : std::uint8_t {
  abx,            ///< K&L, Experiment 1: which of two is X?
  sameDifferent,  ///< are these two the same button or two?
  matching,       ///< K&L, Experiment 2: which of all is X?
  threshold,      ///< which of two has more of a quantity? The differences follow the answers (QUEST+)
  rating,         ///< how good is it, how strong is it, which of two is preferred?
  timing          ///< press with a cue, within a window, as fast as can be kept up: when counts, not which
};
inline constexpr auto studyKinds = named<StudyKind>({{"abx", StudyKind::abx},
                                                     {"same-different", StudyKind::sameDifferent},
                                                     {"matching", StudyKind::matching},
                                                     {"threshold", StudyKind::threshold},
                                                     {"rating", StudyKind::rating},
                                                     {"timing", StudyKind::timing}});
inline const char* nameOf(StudyKind kind) { return studyKinds.word(kind); }
/// Returns true if an answer says which one X is.
inline bool asksForX(StudyKind kind) { return kind == StudyKind::abx || kind == StudyKind::matching; }
/// Returns true if an answer is right or wrong.
inline bool hasRightAnswer(StudyKind kind) { return kind != StudyKind::rating && kind != StudyKind::timing; }

/// The quantity that increases; threshold.
enum class LevelQuantity : std::uint8_t {
  peakForce,     ///< all forces of the button
  eventSize,     ///< strength of the vibration at its jumps
  travel,        ///< the whole travel
  snap,          ///< snap ratio of every jump of the press
  grainStrength  ///< strength of the vibration along its slopes
};
inline constexpr auto levelQuantities =
    named<LevelQuantity>({{"peak-force", LevelQuantity::peakForce},
                          {"event-size", LevelQuantity::eventSize},
                          {"travel", LevelQuantity::travel},
                          {"snap", LevelQuantity::snap},
                          {"grain-strength", LevelQuantity::grainStrength}});
inline const char* nameOf(LevelQuantity quantity) { return levelQuantities.word(quantity); }

/// Scale of a rating.
enum class RatingScale : std::uint8_t {
  preference,  ///< 1 (worst) to 7 (best), one button at a time
  magnitude,   ///< any number above 0, twice as strong is twice the number (Stevens), one button at a time
  pairwise     ///< which of two is preferred?
};
inline constexpr auto ratingScales = named<RatingScale>({{"preference", RatingScale::preference},
                                                         {"magnitude", RatingScale::magnitude},
                                                         {"pairwise", RatingScale::pairwise}});
inline const char* nameOf(RatingScale scale) { return ratingScales.word(scale); }
inline constexpr double worstPreference = 1, bestPreference = 7, greatestMagnitude = 1e6;

/// Kind of X. Physical: the experimenter hands over the real switch of that number.
enum class TargetKind : std::uint8_t { virtualButton, physicalButton };

/// What is heard of each press, on a channel of its own (press_sound.h).
struct StudySound {
  std::string source;  ///< "rendered", a sound file (of a study: in its folder); empty: nothing
  std::string sha256;  ///< of the file
  double level_dB = 0, delay_ms = 0;
};
inline constexpr double softestSound_dB = -60, loudestSound_dB = 20, longestSoundDelay_ms = 500;
inline constexpr const char* renderedSound = "rendered";

/// Limits of a design; checkDesign().
inline constexpr std::size_t mostTrials = 1000, mostPractice = 100, mostButtons = 64;
inline constexpr std::size_t mostTimes = 9;  ///< intervals, windows: each once
inline constexpr double leastInterval_s = 0.2, mostInterval_s = 5, leastWindow_s = 0.01, mostWindow_s = 1;
inline constexpr double shortestRun_s = 3, longestRun_s = 120;

/// Settings of a study; `study new`.
struct StudyDesign {
  StudyKind kind = StudyKind::abx;
  TargetKind targets = TargetKind::virtualButton;       ///< physical: matching only
  std::vector<FeedbackMode> modes{FeedbackMode::full};  ///< each pair (or button) is tried in each; not off
  Feel feel = usualSettings().feel;                     ///< what everything else plays, or the paper's
  LevelQuantity quantity = LevelQuantity::peakForce;    ///< threshold
  RatingScale scale = RatingScale::preference;          ///< rating
  TimingTask task = TimingTask::cue;                    ///< timing
  std::vector<double> intervals_s{0.6, 0.8, 1.0};       ///< cue, window: each as often
  std::vector<double> windows_s{0.08, 0.12, 0.16};      ///< window: likewise; each below the least interval
  double run_s = 10;                                    ///< tapping: from the first press on
  std::size_t trials = 10;   ///< per pair (abx, pairwise) or button (else), and mode; of tapping: runs; not 0
  std::size_t practice = 0;  ///< trials before the first that counts
  std::size_t pairsEach = 0;  ///< a random subset of so many pairs for each participant; 0: all
  std::uint64_t seed = 0;
  StudySound sound{};
  std::vector<ConsentText>
      consents;  ///< one for each language; empty: a short standard text in English and in German
};

/// Trials a kind, and of timing a task, usually needs. Threshold: docs/guide/studies.md has what they come
/// to.
std::size_t usualTrials(StudyKind kind, TimingTask task = TimingTask::cue);

/// One button of a study.
struct StudyButton {
  std::string label;   ///< file name without .button.json; unique in the study
  std::string sha256;  ///< of its file
  Button button;
};

/// A participant's stimulus: button and mode, as sound. SHA-256 over the standard press: it changes when the
/// button, a setting, the device profile or the engine would make it feel different.
struct StudyStimulus {
  std::size_t button = 0;
  FeedbackMode mode = FeedbackMode::full;
  std::string sha256;
};

/// A button with more of the study's quantity; threshold. Made of the button each time a study is opened.
struct StudyLevel {
  std::size_t button = 0;     ///< what is felt
  std::size_t reference = 0;  ///< the button it has more than
  double increase = 0;        ///< share of the reference's: 0.1 is a tenth more
};

/// A study as it stands in its folder. Plain value, any thread.
struct Study {
  std::filesystem::path folder;
  std::string name;     ///< the folder's
  std::string sha256;   ///< of study.json
  std::string program;  ///< version that made it
  int version = 0;      ///< of study.json; how lists of trials are made hangs on it
  StudyDesign design;
  std::vector<StudyButton> buttons;  ///< those it was made of, then one for each level
  std::vector<StudyLevel> levels;    ///< threshold: by reference, rising
  std::optional<DeviceProfile> profile;
  std::string profileSha256;  ///< empty without a profile
  std::vector<StudyStimulus> stimuli;
  Unfinished unfinished = Unfinished::leftOut;  ///< as planned
  std::vector<std::string> sites;               ///< of a merged study (below); else empty

  /// Buttons it was made of.
  std::size_t givenButtons() const { return buttons.size() - levels.size(); }
};

/// Unordered pairs in the order A-B, A-C, B-C, ... of the paper's Table 2: by the second, then the first.
std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t buttons);

/// A participant's id: 1 to 32 of a-z A-Z 0-9 - _, so that it names a file and no person.
Result<Done> checkParticipantId(const std::string& id);
/// An id as it is read out: P-1, P_1, p1 and P01 are one person.
std::string spokenId(const std::string& id);

/// Returns true if trials compare two buttons at a time, as pairsOf() lists them.
bool asksForPairs(const StudyDesign& design);

/// Range checks of a design for so many buttons. Failure wrongUsage: its subject is the option of
/// `study new`, or the study.
Result<Done> checkDesign(const StudyDesign& design, std::size_t buttons);

/// Makes the folder, whole or not at all. `buttonFiles`: at least two (threshold, scales and timing:
/// one), labels unique.
/// `profileFile` may be empty. Failure wrongUsage: the folder exists, or a value is outside its range.
Result<Study> createStudy(const std::filesystem::path& folder, const std::vector<std::string>& buttonFiles,
                          const std::string& profileFile, const StudyDesign& design);

/// Opens a study and proves that its buttons and profile are the ones it was made of. Failure
/// unreadableInput: no study, another version's, or a button missing or changed.
Result<Study> openStudy(const std::filesystem::path& folder);

/// Checks that this program would make the stimuli feel as the one that made them. Failure unreadableInput
/// names the button and mode. For running, not for reading results.
Result<Done> checkStimuli(const Study& study);

/// The sound of presses, read from the study's folder. Failure: as readSoundFile.
Result<PressSound> pressSoundOf(const Study& study);

/// Settings of a button in a mode, and its program.
PlaybackSettings settingsFor(const Study& study, std::size_t button, FeedbackMode mode);
Result<PreparedProgram> programFor(const Study& study, std::size_t button, FeedbackMode mode);

// ---- one study that several laboratories ran (merged_study.cpp): a folder with a whole study of each below
// sites/NAME, and a study.json that names them. Its participants are called NAME-ID.

/// Copies studies into `folder`, whole or not at all. `sites`: one name for each, as of a participant; empty:
/// the names of the folders. Failure wrongUsage: they differ in task or feel, in their rule for the
/// unfinished, or two sites have one name.
Result<Study> mergeStudies(const std::vector<std::filesystem::path>& studies, std::vector<std::string> sites,
                           const std::filesystem::path& folder);
/// Opens the study of these sites; not empty. Failures: those of openStudy, for each site, and of
/// mergeStudies.
Result<Study> openSites(const std::vector<std::string>& sites, const std::filesystem::path& folder);
/// The folder of one site's study.
std::filesystem::path siteFolder(const std::filesystem::path& folder, const std::string& site);

// ---- levels of a threshold study: buttons with more of one quantity than the one they are compared with
// (study_levels.cpp)

/// The settings with the quantity increased; those of quantities of the button itself stay. Jumps whose size
/// is tested play at half their strength, so that there is room for more. `increase` >= 0; 0: the reference.
PlaybackSettings raised(PlaybackSettings settings, LevelQuantity quantity, double increase);

/// Puts a level behind the study's buttons. `reference`: one of the given buttons; `increase` > 0. Failure:
/// as the edit.
Result<Done> addLevel(Study& study, std::size_t reference, double increase);

/// A hundredth to the double, twelve a decade, as far as the button can be changed and the vibration is not
/// at full scale. Failure wrongUsage names a button that has too few such levels.
Result<Done> addUsualLevels(Study& study);

/// Increases of a button, rising.
std::vector<double> increasesOf(const Study& study, std::size_t reference);
/// The level a button is; null: a button the study was made of.
const StudyLevel* levelOf(const Study& study, std::size_t button);

}  // namespace detent::playback
