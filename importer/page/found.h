// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A value with its origin: found or given, the confidence, and the evidence. Doubt is a confidence, not an
// error.

#include <vector>

#include "importer/page/findings.h"
#include "model/button.h"

namespace detent::importer {

/// A value that the importer found or the user gave. `confidence` 0..1; given values have 1.
template <class T>
struct Found {
  T value{};
  double confidence = 0;
  DecidedBy by = DecidedBy::found;
  std::vector<EvidenceItem> evidence;
};

}  // namespace detent::importer
