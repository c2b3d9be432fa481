// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page's own text. Private to importer/page.

#include <vector>

#include "importer/page/mupdf_context.h"
#include "importer/page/page.h"
#include "importer/page/seen_text.h"

namespace detent::importer {

/// Lines of the letters of `seen` of a structured text page made with FZ_STEXT_PRESERVE_LIGATURES, split
/// where a gap is wider than the letters are high (columns of a table, tick labels on one baseline). Boxes in
/// page units. Does not call into MuPDF, so nothing jumps.
std::vector<TextBox> textBoxes(const fz_stext_page& text, const Box& bounds, LetterKeys seen);

}  // namespace detent::importer
