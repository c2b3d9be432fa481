// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/magnetic/write_key_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/number_table.h"
#include "model/version.h"

namespace detent::playback {

namespace {

constexpr double um_per_mm = 1000;
constexpr int csvPieces = 200, checkedReadings = 4096;

/// As detent_travel_um_at() of the header does: straight between two entries, cut to whole micrometres.
double fromTable_mm(const TravelTable& table, double reading) {
  const double place =
      (reading - table.restReading) / (table.endReading - table.restReading) * (travelTableEntries - 1);
  const auto i = static_cast<std::size_t>(std::clamp(place, 0.0, travelTableEntries - 2.0));
  constexpr double rounding_um = 1e-6;
  return std::floor(std::lerp(static_cast<double>(table.travel_um[i]),
                              static_cast<double>(table.travel_um[i + 1]), place - static_cast<double>(i)) +
                    rounding_um) /
         um_per_mm;
}

/// A button's name may be any text, so characters that would end a C comment are replaced.
std::string inComment(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    const bool plain = c >= ' ' && c <= '~' && c != '*' && c != '/' && c != '\\' && c != '?';
    safe += plain ? c : '_';
  }
  return safe;
}

std::string micrometres(double displacement_mm) {
  return std::to_string(std::lround(displacement_mm * um_per_mm));
}

std::string simulatedLine(const MagneticKeyForecast& f) {
  char line[200];
  std::snprintf(line, sizeof line,
                "   rapid trigger %-8s lost %.1f, doubled %.1f of 1,000; held: lets go %.0f times a minute, "
                "shallow %.0f\n",
                textOf(f.settings.rapid).c_str(), f.lost_per_1000, f.doubled_per_1000, f.letsGo_per_minute,
                f.letsGoShallow_per_minute);
  return line;
}

std::string settingsOf(const MagneticKeySettings& chosen) {
  const RapidTrigger rapid = chosen.rapid.value_or(RapidTrigger{0, 0});
  std::string text = "#define DETENT_ACTUATE_UM " + micrometres(chosen.actuate_mm) + "\n" +
                     "#define DETENT_RESET_UM " + micrometres(chosen.reset_mm) + "\n" +
                     "#define DETENT_RAPID_UM " + micrometres(rapid.press_mm) +
                     "  /* 0: no rapid trigger */\n";
  if (!chosen.beyondOneDistance()) return text;
  text +=
      "/* DETENT_RAPID_UM closes below the highest place, DETENT_RAPID_RELEASE_UM opens above the deepest;\n"
      "   continuous: until the top dead zone, not only below DETENT_RESET_UM. */\n";
  text += "#define DETENT_RAPID_RELEASE_UM " + micrometres(rapid.release_mm) + "\n";
  text += "#define DETENT_RAPID_CONTINUOUS " + std::to_string(int{rapid.continuous}) + "\n";
  text += "#define DETENT_TOP_DEAD_ZONE_UM " + micrometres(chosen.topDeadZone_mm) + "\n";
  return text + "#define DETENT_BOTTOM_DEAD_ZONE_UM " + micrometres(chosen.bottomDeadZone_mm) + "\n";
}

/// C function that interpolates the table with integers.
std::string placeFunction() {
  const std::string last = std::to_string(travelTableEntries - 1);
  return "/* Micrometres of a reading: straight between two entries. */\n"
         "static inline uint32_t detent_travel_um_at(int32_t reading) {\n"
         "  int64_t span = (int64_t)DETENT_READING_AT_END - DETENT_READING_AT_REST;\n"
         "  int64_t way = ((int64_t)reading - DETENT_READING_AT_REST) * " +
         last +
         ";\n"
         "  int entry;\n"
         "  if (span < 0) { span = -span; way = -way; }\n"
         "  if (way <= 0) return detent_travel_um[0];\n"
         "  if (way >= span * " +
         last + ") return detent_travel_um[" + last +
         "];\n"
         "  entry = (int)(way / span);\n"
         "  return (uint32_t)(detent_travel_um[entry] +\n"
         "                    ((int64_t)detent_travel_um[entry + 1] - (int64_t)detent_travel_um[entry]) * "
         "(way % span) / span);\n"
         "}\n";
}

std::string head(const Button& button, const MagneticSensor& sensor, const TravelTable& table,
                 const std::vector<MagneticKeyForecast>& simulated) {
  std::string text =
      "/* " + inComment(button.name()) + " on a magnetic switch; written by Detent " + version() + ".\n";
  text += sensor.isAssumed() ? "   READINGS ARE ASSUMED (a magnet of the usual size): measure yours, pass "
                               "them with --readings.\n"
                             : "   Readings as measured.\n";
  char line[240];
  unsigned widest_um = 0;
  for (std::size_t i = 1; i < table.travel_um.size(); ++i)
    widest_um =
        std::max(widest_um, table.travel_um[i] - std::min(table.travel_um[i], table.travel_um[i - 1]));
  std::snprintf(
      line, sizeof line,
      "   The place of a whole reading, as detent_travel_um_at() gives it, is off by up to %.4f mm; a plain "
      "entry by up to %.4f mm.\n   Noise of %.3g counts.\n",
      table.worst_mm, widest_um / um_per_mm, sensor.noise());
  text += line;
  if (!simulated.empty())
    text += "   Forecast for 64 simulated fingers, 1,024 presses, acting at the point below:\n";
  for (const MagneticKeyForecast& one : simulated) text += simulatedLine(one);
  return text + "*/\n";
}

}  // namespace

TravelTable travelTableOf(const MagneticSensor& sensor, double travel_mm) {
  TravelTable table;
  table.restReading = std::round(sensor.reading(0));
  table.endReading = std::round(sensor.reading(travel_mm));
  for (int i = 0; i < travelTableEntries; ++i) {
    const double reading =
        std::lerp(table.restReading, table.endReading, static_cast<double>(i) / (travelTableEntries - 1));
    table.travel_um.push_back(
        static_cast<unsigned>(std::max(0L, std::lround(sensor.displacement_mm(reading) * um_per_mm))));
  }
  const double counts = std::abs(table.endReading - table.restReading);
  const double checked = std::min(counts, static_cast<double>(checkedReadings));
  for (double i = 0; i <= checked && counts > 0; ++i) {
    const double reading = std::round(std::lerp(table.restReading, table.endReading, i / checked));
    const double place_mm = std::clamp(sensor.displacement_mm(reading), 0.0, travel_mm);
    table.worst_mm = std::max(table.worst_mm, std::abs(fromTable_mm(table, reading) - place_mm));
  }
  return table;
}

std::string sensorCsvFrom(const MagneticSensor& sensor, double travel_mm) {
  std::string csv = "displacement_mm,reading,counts_per_mm,noise_mm\n";
  const double spacing_mm = travel_mm / csvPieces;
  for (int i = 0; i <= csvPieces; ++i) {
    const double at_mm = i == csvPieces ? travel_mm : spacing_mm * i;
    const double beside_mm = i == csvPieces ? at_mm - spacing_mm : at_mm + spacing_mm;
    const double slope = (sensor.reading(beside_mm) - sensor.reading(at_mm)) / (beside_mm - at_mm);
    csv += shortestText(at_mm) + ',' + shortestText(sensor.reading(at_mm)) + ',' + shortestText(slope) + ',' +
           shortestText(sensor.noise() / std::abs(slope)) + '\n';
  }
  return csv;
}

std::string keyHeaderFrom(const Button& button, const MagneticSensor& sensor,
                          const MagneticKeySettings& chosen,
                          const std::vector<MagneticKeyForecast>& simulated) {
  const double travel_mm = button.states().front().graph.travel_mm();
  const TravelTable table = travelTableOf(sensor, travel_mm);
  std::string text = head(button, sensor, table, simulated);
  text += "#ifndef DETENT_MAGNETIC_KEY_H\n#define DETENT_MAGNETIC_KEY_H\n\n#include <stdint.h>\n\n";
  text += "#define DETENT_READING_AT_REST " + std::to_string(std::llround(table.restReading)) + "\n";
  text += "#define DETENT_READING_AT_END " + std::to_string(std::llround(table.endReading)) + "\n";
  text += "#define DETENT_TRAVEL_UM " + micrometres(travel_mm) + "\n";
  text += settingsOf(chosen) + "\n";
  text +=
      "/* Micrometres at entry (reading - DETENT_READING_AT_REST) * 255 / (DETENT_READING_AT_END - "
      "DETENT_READING_AT_REST). */\n";
  text += "static const uint32_t detent_travel_um[" + std::to_string(travelTableEntries) + "] = {";
  for (std::size_t i = 0; i < table.travel_um.size(); ++i)
    text += (i % 16 == 0 ? "\n  " : " ") + std::to_string(table.travel_um[i]) + "u,";
  text += "\n};\n\n" + placeFunction();
  return text + "\n#endif\n";
}

}  // namespace detent::playback
