// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A microcontroller with motor and encoder behind our own line protocol (docs/reference/force-protocol.md): the host runs the law, or
// uploads it as a table.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playback/device/force_device.h"
#include "playback/device/serial_link.h"
#include "playback/realtime/force_program.h"

namespace detent::playback {

/// What the device says of itself.
struct SerialForceInfo {
  std::string name;
  double step_mm = 0, force_N = 0, rate_Hz = 0;
  std::uint32_t tableRows = 0;  ///< most it can hold; 0: it runs no law
};

class SerialForceDevice : public ForceDevice {
 public:
  /// Opens a port, asks who is there, sets the device's own limits and reads them back. Failure where nobody answers as the protocol
  /// says, or the device does not hold to the limits.
  static Result<std::unique_ptr<SerialForceDevice>> open(const std::string& port, unsigned baud,
                                                         double period_s, const ForceLimits& limits);
  ~SerialForceDevice() override;

  const SerialForceInfo& info() const { return info_; }

  /// Sends a law that the device then runs at its own rate; `exchange` only listens from then on, and its force is ignored.
  /// Failure where the table does not fit (`refusedAsTable`; the device says how many rows it takes), has no limit or one above that
  /// of `open`, or a row is not acknowledged. A device that heard nothing for longer than it waits has ended the table by itself:
  /// `exchange` then sends it again; one that was reset or away is given it when a person arms. Readings are then the newest there are,
  /// however late they come. Where none come for `longestUnheard_s`, nobody watches the device any more: it is commanded to give no force, and is
  /// given the table again once it answers.
  Result<Done> upload(const ForceProgram& program);
  /// Where a law has been uploaded: this one takes its place, a line with each exchange. A device that refuses it has lost its place.
  void setProgram(const ForceProgram& program) override;

  ForceReading exchange(const ForceCommand& command) override;
  std::optional<double> measureRoundTrip_s() override;
  bool setPace(double period_s) override;
  void rearm() override;
  /// Longest silence while the device runs a table; then it is commanded to give no force until answers are back.
  double longestUnheard_s() const override;
  ForceDeviceState state() const override {
    return link_.isOpen() ? ForceDeviceState::ready : ForceDeviceState::lost;
  }
  ForceLinkCounts counts() const override { return counts_; }

 private:
  SerialForceDevice(SerialLink link, double period_s, const ForceLimits& limits);
  bool hello(Message& problem);
  bool limited();
  bool acknowledged(const std::string& line);
  void send(std::string_view body);
  void sendOrders(const ForceCommand& command);
  void beginTable();
  bool lineIsDue() const;
  void sendTableLine();
  void noteAnswer(std::uint32_t sequence, long long time_us);
  void loseLaw();
  void withdrawLaw();
  enum class Answer : std::uint8_t { reading, old, other, none };
  Answer take(std::string_view line, ForceReading& reading);
  bool isBack();

  SerialLink link_;
  double wait_s_;  ///< for an answer
  ForceLimits limits_;
  SerialForceInfo info_;
  ForceLinkCounts counts_;
  std::string limitLine_;  ///< without checksum; a device that keeps to it says it back
  bool limitHeld_ = false;
  double roundTrip_s_ = 0;  ///< measured; 0: not yet
  double heardAt_s_ = 0;    ///< on now_s(): the last answer
  bool withdrawn_ = false;  ///< no answers came: the device was commanded to give no force by an F of 0
  std::uint32_t withdrawnSince_ = 0;  ///< the first question after that
  double silence_s_ = 0;              ///< after which a table is taken for ended
  bool ownLaw_ = false;               ///< the device runs the table, or is being given it
  std::vector<std::string> table_;    ///< its lines, without checksum
  std::size_t toldLines_ = 0;         ///< of them, those the device has acknowledged
  std::uint32_t lineSince_ = 0;       ///< the first question with which the next one may be sent
  std::uint32_t lineSent_ = 0;        ///< the last one with which a line was sent
  std::uint32_t heard_ = 0;           ///< the last one that was answered
  bool lineTaken_ = false;            ///< an acknowledgement came since the last answer
  bool stopSent_ = false, arming_ = false, zeroLost_ = false;
  bool tableDue_ = false;         ///< a person has armed: the table goes out once the limits are held
  std::uint32_t armedSince_ = 0;  ///< the first question after the last word that a person wants force
  std::uint32_t sequence_ = 0;
  long long heardTime_us_ = -1;  ///< the device's clock at the last answer that was heard
  double last_mm_ = 0;
};

/// Why a device that runs one table cannot run this button; none where it can.
std::optional<Failure> refusedAsTable(const ForceProgram& program, const std::string& device);

/// "L,..." without checksum: the limits as a device takes them and says them back.
std::string forceLimitLine(const ForceLimits& limits, double period_s);

/// The lines, without checksum, that tell a device to run the first state of a program by itself: the table thinned to at most `mostRows` >= 2, its first and
/// last row included, and the command to begin.
std::vector<std::string> forceTableLines(const ForceProgram& program, std::uint32_t mostRows);

/// A line of the protocol with its checksum and end: "F,17,120000*5A\n".
std::string forceLine(const std::string& body);
/// The fields of a received line; none where it has no checksum or a wrong one.
std::optional<std::string_view> forceLineBody(std::string_view line);

}  // namespace detent::playback
