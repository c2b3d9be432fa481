// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables for the firmware of a magnetic keyboard: from reading to displacement, and the settings of the key.

#include <string>
#include <vector>

#include "playback/magnetic/simulate_key.h"

namespace detent::playback {

inline constexpr int travelTableEntries = 256;

/// Displacements in whole micrometres at evenly spaced readings from rest to the end of the travel.
struct TravelTable {
  double restReading = 0, endReading = 0;  ///< whole counts, as the header states them
  std::vector<unsigned> travel_um;         ///< travelTableEntries
  double worst_mm = 0;  ///< largest error at a whole reading, with linear interpolation between entries
};
TravelTable travelTableOf(const MagneticSensor& sensor, double travel_mm);

/// CSV `displacement_mm,reading,counts_per_mm,noise_mm`: 201 points of the travel.
std::string sensorCsvFrom(const MagneticSensor& sensor, double travel_mm);

/// C header for C99 and C++, ASCII: the table, the settings of `chosen`, and the simulated results, if any,
/// in its comment.
std::string keyHeaderFrom(const Button& button, const MagneticSensor& sensor,
                          const MagneticKeySettings& chosen,
                          const std::vector<MagneticKeyForecast>& simulated);

}  // namespace detent::playback
