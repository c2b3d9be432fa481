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
  std::optional<FeltShape> like;    ///< sort by distance to this shape, nearest first; without: by name
  std::vector<FigureRange> ranges;  ///< the switch must satisfy all of them
  std::size_t limit = 10;           ///< most switches that are returned
  std::string name = {};            ///< the switch's name contains this, in any case; empty: any
  std::optional<SwitchKind> kind = {};
};

struct FoundSwitch {
  LibrarySwitch entry;
  std::optional<double> distance_labNoise;  ///< if `like` was given; below 1 the two may be one switch
  SwitchSpread spread;               ///< of all records of this switch by its laboratory, including this one
  std::vector<Rating> ratings = {};  ///< ratings of switches with this name
};

/// Group of a distance. 1: nobody can feel a difference; 2: within two lab noises, and so on. The order
/// within a group means little.
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
  std::vector<NearMiss> nearest;  ///< if no switch satisfies the ranges: those that miss them least
  std::size_t fitting = 0;  ///< number of switches that satisfy the ranges, including those not returned
};

/// Failures: those of LibraryStore::openToRead.
Result<FoundSwitches> findSwitches(const FindRequest& request);

}  // namespace detent::importer
