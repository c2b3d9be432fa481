// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The figures by which datasheets describe a button, derived from its state. Definitions:
// docs/reference/glossary.md ("Key figures").

#include <array>
#include <optional>
#include <string_view>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

/// In display order. "Peak" is the tactile point of the press with the largest drop after it; "valley" is the
/// lowest force between it and the next tactile point (or the end of the press).
enum class KeyFigure {
  initialForce,        ///< N, press, at the start of its curve
  preTravel,           ///< mm, displacement of the operating point (PT)
  operatingForce,      ///< N, press, at the operating point
  peakForce,           ///< N
  peakTravel,          ///< mm, displacement of the peak
  valleyForce,         ///< N
  valleyTravel,        ///< mm, displacement of the valley
  drop,                ///< N, peak force - valley force
  snapRatio,           ///< share, drop / peak force; only where the peak force is above 0
  slopeToPeak,         ///< N/mm, mean from the start to the peak; without a peak to the bottom-out
  slopeOfDrop,         ///< N/mm, mean from peak to valley; < 0
  slopeToBottomOut,    ///< N/mm, mean from the valley to the bottom-out
  resetTravel,         ///< mm, displacement of the reset point
  resetForce,          ///< N, release (without one: press), at the reset point (RF)
  differentialTravel,  ///< mm, operating point - reset point (MD)
  overTravel,          ///< mm, operating point to the end of the press (OT)
  bottomOutForce,      ///< N, press, where the bottom-out begins
  bottomOutTravel,     ///< mm, displacement where the bottom-out begins
  totalTravel,         ///< mm, displacement of the end of the press (TT)
  endForce,            ///< N, press, at its end
  pressWork,           ///< mJ, area under the press curve
  hysteresis           ///< mJ, press minus release where both exist: energy lost in one actuation; signed
};
inline constexpr std::size_t keyFigureCount = static_cast<std::size_t>(KeyFigure::hysteresis) + 1;

enum class FigureUnit { mm, N, N_per_mm, mJ, share };

/// Names of a figure, with static lifetime.
struct KeyFigureName {
  KeyFigure figure;
  FigureUnit unit;
  std::string_view key;  ///< "peak_force_N": for files and programs; ends in the unit, except for shares
  const char* term;      ///< "Peak force": English, a pattern for translation
};

/// One entry per figure, in the order of the enum.
const std::array<KeyFigureName, keyFigureCount>& keyFigureNames();

/// Values of all figures; nullopt if the button has no such figure: a linear button has no peak, a button
/// without contact points no pre-travel.
struct KeyFigures {
  std::array<std::optional<double>, keyFigureCount> values;  ///< mm, N, N/mm, mJ, or a share

  const std::optional<double>& operator[](KeyFigure figure) const {
    return values[static_cast<std::size_t>(figure)];
  }
  std::optional<double>& operator[](KeyFigure figure) { return values[static_cast<std::size_t>(figure)]; }
};

/// Places on a press from which figures are derived.
struct ShapePlaces {
  CurvePoint start;
  std::optional<CurvePoint> peak, valley;  ///< both or neither
  CurvePoint bottom;                       ///< start of the bottom-out
};

/// Any thread.
ShapePlaces shapePlacesOf(const ButtonState& state, const SectionSettings& settings = {});

/// Sets the figures that depend only on these places: peak, valley, bottom-out, and the spring rates between
/// them.
void fillShape(KeyFigures& figures, const ShapePlaces& positions);

/// Any thread.
KeyFigures keyFiguresOf(const ButtonState& state, const SectionSettings& settings = {});

}  // namespace detent
