// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which measured switch feels like this one, or has these figures.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "importer/library/feel_distance.h"
#include "importer/library/store.h"

namespace detent::importer {

struct FindRequest {
  std::string database;
  std::optional<FeltShape> like;    ///< nearest first; without: by name
  std::vector<FigureRange> ranges;  ///< all are kept
  std::size_t limit = 10;           ///< of those that are given
  std::string name = {};            ///< the switch's name contains this, in any case; empty: any
  std::optional<SwitchKind> kind = {};
};

struct FoundSwitch {
  LibrarySwitch entry;
  std::optional<double> distance_labNoise;  ///< if `like` was given; below 1 the two may be one switch
  SwitchSpread spread;               ///< of all records of this switch by its laboratory, this one among them
  std::vector<Rating> ratings = {};  ///< what people said of a switch of this name
};

/// 1: nobody can say that it differs; 2: within two lab noises, and so on. Who stands first in a group says
/// little.
inline std::size_t groupOf(double distance_labNoise) {
  return 1 + static_cast<std::size_t>(distance_labNoise);
}

/// A switch that misses some of the ranges, and the distance from them (missOf).
struct NearMiss {
  LibrarySwitch entry;
  double miss_labNoise = 0;  ///< > 0
};

struct FoundSwitches {
  std::vector<FoundSwitch> found;
  std::vector<NearMiss> nearest;  ///< where none keeps the ranges: those that miss them least
  std::size_t fitting = 0;        ///< how many keep the ranges, shown or not
};

/// Failures: those of LibraryStore::openToRead.
Result<FoundSwitches> findSwitches(const FindRequest& request);

}  // namespace detent::importer
