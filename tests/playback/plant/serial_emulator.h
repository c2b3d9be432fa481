// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A microcontroller that speaks docs/reference/force-protocol.md, with the safety that the document asks of
// it.

#include <cstdint>
#include <string>
#include <vector>

#include "tests/playback/plant/pty_device.h"

namespace detent::test {

struct SerialEmulatorSettings {
  PtySettings pty;
  std::int64_t step_nm = 1000;
  std::int64_t largestForce_uN = 10000000;
  std::uint32_t rate_Hz = 4000;
  std::uint32_t rows = 256;
  int version = 2;       ///< of the protocol; 2 knows limits, an emergency stop and a state
  double stopAt_s = -1;  ///< its own emergency switch is opened at this time of the scene; < 0: never
  int losesRow = 0;      ///< once it has run a table, every so many-th row is lost on the way; 0: none
};

/// An uploaded table as the device uses it.
struct UploadedTable {
  struct Row {
    double press_N = 0, release_N = 0, damping_Ns_per_mm = 0;
  };
  double first_mm = 0, spacing_mm = 0, radius_mm = 0, bottomOut_N_per_mm = 0;
  std::vector<Row> rows;
  /// Force with the play wholly on one side, before any limit of the device.
  double force_N(double position_mm, bool pressing, double speed_mm_per_s) const;
};

class SerialEmulator : public PtyDevice {
 public:
  explicit SerialEmulator(const SerialEmulatorSettings& settings);
  ~SerialEmulator() override { halt(); }

  /// The table last started. A table uploaded again after a pause of the host may still lack rows when a run
  /// ends.
  const UploadedTable& table() const { return ran_; }
  bool ranTable() const { return !ran_.rows.empty(); }
  int rowsSinceTable() const { return rowsSinceTable_; }  ///< that were sent once it had run a table
  /// Largest force the host allowed (version 2), or the device's own.
  double limit_N() const { return static_cast<double>(limit_uN_) * 1e-6; }

 private:
  void hear(const std::string& line) override;
  double command_N() override;
  void reset() override;
  void say(const std::string& body);
  void sayPosition(const std::string& sequence);
  void hearTable(const std::vector<std::string>& fields);
  void hearLimits(const std::string& body, const std::vector<std::string>& fields);
  bool mayPush() const { return settings_.version < 2 || (limited_ && !stopped_); }
  double tableForce_N();
  std::int64_t read_nm() const;

  SerialEmulatorSettings settings_;
  UploadedTable table_, ran_;
  int rowsSinceTable_ = 0;
  std::int64_t limit_uN_;
  bool ownLaw_ = false, limited_ = false, stopped_ = false, switched_ = false;
  double force_N_ = 0, lastLine_s_ = -1, resetAt_mm_ = 0, centre_mm_ = 0;
  double slew_N_per_s_ = 1e9, speed_mm_per_s_ = 1e9, rise_s_ = 0, silence_s_ = 0.05, fade_ = 0,
         tableLimit_N_ = 1e9;
};

}  // namespace detent::test
