// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The figures by which the trade names a button, each with its definition. All derived from the state; nothing is
// stored. The terms stand in docs/reference/glossary.md ("Key figures").

#include <array>
#include <optional>
#include <string_view>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

/// In the order in which they are listed. "Peak" is the tactile point of the press with the largest drop after it,
/// "valley" the lowest force between it and the next tactile point (or the end of the press).
enum class KeyFigure {
  initialForce,        ///< N, press, at the start of its curve
  preTravel,           ///< mm, start of the press to the operating point (PT)
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
  totalTravel,         ///< mm, start to end of the press (TT)
  endForce,            ///< N, press, at its end
  pressWork,           ///< mJ, area under the press curve
  hysteresis  ///< mJ, press minus release where both strokes are: the energy lost in one actuation; signed
};
inline constexpr std::size_t keyFigureCount = static_cast<std::size_t>(KeyFigure::hysteresis) + 1;

enum class FigureUnit { mm, N, N_per_mm, mJ, share };

/// What a figure is called. Strings live for ever.
struct KeyFigureName {
  KeyFigure figure;
  FigureUnit unit;
  std::string_view key;  ///< "peak_force_N": for files and programs; ends in the unit, a share in none
  const char* term;      ///< "Peak force": English, a pattern for translation
};

/// One entry per figure, in the order of the enum.
const std::array<KeyFigureName, keyFigureCount>& keyFigureNames();

/// Empty where the button has no such figure: a linear button has no peak, one without contact points no pre-travel.
struct KeyFigures {
  std::array<std::optional<double>, keyFigureCount> values;  ///< mm, N, N/mm, mJ, or a share

  const std::optional<double>& operator[](KeyFigure figure) const {
    return values[static_cast<std::size_t>(figure)];
  }
  std::optional<double>& operator[](KeyFigure figure) { return values[static_cast<std::size_t>(figure)]; }
};

/// The places of a press that its figures are made of.
struct ShapePlaces {
  CurvePoint start;
  std::optional<CurvePoint> peak, valley;  ///< both or none
  CurvePoint bottom;                       ///< where the bottom-out begins
};

/// Any thread.
ShapePlaces shapePlacesOf(const ButtonState& state, const SectionSettings& settings = {});

/// Sets the figures that are made of these places alone: of the peak, the valley, the bottom-out, and the spring rates between them.
void fillShape(KeyFigures& figures, const ShapePlaces& places);

/// Any thread.
KeyFigures keyFiguresOf(const ButtonState& state, const SectionSettings& settings = {});

}  // namespace detent
