// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page's own text. Private to importer/page.

#include <vector>

#include "importer/page/mupdf_context.h"
#include "importer/page/page.h"

namespace detent::importer {

/// Lines of a structured text page, split where a gap is wider than the letters are high (columns of a table,
/// tick labels on one baseline). Boxes in page units. Does not call into MuPDF, so nothing jumps.
std::vector<TextBox> textBoxes(const fz_stext_page& text, const Box& bounds);

}  // namespace detent::importer
