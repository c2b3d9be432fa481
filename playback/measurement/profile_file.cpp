// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/profile_file.h"

#include <set>
#include <string_view>
#include <vector>

#include "model/file/text_file.h"
#include "model/number_table.h"
#include "playback/measurement/exact_number.h"
#include "playback/measurement/profile_lines.h"
#include "playback/prepare/prepare_program.h"

namespace detent::playback {

namespace {

/// Reads the lines of a profile one by one.
class Reader {
 public:
  /// The error of the line; empty if there is none.
  Message line(std::string_view key, std::string_view value) {
    const bool repeats = key == "resonance" || key == "equalizer";
    if (!repeats && !seen_.insert(std::string(key)).second) return Message("this entry is given twice");
    if (key == "name") {
      profile.name = std::string(value);
      return {};
    }
    if (key == "sensor.circuit") return circuit(value);
    if (!numbersOf(value, n_)) return Message("the value holds something that is not a number");
    if (key == "gain") return take(1, [&] { profile.gain = n_[0]; });
    if (key == "full_scale_dB") return take(1, [&] { profile.fullScale_dB = n_[0]; });
    if (key == "resonance") return take(3, [&] { profile.resonances.push_back({n_[0], n_[1], n_[2]}); });
    if (key == "equalizer") return take(3, [&] { profile.equalizer.push_back({n_[0], n_[1], n_[2]}); });
    if (key == "latency") return latency();
    if (key == "transducer.power_W") return take(1, [&] { profile.transducer.power_W = n_[0]; });
    if (key == "transducer.impedance_ohm") return take(1, [&] { profile.transducer.impedance_ohm = n_[0]; });
    if (key == "transducer.full_scale_V") return take(1, [&] { profile.transducer.fullScale_V = n_[0]; });
    return sensor(key);
  }

  DeviceProfile profile;

 private:
  template <class Action>
  Message take(std::size_t count, Action action) {
    if (n_.size() != count) return Message("this entry needs %1 numbers, but has %2", count, n_.size());
    action();
    return {};
  }

  Message circuit(std::string_view value) {
    const auto circuit = sensorCircuits.value(value);
    if (!circuit) return Message("the value must be \"newtons\", \"linear\" or \"divider\"");
    profile.sensor.circuit = *circuit;
    return {};
  }

  Message latency() {
    return take(4, [&] {
      MeasuredLatency m;
      m.n = static_cast<std::size_t>(std::max(0.0, n_[0]));
      m.mean_s = n_[1];
      m.sd_s = n_[2];
      m.p95_s = n_[3];
      profile.latency = m;
    });
  }

  Message sensor(std::string_view key) {
    SensorCalibration& s = profile.sensor;
    if (key == "sensor.full_scale_counts") {
      if (n_.size() == 1 && !(n_[0] > 0)) return Message("the value must be above 0");
      return take(1, [&] { s.fullScale_counts = n_[0]; });
    }
    if (key == "sensor.coefficients") {
      if (n_.empty() || n_.size() > SensorCalibration::maxCoefficients)
        return Message("this entry needs 1 to 4 numbers");
      s.coefficientCount = n_.size();
      s.coefficients = {};
      std::copy(n_.begin(), n_.end(), s.coefficients.begin());
      return {};
    }
    if (key == "sensor.standard_errors") {
      if (n_.size() > SensorCalibration::maxCoefficients)
        return Message("this entry can have at most 4 numbers");
      std::copy(n_.begin(), n_.end(), s.standardErrors.begin());
      return {};
    }
    if (key == "sensor.noise_N") return take(1, [&] { s.noise_N = n_[0]; });
    if (key == "sensor.residual_N") return take(1, [&] { s.residual_N = n_[0]; });
    if (key == "sensor.weights")
      return take(1, [&] { s.weights = static_cast<std::size_t>(std::max(0.0, n_[0])); });
    if (key == "sensor.range_N") {
      return take(2, [&] {
        s.lowest_N = n_[0];
        s.highest_N = n_[1];
      });
    }
    return Message("this entry is not known");
  }

  std::set<std::string> seen_;
  std::vector<double> n_;
};

}  // namespace

Result<DeviceProfile> parseDeviceProfile(const std::string& text, const std::string& name) {
  Reader reader;
  const ProfileKind kind{"detent-device", deviceProfileVersion, Message("a device profile")};
  Result<Done> read = readProfileLines(text, name, kind, [&](std::string_view key, std::string_view value) {
    return reader.line(key, value);
  });
  if (!read) return read.failure();
  if (Result<Done> ok = checkProfile(reader.profile); !ok) {
    Failure failure = ok.failure();
    failure.code = FailureCode::unreadableInput;
    failure.subject = name;
    return failure;
  }
  return std::move(reader.profile);
}

Result<DeviceProfile> readDeviceProfile(const std::filesystem::path& file) {
  const auto text = readTable(file.string(), largestProfile_bytes,
                              "Write a device profile with `detent-play sweep` or `detent-play calibrate`");
  if (!text) return text.failure();
  return parseDeviceProfile(*text, file.string());
}

std::string toText(const DeviceProfile& p) {
  std::string text = "detent-device " + std::to_string(deviceProfileVersion) + "\n";
  const auto put = [&](const std::string& key, const std::vector<double>& values) {
    text += key + " =";
    for (double v : values) {
      text += ' ';
      text += exact(v);
    }
    text += "\n";
  };
  std::string name;
  for (char c : p.name) name += c == '\n' || c == '\r' || c == '#' ? ' ' : c;
  text += "name = " + name + "\n";
  put("gain", {p.gain});
  if (p.fullScale_dB) put("full_scale_dB", {*p.fullScale_dB});
  text += "# frequency in Hz, Q, gain in dB\n";
  for (const Resonance& r : p.resonances) put("resonance", {r.frequency_Hz, r.q, r.gain_dB});
  for (const EqualizerBand& b : p.equalizer) put("equalizer", {b.frequency_Hz, b.q, b.gain_dB});
  if (p.transducer.power_W > 0) {
    put("transducer.power_W", {p.transducer.power_W});
    put("transducer.impedance_ohm", {p.transducer.impedance_ohm});
    put("transducer.full_scale_V", {p.transducer.fullScale_V});
  }
  const SensorCalibration& s = p.sensor;
  text += "# force_N = c0 + c1 u + c2 u^2 + c3 u^3; u from the circuit\n";
  text += std::string("sensor.circuit = ") + sensorCircuits.word(s.circuit) + "\n";
  put("sensor.full_scale_counts", {s.fullScale_counts});
  put("sensor.coefficients",
      {s.coefficients.begin(), s.coefficients.begin() + static_cast<long>(s.coefficientCount)});
  put("sensor.standard_errors",
      {s.standardErrors.begin(), s.standardErrors.begin() + static_cast<long>(s.coefficientCount)});
  if (s.noise_N > 0) put("sensor.noise_N", {s.noise_N});
  put("sensor.residual_N", {s.residual_N});
  put("sensor.range_N", {s.lowest_N, s.highest_N});
  put("sensor.weights", {static_cast<double>(s.weights)});
  if (p.latency) {
    text += "# number, mean s, SD s, 95th percentile s\n";
    put("latency", {static_cast<double>(p.latency->n), p.latency->mean_s, p.latency->sd_s, p.latency->p95_s});
  }
  return text;
}

Result<Done> writeDeviceProfile(const DeviceProfile& profile, const std::filesystem::path& file) {
  return writeTextFileAtomically(file.string(), toText(profile));
}

}  // namespace detent::playback
