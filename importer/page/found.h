// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A finding remembers who decided it, how sure, and from what (STYLE 8). Doubt is a confidence, not an error.

#include <string>

#include "model/button.h"

namespace detent::importer {

/// Something the importer concluded or was told. `confidence` 0..1; given values have 1.
template <class T>
struct Found {
  T value{};
  double confidence = 0;
  DecidedBy by = DecidedBy::found;
  std::string evidence;  ///< one short sentence: "7 of 7 tick labels on an even progression, rms 0.08 px"
};

}  // namespace detent::importer
