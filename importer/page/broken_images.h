// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One picture that cannot be decoded must not cost the page its other graphs. Private to importer/page.

#include "importer/page/mupdf_context.h"

namespace detent::importer {

/// Takes the images that MuPDF cannot load out of what this page of a PDF draws, its forms and patterns
/// included. Meant for a page that failed to be interpreted: loading an image may decode it. Changes the
/// document in memory, for all its pages. Returns how many images were taken out; 0 too if this is no PDF.
/// Examines at most 4096 objects.
int leaveOutBrokenImages(fz_context* context, fz_page* page);

}  // namespace detent::importer
