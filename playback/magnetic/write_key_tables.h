// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables for the firmware of a magnetic keyboard: reading to displacement, and the settings of the key.

#include <string>
#include <vector>

#include "playback/magnetic/simulate_key.h"

namespace detent::playback {

inline constexpr int travelTableEntries = 256;

/// Displacements in whole micrometres at evenly spaced readings from rest to the end of the travel.
struct TravelTable {
  double restReading = 0, endReading = 0;  ///< whole counts, as the header states them
  std::vector<unsigned> travel_um;         ///< travelTableEntries
  double worst_mm = 0;  ///< error of the place of a whole reading, straight between entries
};
TravelTable travelTableOf(const MagneticSensor& sensor, double travel_mm);

/// `displacement_mm,reading,counts_per_mm,noise_mm`: 201 places of the travel.
std::string sensorCsvFrom(const MagneticSensor& sensor, double travel_mm);

/// C99 and C++: the table, the settings of `chosen`, and in its comment what was simulated. ASCII.
std::string keyHeaderFrom(const Button& button, const MagneticSensor& sensor,
                          const MagneticKeySettings& chosen,
                          const std::vector<MagneticKeyForecast>& simulated);

}  // namespace detent::playback
