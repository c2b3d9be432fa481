// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/fitted_force.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "playback/prepare/loop_limit.h"
#include "playback/prepare/stability.h"

namespace detent::playback {

namespace {

constexpr double busyShare = 0.5;  // share of a round trip from which this computer is named as the cause
constexpr double finestEncoder_mm = 1e-4;  // no device has a finer one

/// The slope that a graph needs at least: that of a straight line from zero to its strongest force over its
/// travel.
double plainestSlope_N_per_mm(const Button& button, double largest_N) {
  double plainest = 0;
  for (const ButtonState& state : button.states()) {
    const StrokeCurve& press = state.graph.press();
    plainest = std::max(plainest, std::min(press.forceRange_N().second, largest_N) / press.travel_mm());
  }
  return plainest;
}

/// Rounds to this many digits, so that measured values are not shown finer than measured.
double rounded(double value, int digits) {
  if (!(value > 0)) return value;
  const double unit = std::pow(10, std::floor(std::log10(value)) - (digits - 1));
  return std::round(value / unit) * unit;
}

/// Factor on the force or slope that a remedy suggests, so that the button is then accepted with a margin.
constexpr double spareOfRemedy = 1.1;

}  // namespace

Failure tooSteepFor(const ForceDeviceProfile& device, const ForceLinkPace& pace, const MarginPoint& least,
                    double needed_N_per_mm) {
  const double allowed = rounded(least.allowed_N_per_mm, 2), needed = rounded(needed_N_per_mm, 2);
  if (pace.roundTrip_s > 0) {
    const double answer_ms = rounded(1e3 * pace.roundTrip_s, 3), late_ms = rounded(1e3 * device.delay_s, 3);
    const bool busy = pace.computer_s > busyShare * pace.roundTrip_s;
    return {
        FailureCode::deviceTrouble, device.name, "",
        Message("the device answers after %1 ms, so the force acts %2 ms late. With this delay, slopes up to "
                "%3 N/mm are stable; this button needs %4 N/mm",
                answer_ms, late_ms, allowed, needed),
        busy ? Remedies(Message(
                   "This computer is too slow: a message to itself takes %1 ms. Close other programs and "
                   "allow real-time scheduling (docs/guide/force-feedback.md)",
                   rounded(1e3 * pace.computer_s, 3)))
             : Remedies{
                   {RemedyKind::advice,
                    Message("The device is too slow. Make the connection faster: native USB, a higher "
                            "baud rate, an FTDI latency timer of 1 ms. Or let the device compute the force")},
                   {RemedyKind::advice, Message("On the command line: --baud, --upload")}}};
  }
  const auto bears =
      Message("can hold %1 N/mm by its measured profile; this button needs %2 N/mm", allowed, needed);
  if (least.bound == StabilityBound::quantisation) {
    const double spared_N_per_mm = spareOfRemedy * needed_N_per_mm;
    const double friction_N = rounded(spared_N_per_mm * device.step_mm / heldByFriction, 2),
                 step_mm = rounded(heldByFriction * device.friction_N / spared_N_per_mm, 2);
    return {FailureCode::deviceTrouble, device.name, "", bears,
            step_mm >= finestEncoder_mm
                ? Message("With friction of %1 N or an encoder step of %2 mm, the button would be stable",
                          friction_N, step_mm)
                : Message("With friction of %1 N, the button would be stable", friction_N)};
  }
  return {
      FailureCode::deviceTrouble, device.name, "", bears,
      Message(
          "With more damping of the handle, a faster loop or a shorter delay, the button would be stable")};
}

Result<FittedForce> fittedTo(const Button& button, const ForceDeviceProfile& device,
                             const ForceSettings& settings, const ForceLinkPace& pace) {
  Result<StableButton> stable = nearestStable(button, device, device.rate_Hz);
  const double needed = plainestSlope_N_per_mm(button, device.limits.force_N);
  const MarginPoint least = stabilityOf(stable ? stable->button : button, device, device.rate_Hz).least;
  const double allowed = stable ? least.allowed_N_per_mm : 0;
  if (allowed < needed) return tooSteepFor(device, pace, least, needed);
  ForceDeviceProfile softened = device;
  softened.largestSlope_N_per_mm = std::min(device.largestSlope_N_per_mm, allowed);
  ForceSettings atRate = settings;
  atRate.rate_Hz = device.rate_Hz;
  atRate.passivityController = settings.passivityController || device.measured;
  Result<PreparedForce> prepared = prepareForce(stable->button, softened, atRate);
  if (!prepared) return prepared.failure();
  FittedForce fitted{*std::move(prepared), softened, pace};
  for (const StabilityChange& c : stable->changes) {
    fitted.pace.addedDamping_Ns_per_mm =
        std::max(fitted.pace.addedDamping_Ns_per_mm, c.addedDamping_Ns_per_mm);
    fitted.pace.largestForceChange_N = std::max(fitted.pace.largestForceChange_N, c.largestForceChange_N);
  }
  return fitted;
}

Result<FittedForce> keptTo(const ForceDeviceProfile& profile, const Button& button,
                           const ForceSettings& settings, PreparedForce prepared) {
  FittedForce unlimited{std::move(prepared), profile, {}};
  unlimited.device.rate_Hz = 1 / unlimited.prepared.program.period_s;
  if (!profile.measured) return unlimited;
  // A slope above the device's limit is limited in any case.
  const std::vector<UnstableStretch> unstable =
      stabilityOf(button, profile, unlimited.device.rate_Hz).unstable;
  const bool borne = std::ranges::all_of(
      unstable, [](const UnstableStretch& u) { return u.worst.bound == StabilityBound::device; });
  if (borne) return unlimited;
  return fittedTo(button, unlimited.device, settings, {});
}

}  // namespace detent::playback
