// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A drawing as one page of PDF, by librsvg and cairo.

#include <string>
#include <string_view>

namespace detent::importer::svg {

struct DrawnPdf {
  double scale = 1;     ///< units of the PDF per CSS pixel
  std::string pdf;      ///< empty: see `problem`
  std::string problem;  ///< the library's words
};

/// `svg`: well-formed XML in UTF-8. `rasters`: it has parts that can only be drawn as pixels (masks), whose
/// number grows with the scale.
DrawnPdf drawPdf(std::string_view svg, bool rasters);

}  // namespace detent::importer::svg
