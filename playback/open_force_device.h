// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Opens a chosen force device, and determines the pace that its link allows. Shared by pressing a button and
// by measuring the device.

#include <memory>

#include "model/result.h"
#include "playback/device/force_device.h"
#include "playback/device/force_orders.h"
#include "playback/device/simulated_finger.h"
#include "playback/force_feedback.h"
#include "playback/prepare/prepare_force.h"

namespace detent::playback {

/// `finger` presses only on simulated devices.
Result<std::unique_ptr<ForceDevice>> openForceDevice(const ForceDeviceChoice& choice,
                                                     const PreparedForce& prepared, FingerPlan finger);

/// Adapts a program for a loop that only watches a device which runs the law itself and continues for
/// `longestUnheard_s` without messages.
void watchOnly(ForceProgram& program, double longestUnheard_s);

/// If the link determines the period, the answer arrives within this share of it; the rest is for the step
/// and the next question.
inline constexpr double answerOfSlowPeriod = 0.8;
/// Returns true if answers after `roundTrip_s` arrive too late for a loop of this period.
bool tooSlowFor(double period_s, double roundTrip_s);
/// The period that such a link allows, never shorter than the requested one.
double slowPeriod_s(double period_s, double roundTrip_s);

Result<std::unique_ptr<ForceOrders>> startForceOrders(ForceLoop& loop, const ForcePlayerSettings& settings);

}  // namespace detent::playback
