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
  sameDifferent,  ///< are these two the same button, or different ones?
  matching,       ///< K&L, Experiment 2: which of all is X?
  threshold,      ///< which of two has more of a quantity? The differences adapt to the answers (QUEST+)
  rating,         ///< how good is it, how strong is it, or which of two is preferred?
  /// press with a cue, within a window, or as fast as one can sustain: about timing, not about choices
  timing
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

/// The quantity that increases in a threshold study.
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
  /// any number above 0, where twice as strong is twice the number (Stevens), one button at a time
  magnitude,
  pairwise  ///< which of two is preferred?
};
inline constexpr auto ratingScales = named<RatingScale>({{"preference", RatingScale::preference},
                                                         {"magnitude", RatingScale::magnitude},
                                                         {"pairwise", RatingScale::pairwise}});
inline const char* nameOf(RatingScale scale) { return ratingScales.word(scale); }
inline constexpr double worstPreference = 1, bestPreference = 7, greatestMagnitude = 1e6;

/// Kind of X. Physical: the experimenter hands over the real switch with that number.
enum class TargetKind : std::uint8_t { virtualButton, physicalButton };

/// The sound that accompanies each press, on an audio channel of its own (press_sound.h).
struct StudySound {
  std::string source;  ///< "rendered", or a sound file (in the study's folder); empty: no sound
  std::string sha256;  ///< hash of the sound file
  double level_dB = 0, delay_ms = 0;
};
inline constexpr double softestSound_dB = -60, loudestSound_dB = 20, longestSoundDelay_ms = 500;
inline constexpr const char* renderedSound = "rendered";

/// Limits of a design, which checkDesign() checks.
inline constexpr std::size_t mostTrials = 1000, mostPractice = 100, mostButtons = 64;
inline constexpr std::size_t mostTimes = 9;  ///< number of intervals, and of windows, each different
inline constexpr double leastInterval_s = 0.2, mostInterval_s = 5, leastWindow_s = 0.01, mostWindow_s = 1;
inline constexpr double shortestRun_s = 3, longestRun_s = 120;

/// Settings of a study, as given to `study new`.
struct StudyDesign {
  StudyKind kind = StudyKind::abx;
  TargetKind targets = TargetKind::virtualButton;       ///< physical: matching only
  std::vector<FeedbackMode> modes{FeedbackMode::full};  ///< each pair (or button) is tried in each; not off
  /// default: the feel that programs have outside of studies; or that of the paper
  Feel feel = usualSettings().feel;
  LevelQuantity quantity = LevelQuantity::peakForce;  ///< threshold
  RatingScale scale = RatingScale::preference;        ///< rating
  TimingTask task = TimingTask::cue;                  ///< timing
  std::vector<double> intervals_s{0.6, 0.8, 1.0};     ///< cue, window: each is used equally often
  /// window: each is used equally often; each below the least interval
  std::vector<double> windows_s{0.08, 0.12, 0.16};
  double run_s = 10;  ///< tapping: duration from the first press on
  /// per pair (abx, pairwise) or button (others), and mode; for tapping: runs; not 0
  std::size_t trials = 10;
  std::size_t practice = 0;   ///< trials before the first that counts
  std::size_t pairsEach = 0;  ///< a random subset of this many pairs for each participant; 0: all
  std::uint64_t seed = 0;
  StudySound sound{};
  std::vector<ConsentText>
      consents;  ///< one for each language; empty: a short standard text in English and in German
};

/// Usual number of trials for a kind and, for timing, a task. docs/guide/studies.md explains those of
/// thresholds.
std::size_t usualTrials(StudyKind kind, TimingTask task = TimingTask::cue);

/// One button of a study.
struct StudyButton {
  std::string label;   ///< file name without .button.json; unique in the study
  std::string sha256;  ///< SHA-256 of the button's file
  Button button;
};

/// A participant's stimulus: button and mode, as sound. SHA-256 over the standard press: it changes when the
/// button, a setting, the device profile or the engine would change how it feels.
struct StudyStimulus {
  std::size_t button = 0;
  FeedbackMode mode = FeedbackMode::full;
  std::string sha256;
};

/// A button with more of the study's quantity, in a threshold study. Derived from the button each time a
/// study is opened.
struct StudyLevel {
  std::size_t button = 0;     ///< the changed button
  std::size_t reference = 0;  ///< the button it is compared with
  double increase = 0;        ///< relative to the reference: 0.1 is a tenth more
};

/// A study as stored in its folder. Plain value, any thread.
struct Study {
  std::filesystem::path folder;
  std::string name;     ///< name of the folder
  std::string sha256;   ///< hash of study.json
  std::string program;  ///< version that made it
  int version = 0;      ///< version of study.json's format; lists of trials depend on it
  StudyDesign design;
  std::vector<StudyButton> buttons;  ///< the given buttons, followed by one for each level
  std::vector<StudyLevel> levels;    ///< threshold: by reference, increasing
  std::optional<DeviceProfile> profile;
  std::string profileSha256;  ///< empty without a profile
  std::vector<StudyStimulus> stimuli;
  Unfinished unfinished = Unfinished::leftOut;  ///< as planned
  std::vector<std::string> sites;               ///< names of a merged study's sites (below); else empty

  /// Number of buttons with which the study was made.
  std::size_t givenButtons() const { return buttons.size() - levels.size(); }
};

/// Unordered pairs in the order A-B, A-C, B-C, ... of the paper's Table 2: by the second, then the first.
std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t buttons);

/// Checks a participant's id: 1 to 32 of a-z A-Z 0-9 - _, so that it can be a file name and identifies no
/// person.
Result<Done> checkParticipantId(const std::string& id);
/// An id as it is spoken: P-1, P_1, p1 and P01 are one person.
std::string spokenId(const std::string& id);

/// Returns true if trials compare two buttons at a time, as pairsOf() lists them.
bool asksForPairs(const StudyDesign& design);

/// Range checks of a design for this many buttons. Failure wrongUsage: about the option of `study new`, or
/// about the study.
Result<Done> checkDesign(const StudyDesign& design, std::size_t buttons);

/// Creates the folder, completely or not at all. `buttonFiles`: at least two (threshold, scales and timing:
/// one), with different labels. `profileFile` may be empty. Failure wrongUsage: the folder exists, or a value
/// is outside its range.
Result<Study> createStudy(const std::filesystem::path& folder, const std::vector<std::string>& buttonFiles,
                          const std::string& profileFile, const StudyDesign& design);

/// Opens a study and verifies that its buttons and profile are unchanged. Failure unreadableInput: no study,
/// one of another version, or a button missing or changed.
Result<Study> openStudy(const std::filesystem::path& folder);

/// Verifies that this program makes the stimuli feel as the program that created the study. Failure
/// unreadableInput names button and mode. For running a study, not for reading results.
Result<Done> checkStimuli(const Study& study);

/// The sound of presses, read from the study's folder. Failure: as readSoundFile.
Result<PressSound> pressSoundOf(const Study& study);

/// Settings for a button in a mode, and its program.
PlaybackSettings settingsFor(const Study& study, std::size_t button, FeedbackMode mode);
Result<PreparedProgram> programFor(const Study& study, std::size_t button, FeedbackMode mode);

// ---- merged studies (merged_study.cpp): a study that several laboratories ran. The folder contains the
// study of each in sites/NAME, and a study.json that names them. The participants are called NAME-ID.

/// Copies studies into `folder`, completely or not at all. `sites`: one name each, with the rules of
/// participants' ids; empty: the names of the folders. Failure wrongUsage: the studies differ in task, feel,
/// or rule for the unfinished, or two sites have the same name.
Result<Study> mergeStudies(const std::vector<std::filesystem::path>& studies, std::vector<std::string> sites,
                           const std::filesystem::path& folder);
/// Opens the study of these sites, of which there must be at least one. Failures: those of openStudy, for
/// each site, and of mergeStudies.
Result<Study> openSites(const std::vector<std::string>& sites, const std::filesystem::path& folder);
/// The folder of one site's study.
std::filesystem::path siteFolder(const std::filesystem::path& folder, const std::string& site);

// ---- levels of a threshold study (study_levels.cpp): buttons with more of one quantity than their reference

/// The settings with an increased quantity; quantities of the button itself leave them unchanged. Jumps whose
/// size is tested play at half their strength, so that it can be increased. `increase` >= 0; 0: the
/// reference.
PlaybackSettings raised(PlaybackSettings settings, LevelQuantity quantity, double increase);

/// Appends a level to the study's buttons. `reference`: one of the given buttons; `increase` > 0. Failure: as
/// the edit.
Result<Done> addLevel(Study& study, std::size_t reference, double increase);

/// Adds the usual levels: increases from 1 % to 100 %, twelve per decade, as far as the button can be changed
/// and the vibration stays below full scale. Failure wrongUsage names a button with too few
/// such levels.
Result<Done> addUsualLevels(Study& study);

/// Increases of a button, ascending.
std::vector<double> increasesOf(const Study& study, std::size_t reference);
/// The level that a button is; null for a button with which the study was made.
const StudyLevel* levelOf(const Study& study, std::size_t button);

}  // namespace detent::playback
