// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A prepared button on one device for the force loop: fixed size, plainly copyable, nothing to allocate or
// free while it plays. Built by prepare/prepare_force.h, played by force_engine.h.
//
// Signs: displacement grows with pressing; a positive force is what the button pushes back with, as in a
// force graph.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace detent::playback {

inline constexpr std::size_t maxForceRows =
    2048;  ///< per state; a travel of 4 mm is stored every 3 µm or finer
inline constexpr std::size_t maxForceStates = 2;  ///< momentary: 1, self-locking: 2

inline constexpr std::size_t maxForceSpeeds = 4;  ///< of a button that feels different at different speeds

/// The forces of a state at one displacement and one speed; linear between rows.
struct ForceCurveRow {
  float press_N = 0, release_N = 0;  ///< press >= release
  float pending_N =
      0;  ///< self-locking: both ways before the actuation, held at the rest the state began with
};

/// Forces and damping of a state at one displacement, at its lowest speed or its only one.
struct ForceRow : ForceCurveRow {
  float damping_Ns_per_mm = 0;
  float stored_mJ = 0;         ///< what a finger that lets go here gets back, slowly, along the release
  float pendingStored_mJ = 0;  ///< and before the actuation (self-locking)
};

/// One state of the button, on evenly spaced displacements. No slope in it is steeper than the device can
/// render.
struct ForceStateTable {
  double first_mm = 0;    ///< displacement of row 0; before it the force is row 0's
  double spacing_mm = 1;  ///< > 0
  std::uint32_t rowCount = 0;
  double bottomOutSlope_N_per_mm = 0;  ///< beyond the last row: an end stop that only pushes
  bool hysteresis = false;             ///< press and release differ; else one curve is computed
  bool damped = false;                 ///< else no damping is computed
  double rest_mm = 0;                  ///< where a release ends after an actuation (self-locking)
  double operating_mm = 0;             ///< a press that arrives here has actuated (self-locking)
  std::array<ForceRow, maxForceRows> rows{};
  /// 0: one graph for every speed. Else the speeds of the graphs, rising, and the rows of all but the lowest;
  /// linear in speed between them, held outside. No release of any of them lies above a press of any.
  std::uint32_t speedCount = 0;
  std::array<double, maxForceSpeeds> speeds_mm_per_s{};
  std::array<std::array<ForceCurveRow, maxForceRows>, maxForceSpeeds - 1> faster{};
};

enum class VelocityMethod : std::uint8_t { kalman, foaw, difference };

/// The law's numbers besides its curves.
struct ForceLawSettings {
  double playRadius_mm =
      0.02;                 ///< > 0; way from the press to the release curve is twice this (play operator)
  double holdLead_s = 0;    ///< >= 0; half a period and the device's delay: how late the force will act
  double settle_mm = 0.05;  ///< an actuated state counts as back at rest this close to it
  double catchDamping_Ns_per_mm =
      0;  ///< >= 0; a latch catches: added from a change of state until the handle is calm
  double crossFade_s = 0.01;  ///< a difference of force between two states fades with this time constant
};

/// Capabilities of the device and limits of its commands. Every limit is on by default.
struct ForceLimits {
  double force_N = 5;  ///< > 0; largest force, both signs
  double slew_N_per_s =
      5000;  ///< > 0; fastest change of force; below slope times speed a bottom-out gives energy
  double speed_mm_per_s = 2000;  ///< > 0; above it the force fades: no button moves like that
  /// > 0; a handle gains speed no faster: 40 times a free fall, beyond fingers and motors of these forces. It
  /// may stop at once.
  double acceleration_mm_per_s2 = 4e5;
  double lowest_mm = -50;  ///< readings outside lowest..highest are absurd
  double highest_mm = 150;
  double startRamp_s = 0.2;        ///< > 0; force rises from nothing over this
  double stopRamp_s = 0.01;        ///< > 0; and falls to nothing over this
  double emergencyRamp_s = 0.005;  ///< > 0; or over this, at an emergency stop or where nobody holds
  std::uint32_t heldReadings = 3;  ///< at most so many bad readings are bridged with the last force
  double longestHold_s = 0.0039;   ///< > 0; and for no longer than this
  double stall_s =
      0.012;  ///< > 0; a loop that paused for longer begins with no force: the device gave it up meanwhile
  /// >= 0; an encoder that counts not one step under more force than this is probed, then given up; infinite:
  /// never.
  double deadCountAbove_N = std::numeric_limits<double>::infinity();
  double deadCountFrom_mm = 0.1;  ///< only farther in than this: a handle may rest at its stop for ever
  double travelEnd_mm = std::numeric_limits<double>::infinity();  ///< where the button's travel ends
  double movedMass_kg = 0.05;  ///< > 0; about; what a runaway handle's speed is judged by
};

/// A push before the first force: motor and encoder must agree on its direction.
struct DirectionProofSettings {
  bool present = false;
  double push_N = 0.09;  ///< > 0; largest push
  double way_mm = 0.05;  ///< > 0; the handle must follow each push this far
};

/// Sideways springs of a three-axis device: the motion stays on the axis of the button (Shrestha, Figure 3).
struct ForceGuide {
  bool present = false;
  double stiffness_N_per_mm = 0;
  double damping_Ns_per_mm = 0;
  double force_N = 0;  ///< largest
};

/// Forces by which a free handle reveals its dynamics, in place of a button's law: the relay throws it to and
/// fro between two displacements at several speeds and lets it coast between, the chirp shakes it around the
/// middle at rising frequencies.
struct ForceExcitation {
  enum class Kind : std::uint8_t { none, relay, chirp };
  Kind kind = Kind::none;
  double middle_mm = 5, half_mm = 2;  ///< half_mm > 0: it turns so far from the middle
  double largest_N = 1;               ///< > 0; it asks for no more
  double lead_s = 0.001;              ///< >= 0; about how late a force acts
  // Of the relay.
  double slowest_mm_per_s = 30, fastest_mm_per_s = 150;
  // Of the chirp.
  double mass_kg = 0.05,
         friction_N =
             0;  ///< about; the force is what moves this mass by `shake_mm`, and more than its friction
  double shake_mm = 0.8;
  double from_Hz = 8, to_Hz = 120, sweep_s = 3;  ///< then up again
};

/// A button prepared for one device.
struct ForceProgram {
  double period_s = 0.001;  ///< > 0; one step
  double step_mm = 0.01;    ///< > 0; of the device's encoder
  VelocityMethod velocity = VelocityMethod::kalman;
  ForceLawSettings law;
  ForceLimits limits;
  ForceGuide guide;
  bool passivityController = false;  ///< else the observer is a meter only
  ForceExcitation excitation;        ///< plays in place of the states where it is one
  DirectionProofSettings proof;      ///< before any other force, at the start and each time a person arms
  std::uint32_t stateCount = 0;
  std::array<ForceStateTable, maxForceStates> states{};
};

static_assert(std::is_trivially_copyable_v<ForceProgram>, "a program crosses threads by plain copy");

}  // namespace detent::playback
