// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Source of a text: its letters may be misread.

#include "importer/axes/axis_calibration.h"
#include "importer/lexicon/lexicon.h"

namespace detent::importer {

/// Letters of the document's own text are what they are.
inline TextSource sourceOf(const SeenText& text) {
  return text.confidence >= 1 ? TextSource::exact : TextSource::recognised;
}

}  // namespace detent::importer
