// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a study with people is: which buttons, which task, how often. One study is one folder that can be
// copied: study.json, buttons/, device.device (optional), consent.txt, participants/ID.jsonl.

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

namespace detent::playback {

enum class StudyKind : std::uint8_t {
  abx,      ///< K&L, Experiment 1: which of two is X?
  matching  ///< K&L, Experiment 2: which of all is X?
};
inline constexpr auto studyKinds =
    named<StudyKind>({{"abx", StudyKind::abx}, {"matching", StudyKind::matching}});
inline const char* nameOf(StudyKind kind) { return studyKinds.word(kind); }

/// What X is made of. Physical: the experimenter hands over the real switch of that number.
enum class TargetKind : std::uint8_t { virtualButton, physicalButton };

/// What is asked for; `study new`.
struct StudyDesign {
  StudyKind kind = StudyKind::abx;
  TargetKind targets = TargetKind::virtualButton;       ///< physical: matching only
  std::vector<FeedbackMode> modes{FeedbackMode::full};  ///< each pair (or button) is tried in each; not off
  std::size_t trials = 10;    ///< per pair (abx) or button (matching), and mode; 1..1000
  std::size_t practice = 0;   ///< trials before the first that counts; 0..100
  std::size_t pairsEach = 0;  ///< a random subset of so many pairs for each participant; 0: all
  std::uint64_t seed = 0;
  std::string consent;  ///< shown before the first trial; empty: a short standard text
};

/// One button of a study.
struct StudyButton {
  std::string label;   ///< file name without .button.json; unique in the study
  std::string sha256;  ///< of its file
  Button button;
};

/// What a participant gets: button and mode, as sound. SHA-256 over the standard press: it changes when the
/// button, a setting, the device profile or the engine would make it feel different.
struct StudyStimulus {
  std::size_t button = 0;
  FeedbackMode mode = FeedbackMode::full;
  std::string sha256;
};

/// A study as it stands in its folder. Plain value, any thread.
struct Study {
  std::filesystem::path folder;
  std::string name;     ///< the folder's
  std::string sha256;   ///< of study.json
  std::string program;  ///< version that made it
  int version = 0;      ///< of study.json; how lists of trials are made hangs on it
  StudyDesign design;
  std::vector<StudyButton> buttons;
  std::optional<DeviceProfile> profile;
  std::string profileSha256;  ///< empty without a profile
  std::vector<StudyStimulus> stimuli;
};

/// Unordered pairs in the order A-B, A-C, B-C, ... of the paper's Table 2: by the second, then the first.
std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t buttons);

/// A participant's id: 1 to 32 of a-z A-Z 0-9 - _, so that it names a file and no person.
Result<Done> checkParticipantId(const std::string& id);
/// What remains of an id for reading it out: P-1, P_1, p1 and P01 are one person.
std::string spokenId(const std::string& id);

/// Range checks of a design for so many buttons. Failure wrongUsage names the value.
Result<Done> checkDesign(const StudyDesign& design, std::size_t buttons);

/// Makes the folder, whole or not at all. `buttonFiles`: at least two (abx, matching), labels unique.
/// `profileFile` may be empty. Failure wrongUsage: the folder exists, or a value is outside its range.
Result<Study> createStudy(const std::filesystem::path& folder, const std::vector<std::string>& buttonFiles,
                          const std::string& profileFile, const StudyDesign& design);

/// Opens a study and proves that its buttons and profile are the ones it was made of. Failure
/// unreadableInput: no study, another version's, or a button missing or changed.
Result<Study> openStudy(const std::filesystem::path& folder);

/// That this program would make it feel as the one that made it. Failure unreadableInput names the button
/// and mode. For running, not for reading results.
Result<Done> checkStimuli(const Study& study);

/// What a participant feels for a button in a mode.
Result<PreparedProgram> programFor(const Study& study, std::size_t button, FeedbackMode mode);

}  // namespace detent::playback
