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

/// Rule for participants who did not answer all trials. The report shows both results; this one comes first
/// and is tested.
enum class Unfinished : std::uint8_t {
  leftOut,  ///< unless nobody has finished yet
  counted
};
inline constexpr auto unfinishedRules =
    named<Unfinished>({{"left-out", Unfinished::leftOut}, {"counted", Unfinished::counted}});

/// Plan made before the first person comes: `plan.json` of the study's folder. Which list of trials a
/// participant gets is a matter of their place.
struct PlannedPlaces {
  std::vector<std::string> participants;  ///< by place
  Unfinished unfinished = Unfinished::leftOut;
  std::string listsSha256 = {};  ///< as read; empty where no lists were made
};

/// P01, P02, ... for so many people.
PlannedPlaces usualPlaces(std::size_t people);

/// The places a study was planned with; none: they follow from who comes first. Failure unreadableInput:
/// plan.json is broken.
Result<PlannedPlaces> placesOf(const std::filesystem::path& folder);
/// The place of somebody who begins now, `begunBefore` others having begun; behind all planned ones where
/// they are not among them.
std::size_t placeOf(const PlannedPlaces& places, const std::string& participant, std::size_t begunBefore);

/// Writes plan.json. `studySha256`, `listsSha256`: of study.json, of all lists in order.
Result<Done> writePlaces(const std::filesystem::path& folder, const PlannedPlaces& places,
                         const std::string& studySha256, const std::string& listsSha256);

}  // namespace detent::playback
