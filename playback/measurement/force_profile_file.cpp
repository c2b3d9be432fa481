// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/force_profile_file.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "model/file/text_file.h"
#include "model/number_table.h"
#include "playback/measurement/exact_number.h"
#include "playback/measurement/profile_lines.h"

namespace detent::playback {

namespace {

/// Name of a number in the file, and the member that stores it.
struct Key {
  std::string_view name;
  double* value;
  bool needed;
  double least, most;
};

std::vector<Key> keysOf(ForceDeviceMeasurement& d) {
  constexpr double none = 0, most = 1e3, longest_s = 0.1;
  return {{"mass_kg", &d.mass_kg.value, true, 1e-4, 100},
          {"sigma_mass_kg", &d.mass_kg.sigma, false, none, most},
          {"friction_N", &d.friction_N.value, true, none, 100},
          {"sigma_friction_N", &d.friction_N.sigma, false, none, most},
          {"damping_Ns_per_mm", &d.damping_Ns_per_mm.value, true, none, 1},
          {"sigma_damping_Ns_per_mm", &d.damping_Ns_per_mm.sigma, false, none, most},
          {"delay_s", &d.delay_s.value, true, none, longest_s},
          {"sigma_delay_s", &d.delay_s.sigma, false, none, most},
          {"lag_s", &d.lag_s.value, true, none, longest_s},
          {"sigma_lag_s", &d.lag_s.sigma, false, none, most},
          {"late_s", &d.late_s.value, false, none, 2 * longest_s},
          {"sigma_late_s", &d.late_s.sigma, false, none, most},
          {"rate_Hz", &d.rate_Hz, true, 50, 20000},
          {"step_mm", &d.step_mm, false, 1e-6, 1}};
}

}  // namespace

ForceDeviceProfile measuredProfile(ForceDeviceProfile profile, const ForceDeviceMeasurement& measured,
                                   double rate_Hz, bool hosted) {
  profile.mass_kg = measured.mass_kg.value;
  profile.friction_N = measured.friction_N.value;
  profile.damping_Ns_per_mm = measured.damping_Ns_per_mm.value;
  profile.delay_s = measured.delay_s.value;
  profile.lag_s = measured.lag_s.value;
  if (measured.step_mm > 0) profile.step_mm = measured.step_mm;
  if (hosted) profile.delay_s += std::max(0.0, 1 / rate_Hz - 1 / measured.rate_Hz);
  profile.measured = true;
  return profile;
}

Result<ForceDeviceMeasurement> parseForceDevice(const std::string& text, const std::string& name) {
  ForceDeviceMeasurement device;
  const std::vector<Key> keys = keysOf(device);
  std::set<std::string, std::less<>> seen;
  const ProfileKind kind{"detent-force-device", forceDeviceFileVersion,
                         Message("the profile of a force device")};
  Result<Done> read =
      readProfileLines(text, name, kind, [&](std::string_view key, std::string_view value) -> Message {
        if (!seen.emplace(key).second) return Message("this entry is given twice");
        if (key == "name") {
          device.name = std::string(value);
          return {};
        }
        const auto known =
            std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == key; });
        if (known == keys.end()) return Message("this entry is not known");
        std::vector<double> numbers;
        if (!numbersOf(value, numbers) || numbers.size() != 1)
          return Message("the value is not a single number");
        if (!(numbers[0] >= known->least && numbers[0] <= known->most))
          return Message("the value lies outside %1 to %2", exact(known->least), exact(known->most));
        *known->value = numbers[0];
        return {};
      });
  if (!read) return read.failure();
  for (const Key& key : keys) {
    if (key.needed && !seen.contains(key.name)) {
      return Failure{FailureCode::unreadableInput, name, "", Message("%1 is missing", key.name),
                     Message("Measure the device with `detent-play identify-device`")};
    }
  }
  return device;
}

Result<ForceDeviceMeasurement> readForceDevice(const std::string& file) {
  const auto text =
      readTable(file, largestProfile_bytes, "Measure the device with `detent-play identify-device`");
  if (!text) return text.failure();
  return parseForceDevice(*text, file);
}

std::string toText(const ForceDeviceMeasurement& device) {
  std::string name;
  for (const char c : device.name) name += c == '\n' || c == '\r' || c == '#' ? ' ' : c;
  std::string text = "detent-force-device " + std::to_string(forceDeviceFileVersion) + "\nname = " + name +
                     "\n# without a finger; sigma: standard errors\n";
  ForceDeviceMeasurement copy = device;
  for (const Key& key : keysOf(copy)) {
    text += key.name;
    text += " = " + exact(*key.value) + "\n";
  }
  return text;
}

Result<Done> writeForceDevice(const ForceDeviceMeasurement& device, const std::string& file) {
  return writeTextFileAtomically(file, toText(device));
}

}  // namespace detent::playback
