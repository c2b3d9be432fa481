// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From a choice of a force device to the device, and how its link sets the pace: what pressing a button and
// measuring the device itself share.

#include <memory>

#include "model/result.h"
#include "playback/device/force_device.h"
#include "playback/device/force_orders.h"
#include "playback/device/simulated_finger.h"
#include "playback/force_feedback.h"
#include "playback/prepare/prepare_force.h"

namespace detent::playback {

/// `finger` presses on simulated devices only.
Result<std::unique_ptr<ForceDevice>> openForceDevice(const ForceDeviceChoice& choice,
                                                     const PreparedForce& prepared, FingerPlan finger);

/// Changes a program for a loop that only watches a device which runs the law by itself and goes on unheard
/// for `longestUnheard_s`.
void watchOnly(ForceProgram& program, double longestUnheard_s);

/// If the link sets the period, the answer comes in this share of it, the step and the next question in the
/// rest.
inline constexpr double answerOfSlowPeriod = 0.8;
/// Answers after `roundTrip_s` come too late for a loop of this period.
bool tooSlowFor(double period_s, double roundTrip_s);
/// Period that such a link allows, never shorter than the requested one.
double slowPeriod_s(double period_s, double roundTrip_s);

Result<std::unique_ptr<ForceOrders>> startForceOrders(ForceLoop& loop, const ForcePlayerSettings& settings);

}  // namespace detent::playback
