// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Keeps the other graphs of a page if one of its pictures cannot be decoded. Private to importer/page.

#include "importer/page/mupdf_context.h"

namespace detent::importer {

/// Removes images that MuPDF cannot load from the drawing of this PDF page, including its forms and patterns.
/// Only for a page that could not be interpreted, because loading an image may mean decoding it. Changes the
/// document in memory, for all its pages. Returns the number of removed images; 0 also if this is no PDF.
/// Examines at most 4096 objects.
int leaveOutBrokenImages(fz_context* context, fz_page* page);

}  // namespace detent::importer
