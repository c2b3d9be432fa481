// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One row of the library: a switch as one file has it.

#include <string>
#include <string_view>

#include "importer/library/felt_shape.h"
#include "model/key_figures.h"

namespace detent::importer {

/// Kind by the largest drop of the press: laboratories agree on it outside of 5 to 8 gf.
enum class SwitchKind { linear, between, tactile };
std::string_view nameOf(SwitchKind kind);
SwitchKind kindOf(const KeyFigures& figures);
/// Removes peak, valley and derived figures from a linear switch whose peak lies at its first contact: the
/// force rises to the preload there, which is no tactile point. `start_mm`: of the press.
void forgetContactBump(KeyFigures& figures, KeyFigures& sigmas, double start_mm);

struct LibrarySwitch {
  std::string name, unit, run;  ///< see SwitchName
  std::string source;           ///< the file, absolute
  int part = 1;                 ///< of several switches or states in the file, from 1
  std::string licence, credit;  ///< see Origin
  std::string sha256;           ///< of the file
  std::string version;          ///< version of the program that read the file
  KeyFigures figures;
  KeyFigures
      sigmas;  ///< standard errors of the figures (measured_figures.h, PageButton); none of a button's file
  /// files of this kind are known to have forces far from those of other laboratories
  bool scaleDoubtful = false;
  FeltShape shape;
};

}  // namespace detent::importer
