// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A force engine that is connected to a simulated device, whose physics shares no code with the engine: once
// per period the engine gets a reading and returns a force.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "model/button.h"
#include "playback/prepare/prepare_force.h"
#include "playback/realtime/force_engine.h"
#include "tests/playback/plant/faults.h"
#include "tests/playback/plant/handle.h"
#include "tests/playback/plant/transport.h"

namespace detent::test {

/// A button of samples/buttons, by the name of its file ("B").
Button sampleButton(const std::string& name);
/// Throws with the sentence of the failure: a test that cannot be set up has failed.
playback::ForceProgram preparedFor(const Button& button, const playback::ForceDeviceProfile& device,
                                   const playback::ForceSettings& settings = {});
/// Settings of a simulated handle with the figures of a device profile.
HandleSettings handleOf(const playback::ForceDeviceProfile& device);

struct LoopSettings {
  HandleSettings handle;
  FingerSettings finger;
  TransportSettings reading, sending;
  double encoderStep_mm = 0.001;
  double start_mm = 0;
  std::uint64_t seed = 1;
};

/// State of one period.
struct LoopStep {
  double time_s = 0;
  double position_mm = 0;  ///< true
  double read_mm = 0;      ///< position as the engine received it
  bool fresh = false;
  double command_N = 0;  ///< force that the engine requested
  double motor_N = 0;    ///< force that acted, after delay and lag
  double finger_N = 0;
  double fingerWork_mJ = 0;
  std::uint32_t state = 0;
  bool actuated = false;
};

class ClosedLoop {
 public:
  ClosedLoop(const playback::ForceProgram& program, const LoopSettings& settings, Plan plan,
             std::vector<Fault> faults = {});

  LoopStep step();
  /// Steps until a time; returns all steps.
  std::vector<LoopStep> runUntil(double time_s);

  playback::ForceEngine& engine() { return engine_; }
  HandleAndFinger& world() { return world_; }
  const playback::ForceProgram& program() const { return *program_; }

 private:
  std::unique_ptr<playback::ForceProgram> program_;
  playback::ForceEngine engine_;
  LoopSettings settings_;
  HandleAndFinger world_;
  FaultyEncoder encoder_;
  Transport<double> reading_, sending_;
  std::int64_t index_ = 0;
  double arrived_N_ = 0, read_mm_ = 0;
};

}  // namespace detent::test
