// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page's own text. Private to importer/page.

#include <vector>

#include "importer/page/mupdf_context.h"
#include "importer/page/page.h"
#include "importer/page/seen_text.h"

namespace detent::importer {

/// Lines of text from the letters of `seen` in a structured text page made with FZ_STEXT_PRESERVE_LIGATURES.
/// Lines are split at gaps wider than the letters are high (table columns, tick labels on one baseline).
/// Boxes in page units. Makes no MuPDF call, so no longjmp can occur.
std::vector<TextBox> textBoxes(const fz_stext_page& text, const Box& bounds, LetterKeys seen);

}  // namespace detent::importer
