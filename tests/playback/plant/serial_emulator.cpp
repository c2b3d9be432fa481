// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/plant/serial_emulator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace detent::test {
namespace {

unsigned checksumOf(const std::string& text) {
  unsigned sum = 0;
  for (const char c : text) sum ^= static_cast<unsigned char>(c);
  return sum;
}

/// The fields of a line whose checksum is right; none otherwise.
std::vector<std::string> fieldsOf(const std::string& line) {
  const std::size_t star = line.rfind('*');
  if (line.size() > 95 || star == std::string::npos || line.size() != star + 3) return {};
  char checksum[3];
  std::snprintf(checksum, sizeof checksum, "%02X", checksumOf(line.substr(0, star)));
  if (line.substr(star + 1) != checksum) return {};
  std::vector<std::string> fields;
  std::istringstream body(line.substr(0, star));
  for (std::string field; std::getline(body, field, ',');) fields.push_back(field);
  return fields;
}

double numberIn(const std::vector<std::string>& fields, std::size_t index) {
  return index < fields.size() ? static_cast<double>(std::stoll(fields[index])) : 0;
}

}  // namespace

double UploadedTable::force_N(double position_mm, bool pressing, double speed_mm_per_s) const {
  if (rows.size() < 2 || spacing_mm <= 0) return 0;
  const double last_mm = first_mm + spacing_mm * static_cast<double>(rows.size() - 1);
  const double along = (std::clamp(position_mm, first_mm, last_mm) - first_mm) / spacing_mm;
  const std::size_t below = std::min(static_cast<std::size_t>(along), rows.size() - 2);
  const double share = along - static_cast<double>(below);
  const auto between = [&](double Row::*column) {
    return rows[below].*column + (rows[below + 1].*column - rows[below].*column) * share;
  };
  return between(pressing ? &Row::press_N : &Row::release_N) +
         std::max(0.0, position_mm - last_mm) * bottomOut_N_per_mm +
         between(&Row::damping_Ns_per_mm) * speed_mm_per_s;
}

SerialEmulator::SerialEmulator(const SerialEmulatorSettings& settings)
    : PtyDevice(settings.pty), settings_(settings), limit_uN_(settings.largestForce_uN) {
  begin();
}

void SerialEmulator::say(const std::string& body) {
  char tail[8];
  std::snprintf(tail, sizeof tail, "*%02X\n", checksumOf(body));
  answer(body + tail);
}

std::int64_t SerialEmulator::read_nm() const {
  const double mm = truePosition_mm() - resetAt_mm_;
  return static_cast<std::int64_t>(std::floor(mm * 1e6 / static_cast<double>(settings_.step_nm) + 0.5)) *
         settings_.step_nm;
}

void SerialEmulator::sayPosition(const std::string& sequence) {
  std::string body = "P," + sequence + "," + std::to_string(static_cast<long long>(now_s() * 1e6)) + "," +
                     std::to_string(read_nm());
  if (settings_.version >= 2) body += stopped_ ? ",1" : limited_ ? ",0" : ",2";
  say(body);
}

// L,FORCE,SLEW,SPEED,RISE,SILENCE: stores the limits, reduced to the device's own, and replies with them.
void SerialEmulator::hearLimits(const std::string& body, const std::vector<std::string>& fields) {
  const double force_uN = numberIn(fields, 1), silence_ms = numberIn(fields, 5);
  if (fields.size() != 6 || force_uN <= 0 || force_uN > static_cast<double>(settings_.largestForce_uN) ||
      silence_ms <= 0 || silence_ms > 50)
    return say("N,limits");
  limit_uN_ = static_cast<std::int64_t>(force_uN);
  slew_N_per_s_ = numberIn(fields, 2) * 1e-3;
  speed_mm_per_s_ = numberIn(fields, 3) * 1e-3;
  rise_s_ = numberIn(fields, 4) * 1e-3;
  silence_s_ = silence_ms * 1e-3;
  limited_ = true;
  say(body);
}

void SerialEmulator::hearTable(const std::vector<std::string>& fields) {
  ownLaw_ = false;
  const double rows = numberIn(fields, 1);
  if (rows < 2 || rows > settings_.rows || numberIn(fields, 3) <= 0) return say("N,table");
  if (settings_.version >= 2 && (!limited_ || fields.size() != 7 || numberIn(fields, 6) <= 0 ||
                                 numberIn(fields, 6) > static_cast<double>(limit_uN_)))
    return say("N,no limit");
  table_ = {numberIn(fields, 2) * 1e-6, numberIn(fields, 3) * 1e-6, numberIn(fields, 4) * 1e-6,
            numberIn(fields, 5) * 1e-6, std::vector<UploadedTable::Row>(static_cast<std::size_t>(rows))};
  tableLimit_N_ = settings_.version >= 2 ? numberIn(fields, 6) * 1e-6 : 1e9;
  say("A");
}

void SerialEmulator::hear(const std::string& line) {
  const std::vector<std::string> fields = fieldsOf(line);
  if (fields.empty()) return;
  lastLine_s_ = now_s();
  const std::string& word = fields[0];
  if (word == "R" && ranTable() && ++rowsSinceTable_ % std::max(1, settings_.losesRow) == 0 &&
      settings_.losesRow > 0)
    return;
  if (word == "?") {
    say("I,plant," + std::to_string(settings_.step_nm) + "," + std::to_string(settings_.largestForce_uN) +
        "," + std::to_string(settings_.rate_Hz) + "," + std::to_string(settings_.rows) +
        (settings_.version >= 2 ? "," + std::to_string(settings_.version) : ""));
  } else if (word == "L" && settings_.version >= 2) {
    hearLimits(line.substr(0, line.rfind('*')), fields);
  } else if (word == "F" && fields.size() == 3) {
    ownLaw_ = false;
    force_N_ = numberIn(fields, 2) * 1e-6;
    sayPosition(fields[1]);
  } else if (word == "H" && fields.size() == 2) {
    sayPosition(fields[1]);
  } else if (word == "T") {
    hearTable(fields);
  } else if (word == "R" && fields.size() == 5) {
    const double index = numberIn(fields, 1);
    if (index < 0 || index >= static_cast<double>(table_.rows.size())) return say("N,row");
    table_.rows[static_cast<std::size_t>(index)] = {numberIn(fields, 2) * 1e-6, numberIn(fields, 3) * 1e-6,
                                                    numberIn(fields, 4) * 1e-6};
    say("A");
  } else if (word == "G") {
    ownLaw_ = table_.rows.size() >= 2 && (settings_.version < 2 || limited_);
    if (ownLaw_) ran_ = table_, beginScene();
    fade_ = force_N_ = 0;
    centre_mm_ = static_cast<double>(read_nm()) * 1e-6 + table_.radius_mm;
    say(ownLaw_ ? "A" : "N,no table");
  } else if (word == "X") {
    ownLaw_ = false;
    force_N_ = 0;
  } else if (word == "S" && settings_.version >= 2) {
    stopped_ = true;
  } else if (word == "U" && settings_.version >= 2) {
    stopped_ = false;
    fade_ = 0;
  }
}

// Limited first, then faded, then no faster than the slew.
double SerialEmulator::tableForce_N() {
  const double mm = static_cast<double>(read_nm()) * 1e-6, radius_mm = std::max(table_.radius_mm, 1e-6);
  centre_mm_ = std::clamp(centre_mm_, mm - radius_mm, mm + radius_mm);
  const double pressing = 0.5 * (1 + (mm - centre_mm_) / radius_mm), speed = trueSpeed_mm_per_s();
  const double law_N =
      pressing * table_.force_N(mm, true, speed) + (1 - pressing) * table_.force_N(mm, false, speed);
  const double most_N = std::min(tableLimit_N_, static_cast<double>(limit_uN_) * 1e-6);
  const double dt_s = HandleAndFinger::step_s;
  fade_ = std::abs(speed) > speed_mm_per_s_ ? std::max(0.0, fade_ - dt_s / 0.01)
                                            : std::min(1.0, rise_s_ > 0 ? fade_ + dt_s / rise_s_ : 1.0);
  const double wanted_N = fade_ * std::clamp(law_N, -most_N, most_N);
  return force_N_ + std::clamp(wanted_N - force_N_, -slew_N_per_s_ * dt_s, slew_N_per_s_ * dt_s);
}

double SerialEmulator::command_N() {
  if (settings_.stopAt_s >= 0 && scene_s() > settings_.stopAt_s && !switched_) switched_ = stopped_ = true;
  if (lastLine_s_ < 0 || now_s() - lastLine_s_ > silence_s_ || !mayPush()) {
    if (mayPush()) ownLaw_ = false;
    force_N_ = fade_ = 0;
    return 0;
  }
  if (ownLaw_) force_N_ = tableForce_N();
  const double limit_N = static_cast<double>(limit_uN_) * 1e-6;
  return std::clamp(force_N_, -limit_N, limit_N);
}

void SerialEmulator::reset() {
  resetAt_mm_ = truePosition_mm();
  ownLaw_ = limited_ = stopped_ = false;
  force_N_ = fade_ = 0;
  table_ = {};
  limit_uN_ = settings_.largestForce_uN;
  silence_s_ = 0.05;
}

}  // namespace detent::test
