// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A microcontroller with motor and encoder behind our own line protocol (docs/reference/force-protocol.md):
// the host runs the law, or uploads it as a table.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playback/device/force_device.h"
#include "playback/device/serial_link.h"
#include "playback/realtime/force_program.h"

namespace detent::playback {

/// The device's description of itself.
struct SerialForceInfo {
  std::string name;
  double step_mm = 0, force_N = 0, rate_Hz = 0;
  std::uint32_t tableRows = 0;  ///< largest number of rows that it can hold; 0: it cannot run a law
};

class SerialForceDevice : public ForceDevice {
 public:
  /// Opens a port, identifies the device, sets the device's own limits and reads them back. Failure if no
  /// device answers by the protocol, or if it does not accept the limits.
  static Result<std::unique_ptr<SerialForceDevice>> open(const std::string& port, unsigned baud,
                                                         double period_s, const ForceLimits& limits);
  ~SerialForceDevice() override;

  const SerialForceInfo& info() const { return info_; }

  /// Uploads a law that the device then runs at its own rate. From then on `exchange` only reads, and its
  /// force is ignored. Failure if the table does not fit (`refusedAsTable`; the device reports how many rows
  /// it takes), has no limit or one above that of `open`, or if a row is not acknowledged. A device that has
  /// received nothing for longer than its limit ends the table itself, and `exchange` uploads it again; one
  /// that was reset or disconnected gets it when a person arms. Readings are the newest available, however
  /// late. If none arrive for `longestUnheard_s`, nobody watches the device any more: it is commanded to give
  /// no force, and gets the table again once it answers.
  Result<Done> upload(const ForceProgram& program);
  /// If a law has been uploaded, replaces it by this one, one line per exchange. A device that refuses it
  /// must be armed again.
  void setProgram(const ForceProgram& program) override;

  ForceReading exchange(const ForceCommand& command) override;
  std::optional<double> measureRoundTrip_s() override;
  bool setPace(double period_s) override;
  void rearm() override;
  /// Longest time without answers while the device runs a table; then it is commanded to give no force until
  /// answers arrive again.
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
  double wait_s_;  ///< longest wait for an answer
  ForceLimits limits_;
  SerialForceInfo info_;
  ForceLinkCounts counts_;
  std::string limitLine_;  ///< without checksum; a device that accepts it repeats it
  bool limitHeld_ = false;
  double roundTrip_s_ = 0;  ///< measured; 0: not yet
  double heardAt_s_ = 0;    ///< time of the last answer, on now_s()
  bool withdrawn_ = false;  ///< answers stopped, so the device was commanded to give no force (an F of 0)
  std::uint32_t withdrawnSince_ = 0;   ///< the first question after that command
  double silence_s_ = 0;               ///< time without messages after which the device ends a table
  bool ownLaw_ = false;                ///< the device runs the table, or is receiving it
  std::vector<std::string> table_;     ///< lines of the table, without checksum
  std::size_t acknowledgedLines_ = 0;  ///< number of lines that the device has acknowledged
  std::uint32_t lineSince_ = 0;        ///< the first question with which the next line may be sent
  std::uint32_t lineSent_ = 0;         ///< the last question with which a line was sent
  std::uint32_t heard_ = 0;            ///< the last question that was answered
  bool lineTaken_ = false;             ///< an acknowledgement came since the last answer
  bool stopSent_ = false, arming_ = false, zeroLost_ = false;
  bool tableDue_ = false;         ///< a person has armed: the table is sent once the limits are accepted
  std::uint32_t armedSince_ = 0;  ///< the first question after a person last armed
  std::uint32_t sequence_ = 0;
  long long heardTime_us_ = -1;  ///< the device's clock in the last answer that arrived
  double last_mm_ = 0;
};

/// The reason why a device that runs one table cannot run this button; none if it can.
std::optional<Failure> refusedAsTable(const ForceProgram& program, const std::string& device);

/// "L,..." without checksum: the limits, in the form in which a device accepts and repeats them.
std::string forceLimitLine(const ForceLimits& limits, double period_s);

/// The lines, without checksum, that make a device run the first state of a program: the table, thinned to at
/// most `mostRows` >= 2 rows including its first and last, and the command to begin.
std::vector<std::string> forceTableLines(const ForceProgram& program, std::uint32_t mostRows);

/// A line of the protocol with its checksum and end: "F,17,120000*5A\n".
std::string forceLine(const std::string& body);
/// The fields of a received line; none if its checksum is missing or wrong.
std::optional<std::string_view> forceLineBody(std::string_view line);

}  // namespace detent::playback
