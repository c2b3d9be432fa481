// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Progress reports of long work, and requests to stop it.

#include <functional>
#include <string_view>

#include "importer/page/findings.h"
#include "importer/page/raster.h"

namespace detent::importer {

/// Passed down by every step. All members may be empty. Called on the thread that does the work.
struct Progress {
  std::function<void(double fraction, ImportStep step)> report;  ///< 0..1 over the whole import
  /// returns true to request a stop: work then ends soon with Failure::cancelled
  std::function<bool()> cancelled;
  /// Receives a step's intermediate pictures; costs nothing when empty.
  std::function<void(std::string_view label, const Raster& picture)> picture;

  bool isCancelled() const { return cancelled && cancelled(); }
};

}  // namespace detent::importer
