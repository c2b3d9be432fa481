// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pixels to a PNG file's bytes.

#include <string>

#include "importer/page/raster.h"

namespace detent::importer {

/// `picture` must not be empty (checked).
std::string pngBytes(const Raster& picture);

}  // namespace detent::importer
