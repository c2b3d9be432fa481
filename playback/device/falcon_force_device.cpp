// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/falcon_force_device.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "playback/device/falcon_kinematics.h"
#include "playback/device/falcon_protocol.h"
#include "playback/device/falcon_usb.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr double falconWaitOfPeriod = 0.5, falconAnswer_s = 0.2, reopenPause_s = 0.2, falconFarewell_s = 0.05;
constexpr int helloTries = 20, firstAnswers = 20, farewells = 3;
constexpr unsigned uploadTries = 10;
constexpr std::size_t pieceBytes = 62;
// An exchange takes about a period, so two commands may be under way. If more than these have no answer, one
// was lost.
constexpr unsigned mostUnanswered = 2;
constexpr double lost_s = 0.05;
// A person takes seconds to move the handle out and in. A shorter homing means corrupt packets, which have no
// checksum.
constexpr double homing_s = 0.5;

// Motor value per torque, and the largest one, as in libnifalcon; not verified by a measurement.
constexpr double motorPerNm = 10000, largestMotor = 4096;

constexpr std::uint8_t helloQuestion[] = {0x0a, 0x43, 0x0d}, helloAnswer[] = {0x0a, 0x44, 0x2c, 0x0d},
                       synchronise[] = {0x41};

using Bytes = std::span<const std::uint8_t>;

/// Reads until the received bytes end with `wanted`.
bool heard(FalconUsb& usb, Bytes wanted, double wait_s) {
  std::vector<std::uint8_t> got;
  for (const double deadline_s = now_s() + wait_s; usb.alive() && now_s() < deadline_s;) {
    const Bytes bytes = usb.receive(deadline_s);
    got.insert(got.end(), bytes.begin(), bytes.end());
    if (got.size() >= wanted.size() && std::equal(wanted.rbegin(), wanted.rend(), got.rbegin())) return true;
  }
  return false;
}

bool delivered(FalconUsb& usb, Bytes bytes) { return usb.send(bytes) && usb.sent(now_s() + falconAnswer_s); }

bool greeted(FalconUsb& usb) {
  if (!usb.set(FalconLine::hello)) return false;
  bool answered = false;
  for (int i = 0; i < helloTries && !answered && usb.alive(); ++i)
    answered = delivered(usb, helloQuestion) && heard(usb, helloAnswer, falconAnswer_s / 4);
  return answered && usb.set(FalconLine::upload) && delivered(usb, synchronise) &&
         heard(usb, synchronise, falconAnswer_s);
}

/// Uploads in pieces; the device returns each piece as it was sent.
bool uploaded(FalconUsb& usb, Bytes image, const std::atomic<bool>& cancelled) {
  if (!greeted(usb)) return false;
  for (; !image.empty(); image = image.subspan(std::min(pieceBytes, image.size()))) {
    const Bytes piece = image.first(std::min(pieceBytes, image.size()));
    if (cancelled || !delivered(usb, piece) || !heard(usb, piece, falconAnswer_s)) return false;
  }
  return true;
}

/// Returns true if a firmware is running: then it answers an empty packet.
bool running(FalconUsb& usb) {
  if (!usb.set(FalconLine::run)) return false;
  FalconAnswers answers;
  const FalconPacket quiet = falconPacket({});
  for (int i = 0; i < firstAnswers && usb.alive(); ++i) {
    if (!delivered(usb, quiet)) continue;
    for (const std::uint8_t byte : usb.receive(now_s() + falconAnswer_s / 10)) {
      if (answers.take(byte)) return true;
    }
  }
  return false;
}

struct Started {
  std::unique_ptr<FalconUsb> usb;
  unsigned uploads = 0;  ///< number of attempts to upload the firmware
};

Result<Started> startedFalcon(const FalconSettings& settings, const std::atomic<bool>& cancelled) {
  Result<std::unique_ptr<FalconUsb>> usb = FalconUsb::open(settings.number);
  if (!usb) return usb.failure();
  Started started{std::move(*usb), 0};
  const std::string name = "Novint Falcon " + std::to_string(settings.number);
  if (running(*started.usb)) return started;
  if (settings.firmware.empty()) {
    return Failure{FailureCode::deviceTrouble,
                   name,
                   "",
                   Message("the Falcon was switched on and has no firmware yet"),
                   {{RemedyKind::advice, Message("Choose its firmware file (docs/guide/force-feedback.md)")},
                    {RemedyKind::advice, Message("On the command line: --firmware FILE")}}};
  }
  while (started.uploads < uploadTries && started.usb->alive() && !cancelled) {
    ++started.uploads;
    if (uploaded(*started.usb, settings.firmware, cancelled) && running(*started.usb)) return started;
  }
  return Failure{FailureCode::deviceTrouble, name, "",
                 Message("the Falcon did not accept the firmware in %1 attempts", started.uploads),
                 Message("Switch the device off and on, connect it without a hub, and try again")};
}

class FalconForceDevice : public ForceDevice {
 public:
  FalconForceDevice(const FalconSettings& settings, Started started) : settings_(settings) {
    take(std::move(started));
  }

  ~FalconForceDevice() override {
    ending_ = true;
    if (!usb_) return;
    const FalconPacket quiet = falconPacket({});
    for (int i = 0; i < farewells; ++i) {
      usb_->sent(now_s() + falconFarewell_s);
      usb_->send(quiet);
    }
    usb_->sent(now_s() + falconFarewell_s);
  }

  ForceReading exchange(const ForceCommand& command) override {
    ForceReading reading;
    reading.fresh = false;
    ++counts_.exchanges;
    if (!usb_ || !usb_->alive()) {
      bringBack();
      return reading;
    }
    send(command);
    const std::optional<FalconAnswer> answer =
        newestAnswer(now_s() + falconWaitOfPeriod * settings_.period_s);
    if (!answer) {
      ++counts_.late;
      return reading;
    }
    homed_ = answer->homed;
    if (!homed_) {
      if (!unhomedSince_s_) unhomedSince_s_ = now_s();
      return reading;
    }
    const std::optional<double> since_s = std::exchange(unhomedSince_s_, std::nullopt);
    if (since_s && now_s() - *since_s >= homing_s) zero_ = ForceReading::Zero::found;
    reading = placed(*answer);
    reading.zero = std::exchange(zero_, ForceReading::Zero::kept);
    return reading;
  }

  ForceDeviceState state() const override {
    if (!usb_ || !usb_->alive()) return ForceDeviceState::lost;
    return homed_ ? ForceDeviceState::ready : ForceDeviceState::homing;
  }

  ForceLinkCounts counts() const override { return counts_; }

 private:
  void take(Started started) {
    usb_ = std::move(started.usb);
    counts_.firmwareTries += started.uploads;
    homed_ = false;
    unhomedSince_s_.reset();
    unanswered_ = 0;
    answers_.forget();
    place_mm_ = {0, 0, falconRest_mm};
  }

  void send(const ForceCommand& command) {
    if (unanswered_ >= mostUnanswered) {
      if (now_s() - sent_s_ < lost_s) return;
      unanswered_ = 0;
    }
    FalconCommand out;
    out.light = homed_ ? FalconLight::green : FalconLight::red;
    out.homing = !homed_;
    if (homed_) out.motors = motorsOf(command);
    if (!usb_->send(falconPacket(out))) return;
    ++unanswered_;
    sent_s_ = now_s();
  }

  std::optional<FalconAnswer> newestAnswer(double deadline_s) {
    std::optional<FalconAnswer> newest;
    while (!newest && usb_->alive()) {
      for (const std::uint8_t byte : usb_->receive(deadline_s)) {
        if (const std::optional<FalconAnswer> answer = answers_.take(byte)) {
          newest = answer;
          counts_.repeated += unanswered_ == 0 ? 1 : 0;
          unanswered_ -= unanswered_ > 0 ? 1 : 0;
        }
      }
      if (now_s() >= deadline_s) break;
    }
    counts_.malformed = answers_.malformed();
    return newest;
  }

  ForceReading placed(const FalconAnswer& answer) {
    FalconAngles_rad angles_rad{};
    for (std::size_t i = 0; i < angles_rad.size(); ++i) angles_rad[i] = falconAngle_rad(answer.counts[i]);
    ForceReading reading;
    const std::optional<FalconPlace_mm> place_mm = falconPlace_mm(angles_rad, place_mm_);
    if (!place_mm) {  // impossible angles of the legs: the guard rejects NaN
      reading.position_mm = std::numeric_limits<double>::quiet_NaN();
      return reading;
    }
    place_mm_ = *place_mm;
    reading.position_mm = falconRest_mm - place_mm_[2];
    reading.sideways_mm = {place_mm_[0], place_mm_[1]};
    return reading;
  }

  /// If one value would be too large, all three are scaled by the same factor, so that the force keeps its
  /// direction.
  std::array<int, 3> motorsOf(const ForceCommand& command) const {
    std::array<int, 3> motors{};
    const auto torques_Nm =
        falconTorques_Nm(place_mm_, {command.sideways_N[0], command.sideways_N[1], command.force_N});
    if (!torques_Nm) return motors;
    double largest = largestMotor;
    for (const double torque_Nm : *torques_Nm) largest = std::max(largest, std::abs(motorPerNm * torque_Nm));
    for (std::size_t i = 0; i < motors.size(); ++i)
      motors[i] = static_cast<int>(std::lround(-motorPerNm * (*torques_Nm)[i] * largestMotor / largest));
    return motors;
  }

  // Opening the device and uploading a firmware take seconds, so another thread does it while the loop
  // continues without force.
  void bringBack() {
    if (!returning_.valid()) {
      if (now_s() - triedBack_s_ < reopenPause_s) return;
      usb_.reset();
      returning_ = std::async(std::launch::async, [this] { return startedFalcon(settings_, ending_); });
      return;
    }
    if (returning_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    triedBack_s_ = now_s();
    Result<Started> started = returning_.get();
    if (!started) return;
    take(std::move(*started));
    zero_ = ForceReading::Zero::lost;  // until the handle has been moved out and in, or somebody arms
    ++counts_.reconnects;
  }

  FalconSettings settings_;
  std::unique_ptr<FalconUsb> usb_;
  FalconAnswers answers_;
  ForceLinkCounts counts_;
  FalconPlace_mm place_mm_{};
  bool homed_ = false;
  std::optional<double> unhomedSince_s_;  ///< time of the first answer that reports it
  unsigned unanswered_ = 0;               ///< commands without an answer so far
  /// state of the zero, to be reported with the next reading
  ForceReading::Zero zero_ = ForceReading::Zero::kept;
  double sent_s_ = 0, triedBack_s_ = 0;
  std::atomic<bool> ending_{false};
  /// declared last, because it uses the other members until it is done
  std::future<Result<Started>> returning_;
};

}  // namespace

Result<std::unique_ptr<ForceDevice>> openFalcon(const FalconSettings& settings) {
  const std::atomic<bool> never{false};
  Result<Started> started = startedFalcon(settings, never);
  if (!started) return started.failure();
  return std::unique_ptr<ForceDevice>(std::make_unique<FalconForceDevice>(settings, std::move(*started)));
}

}  // namespace detent::playback
