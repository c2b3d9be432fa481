// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/plant/closed_loop.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "model/file/button_file.h"

namespace detent::test {

Button sampleButton(const std::string& name) {
  Result<Button> button =
      readButtonFile(std::string(DETENT_SOURCE_DIR "/samples/buttons/") + name + ".button.json");
  if (!button) throw std::runtime_error(button.failure().sentence());
  return *std::move(button);
}

playback::ForceProgram preparedFor(const Button& button, const playback::ForceDeviceProfile& device,
                                   const playback::ForceSettings& settings) {
  Result<playback::PreparedForce> prepared = playback::prepareForce(button, device, settings);
  if (!prepared) throw std::runtime_error(prepared.failure().sentence());
  return prepared->program;
}

HandleSettings handleOf(const playback::ForceDeviceProfile& device) {
  HandleSettings handle;
  handle.mass_kg = device.mass_kg;
  handle.damping_Ns_per_mm = device.damping_Ns_per_mm;
  handle.coulomb_N = device.friction_N;
  handle.static_N = 1.2 * device.friction_N;
  return handle;
}

ClosedLoop::ClosedLoop(const playback::ForceProgram& program, const LoopSettings& settings, Plan plan,
                       std::vector<Fault> faults)
    : program_(std::make_unique<playback::ForceProgram>(program)),
      engine_(*program_),
      settings_(settings),
      world_(settings.handle, settings.finger, std::move(plan), settings.start_mm),
      encoder_(std::move(faults)),
      reading_(settings.reading, settings.seed),
      sending_(settings.sending, settings.seed + 1),
      read_mm_(settings.start_mm) {}

LoopStep ClosedLoop::step() {
  const double now_s = static_cast<double>(index_) * program_->period_s;
  reading_.send(now_s, quantised_mm(world_.position_mm(), settings_.encoderStep_mm));
  const std::optional<double> arrived_mm = reading_.newest(now_s);
  if (arrived_mm) read_mm_ = *arrived_mm;
  playback::ForceReading reading = encoder_.reading(index_, read_mm_);
  reading.fresh = reading.fresh && arrived_mm;
  const double command_N = engine_.step(reading).force_N;
  sending_.send(now_s, command_N);
  ++index_;
  const double next_s = static_cast<double>(index_) * program_->period_s;
  do {
    if (const std::optional<double> force_N = sending_.newest(world_.time_s())) arrived_N_ = *force_N;
    world_.advance(arrived_N_);
  } while (world_.time_s() < next_s - 0.5 * HandleAndFinger::step_s);
  LoopStep out;
  out.time_s = now_s;
  out.position_mm = world_.position_mm();
  out.read_mm = reading.position_mm;
  out.fresh = reading.fresh;
  out.command_N = command_N;
  out.motor_N = world_.motorForce_N();
  out.finger_N = world_.fingerForce_N();
  out.fingerWork_mJ = world_.energy().finger_mJ;
  out.state = engine_.last().state;
  out.actuated = engine_.last().actuated;
  return out;
}

std::vector<LoopStep> ClosedLoop::runUntil(double time_s) {
  std::vector<LoopStep> steps;
  while (static_cast<double>(index_) * program_->period_s < time_s - 1e-9) steps.push_back(step());
  return steps;
}

}  // namespace detent::test
