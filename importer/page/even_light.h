// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Evens out the light on photographs of sheets under a lamp. Private to importer/page.

#include "importer/page/raster.h"

namespace detent::importer {

/// Divides each pixel by the paper around it, channel by channel, so that paper becomes one light grey and
/// lines keep their colour. Pictures with a dark background are returned unchanged.
Raster evenlyLit(Raster raster);

}  // namespace detent::importer
