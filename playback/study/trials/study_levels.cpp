// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/edits.h"
#include "playback/study/trials/study_design.h"

namespace detent::playback {

namespace {

constexpr int levelsPerDecade = 12, decades = 2;
constexpr double smallestIncrease = 0.01;
constexpr double eventHeadroom =
    0.5;  // strong jumps are near full scale; at half of it there is room for twice the strength
constexpr std::size_t fewestLevels =
    13;  // up to a tenth: a shorter range might end below the threshold of everybody

Result<Button> raised(const Button& button, LevelQuantity quantity, double increase) {
  switch (quantity) {
    case LevelQuantity::peakForce:
      return scaleForce(button, 1 + increase);
    case LevelQuantity::travel:
      return scaleTravel(button, 1 + increase);
    case LevelQuantity::snap:
      return scaleSnapRatios(button, 1 + increase);
    case LevelQuantity::eventSize:
    case LevelQuantity::grainStrength:
      break;  // quantities of the vibration are changed by raised() of the settings
  }
  return button;
}

/// "A+12.1%"
std::string levelLabel(const std::string& label, double increase) {
  constexpr double percent = 100;
  char text[32];
  std::snprintf(text, sizeof text, "+%.3g%%", percent * increase);
  return label + text;
}

/// Rounded to three digits, so that files and tables show the actual value.
double usualIncrease(int step) {
  const double exact = smallestIncrease * std::pow(10.0, double(step) / levelsPerDecade);
  const double unit = std::pow(10.0, std::floor(std::log10(exact)) - 2);
  return std::round(exact / unit) * unit;
}

/// Returns true if the vibration can be increased; at full scale an increase could not be felt.
bool hasRoom(const Study& study, std::size_t button) {
  for (const FeedbackMode mode : study.design.modes) {
    const Result<PreparedProgram> program = programFor(study, button, mode);
    if (!program) return false;
    for (const PrepareWarning& warning : program->summary.warnings)
      if (warning.code == PrepareWarningCode::jumpClipped &&
          study.design.quantity == LevelQuantity::eventSize)
        return false;
  }
  return true;
}

}  // namespace

PlaybackSettings raised(PlaybackSettings settings, LevelQuantity quantity, double increase) {
  if (quantity == LevelQuantity::grainStrength) settings.grainAmplitude *= 1 + increase;
  if (quantity == LevelQuantity::eventSize) {
    settings.jumpAmplitudePerArea_per_mJ *= eventHeadroom * (1 + increase);
    settings.faintestJump *= eventHeadroom * (1 + increase);
  }
  return settings;
}

Result<Done> addLevel(Study& study, std::size_t reference, double increase) {
  const StudyButton& given = study.buttons[reference];
  Result<Button> button = raised(given.button, study.design.quantity, increase);
  if (!button) return button.failure();
  StudyButton level{levelLabel(given.label, increase), given.sha256, *std::move(button)};
  study.levels.push_back({study.buttons.size(), reference, increase});
  study.buttons.push_back(std::move(level));
  return Done{};
}

Result<Done> addUsualLevels(Study& study) {
  const std::size_t given = study.buttons.size();
  for (std::size_t reference = 0; reference < given; ++reference) {
    std::size_t count = 0;
    for (int step = 0; step <= levelsPerDecade * decades; ++step) {
      if (!addLevel(study, reference, usualIncrease(step))) break;
      if (!hasRoom(study, study.levels.back().button)) {
        study.levels.pop_back();
        study.buttons.pop_back();
        break;
      }
      ++count;
    }
    if (count < fewestLevels)
      return Failure{FailureCode::wrongUsage, Subject::option("--quantity"), study.buttons[reference].label,
                     Message("the button has no room to increase \"%1\" by 10 %",
                             Message::of(nameOf(study.design.quantity), {})),
                     Message("Choose another quantity, or a button that has less of the present quantity")};
  }
  return Done{};
}

std::vector<double> increasesOf(const Study& study, std::size_t reference) {
  std::vector<double> increases;
  for (const StudyLevel& level : study.levels)
    if (level.reference == reference) increases.push_back(level.increase);
  return increases;
}

const StudyLevel* levelOf(const Study& study, std::size_t button) {
  return button < study.givenButtons() ? nullptr : &study.levels[button - study.givenButtons()];
}

}  // namespace detent::playback
