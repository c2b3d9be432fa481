// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The loss record as data; apart from export_loss.h, which other rooms read.

#include <nlohmann/json.hpp>

#include "playback/interchange/export_loss.h"

namespace detent::playback {

/// The loss record as `--json` and the files themselves carry it.
nlohmann::ordered_json jsonOf(const ExportLoss& loss);

}  // namespace detent::playback
