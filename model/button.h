// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button: one or more states, each with its force graph, and its provenance.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/force_graph.h"

namespace detent {

/// A point of the damping b(x) for force feedback, N·s/mm over displacement (Shrestha, "Basic Model": F = -kx
/// - bv).
struct DampingPoint {
  double displacement_mm = 0;
  double damping_Ns_per_mm = 0;  ///< >= 0
  friend bool operator==(const DampingPoint&, const DampingPoint&) = default;
};

/// Force graph of a state pressed and released at one speed.
struct SpeedGraph {
  double speed_mm_per_s = 0;  ///< > 0; for press and release
  ForceGraph graph;
  friend bool operator==(const SpeedGraph&, const SpeedGraph&) = default;
};

/// One state of a button (momentary: the only one; self-locking: unlocked, locked).
struct ButtonState {
  std::string name;  ///< "", "unlocked", "locked"; unique in the button
  ForceGraph graph;
  std::optional<double> operatingPoint_mm;  ///< press displacement at which the contact closes
  std::optional<double> resetPoint_mm;      ///< release displacement at which the contact opens
  std::vector<DampingPoint> damping;        ///< linear between points; empty: no damping is computed
  /// For a button that feels different at different speeds: the speed of `graph`, and graphs at one to three
  /// other speeds, by rising speed (speed_family.h). Code that knows no speed uses `graph`.
  std::optional<double> speed_mm_per_s = {};
  std::vector<SpeedGraph> otherSpeeds = {};
  friend bool operator==(const ButtonState&, const ButtonState&) = default;
};

/// Origin of an imported value: found by Detent or given by the user.
enum class DecidedBy { found, given };

/// One calibrated axis as it stood on the page.
struct AxisProvenance {
  std::string unit;         ///< as printed: "cN", "gf", "mm"
  double min = 0, max = 0;  ///< values at the plot frame's edges, in `unit`
  double residual_px = 0;   ///< rms distance of ticks from the calibration
  DecidedBy by = DecidedBy::found;
  friend bool operator==(const AxisProvenance&, const AxisProvenance&) = default;
};

/// A warning of an import as stored in the button file, in words and as a code.
struct RecordedWarning {
  std::string code;  ///< "several-graphs"; empty in files of version 1
  std::string text;  ///< English
  friend bool operator==(const RecordedWarning&, const RecordedWarning&) = default;
};

/// Source of an imported button; stored in the file.
struct Provenance {
  std::string sourceFile;    ///< name without folder
  std::string sourceSha256;  ///< hex
  int page = 1, graph = 1;
  std::vector<double> frame;  ///< x0,y0,x1,y1 in page units (px or pt), empty for a force log
  std::optional<AxisProvenance> xAxis, yAxis;
  std::string quality;  ///< draft, standard, precise
  double pressRms_px = 0, releaseRms_px = 0;
  double confidence = 0;           ///< 0..1
  std::vector<std::string> given;  ///< options given by hand, e.g. "--y-unit gf"
  std::vector<RecordedWarning> warnings;
  friend bool operator==(const Provenance&, const Provenance&) = default;
};

/// A button. Rules: one state (momentary) or two (self-locking, alternating at each actuation); unique state
/// names; operating and reset points inside the travel; damping by increasing displacement, finite, >= 0.
/// With graphs at other speeds: two to four speeds in all, each stated once, the same in all states; a state
/// has the same strokes at all speeds, and their ends agree within `familyTravelShare` of the travel.
/// Immutable; any thread.
class Button {
 public:
  static constexpr std::size_t mostSpeeds = 4;
  static constexpr double largestSpeed_mm_per_s = 1e5;
  static constexpr double familyTravelShare = 0.05;

  static Result<Button> fromStates(std::string name, std::vector<ButtonState> states,
                                   std::optional<Provenance> provenance = {});

  const std::string& name() const { return name_; }
  const std::vector<ButtonState>& states() const { return states_; }
  bool selfLocking() const { return states_.size() > 1; }
  const std::optional<Provenance>& provenance() const { return provenance_; }

  friend bool operator==(const Button&, const Button&) = default;

 private:
  Button(std::string name, std::vector<ButtonState> states, std::optional<Provenance> provenance)
      : name_(std::move(name)), states_(std::move(states)), provenance_(std::move(provenance)) {}
  std::string name_;
  std::vector<ButtonState> states_;
  std::optional<Provenance> provenance_;
};

}  // namespace detent
