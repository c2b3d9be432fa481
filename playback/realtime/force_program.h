// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A prepared button on one device for the force loop: fixed size, trivially copyable, without allocation
// during playback. Built by prepare/prepare_force.h, played by force_engine.h.
//
// Signs: displacement grows with pressing; a positive force is the one with which the button pushes back, as
// in a force graph.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace detent::playback {

inline constexpr std::size_t maxForceRows =
    2048;  ///< rows per state; a travel of 4 mm is stored in steps of 3 µm or finer
inline constexpr std::size_t maxForceStates = 2;  ///< momentary: 1, self-locking: 2

/// number of speeds of a button that feels different at different speeds
inline constexpr std::size_t maxForceSpeeds = 4;

/// The forces of a state at one displacement and one speed; linear between rows.
struct ForceCurveRow {
  float press_N = 0, release_N = 0;  ///< press >= release
  /// self-locking: both strokes before the actuation, with a force that holds the handle at the rest
  /// where the state began
  float pending_N = 0;
};

/// Forces and damping of a state at one displacement, at its lowest speed or its only one.
struct ForceRow : ForceCurveRow {
  float damping_Ns_per_mm = 0;
  /// energy that a finger gets back if it releases slowly from here, along the release curve
  float stored_mJ = 0;
  float pendingStored_mJ = 0;  ///< the same before the actuation (self-locking)
};

/// One state of the button, at evenly spaced displacements. No slope in it is steeper than the device can
/// render.
struct ForceStateTable {
  double first_mm = 0;    ///< displacement of row 0; below it the force of row 0 applies
  double spacing_mm = 1;  ///< > 0
  std::uint32_t rowCount = 0;
  double bottomOutSlope_N_per_mm = 0;  ///< beyond the last row: an end stop that only pushes outwards
  bool hysteresis = false;             ///< press and release differ; otherwise only one curve is computed
  bool damped = false;                 ///< false: no damping is computed
  double rest_mm = 0;                  ///< position where a release ends after an actuation (self-locking)
  double operating_mm = 0;             ///< a press that reaches this displacement has actuated (self-locking)
  std::array<ForceRow, maxForceRows> rows{};
  /// 0: one graph for every speed. Otherwise the speeds of the graphs, increasing, and the rows of all but
  /// the lowest; forces are linear in speed between them and constant outside. No release lies above a press
  /// of any speed.
  std::uint32_t speedCount = 0;
  std::array<double, maxForceSpeeds> speeds_mm_per_s{};
  std::array<std::array<ForceCurveRow, maxForceRows>, maxForceSpeeds - 1> faster{};
};

enum class VelocityMethod : std::uint8_t { kalman, foaw, difference };

/// Parameters of the law besides its curves.
struct ForceLawSettings {
  double playRadius_mm =
      0.02;                 ///< > 0; half of the travel from the press to the release curve (play operator)
  double holdLead_s = 0;    ///< >= 0; half a period plus the device's delay: lateness of the force
  double settle_mm = 0.05;  ///< distance from rest at which an actuated state counts as returned
  /// >= 0; damping that catches the handle in a latch: added from a change of state until the handle is
  /// calm
  double catchDamping_Ns_per_mm = 0;
  double crossFade_s = 0.01;  ///< a difference of force between two states fades with this time constant
};

/// Limits of the device and of the forces sent to it. Every limit is on by default.
struct ForceLimits {
  double force_N = 5;  ///< > 0; largest force, both signs
  double slew_N_per_s =
      5000;  ///< > 0; fastest change of force; if it is below slope times speed, a bottom-out supplies energy
  double speed_mm_per_s = 2000;  ///< > 0; above this speed the force fades, because no button moves like that
  /// > 0; largest acceleration of the handle: 40 times that of free fall, beyond fingers and motors of these
  /// forces. It may stop instantly.
  double acceleration_mm_per_s2 = 4e5;
  double lowest_mm = -50;  ///< readings outside lowest..highest are rejected
  double highest_mm = 150;
  double startRamp_s = 0.2;        ///< > 0; duration of the increase of force from zero
  double stopRamp_s = 0.01;        ///< > 0; duration of its decrease to zero
  double emergencyRamp_s = 0.005;  ///< > 0; duration of the decrease at an emergency stop, or if nobody holds
  std::uint32_t heldReadings = 3;  ///< number of bad readings that are bridged with the last force
  double longestHold_s = 0.0039;   ///< > 0; longest time that is bridged
  /// > 0; after a longer pause of the loop the force starts from zero, because the device has removed it
  /// meanwhile
  double stall_s = 0.012;
  /// >= 0; an encoder that does not count a step under a larger force is probed, then declared broken;
  /// infinity: never.
  double deadCountAbove_N = std::numeric_limits<double>::infinity();
  /// only at larger displacements, because a handle may rest at its stop for any time
  double deadCountFrom_mm = 0.1;
  double travelEnd_mm = std::numeric_limits<double>::infinity();  ///< end of the button's travel
  double movedMass_kg = 0.05;  ///< > 0; approximate; for judging the speed of a runaway handle
};

/// The pushes before the first force, which prove that motor and encoder agree in direction.
struct DirectionProofSettings {
  bool present = false;
  double push_N = 0.09;  ///< > 0; largest push
  double way_mm = 0.05;  ///< > 0; distance that the handle must follow each push
};

/// Sideways springs of a three-axis device, which keep the motion on the axis of the button (Shrestha, Figure
/// 3).
struct ForceGuide {
  bool present = false;
  double stiffness_N_per_mm = 0;
  double damping_Ns_per_mm = 0;
  double force_N = 0;  ///< largest
};

/// Forces that reveal the dynamics of a free handle, in place of a button's law. The relay drives it back and
/// forth between two displacements at several speeds and lets it coast between; the chirp shakes it around
/// the middle with increasing frequency.
struct ForceExcitation {
  enum class Kind : std::uint8_t { none, relay, chirp };
  Kind kind = Kind::none;
  double middle_mm = 5, half_mm = 2;  ///< half_mm > 0: turning points at this distance from the middle
  double largest_N = 1;               ///< > 0; largest force
  double lead_s = 0.001;              ///< >= 0; approximate delay of a force
  // For the relay.
  double slowest_mm_per_s = 30, fastest_mm_per_s = 150;
  // For the chirp.
  double mass_kg = 0.05,
         friction_N =
             0;  ///< approximate; the force is that which moves this mass by `shake_mm`, plus its friction
  double shake_mm = 0.8;
  double from_Hz = 8, to_Hz = 120, sweep_s = 3;  ///< then a second, stronger sweep
};

/// A button prepared for one device.
struct ForceProgram {
  double period_s = 0.001;  ///< > 0; one step
  double step_mm = 0.01;    ///< > 0; of the device's encoder
  VelocityMethod velocity = VelocityMethod::kalman;
  ForceLawSettings law;
  ForceLimits limits;
  ForceGuide guide;
  bool passivityController = false;  ///< false: the observer only measures
  ForceExcitation excitation;        ///< if present, replaces the states
  DirectionProofSettings proof;      ///< before any other force, at the start and each time a person arms
  std::uint32_t stateCount = 0;
  std::array<ForceStateTable, maxForceStates> states{};
};

static_assert(std::is_trivially_copyable_v<ForceProgram>, "a program crosses threads by plain copy");

}  // namespace detent::playback
