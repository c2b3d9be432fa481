// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// States whether a text's letters are certain or may be misread.

#include "importer/axes/axis_calibration.h"
#include "importer/lexicon/lexicon.h"

namespace detent::importer {

/// Returns `exact` for text of the document itself, whose letters are certain; `recognised` for text read
/// from pixels.
inline TextSource sourceOf(const SeenText& text) {
  return text.confidence >= 1 ? TextSource::exact : TextSource::recognised;
}

}  // namespace detent::importer
