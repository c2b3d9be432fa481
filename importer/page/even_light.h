// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Photographs of sheets under a lamp. Private to importer/page.

#include "importer/page/raster.h"

namespace detent::importer {

/// The picture as if its light fell evenly: each place is divided by the paper around it, channel by channel, so that paper
/// is one light grey wherever the lamp stood and ink keeps its colour. Pictures on dark ground come back as they were.
Raster evenlyLit(Raster raster);

}  // namespace detent::importer
