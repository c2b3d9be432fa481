// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Assigns a list of trials to each participant, fixed before the first person comes (study_plan.h). Any
// thread.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/named_values.h"
#include "model/result.h"

namespace detent::playback {

/// Rule for participants who did not answer all trials. The report shows both results; the one by this rule
/// comes first and is tested.
enum class Unfinished : std::uint8_t {
  leftOut,  ///< not counted, unless nobody has finished yet
  counted
};
inline constexpr auto unfinishedRules =
    named<Unfinished>({{"left-out", Unfinished::leftOut}, {"counted", Unfinished::counted}});

/// Plan made before the first person comes: `plan.json` of the study's folder. A participant's place
/// determines their list of trials.
struct PlannedPlaces {
  std::vector<std::string> participants;  ///< in the order of their places
  Unfinished unfinished = Unfinished::leftOut;
  std::string listsSha256 = {};  ///< hash that was read from the file; empty if no lists were made
};

/// The ids P01, P02, ... for this many people.
PlannedPlaces usualPlaces(std::size_t people);

/// The planned places of a study; empty if there is no plan, so that places follow from the order of arrival.
/// Failure unreadableInput: plan.json is broken.
Result<PlannedPlaces> placesOf(const std::filesystem::path& folder);
/// The place of a participant who begins after `begunBefore` others: the planned one, or one behind all
/// planned ones.
std::size_t placeOf(const PlannedPlaces& plan, const std::string& participant, std::size_t begunBefore);

/// Writes plan.json. `studySha256` is of study.json, `listsSha256` of all lists in order.
Result<Done> writePlaces(const std::filesystem::path& folder, const PlannedPlaces& plan,
                         const std::string& studySha256, const std::string& listsSha256);

}  // namespace detent::playback
